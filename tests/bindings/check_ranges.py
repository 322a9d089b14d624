#!/usr/bin/env python3
"""Holds the library file to the ranges, defaults and errors of bindings/api.json: each number that is passed, by value
or in an array, may be what its range says, and nothing else; what is refused is refused by an error of the function's
list, whose message names the argument and its value, and changes neither the object nor what outputs hold.

    check_ranges.py API LIBRARY
"""
import ctypes
import json
import math
import re
import sys
from math import inf, nan, nextafter
from pathlib import Path

sys.dont_write_bytecode = True
import check_api  # noqa: E402
from check_api import COMPONENTS, FAILURES, OK, SHAPES, Library, arguments, check, extent, saved_state  # noqa: E402

SIZE_MAX = (1 << 8 * ctypes.sizeof(ctypes.c_size_t)) - 1
INT_ENDS = (-(1 << 31), (1 << 31) - 1)
STATES = {"chain": ("new", "with lengths", "ring"), "membrane": ("new", "with lengths", "ring"),
          "water": ("new", "with hulls")}
PLATES = 2  # of each hull
LOOKED_AT = 64  # bytes of an output
FLOAT32, FLOAT64 = 0, 1

# Arguments with which what is tried counts, or succeeds: of a function, or of one of its parameters.
OTHERS = {
    "cd_water_set_side": {"kind": 1},
    "cd_water_set_hull": {"count": PLATES},
    "cd_water_get_hull": {"count": PLATES},
    "cd_membrane_set_stiffness": {"along_u": 2, "along_v": 3},  # not what a new one has: half of a call would be seen
    "cd_membrane_set_rest_length": {"along_u": 2, "along_v": 3},
    ("cd_membrane_write_vertices", "normal_offset"): {"position_offset": 40},
    ("cd_water_write_vertices", "normal_offset"): {"position_offset": 40},
    ("cd_water_write_vertices", "depth_offset"): {"position_offset": 40},
}
# What has to be the same number.
TOGETHER = {"cd_membrane_set_rest_length": {0: ("along_u", "along_v")}}
# What says which part of a field is meant, in which a buffer then has as many numbers.
OF_PARTS = ("first_strand", "strands", "first", "n", "first_u", "n_u", "first_v", "n_v",
            "first_x", "n_x", "first_y", "n_y")


# ---- limits ---------------------------------------------------------------------------------------------------------


def told(library, kind, handle, getter):
    """What a getter without arguments tells, by the words of its results."""
    function = next(f for f in library.api["functions"] if f["name"] == f"cd_{kind}_{getter}")
    results = function["parameters"][1:]
    room = [library.plain(p["base"])() for p in results]
    assert getattr(library.dll, function["name"])(handle, *map(ctypes.byref, room)) == OK
    return {p["name"][4:]: number.value for p, number in zip(results, room)}


def limit_names(library, kind, handle):
    """The words in ranges, as README.md tells them, and what they are of this object now."""
    names = {"INFINITY": inf, "SIZE_MAX": SIZE_MAX, **told(library, kind, handle, "get_shape")}
    float64 = names["precision"] == FLOAT64
    names |= {"largest": 1e60 if float64 else 1e30,
              "finite": sys.float_info.max if float64 else (2 - 2.0 ** -23) * 2.0 ** 127}
    if kind == "water":
        names["hulls"] = told(library, kind, handle, "get_hulls")["count"]
        names["cell"] = min(names["dx"], names["dy"])
        names["largest_disc"] = 512 * names["cell"] / math.sqrt(math.pi)  # where all plates are in it
    else:
        names["colliders"] = told(library, kind, handle, "get_colliders")["count"]
        ring = told(library, kind, handle, "get_ring")
        names |= {"ring": ring.get("ring"), "ring_u": ring.get("along_u"), "ring_v": ring.get("along_v")}
    if kind == "chain":
        names["is_rope"] = told(library, kind, handle, "get_rest_length")["length"] > 0
        names["own_strands"] = names["strands"] if names["is_rope"] else 1
    thing = next(o for o in library.api["objects"] if o["name"] == kind)
    field = next(f for f in thing["fields"] if library.enums["cd_field"][f["name"]] == check_api.field_of(kind))
    numbers, _ = extent(kind, field)
    along = {"chain": ("field_strands", "field_nodes"), "membrane": ("field_u", "field_v"),
             "water": ("field_x", "field_y")}[kind]
    return names | dict(zip(along, (numbers[1], numbers[3]) if kind == "chain" else numbers[2:]))


