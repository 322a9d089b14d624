#!/usr/bin/env python3
"""Holds contdyn.hpp to bindings/api.json.

    check_description.py API HEADER COMMAND...   COMMAND compiles a C++ file from standard input without output:
                                                 every enumerator has its value, every C function its type, every method
                                                 the type that the description gives it; the header calls every function
    check_description.py calls API NM PROGRAM... the test programs together call every function of the library
"""
import json
import re
import subprocess
import sys
from pathlib import Path

PLAIN = {"size_t": "std::size_t", "uint64_t": "std::uint64_t", "int32_t": "bool"}  # an int32_t is a flag


def fail(what):
    sys.exit(f"check_description: {what}")


def differ(found, described, what):
    if found != described:
        fail(f"{what}: not described: {sorted(found - described)}; missing: {sorted(described - found)}")


def enumerator(value):
    return value["short"] + "_" * (value["short"] == "auto")  # a keyword


class Check:
    def __init__(self, api):
        self.api, self.enums = api, [enum["name"] for enum in api["enums"]]

    def plain(self, base):
        return f"contdyn::{base[3:]}" if base in self.enums else PLAIN.get(base, base)

    def parameter(self, kind, p):
        """Its type in C++; "" if it is none there."""
        const = "const " if p["direction"] == "in" else ""
        return {
            "value": lambda: self.plain(p["base"]),
            "array": lambda: f"contdyn::span<{const}{p['base']}>",
            "bytes": lambda: "contdyn::bytes" if const else "contdyn::buffer",
            "handle": lambda: f"const contdyn::{kind}&",
            "callbacks": lambda: p["type"],
        }.get(p["role"], lambda: "")()

    def method(self, function):
        kind, name, own = function["object"], function["short"], function["parameters"][0]
        where, parameters = f"contdyn::{kind}", function["parameters"]
        types = [t for t in (self.parameter(kind, p) for p in parameters) if t]
        outputs = [p for p in parameters if p["role"] in ("result", "address")]
        const = " const" if own["direction"] == "in" else ""
        returned = "void"
        if len(outputs) == 1:
            returned = self.plain(outputs[0]["base"])
        elif outputs:
            object_of = f"std::declval<{'const ' if const else ''}{where}&>()"
            values = ", ".join(f"std::declval<{t}>()" for t in types)
            returned = f"decltype({object_of}.{name}({values}))"
        yield f"(void)static_cast<{returned} ({where}::*)({', '.join(types)}){const}>(&{where}::{name});"
        if len(outputs) > 1:
            for p in outputs:
                wanted = "const void*" if p["role"] == "address" else self.plain(p["base"])
                yield f"static_assert(std::is_same_v<decltype({returned}::{p['name'][4:]}), {wanted}>);"

    def lines(self):
        for enum in self.api["enums"]:
            for value in enum["values"]:
                name = f"contdyn::{enum['name'][3:]}::{enumerator(value)}"
                yield f"static_assert(static_cast<{enum['type']}>({name}) == {value['value']});"
                yield f"static_assert({value['name']} == {value['value']});"
        for macro in self.api["macros"]:
            yield f"static_assert({macro['name']} == {macro['value']});"
        for function in self.api["functions"]:
            types = ", ".join(p["type"] for p in function["parameters"])
            yield f"static_assert(std::is_same_v<decltype(&{function['name']}), {function['returns']} (*)({types})>);"
            if function["object"] is None:
                types = filter(None, (self.parameter(None, p) for p in function["parameters"]))
                values = ", ".join(f"std::declval<{t}>()" for t in types)
                yield f"static_assert(sizeof(contdyn::{function['short']}({values})) > 0);"
            elif function["short"] not in ("create", "destroy"):
                yield from self.method(function)
        for thing in self.api["objects"]:
            where = f"contdyn::{thing['name']}"
            create = next(f for f in self.api["functions"] if f["name"] == f"{thing['handle']}_create")
            types = ", ".join(t for t in (self.parameter(thing["name"], p) for p in create["parameters"]) if t)
            yield f"(void)static_cast<{where} (*)({types})>(&{where}::create);"
            yield f"static_assert(std::is_constructible_v<{where}, {types}>);"
            yield f"(void)static_cast<void ({where}::*)() noexcept>(&{where}::destroy);"


def check_header(api, header, command):
    text = re.sub(r"//.*", "", Path(header).read_text(encoding="utf-8"))
    functions = {f["name"] for f in api["functions"]}
    called = set(re.findall(r"\bcd_[a-z0-9_]+", text))
    types = {e["name"] for e in api["enums"]} | {c["name"] for c in api["callbacks"]} | {
        o["handle"] for o in api["objects"]}
    differ(called - types, functions, "functions in the header")
    for enum in api["enums"]:
        body = re.search(rf"enum class (?:\[\[nodiscard\]\] )?{enum['name'][3:]} : std::int32_t {{([^}}]*)}}", text)
        if not body:
            fail(f"the header has no enum class {enum['name'][3:]}")
        differ(set(re.findall(r"(\w+) = ", body.group(1))), {enumerator(v) for v in enum["values"]}, enum["name"])
    code = "#include <contdyn/contdyn.hpp>\n[[maybe_unused]] static void check() {\n" + "\n".join(Check(api).lines())
    compiled = subprocess.run(command, input=code + "\n}\n", text=True, capture_output=True, check=False)
    if compiled.returncode:
        fail(compiled.stderr)


def check_calls(api, nm, programs):
    undefined = "".join(subprocess.run([nm, "-D", "--undefined-only", "--format=posix", program], check=True, text=True,
                                       capture_output=True).stdout for program in programs)
    differ(set(re.findall(r"^(cd_\w+)", undefined, re.MULTILINE)), {f["name"] for f in api["functions"]},
           "functions that the tests call")


def main():
    first, *rest = sys.argv[1:]
    path = rest[0] if first == "calls" else first
    api = json.loads(Path(path).read_text(encoding="utf-8"))
    if first == "calls":
        check_calls(api, rest[1], rest[2:])
    else:
        check_header(api, rest[0], rest[1:])


if __name__ == "__main__":
    main()
