#!/usr/bin/env python3
"""Holds the library file to bindings/api.json.

    check_api.py exports API NM LIBRARY       it exports the functions described, and nothing else
    check_api.py dll API OBJDUMP LIBRARY      so does a DLL of Windows, which needs none but the system's own
    check_api.py behaviour API LIBRARY        names and fields are as described
    check_api.py scenes API SCENES CALLS ENUMERATORS
                                              the conformance scenes use every call that changes an object, and numbers
                                              that every parser reads alike
"""
import ctypes
import json
import re
import subprocess
import sys
from pathlib import Path

FAILURES = []


def check(condition, what):
    if not condition:
        FAILURES.append(what)


def differ(found, described, what):
    check(not found - described, f"{what}, but not described: {', '.join(sorted(found - described))}")
    check(not described - found, f"described, but not {what}: {', '.join(sorted(described - found))}")


# ---- exports --------------------------------------------------------------------------------------------------------


def exports(api, nm, library):
    symbols = subprocess.run([nm, "-D", "--defined-only", "--format=posix", library], check=True, text=True,
                             capture_output=True).stdout
    kinds = {line.split()[0].split("@")[0]: line.split()[1] for line in symbols.splitlines()}
    differ({name for name, kind in kinds.items() if kind != "A"}, {f["name"] for f in api["functions"]}, "exported")


def dll(api, objdump, library):
    said = subprocess.run([objdump, "-p", library], check=True, text=True, capture_output=True).stdout
    table = re.split(r"\[Ordinal/Name Pointer\] Table|Export Table:", said)[1]  # GNU's objdump, or LLVM's
    differ(set(re.findall(r"^\s*(?:\[ *\d+\](?: \+base\[ *\d+\] +\w+)?|\d+ +0x\w+) +(\S+)$", table, re.MULTILINE)),
           {f["name"] for f in api["functions"]}, "exported")
    needed = set(re.findall(r"DLL Name: (\S+)", said))
    check(needed, "no import was found")
    more = [name for name in needed if not re.fullmatch(r"(?i)(kernel32|msvcrt|ucrtbase|api-ms-win-crt-.*)\.dll", name)]
    check(not more, f"needs {', '.join(more)}")


# ---- behaviour ------------------------------------------------------------------------------------------------------

PLAIN = {"size_t": ctypes.c_size_t, "uint32_t": ctypes.c_uint32, "uint64_t": ctypes.c_uint64, "int32_t": ctypes.c_int32,
         "float": ctypes.c_float, "double": ctypes.c_double, "const char*": ctypes.c_char_p, "void": None}
OK, NULL, RANGE, UNSUPPORTED = 0, 1, 5, 9
COMPONENTS = 3
SHAPES = {"chain": (2, 4, COMPONENTS, 1, None), "membrane": (4, 5, COMPONENTS, 1, None),
          "water": (5, 4, 1.0, 2.0, 1, None)}
IN_A_PLANE = ("cd_chain_set_rest_angle", "CD_REST_ANGLE")  # what needs 2 components
# Arguments with which every call succeeds; what is not here is 1.
VALUES = {"lambda": 0.5, "tolerance": 0.01, "dt": 0.01, "strand": 0, "index_size": 4, "stride": 64,
          "position_offset": 0, "normal_offset": 12, "depth_offset": 24, "first": 0, "first_strand": 0, "first_u": 0,
          "first_v": 0, "first_x": 0, "first_y": 0, "along_u": 1, "along_v": 1, "height": 0.1, "skip_dry": 0,
          "index": 0, "columns": 2, "rows": 2}
# How many values arrays have whose lengths no shape tells.
COUNTS = {"set_bed": {"heights": 4}, "get_bed": {"out_heights": 0}, "set_hull": {"heights": 1},
          "get_hull": {"out_heights": 1}, "set_hull_pose": {"pose": 7}, "get_hull_pose": {"out_pose": 7},
          "get_hull_floor": {"out_pose": 7}, "set_hull_velocity": {"velocity": 6},
          "get_hull_velocity": {"out_velocity": 6}, "set_hull_force": {"force": 6}, "get_hull_force": {"out_force": 6},
          "get_hull_load": {"out_load": 6}, "get_collider_load": {"out_load": 6}}
STARTS = ("rotation", "normal", "pose")  # what begins as this does, in as many numbers as it has
IDENTITY = [float(row == column) for row in range(COMPONENTS) for column in range(COMPONENTS)]
ROOM = 1 << 16