def value_of(limit, names):
    return eval(limit, {"__builtins__": {}}, names) if isinstance(limit, str) else limit


def ends(described, base, names):
    """(the numbers at the ends of the range, those just outside)."""
    others = described.get("values", []) + (described.get("in_ropes", []) if names.get("is_rope") else [])
    others = [value_of(other, names) for other in others]
    limits = {key: value_of(described[key], names) for key in ("least", "most", "above", "below") if key in described}
    if base in ("double", "float"):
        about = 1e-12 if described.get("most") == "largest_disc" else 0
        inside, outside = list(others), [nan, -inf, inf]
        if "above" in limits:
            inside, outside = inside + [nextafter(limits["above"], inf)], outside + [limits["above"]]
        if "least" in limits:
            inside, outside = inside + [limits["least"]], outside + [nextafter(limits["least"], -inf)]
        if "most" in limits:
            inside.append(limits["most"] * (1 - about))
            outside.append(nextafter(limits["most"] * (1 + about), inf))
        outside += [nextafter(other, to) for other in others if math.isfinite(other) for to in (-inf, inf)]
        least, most = limits.get("least", inf), limits.get("most", -inf)
        outside = [x for x in outside if x not in others and not least <= x <= most]
        return inside, outside
    if "below" in limits:
        limits["most"] = limits["below"] - 1
    inside = others + [limits[key] for key in ("least", "most") if key in limits]
    outside = [other + step for other in others for step in (-1, 1)]
    outside += [limits["least"] - 1] if "least" in limits else []
    outside += [limits["most"] + 1] if "most" in limits else []
    first, last = INT_ENDS if base == "int32_t" else (0, SIZE_MAX)
    outside += [first, last] if "least" not in limits or "most" in limits else []
    within = range(limits["least"], limits.get("most", last) + 1) if limits else ()
    return inside, [x for x in outside if first <= x <= last and x not in inside and x not in within]


# ---- calls ----------------------------------------------------------------------------------------------------------


