#!/usr/bin/env python3
"""Holds the library file to what bindings/api.json says of pointers. What is no living object of a function's kind is
refused, and so is null where it is not allowed: by an error of the function's list, whose message names the function
and the argument, and neither an object nor an output changes. Null where it is allowed is taken, and changes nothing
else that the call does.

    check_pointers.py API LIBRARY
"""
import ctypes
import json
import mmap
import os
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from check_api import FAILURES, NULL, OK, SHAPES, Library, check  # noqa: E402
from check_ranges import FLOAT32, FLOAT64, SIZE_MAX, STATES, Calls, told  # noqa: E402

# What an object goes through before a function is tried: then a field can be switched off, and a collider is a
# callback's, which may get another callback without an origin.
BEFORE = {"disable_field": "enable_field", "set_callback": "set_callback"}
FORCE = {"chain": "CD_FORCE", "membrane": "CD_FORCE", "water": "CD_FORCE_X"}  # fields that a new object has not
# Where all arrays of a length are null, the length means nothing. Nor does this then,
MEANINGLESS = {"set_callback": {"friction": -1.0}}
# but these want the right length all the same.
COUNTING = {"get_collider"}
FOREIGN_BYTES, UNTOUCHED = 8192, 0x5A5A5A5A
AT = mmap.mmap(-1, 256)  # what is being tried, which the process that is left after a crash tells


def trying(what):
    AT[:] = what.encode()[:len(AT)].ljust(len(AT))


def tables(library, p, heap):
    """Each function of a table of callbacks, with a table that lacks it."""
    members = next(c for c in library.api["callbacks"] if c["name"] == p["base"])["members"]
    whole = heap.table if p["base"] == "cd_allocator" else [None] + [1] * (len(members) - 1)  # never called
    return [(member["name"], (ctypes.c_void_p * len(members))(*whole[:i], None, *whole[i + 1:]))
            for i, member in enumerate(members) if member["function"]]


# ---- what is no living object of a kind -----------------------------------------------------------------------------


class Heap:
    """An allocator whose memory stays readable after its release."""

    def __init__(self):
        self.blocks, self.releases = [], 0
        sizes = [ctypes.c_size_t] * 2
        self.functions = (ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, *sizes)(self.allocate),
                          ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p, *sizes)(self.release))
        self.table = [None, *(ctypes.cast(function, ctypes.c_void_p).value for function in self.functions)]

    def allocate(self, _, size, alignment):
        self.blocks.append(ctypes.create_string_buffer(size + alignment))
        address = ctypes.addressof(self.blocks[-1])
        return address + -address % alignment

    def release(self, *_):
        self.releases += 1

    def create(self, library, kind):
        handle, table = ctypes.c_void_p(), (ctypes.c_void_p * 3)(*self.table)
        create = getattr(library.dll, f"cd_{kind}_create")
        assert create(*SHAPES[kind][:-1], table, ctypes.byref(handle)) == OK, library.dll.cd_error_message()
        return handle


class Wrong:
    """What may be passed for an object, and is none of its kind. All its memory is looked at."""

    def __init__(self, library):
        self.heap, self.foreign = Heap(), ctypes.create_string_buffer(b"\1\2\3", FOREIGN_BYTES)
        self.living = {kind: self.heap.create(library, kind) for kind in SHAPES}
        self.dead = {kind: self.heap.create(library, kind) for kind in SHAPES}
        for kind, handle in self.dead.items():
            library.destroy(kind, handle)
        self.before = self.now()

    def of(self, kind):
        return {"a foreign block": ctypes.addressof(self.foreign), f"a destroyed {kind}": self.dead[kind],
                **{f"a living {other}": handle for other, handle in self.living.items() if other != kind}}

    def now(self):
        return self.heap.releases, self.foreign.raw, [block.raw for block in self.heap.blocks]

    def stays(self, what):
        now = self.now()
        check(now == self.before, f"{what} has been changed or destroyed")
        self.before = now


# ---- calls ----------------------------------------------------------------------------------------------------------


