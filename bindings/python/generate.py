#!/usr/bin/env python3
"""Makes contdyn/_api.py from ../api.json: enumerations, fields, callbacks and the functions' types.

    generate.py            writes contdyn/_api.py
    generate.py --check    fails if contdyn/_api.py is not what would be written
"""
import json
import sys
import textwrap
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "generate"))
from description import pascal as class_name  # noqa: E402
from description import written_or_checked  # noqa: E402

DESCRIPTION = HERE.parent / "api.json"
OUTPUT = HERE / "contdyn" / "_api.py"

# What the functions' texts in _api.py call the types, and what ctypes calls them.
TYPES = {
    "handle": "c_void_p",
    "pointer": "c_void_p",
    "status": "c_int32",
    "int": "c_int32",
    "uint": "c_uint32",
    "uint64": "c_uint64",
    "size": "c_size_t",
    "double": "c_double",
    "text": "c_char_p",
    "nothing": "None",
    "handle*": "POINTER(c_void_p)",
    "pointer*": "POINTER(c_void_p)",
    "int*": "POINTER(c_int32)",
    "uint64*": "POINTER(c_uint64)",
    "size*": "POINTER(c_size_t)",
    "double*": "POINTER(c_double)",
    "Allocator*": "POINTER(Allocator)",
    "Parallel*": "POINTER(Parallel)",
    "Distance*": "POINTER(Distance)",
}
WORDS = {
    "int32_t": "int",
    "uint32_t": "uint",
    "uint64_t": "uint64",
    "size_t": "size",
    "double": "double",
    "cd_status": "status",
    "const char*": "text",
    "void": "nothing",
}
ROLES = {
    "self": "handle",
    "handle": "handle",
    "array": "pointer",
    "bytes": "pointer",
    "created": "handle*",
    "address": "pointer*",
}
WIDTH = 120


def type_of(parameter, enums):
    role, base = parameter["role"], parameter["base"]
    if role in ROLES:
        return ROLES[role]
    if role == "callbacks":
        return f"{class_name(base)}*"
    word = "int" if base in enums else WORDS[base]
    return f"{word}*" if role == "result" else word


def python_words(text):
    """A comment of the C API, as Python calls what it names."""
    for c_word, python_word in (("cd_*_", ""), ("CD_PIN", "Field.PIN"), ("CD_TARGET", "Field.TARGET"),
                                ("CD_NODE_", "Node."), ("CD_METHOD_", "Method."), ("CD_SOLVER_", "Solver."),
                                ("CD_BED_", "BedRule.")):
        text = text.replace(c_word, python_word)
    return " ".join(text.split())


def enumeration(enum):
    yield f"class {class_name(enum['name'])}(IntEnum):"
    doc = python_words(enum["doc"]) or "What a call of the C API returns."
    yield from textwrap.wrap(f'"""{doc}"""', WIDTH, initial_indent="    ", subsequent_indent="    ")
    yield ""
    for value in enum["values"]:
        if value["doc"]:
            yield from textwrap.wrap(python_words(value["doc"]), WIDTH, initial_indent="    #: ",
                                     subsequent_indent="    #: ")
        yield f"    {value['short'].upper()} = {value['value']}"


def prototype(member):
    types = [{"void*": "c_void_p", "size_t": "c_size_t", "double": "c_double", "const double*": "c_void_p",
              "double*": "c_void_p", "void": "None"}.get(part.get("type", ""))
             or f"{part['name'].upper()}_FUNCTION" for part in member["parameters"]]
    returns = {"void*": "c_void_p", "void": "None"}[member["returns"]]
    return f"{member['name'].upper()}_FUNCTION = CFUNCTYPE({', '.join([returns, *types])})"


def callbacks(struct):
    functions = [member for member in struct["members"] if member["function"]]
    for member in functions:
        for parameter in member["parameters"]:
            if parameter.get("function"):
                yield prototype(parameter)
        yield prototype(member)
    yield ""
    yield ""
    yield f"class {class_name(struct['name'])}(Structure):"
    yield f'    """{struct["name"]}."""'
    yield ""
    yield "    _fields_ = ["
    for member in struct["members"]:
        kind = f"{member['name'].upper()}_FUNCTION" if member["function"] else "c_void_p"
        yield f'        ("{member["name"]}", {kind}),'
    yield "    ]"


FLAGS = ("components", "always", "viewable", "lengths", "own_in_ropes", "read_only")


def fields(a_object):
    yield f'    "{a_object["name"]}": {{'
    for field in a_object["fields"]:
        per = ", ".join(f'"{place}"' for place in field["per"])
        per += "," if len(field["per"]) == 1 else ""
        flags = ", ".join(str(field[flag]) for flag in FLAGS)
        yield f'        Field.{field["name"][3:]}: FieldInfo(({per}), {flags}),'
    yield "    },"


def function(entry, enums):
    words = ", ".join(f"{p['name']} {type_of(p, enums)}" for p in entry["parameters"])
    start = f'    "{entry["name"]}": '
    lines = textwrap.wrap(f"{WORDS[entry['returns']]}: {words}".strip(), WIDTH - len(start) - 4, break_long_words=False)
    texts = [f'"{line} "' for line in lines[:-1]] + [f'"{lines[-1]}"']
    if len(texts) == 1:
        return [f"{start}{texts[0]},"]
    return [f"{start}({texts[0]}", *(" " * (len(start) + 1) + text for text in texts[1:-1]),
            " " * (len(start) + 1) + f"{texts[-1]}),"]


def module(api):
    enums = {enum["name"] for enum in api["enums"]}
    yield '"""The C API as data. Made by generate.py from ../api.json: do not edit."""'
    yield "from ctypes import CFUNCTYPE, POINTER, Structure"
    yield "from ctypes import c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p"
    yield "from enum import IntEnum"
    yield "from typing import Any, Dict, NamedTuple, Tuple"
    yield ""
    yield f"VERSION = ({', '.join(str(macro['value']) for macro in api['macros'])})"
    for enum in api["enums"]:
        yield ""
        yield ""
        yield from enumeration(enum)
    yield ""
    yield ""
    yield "class FieldInfo(NamedTuple):"
    doc = ("One value per what, and for each component; always there; shown by view; only with rest lengths, in ropes "
           "and cloth; per strand only in ropes; not to be written.")
    yield from textwrap.wrap(f'"""{doc}"""', WIDTH, initial_indent="    ", subsequent_indent="    ")
    yield ""
    yield "    per: Tuple[str, ...]"
    yield from (f"    {flag}: bool" for flag in FLAGS)
    yield ""
    yield ""
    yield "FIELDS: Dict[str, Dict[int, FieldInfo]] = {"
    for a_object in api["objects"]:
        yield from fields(a_object)
    yield "}"
    for struct in api["callbacks"]:
        yield ""
        yield from callbacks(struct)
        yield ""
    yield ""
    yield "TYPES: Dict[str, Any] = {"
    yield from (f'    "{word}": {kind},' for word, kind in TYPES.items())
    yield "}"
    yield ""
    yield "# What each function returns: its parameters' names and types."
    yield "FUNCTIONS: Dict[str, str] = {"
    for entry in api["functions"]:
        yield from function(entry, enums)
    yield "}"


def main():
    text = "\n".join(module(json.loads(DESCRIPTION.read_text(encoding="utf-8")))) + "\n"
    written_or_checked(__doc__, {OUTPUT: text})


if __name__ == "__main__":
    main()