class Calls:
    """Calls of one function on objects of one state, each with valid arguments but for what is tried."""

    def __init__(self, library, function, state, precision=FLOAT64, needs=None):
        self.library, self.function, self.state = library, function, state
        self.precision, self.kind, self.name = precision, function["object"], function["name"]
        self.codes = {error["code"] for error in function["errors"]}
        self.objects, self.what, self.needs = [], "", needs or self.name

    def make(self):
        handle, dll = self.library.create(self.kind, self.needs, self.precision), self.library.dll
        if self.state == "with hulls":
            assert dll.cd_water_set_hulls(handle, 1, PLATES, 1) == OK
            assert dll.cd_water_set_disc(handle, 0, 1.0, 1.0) == OK
        elif self.state == "with lengths":
            assert check_api.set_length(self.library, self.kind, handle, 1.0) == OK
            assert getattr(dll, f"cd_{self.kind}_set_colliders")(handle, 1) == OK
            assert getattr(dll, f"cd_{self.kind}_set_loads")(handle, 1) == OK
        elif self.state == "ring":
            assert getattr(dll, f"cd_{self.kind}_set_ring")(handle, 1, 1) == OK
        self.objects.append(handle)
        return handle

    def close(self):
        for handle in self.objects:
            self.library.destroy(self.kind, handle)

    def call(self, handle, changes=None, element=None):
        """The status of a call with `changes` to its numbers, and with element = (array, index, number)."""
        other = self.objects[0]
        values, kept = arguments(self.library, self.function, handle, other,
                                 saved_state(self.library, self.kind, other))
        names = [p["name"] for p in self.function["parameters"]]
        for name, value in {**OTHERS.get(self.name, {}), **(changes or {})}.items():
            values[names.index(name)] = value
        if element:
            name, index, number = element
            at = names.index(name)
            plain = self.library.plain(self.function["parameters"][at]["base"])
            (plain * (index + 1)).from_buffer(kept[at])[index] = number
        outputs = {p["name"]: buffer for p, buffer in zip(self.function["parameters"], kept)
                   if p["direction"] != "in" and isinstance(buffer, ctypes.Array)}
        for buffer in outputs.values():
            ctypes.memset(buffer, ord("?"), LOOKED_AT)
        dll = self.library.dll  # what fails first leaves the message of another function
        (dll.cd_chain_get_time if self.name == "cd_chain_get_steps" else dll.cd_chain_get_steps)(None, None)
        status = getattr(dll, self.name)(*values)
        self.outputs = {name: buffer.raw[:LOOKED_AT] for name, buffer in outputs.items()}
        self.wrote = any(output != b"?" * LOOKED_AT for output in self.outputs.values())
        return status

    def says(self):
        return self.library.dll.cd_error_message().decode()

    def value(self, name):
        """What a call gives the parameter, unless it is changed."""
        values, _ = arguments(self.library, self.function, self.objects[0], self.objects[0], b"")
        names = [p["name"] for p in self.function["parameters"]]
        return {**dict(zip(names, values)), **OTHERS.get(self.name, {})}[name]

    def numbers_in(self, array):
        times = array["times"] if isinstance(array["times"], int) else self.value(array["times"])
        return self.value(array["length"]) * times

    def taken(self, what, changes, element=None):
        handle, self.what = self.make(), what
        status = self.call(handle, changes, element)
        check(status == OK, f"{self.name}: {what} should be taken, but: {self.says()}")
        return handle

    def refused(self, what, words, statuses, number, changes, element=None):
        handle, self.what = self.make(), what
        before = told(self.library, self.kind, handle, "hash")
        status = self.call(handle, changes, element)
        name = next(name for name, value in self.library.enums["cd_status"].items() if value == status)
        message = self.says() if status != OK else "nothing"
        check(name in statuses and name in self.codes,
              f"{self.name}: {what} gives {name}, not {' or '.join(sorted(statuses))}; described: {sorted(self.codes)}")
        shown = "%g" % number if isinstance(number, float) else str(number)
        function, _, rest = message.partition(": ")
        check(status == OK or function == self.name and re.search(rf"(?<!\w){words}(?!\w)", rest) and shown in rest,
              f"{self.name}: {what} is refused by a message that does not name it: {message}")
        limits = re.search(r"must be in \[(\S+), (\S+)\]", message)
        check(not limits or float(limits[1]) <= float(limits[2]), f"{self.name}: no range: {message}")
        check(not self.wrote, f"{self.name}: {what} is refused, but an output has been written")
        check(told(self.library, self.kind, handle, "hash") == before, f"{self.name}: {what} is refused, but the state "
                                                                       "has changed")


def each_with(calls, p, number):
    """The changes that give a parameter this number, and what else has to change with it."""
    others = TOGETHER.get(calls.name, {}).get(number, [p["name"]])
    changes = {**OTHERS.get((calls.name, p["name"]), {}), **{name: number for name in others}}
    arrays = [q for q in calls.function["parameters"] if q["role"] == "length"]
    if p["name"] in OF_PARTS and arrays:  # as many numbers as the part then has
        parts = [q["name"] for q in calls.function["parameters"] if q["role"] == "value" and q["base"] == "size_t"
                 and not q["name"].startswith("first")]
        count = math.prod(changes.get(name, calls.value(name)) for name in parts)
        changes[arrays[0]["name"]] = count * (COMPONENTS if calls.kind != "water" else 1)
    return changes