class Library:
    def __init__(self, api, path):
        self.api, self.dll = api, ctypes.CDLL(path)
        self.enums = {enum["name"]: {v["name"]: v["value"] for v in enum["values"]} for enum in api["enums"]}
        for function in api["functions"]:
            bound = getattr(self.dll, function["name"])
            bound.restype = self.plain(function["returns"])
            bound.argtypes = [ctypes.c_void_p if "*" in p["type"] else self.plain(p["type"])
                              for p in function["parameters"]]

    def plain(self, name):
        return ctypes.c_int32 if name in self.enums else PLAIN[name]

    def create(self, kind, what=None, precision=1):
        """An object that has what is named."""
        handle = ctypes.c_void_p()
        create = getattr(self.dll, f"cd_{kind}_create")
        numbers = [*SHAPES[kind]]
        numbers[-2] = precision
        if what in IN_A_PLANE:
            numbers[2] = 2
        assert create(*numbers, ctypes.byref(handle)) == OK, self.dll.cd_error_message()
        return handle

    def destroy(self, kind, handle):
        getattr(self.dll, f"cd_{kind}_destroy")(handle)


def field_of(kind):
    return 11 if kind == "water" else 0  # depth; position


def set_length(library, kind, handle, length):
    """Makes a chain a rope and a membrane cloth; 0 undoes it."""
    return getattr(library.dll, f"cd_{kind}_set_rest_length")(handle, *[length] * (2 if kind == "membrane" else 1))


def arguments(library, function, handle, other, saved):
    """Valid ones; buffers are kept alive by the second list."""
    kind, values, kept = function["object"], [], []
    for p in function["parameters"]:
        role, value = p["role"], None
        if role == "self":
            value = handle
        elif role == "handle":
            value = other
        elif role == "value" and p["base"] in library.enums:
            value = field_of(kind) if p["base"] == "cd_field" else 0
        elif role == "value":
            value = VALUES.get(p["name"], 1)
        elif role == "length":
            counted = next(q for q in function["parameters"] if q["name"] == p["of"][0])
            single = counted["times"] in (2, 3) or function["short"] == "sample" and p["name"] == "n"
            value = {"bytes": ROOM}.get(counted["role"], 1 if single or kind == "water" else COMPONENTS)
            if function["short"] == "load":
                value = len(saved)
            value = COUNTS.get(function["short"], {}).get(p["of"][0], value)
        elif role == "bytes" and p["direction"] == "in":
            value = ctypes.create_string_buffer(saved, len(saved))
        elif role == "callbacks":
            value = None if p["null"] else (ctypes.c_size_t * 2)(1, 1)  # never called
        elif p["name"] in STARTS:
            value = (ctypes.c_double * len(IDENTITY))(*IDENTITY)
        elif role != "length":
            value = ctypes.create_string_buffer(ROOM)
        kept.append(value)
        values.append(ctypes.addressof(value) if isinstance(value, ctypes.Array) else value)
    return values, kept


def saved_state(library, kind, handle):
    size, written = ctypes.c_size_t(), ctypes.c_size_t()
    assert getattr(library.dll, f"cd_{kind}_save_size")(handle, ctypes.byref(size)) == OK
    data = ctypes.create_string_buffer(size.value)
    assert getattr(library.dll, f"cd_{kind}_save")(handle, data, size.value, ctypes.byref(written)) == OK
    return data.raw


def extent(kind, field, is_rope=False):
    """Four numbers that a read of the whole field takes, and how many values it has."""
    a, b = SHAPES[kind][:2]
    per = field["per"][-1]
    if kind == "chain":
        own = "strand" in field["per"] and (is_rope or not field["own_in_ropes"])
        strands, items = (a if own else 1), b + (per == "node")
        numbers, count = (0, strands, 0, items), strands * items
    elif kind == "membrane":
        n_u, n_v = a + (not field["name"].endswith("_U")), b + (not field["name"].endswith("_V"))
        numbers, count = (0, 0, n_u, n_v), n_u * n_v
    else:
        n_x, n_y = a + (per == "x-face"), b + (per == "y-face")
        numbers, count = (0, 0, n_x, n_y), n_x * n_y
    return numbers, count * (COMPONENTS if field["components"] else 1)