class Pointers(Calls):
    def make(self):
        handle = super().make()
        if self.function["short"] in BEFORE:
            name = f"cd_{self.kind}_{BEFORE[self.function['short']]}"
            before = Pointers(self.library, next(f for f in self.library.api["functions"] if f["name"] == name),
                              self.state, self.precision)
            before.objects = [handle]
            before.call(handle)
        return handle

    def call(self, handle, changes=None, element=None):
        if self.function["short"] in ("enable_field", "disable_field"):
            changes = {"field": self.library.enums["cd_field"][FORCE[self.kind]], **(changes or {})}
        trying(f"{self.name}: {self.what}")
        return super().call(handle, changes, element)

    def pointers(self, wrong, tried):
        optional = []
        for p in self.function["parameters"]:
            if "*" not in p["type"]:
                continue
            name = p["name"]
            tried.add((self.name, name))
            if p["null"]:
                optional.append(p)
            else:
                self.refused(f"null for {name}", name, {"CD_ERROR_NULL"}, "", {name: None})
            for what, handle in wrong.of(self.kind).items() if p["role"] in ("self", "handle") else ():
                self.refused(f"{what} for {name}", name, {"CD_ERROR_HANDLE"}, "", {name: handle})
                wrong.stays(f"{self.name}: {what} for {name}")
            for missing, table in tables(self.library, p, wrong.heap) if p["role"] == "callbacks" else ():
                self.refused(f"{name} without {missing}", missing, {"CD_ERROR_NULL"}, "",
                             {name: ctypes.addressof(table)})
        self.optional(optional)
        self.lengths({p["name"] for p in optional})
        self.empty_arrays()

    def optional(self, optional):
        """Null for each, and for all, that may be null: the call does and tells what else it would."""
        state = told(self.library, self.kind, self.taken("what is valid", {}), "hash")
        outputs = self.outputs
        for some in [[p] for p in optional] + [optional] * bool(optional):
            names = [p["name"] for p in some]
            what = f"null for {' and '.join(names)}"
            handle = self.taken(what, dict.fromkeys(names))
            for name in self.outputs.keys() - names:
                check(self.outputs[name] == outputs[name], f"{self.name}: {what} changes what {name} tells")
            check(told(self.library, self.kind, handle, "hash") == state or any(p["direction"] == "in" for p in some),
                  f"{self.name}: {what} changes the state")

    def lengths(self, optional):
        for p in self.function["parameters"]:
            if p["role"] == "length" and optional.issuperset(p["of"]) and self.function["short"] not in COUNTING:
                for number in (0, SIZE_MAX):
                    self.taken(f"{p['name']} {number} of null", {**dict.fromkeys(p["of"]), p["name"]: number,
                                                                 **MEANINGLESS.get(self.function["short"], {})})

    def empty_arrays(self):
        """A part of a field that is empty along one way, and no places to sample at, need no arrays."""
        parameters = self.function["parameters"]
        arrays = [p["name"] for p in parameters if p["role"] == "array"]
        lengths = [p["name"] for p in parameters if p["role"] == "length"]
        ways = [name for name in lengths if name == "n"]
        if any(p["base"] == "cd_field" for p in parameters):
            ways = [p["name"] for p in parameters if p["role"] == "value" and p["base"] == "size_t"
                    and not p["name"].startswith("first")]
        for way in ways if arrays else ():
            self.taken(f"null where {way} is 0", {**dict.fromkeys(arrays), **dict.fromkeys(lengths, 0), way: 0})


# ---- the tests ------------------------------------------------------------------------------------------------------


def creates_and_destroys(library, wrong, tried):
    for kind, shape in SHAPES.items():
        function = next(f for f in library.api["functions"] if f["name"] == f"cd_{kind}_create")
        name, (allocator, out) = function["name"], function["parameters"][-2:]
        codes = {error["code"] for error in function["errors"]}
        library.destroy(kind, library.create(kind))  # without an allocator
        for missing, table in [(out["name"], None), *tables(library, allocator, wrong.heap)]:
            handle = ctypes.c_void_p(UNTOUCHED)
            trying(f"{name}: without {missing}")
            library.dll.cd_chain_get_steps(None, None)  # leaves the message of another function
            status = getattr(library.dll, name)(*shape[:-1], table, ctypes.byref(handle) if table else None)
            message = library.dll.cd_error_message().decode()
            check(status == NULL and "CD_ERROR_NULL" in codes, f"{name}: without {missing}: {status}, {message}")
            check(message.startswith(f"{name}: ") and missing in message.split(), f"{name}: without {missing}: it says "
                                                                                  f"{message}")
            check(handle.value == UNTOUCHED, f"{name}: without {missing}: the output has been written")
        for what, handle in {"null": None, **wrong.of(kind)}.items():
            trying(f"cd_{kind}_destroy: {what}")
            library.destroy(kind, handle)
            wrong.stays(f"cd_{kind}_destroy: {what}")
        tried |= {(name, allocator["name"]), (name, out["name"]), (f"cd_{kind}_destroy", kind)}


def main():
    path, library = sys.argv[1:]
    child = os.fork()
    if child:
        status = os.waitpid(child, 0)[1]
        sys.exit(f"{AT[:].decode().strip()}: signal {status}" if os.WIFSIGNALED(status) else bool(status))
    library = Library(json.loads(Path(path).read_text(encoding="utf-8")), library)
    wrong, tried = Wrong(library), set()
    creates_and_destroys(library, wrong, tried)
    functions = [f for f in library.api["functions"] if f["object"]]
    for function in functions:
        states = STATES[function["object"]] if function["short"] not in ("create", "destroy") else ()
        for state, precision in ((state, precision) for state in states for precision in (FLOAT32, FLOAT64)):
            calls = Pointers(library, function, state, precision)
            if calls.call(calls.make()) == OK:
                calls.pointers(wrong, tried)
            calls.close()
    every = {(f["name"], p["name"]) for f in functions for p in f["parameters"] if "*" in p["type"]}
    check(tried == every, f"never tried: {sorted(every - tried)}")
    if FAILURES:
        sys.exit("\n".join(dict.fromkeys(FAILURES)))


if __name__ == "__main__":
    main()