def tries(calls, tried):
    """All that may be passed, and what may not, for each argument of a function whose other arguments are valid."""
    function = calls.function
    for p in function["parameters"]:
        if p["role"] == "value" and p["base"] in calls.library.enums:
            values = calls.library.enums[p["base"]].values()
            for number in (min(values) - 1, max(values) + 1, *INT_ENDS):
                calls.refused(f"{p['name']} {number}", p["name"], {"CD_ERROR_ENUM"}, number, {p["name"]: number})
        elif p["role"] == "value":
            names = limit_names(calls.library, calls.kind, calls.objects[0])
            names |= {q["name"]: calls.value(q["name"]) for q in function["parameters"] if q["role"] == "value"}
            names |= OTHERS.get((calls.name, p["name"]), {})
            inside, outside = ends(p["range"], p["base"], names)
            tried.add((function["name"], p["name"]))
            for number in inside:
                calls.taken(f"{p['name']} {number}", each_with(calls, p, number))
            for number in outside:
                calls.refused(f"{p['name']} {number}", p["name"],
                              {"CD_ERROR_VALUE", "CD_ERROR_RANGE"}, number, each_with(calls, p, number))
        elif p["role"] == "array" and p["direction"] == "in":
            tried.add((function["name"], p["name"]))
            in_array(calls, p)
        elif p["role"] == "length" and not any(q["role"] == "bytes" for q in function["parameters"]):
            right = calls.value(p["name"])
            for number in {SIZE_MAX} if p["name"] == "n" else {0, right + 1, SIZE_MAX} - {right}:
                calls.refused(f"{p['name']} {number}", p["name"], {"CD_ERROR_RANGE"}, number, {p["name"]: number})


def in_array(calls, p):
    names = limit_names(calls.library, calls.kind, calls.objects[0])
    for i in range(calls.numbers_in(p)):
        described = p.get("range")
        if isinstance(described, list):
            described = described[i % len(described)]
        inside, outside = ends(described, p["base"], names) if described else ([], [nan, -inf, inf])
        for number in inside:
            calls.taken(f"{p['name']}[{i}] = {number}", {}, (p["name"], i, number))
        for number in outside:
            calls.refused(f"{p['name']}[{i}] = {number}", re.escape(f"{p['name']}[{i}]"), {"CD_ERROR_VALUE"}, number,
                          {}, (p["name"], i, number))


# ---- the tests ------------------------------------------------------------------------------------------------------


def ranges(library):
    tried = set()
    for function in library.api["functions"]:
        kind = function["object"]
        if kind is None or function["short"] in ("create", "destroy") or function["returns"] != "cd_status":
            continue
        states = [(state, FLOAT64) for state in STATES[kind]]
        if any(limit in json.dumps(function["parameters"]) for limit in ("largest", "finite")):
            states.append((STATES[kind][1], FLOAT32))
        for state, precision in states:
            calls = Calls(library, function, state, precision)
            calls.make()
            if calls.call(calls.make()) == OK:
                tries(calls, tried)
            calls.close()
    every = {(f["name"], p["name"]) for f in library.api["functions"] for p in f["parameters"]
             if f["object"] and f["short"] != "create" and p["base"] not in library.enums
             and (p["role"] == "value" or p["role"] == "array" and p["direction"] == "in")}
    check(tried == every, f"never tried: {sorted(every - tried)}")