def fields(library):
    for thing in library.api["objects"]:
        kind, described = thing["name"], {field["name"]: field for field in thing["fields"]}
        for name, value in library.enums["cd_field"].items():
            handle = library.create(kind, name)

            def call(verb, *rest):
                return getattr(library.dll, f"cd_{kind}_{verb}")(handle, value, *rest)

            where, field = f"cd_{kind}, {name}", described.get(name)
            if field and field["lengths"]:
                check(call("enable_field") == UNSUPPORTED, f"{where}: switched on without a rest length")
                check(set_length(library, kind, handle, 1.0) == OK, f"{where}: a rest length is refused")
            known = call("enable_field") == OK
            check(known == (field is not None), f"{where}: switched on: {known}")
            if field and known:
                numbers, count = extent(kind, field)
                room = (ctypes.c_double * (count + 1))()
                check(call("read_f64", *numbers, room, count) == OK, f"{where}: not of {count} values")
                check(call("read_f64", *numbers, room, count + 1) == RANGE, f"{where}: of more than {count} values")
                if field.get("own_in_ropes"):
                    check(set_length(library, kind, handle, 1.0) == OK, f"{where}: a rest length is refused")
                    of_all, more = extent(kind, field, is_rope=True)
                    room = (ctypes.c_double * more)()
                    check(call("read_f64", *of_all, room, more) == OK, f"{where}: of ropes not of {more} values")
                    check(set_length(library, kind, handle, 0.0) == OK, f"{where}: lengths stay")
                check(call("read_f64", *numbers, room, count) == OK, f"{where}: cannot be read again")
                status = call("write_f64", *numbers, room, count)
                check(status == (UNSUPPORTED if field["read_only"] else OK), f"{where}: written, status {status}")
                for k in (2, 3):
                    more = [n + (i == k) for i, n in enumerate(numbers)]
                    if kind == "chain":
                        more = [n + (i == (1 if k == 2 else 3)) for i, n in enumerate(numbers)]
                    check(call("read_f64", *more, room, count) == RANGE, f"{where}: reaches to {more}")
                strides = 2 if kind == "water" else 3
                out = [ctypes.byref(ctypes.c_size_t()) for _ in range(strides)]
                status = call("view", ctypes.byref(ctypes.c_void_p()), *out)
                check(status == (OK if field["viewable"] else UNSUPPORTED), f"{where}: view gives status {status}")
                status = call("disable_field")
                check(status == (UNSUPPORTED if field["always"] else OK), f"{where}: switched off, status {status}")
            library.destroy(kind, handle)


def behaviour(api, path):
    library = Library(api, path)
    names = library.enums["cd_status"]
    for name, value in names.items():
        check(library.dll.cd_status_name(value).decode() == name, f"the name of status {value}")
    check(library.dll.cd_status_name(max(names.values()) + 1) == b"CD_ERROR_UNKNOWN", "a status more than described")
    check(library.dll.cd_version_string().decode() == api["version"], "the version")
    fields(library)


# ---- scenes ---------------------------------------------------------------------------------------------------------

# What plays scenes sets the kernels; the last two are save_and_load and copy. Callbacks are no numbers.
NOT_IN_SCENES = {"destroy", "set_parallel", "set_callback", "set_kernels", "load", "copy_state"}


def scenes(api, path, calls, enumerators):
    text = re.sub(r"^#.*", "", Path(path).read_text(encoding="utf-8"), flags=re.MULTILINE)
    used, kind = set(), None
    for line in text.splitlines():
        words = line.split()
        if not words or line.startswith(" "):
            continue
        if words[0] == "create":
            kind = words[1]
        name = words[2] if words[0] == "refused" else words[0]
        if name not in ("scene", "create", "copy", "save_and_load", "hash"):
            used.add(f"cd_{kind}_{name}")
    changing = {f["name"] for f in api["functions"] if f["parameters"] and f["parameters"][0].get("role") == "self"
                and f["parameters"][0]["direction"] == "inout" and f["short"] not in NOT_IN_SCENES}
    differ(used, changing, "called in the scenes")
    for word in re.findall(r"(?<=\s)-?\d[^\s]*(?=\s)", text):
        if word.startswith("0x"):
            continue
        mantissa, _, exponent = word.lstrip("-").partition("e")
        digits = mantissa.replace(".", "").lstrip("0")
        power = int(exponent or 0) - len(mantissa.partition(".")[2])
        check(re.fullmatch(r"\d+(\.\d+)?(e-?\d+)?", word.lstrip("-")) and len(digits) <= 15 and abs(power) <= 22,
              f"the number {word} is not read alike by every parser")
    listed = re.findall(r"ENUMERATOR\((\w+)\)", Path(enumerators).read_text(encoding="utf-8"))
    differ(set(listed), {v["name"] for e in api["enums"] for v in e["values"]}, "in enumerators.h")
    known = Path(calls).read_text(encoding="utf-8")
    every = re.search(r"#define EVERY_OBJECT(?:.*\\\n)*.*", known).group(0)
    of = {f"cd_{k}_{n}" for n in re.findall(r"CALL(?:_0)?\((\w+)[,)]", every) for k in SHAPES}
    of |= {f"cd_{k.lower()}_{n}" for k, n in re.findall(r"^(CHAIN|MEMBRANE|WATER)(?:_0)?\((\w+)", known, re.MULTILINE)}
    differ(of, changing, "in calls.h")


def main():
    task, path, *rest = sys.argv[1:]
    api = json.loads(Path(path).read_text(encoding="utf-8"))
    {"exports": exports, "dll": dll, "behaviour": behaviour, "scenes": scenes}[task](api, *rest)
    if FAILURES:
        sys.exit("\n".join(FAILURES))


if __name__ == "__main__":
    main()