def fields(library):
    """A value of each field may be what its range says, and nothing else."""
    count, enumerators = 0, {v["name"]: v["value"] for enum in library.api["enums"] for v in enum["values"]}
    statuses = {v: k for k, v in library.enums["cd_status"].items()}
    for kind, field in ((o["name"], f) for o in library.api["objects"] for f in o["fields"]):
        check(("range" in field) != field["read_only"], f"cd_{kind}, {field['name']}: no range, or one to read only")
        write = next(f for f in library.api["functions"] if f["name"] == f"cd_{kind}_write_f64")
        for precision in (FLOAT32, FLOAT64) if "range" in field else ():
            calls = Calls(library, write, "with lengths" if field["lengths"] else "new", precision, field["name"])
            number, values = enumerators[field["name"]], COMPONENTS if field["components"] else 1
            at = int(field["unit"] != "-")  # of all nodes only an end may be matched, and only inside water flows
            place = (0, 1, at, 1) if kind == "chain" else (at, at, 1, 1)

            def written(value):
                handle = calls.make()
                assert getattr(library.dll, f"cd_{kind}_enable_field")(handle, number) == OK
                room = (ctypes.c_double * values)(*[value] * values)
                return statuses[getattr(library.dll, write["name"])(handle, number, *place, room, values)]

            names = limit_names(library, kind, calls.make()) | enumerators
            inside, outside = ends(field["range"], "double", names)
            for value in inside:
                check(written(value) == "CD_OK", f"cd_{kind}, {field['name']}: {value} is in the range: {calls.says()}")
            for value in outside:
                check(written(value) == "CD_ERROR_VALUE", f"cd_{kind}, {field['name']}: {value} is out of the range")
            count += len(inside) + len(outside)
            calls.close()
    check(count > 300, f"only {count} values")


def creates(library):
    for kind, shape in SHAPES.items():
        function = next(f for f in library.api["functions"] if f["name"] == f"cd_{kind}_create")
        codes = {error["code"] for error in function["errors"]}
        for i, p in enumerate(function["parameters"][:len(shape) - 1]):

            def made_of(number):
                numbers, handle = list(shape), ctypes.c_void_p()
                numbers[i] = number
                status = getattr(library.dll, function["name"])(*numbers, ctypes.byref(handle))
                check((status == OK) == bool(handle.value), f"{function['name']}: status {status}, but {handle}")
                library.destroy(kind, handle)
                return next(name for name, value in library.enums["cd_status"].items() if value == status)

            if p["base"] in library.enums:
                values = library.enums[p["base"]].values()
                inside, outside = list(values), [min(values) - 1, max(values) + 1, *INT_ENDS]
            else:
                inside, outside = ends(p["range"], p["base"], {})
                if p["base"] == "size_t":
                    outside.append(SIZE_MAX)
            for number in inside:
                check(made_of(number) == "CD_OK", f"{function['name']}: {p['name']} {number} is in the range")
            for number in outside:
                status = made_of(number)
                check(status in codes - {"CD_ERROR_MEMORY", "CD_ERROR_UNSUPPORTED"} and re.search(
                    rf"\b{p['name']}\b", library.dll.cd_error_message().decode()),
                      f"{function['name']}: {p['name']} {number} gives {status}: {library.dll.cd_error_message()}")


def defaults(library):
    """What a new object is made with, as its getters tell."""
    count, names = 0, {v["name"]: v["value"] for enum in library.api["enums"] for v in enum["values"]}
    names |= {"INFINITY": inf}
    for function in library.api["functions"]:
        results = [p for p in function["parameters"] if p["role"] in ("result", "array") and p["direction"] == "out"]
        if not function["short"].startswith("get_") or not any("default" in p for p in results):
            continue
        kind = function["object"]
        calls = Calls(library, function, STATES[kind]["index" in [p["name"] for p in function["parameters"]]])
        handle = calls.make()
        values, kept = arguments(library, function, handle, handle, b"")
        status = getattr(library.dll, function["name"])(*values)
        check(status == OK, f"{function['name']}: {calls.says()}")
        for p, room in zip(function["parameters"], kept):
            if "default" in p:
                wanted = names.get(p["default"], p["default"])
                room = (library.plain(p["base"]) * 1).from_buffer(room)
                check(room[0] == wanted, f"{function['name']}: {p['name']} of a new {kind} is {room[0]}, not {wanted}")
                count += 1
        calls.close()
    check(count > 40, f"only {count} defaults")


def main():
    path, library = sys.argv[1:]
    library = Library(json.loads(Path(path).read_text(encoding="utf-8")), library)
    ranges(library)
    fields(library)
    creates(library)
    defaults(library)
    if FAILURES:
        sys.exit("\n".join(FAILURES))


if __name__ == "__main__":
    main()
