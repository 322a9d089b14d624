#!/usr/bin/env python3
"""Makes contdyn.mjs, contdyn.d.ts and exports.txt from ../api.json.

    generate.py            writes them
    generate.py --check    fails if they are not what would be written

What a function of the C API becomes follows from its parameters alone, by the rules in README.md. A function that no
rule covers is an error.
"""
import json
import re
import sys
import textwrap
from pathlib import Path

HERE = Path(__file__).resolve().parent
DESCRIPTION = HERE.parent / "api.json"
WIDTH = 120

# Functions of the C library that the binding calls.
LIBC = ["malloc", "free"]
# Numbers that a call may leave out at its end, as it may arrays that may be null.
DEFAULTS = {("step", "count"): "1", ("sample", "outside"): '"refused"', ("sample_heads", "outside"): '"refused"',
            ("set_plane", "friction"): "0", ("set_capsule", "friction"): "0",
            ("set_side", "value"): "0", ("set_side", "rate"): "0"}
PRECISION = ("float64", "float32")

ARRAYS = {"float": "Float32Array", "double": "Float64Array", "int32_t": "Int32Array", "uint32_t": "Uint32Array",
          "uint64_t": "BigUint64Array", "size_t": "Uint32Array"}
# Said of pointers, which are none here.
MAY_BE_NULL = re.compile(r"\s*(each|all) (output )?may\s+be\s+null\.?|,\s+which\s+may\s+be\s+null,|"
                         r"\s*allocator\s+may\s+be\s+null\s+\(malloc\)\.|"
                         r"\s*The\s+caller\s+owns\s+\*out_\w+\s+and\s+releases\s+it\s+with\s+\w+;\s+on\s+failure\s+"
                         r"\*out_\w+\s+is\s+left\s+alone\.", re.IGNORECASE)
RESERVED = {"default", "delete", "function", "in", "new", "with", "arguments", "class", "this"}


class NotUnderstood(Exception):
    pass


# ---- names -----------------------------------------------------------------------------------------------------------


def camel(name):
    head, *rest = name.split("_")
    return head + "".join(part.capitalize() for part in rest)


def pascal(name):
    return "".join(part.capitalize() for part in name.split("_"))


def enum_name(c_name):
    """cd_mass_rule -> MassRule."""
    return pascal(c_name[3:])


def variable(name):
    word = camel(name)
    return word + "_" if word in RESERVED else word


def result_name(parameter):
    return camel(parameter["name"][len("out_"):])


class Api:
    def __init__(self, api):
        self.api = api
        self.enums = {enum["name"]: enum for enum in api["enums"]}
        self.objects = {thing["name"]: thing for thing in api["objects"]}
        self.handles = {thing["handle"]: thing["name"] for thing in api["objects"]}
        self.of = {name: {f["short"]: f for f in api["functions"] if f["object"] == name}
                   for name in [None, *self.objects]}
        self.values = {}
        for enum in api["enums"]:
            for value in enum["values"]:
                self.values[value["name"]] = f'"{camel(value["short"])}"'

    def words(self, doc, thing):
        """A comment of the C API, as this binding calls what it names."""
        text = re.sub(MAY_BE_NULL, "", doc)
        text = re.sub(r"\bcd_\*_(\w+)", lambda m: camel(m[1]), text)
        text = re.sub(r"\bcd_(\w+)", self.spoken, text)
        text = re.sub(r'(?<!")\bCD_[A-Z0-9_]+\b(?!")', lambda m: self.values.get(m[0], m[0]), text)
        text = re.sub(r"\bSIZE_MAX\b", "null", re.sub(r"\bINFINITY\b", "Infinity", text))
        text = re.sub(r"\bout_(\w+)", lambda m: camel(m[1]), text)
        names = {p["name"] for f in self.of.get(thing, {}).values() for p in f["parameters"]}
        return re.sub(r"\b[a-z]+(_[a-z0-9]+)+\b", lambda m: camel(m[0]) if m[0] in names else m[0], text)

    def spoken(self, match):
        name = match[0]
        if name in self.enums:
            return enum_name(name)
        if name in self.handles:
            return pascal(self.handles[name])
        if name[3:] in self.of[None]:
            return camel(name[3:])
        for thing, functions in self.of.items():
            short = name[len(f"cd_{thing}_" if thing else "cd_"):]
            if name == f"cd_{thing}_{short}" and short in functions:
                return self.public_name(functions[short])
        return name

    def public_name(self, function):
        short = function["short"]
        if short in ("create", "destroy"):
            return f"new {pascal(function['object'])}" if short == "create" else "dispose"
        if self.is_property(function):
            return camel(short[4:])
        return camel(re.sub(r"_f(32|64)$", "", short))

    # -- what a function is --

    def getter_of(self, function):
        short = function["short"]
        if short.startswith(("get_", "set_")):
            getter = self.of[function["object"]].get("get_" + short[4:])
            if getter and all(p["role"] in ("self", "result", "array", "length") and p["direction"] == "out"
                              or p["role"] in ("self", "length") for p in getter["parameters"]):
                return getter
        return None

    def is_property(self, function):
        return self.getter_of(function) is not None

    @staticmethod
    def left_out(function):
        return function["short"] != "create" and any(p["role"] == "callbacks" for p in function["parameters"])

    @staticmethod
    def results(function):
        return [p for p in function["parameters"] if p["direction"] == "out" and p["role"] in ("result", "array")]

    @staticmethod
    def inputs(function):
        """What a caller gives; lengths only where nothing else tells them."""
        return [p for p in function["parameters"] if p["role"] in ("value", "handle", "bytes")
                or p["role"] == "array" and p["direction"] == "in" or Api.is_given(function, p)]

    @staticmethod
    def is_given(function, parameter):
        """A length that the caller must tell: of arrays that are only results, and hold neither a number per component
        nor one per component for each item of another array."""
        if parameter["role"] != "length":
            return False
        counted = [p for p in function["parameters"] if p["name"] in parameter["of"]]
        if any(p["direction"] != "out" or p["role"] == "bytes" for p in counted):
            return False
        others = [p for p in function["parameters"] if p["role"] == "length" and p is not parameter]
        per_component = parameter["name"] == "count" or parameter["name"] == "out_count" and len(others) == 1
        return function.get("no_components", False) or not per_component

    # -- a call --

    def argument(self, function, p):
        """An argument as the function of the library takes it."""
        name, what = variable(p["name"]), f'"{camel(p["name"])}"'
        if p["role"] == "handle":
            return f"addressOf({name}, {pascal(self.handles[p['base']])}, {what})"
        if p["role"] == "callbacks":
            return "0"
        if p["base"] in self.enums:
            return f"member({enum_name(p['base'])}, {name}, {what})"
        if p["base"] == "double":
            return f"number({name}, {what})"
        if p["base"] == "int32_t":
            return f"flag({name}, {what})"
        if may_be_none(function, p):
            return f"sizeOrNone({name}, {what})"
        if p["base"] in ("size_t", "uint32_t"):
            return f"size({name}, {what})"
        if p["base"] == "uint64_t":
            return f"BigInt(size({name}, {what}))"
        raise NotUnderstood(f"{function['name']}: {p['name']}")

    def taken(self, function, p, k):
        """The result number k, taken from where the call left it."""
        if p["base"] in self.enums:
            return f"nameOf({enum_name(p['base'])}, integer({k}))"
        if p["base"] == "int32_t":
            return f"integer({k}) !== 0"
        if p["base"] == "uint64_t":
            return f"bits({k})" if "hash" in p["name"] else f"count({k})"
        return {"double": "real", "size_t": "whole", "uint32_t": "whole"}[p["base"]] + f"({k})"

    def length(self, function, p, lines):
        """How many items the arrays of a length have."""
        arrays = [q for q in function["parameters"] if q["name"] in p["of"]]
        given = [q for q in arrays if q["direction"] != "out" or q["role"] == "bytes"]
        if given:
            first = min((q for q in given if q["role"] == "bytes" or isinstance(q["times"], int)),
                        key=lambda q: q["times"])
            array = f"{camel(q_name(first))}At"
            length = f"{array}.length" if first["times"] == 1 else \
                f'items({array}, {first["times"]}, "{camel(first["name"])}")'
            for other in given:
                if other is not first:
                    times = f" * {length if other['times'] == p['name'] else other['times']}"
                    lines.append(f'expect({camel(q_name(other))}At, {length}{"" if times == " * 1" else times}, '
                                 f'"{camel(other["name"])}");')
            return length
        if self.is_given(function, p):
            return f'size({variable(p["name"])}, "{camel(p["name"])}")'
        if "out_load" in p["of"]:  # force and moment, in any number of components
            return "6"
        others = [q for q in function["parameters"] if q["role"] == "length" and q is not p]
        items = "".join(f"{camel(q['name'])} * " for q in others)
        return f"{items}componentsOf(this)"

    def call(self, function, values=None):
        """The lines of a method's body."""
        lines, after, arguments = [], [], []
        parameters = function["parameters"]
        stored = [p for p in parameters if p["role"] in ("array", "bytes")]
        self_at = "address"
        if any(p["role"] == "self" for p in parameters):
            lines.append(f"const address = addressOf(this, {pascal(function['object'])});")
        if stored:
            lines.append("begin();")
        for p in stored:
            name, at = variable(p["name"]), f"{camel(q_name(p))}At"
            if p["role"] == "bytes":
                lines.append(f'const {at} = putBytes({name}, "{camel(p["name"])}");')
                if p["direction"] != "in":
                    after.append(f"getBytes({name}, {at});")
            elif p["direction"] == "in":
                optional = ", true" if p["null"] else ""
                lines.append(f'const {at} = put({name}, {ARRAYS[p["base"]]}, "{camel(p["name"])}"{optional});')
        lengths = {}
        for p in sorted((p for p in parameters if p["role"] == "length"), key=lambda p: p["name"] == "out_count"):
            length = self.length(function, p, lines)
            lines.append(f"const {camel(p['name'])}Of = {length};")
            lengths[p["name"]] = f"{camel(p['name'])}Of"
        # a length that is counted by another one
        lines = [re.sub(r"= (\w+) \* componentsOf", lambda m: f"= {m[1]}Of * componentsOf", line) for line in lines]
        outputs, k = [], 0
        for p in parameters:
            at = f"{camel(q_name(p))}At"
            if p["role"] == "self":
                arguments.append(self_at)
            elif p["role"] == "length":
                arguments.append(lengths[p["name"]])
            elif p["role"] in ("array", "bytes") and (p["direction"] == "in" or p["role"] == "bytes"):
                arguments.append(f"{at}.address")
            elif p["role"] == "array":
                count = lengths[p["length"]] + ("" if p["times"] == 1 else f" * {p['times']}")
                room = f"take({ARRAYS[p['base']]}.BYTES_PER_ELEMENT * {count})"
                given = next(q for q in parameters if q["name"] == p["length"])
                if p["null"] and self.is_given(function, given):
                    room = f"{lengths[p['length']]} === 0 ? 0 : {room}"
                lines.append(f"const {at} = {room};")
                arguments.append(at)
                outputs.append((p, f"got({at}, {ARRAYS[p['base']]}, {count})"))
            elif p["role"] in ("result", "created"):
                arguments.append(f"result({k})")
                if p["role"] == "result":
                    outputs.append((p, self.taken(function, p, k)))
                k += 1
            else:
                arguments.append(self.argument(function, p))
        called = f"wasm.{function['name']}({', '.join(arguments)})"
        if function["returns"] == "cd_status":
            lines.append(f"check({called});")
        elif function["returns"] == "const char*":
            outputs.append((None, f"text({called})"))
        elif function["returns"] == "uint32_t":
            outputs.append((None, f"{called} >>> 0"))
        elif function["returns"] == "void" and not outputs:
            lines.append(f"{called};")
        else:
            raise NotUnderstood(f"{function['name']} returns {function['returns']}")
        lines += after
        if len(outputs) == 1:
            lines.append(f"return {outputs[0][1]};")
        elif outputs:
            lines.append("return {")
            lines += [f"  {result_name(p)}: {value}," for p, value in outputs]
            lines.append("};")
        if lines[0] == "const address = addressOf(this, " + pascal(function["object"] or "") + ");" and not stored:
            lines = [line.replace("(address", f"(addressOf(this, {pascal(function['object'])})", 1)
                     for line in lines[1:]]
        return lines


def may_be_none(function, p):
    """Whether a size may be SIZE_MAX, for none."""
    return p["base"] == "size_t" and bool(re.search(rf"\b{p['name']}( or \w+)? SIZE_MAX", function["doc"]))


def q_name(p):
    return p["name"][len("out_"):] if p["name"].startswith("out_") else p["name"]


# ---- contdyn.mjs -----------------------------------------------------------------------------------------------------


def wrapped(text, indent):
    """Code broken at commas where it is too long."""
    line = " " * indent + text
    if len(line) <= WIDTH:
        return [line]
    return textwrap.wrap(text, WIDTH, initial_indent=" " * indent, subsequent_indent=" " * (indent + 2),
                         break_long_words=False, break_on_hyphens=False)


def default(function, p):
    """What stands for a parameter that is left out, or None."""
    if p["role"] == "array" and p["null"]:
        return "null"
    if p["role"] == "length" and all(q["null"] for q in function["parameters"] if q["name"] in p["of"]):
        return "0"
    return DEFAULTS.get((function["short"], p["name"]))


def how_many_needed(function, inputs):
    """The parameters at the end that may be left out come after these."""
    needed = len(inputs)
    while needed and default(function, inputs[needed - 1]):
        needed -= 1
    return needed


def listed(function):
    """Names of a method's parameters, with the defaults of those at its end."""
    inputs = Api.inputs(function)
    needed = how_many_needed(function, inputs)
    return ", ".join(variable(p["name"]) + (f" = {default(function, p)}" if i >= needed else "")
                     for i, p in enumerate(inputs))


class Module:
    def __init__(self, api):
        self.api = api

    def text(self):
        api = self.api
        yield "// contdyn: ropes, hair, sheets, drums and water. Made by generate.py from ../api.json: do not edit."
        yield "import {"
        yield from textwrap.wrap(
            "Handle, addressOf, assign, begin, bits, check, componentsOf, count, enumeration, expect, flag, "
            "getBytes, got, integer, items, knowStatuses, member, nameOf, number, optionsOf, put, putBytes, "
            "readField, real, result, several, size, sizeOrNone, take, text, viewField, wasm, whole, writeField,",
            WIDTH, initial_indent="  ", subsequent_indent="  ")
        yield '} from "./runtime.mjs";'
        yield ""
        yield 'export { ContdynError, load } from "./runtime.mjs";'
        yield ""
        yield f'export const VERSION = "{api.api["version"]}";'
        for enum in api.api["enums"]:
            yield ""
            yield f"export const {enum_name(enum['name'])} = enumeration({{"
            yield from (f"  {camel(value['short'])}: {value['value']}," for value in enum["values"])
            yield "});"
        yield "knowStatuses(Status);"
        for function in api.of[None].values():
            yield ""
            yield f"export function {camel(function['short'])}({listed(function)}) {{"
            for line in api.call(function):
                yield from wrapped(line, 2)
            yield "}"
        for thing in api.objects.values():
            yield from self.a_class(thing)

    def a_class(self, thing):
        api, name, functions = self.api, thing["name"], self.api.of[thing["name"]]
        Name = pascal(name)
        create = functions["create"]
        made_with = [p for p in create["parameters"] if p["role"] == "value"]
        has_components = any(p["name"] == "components" for p in made_with)
        needed = [p for p in made_with if p["base"] != "cd_precision"]
        for function in functions.values():
            function["no_components"] = not has_components
        names = [variable(p["name"]) for p in made_with]
        kind = f"k{Name}"
        yield ""
        yield f"export class {Name} extends Handle {{"
        yield "  constructor(options) {"
        defaults = [f'{n} = "{PRECISION[0]}"' if p["base"] == "cd_precision" else n for n, p in zip(names, made_with)]
        quoted = ", ".join(f'"{variable(p["name"])}"' for p in needed)
        yield from wrapped(f'const {{ {", ".join(defaults)} }} = optionsOf(options, "{Name}", [{quoted}]);', 4)
        for line in api.call(create):
            yield from wrapped(line, 4)
        yield f"    super(wasm.cd_{name}_destroy, {'components' if has_components else 1});"
        every = ", ".join(f'"{n}"' for n in names)
        yield from wrapped(f"assign(this, options, [{every}]);", 4)
        yield f"    if (new.target === {Name}) Object.preventExtensions(this); // a property that is misspelt throws"
        yield "  }"
        members = {"dispose", "disposed"}

        def fresh(member):
            if member in members:
                raise NotUnderstood(f"{name}: two members would be called {member}")
            members.add(member)

        for short, function in functions.items():
            if short in ("create", "destroy", "save_size") or api.left_out(function):
                if short == "save_size":
                    fresh("saveSize")
                    yield from self.method("saveSize", function)
                continue
            if api.is_property(function):
                if short.startswith("get_"):
                    fresh(camel(short[4:]))
                    yield from self.property(function, functions.get("set_" + short[4:]))
            elif short.endswith("_f64") and short[:-4] + "_f32" in functions:
                fresh(camel(short[:-4]))
                yield ""
                if short == "read_f64":
                    yield "  read(field, range, out) {"
                    yield f"    return readField(this, {kind}, field, range, out);"
                elif short == "write_f64":
                    yield "  write(field, values, range) {"
                    yield f"    writeField(this, {kind}, field, values, range);"
                else:
                    raise NotUnderstood(function["name"])
                yield "  }"
            elif short.endswith("_f32") and short[:-4] + "_f64" in functions:
                continue
            elif short == "view":
                fresh("view")
                yield ""
                yield "  view(field) {"
                yield f"    return viewField(this, {kind}, field);"
                yield "  }"
                for field in thing["fields"]:
                    if field["viewable"]:
                        own = camel(field["name"][3:].lower())
                        fresh(own)
                        yield ""
                        yield f"  get {own}() {{"
                        yield f'    return viewField(this, {kind}, "{own}");'
                        yield "  }"
                        yield ""
                        yield f"  set {own}(values) {{"
                        yield f'    writeField(this, {kind}, "{own}", values);'
                        yield "  }"
            elif short == "save":
                fresh("save")
                yield ""
                yield "  save() {"
                yield "    const size = this.saveSize();"
                yield "    begin();"
                yield "    const at = take(size);"
                yield f"    check(wasm.cd_{name}_save(addressOf(this, {Name}), at, size, result(0)));"
                yield "    return got(at, Uint8Array, whole(0));"
                yield "  }"
            else:
                fresh(camel(short))
                yield from self.method(camel(short), function)
        yield "}"
        yield ""
        yield f"const {kind} = {{"
        yield f'  name: "{name}",'
        yield f"  Class: {Name},"
        yield "  Field,"
        ranges = [p for p in functions["read_f64"]["parameters"] if p["role"] == "value" and p["base"] == "size_t"]
        quoted = ", ".join('"' + camel(p["name"]) + '"' for p in ranges)
        yield f"  range: [{quoted}],"
        yield f"  reversed: {'false' if ranges[0]['name'] == 'first_strand' else 'true'},"
        yield "  fields: {"
        yield "    __proto__: null,"
        for field in thing["fields"]:
            per = ", ".join(f'"{place}"' for place in field["per"])
            flags = [f"{camel(flag)}: true" for flag in ("components", "own_in_ropes") if field[flag]]
            yield f"    {camel(field['name'][3:].lower())}: {{ {', '.join([f'per: [{per}]', *flags])} }},"
        yield "  },"
        yield "};"

    def method(self, name, function):
        yield ""
        yield f"  {name}({listed(function)}) {{"
        for line in self.api.call(function):
            yield from wrapped(line, 4)
        yield "  }"

    def property(self, getter, setter):
        name = camel(getter["short"][4:])
        yield ""
        yield f"  get {name}() {{"
        for line in self.api.call(getter):
            yield from wrapped(line, 4)
        yield "  }"
        if not setter or self.api.left_out(setter):
            return
        inputs = [variable(p["name"]) for p in self.api.inputs(setter)]
        yield ""
        if len(inputs) == 1:
            yield f"  set {name}({inputs[0]}) {{"
        else:
            yield f"  set {name}(numbers) {{"
            quoted = ", ".join(f'"{word}"' for word in inputs)
            yield from wrapped(f"const {{ {', '.join(inputs)} }} = several(numbers, () => this.{name}, \"{name}\", "
                               f"[{quoted}]);", 4)
        for line in self.api.call(setter):
            yield from wrapped(line, 4)
        yield "  }"


# ---- contdyn.d.ts ----------------------------------------------------------------------------------------------------


class Types:
    def __init__(self, api):
        self.api = api
        self.told = None

    def comment(self, doc, indent, thing=None, also=""):
        """A comment, once for functions that share it."""
        text = self.api.words(doc, thing).strip()
        if also:
            text = f"{text}\n{also}".strip()
        if not text:
            return
        pad = " " * indent
        lines = [line for part in text.split("\n")
                 for line in (textwrap.wrap(part, WIDTH - indent - 3) if len(part) > WIDTH - indent - 3 else [part])]
        if len(lines) == 1 and len(lines[0]) + indent + 7 <= WIDTH:
            yield f"{pad}/** {lines[0]} */"
            return
        yield f"{pad}/**"
        yield from (f"{pad} * {line}".rstrip() for line in lines)
        yield f"{pad} */"

    def text(self):
        api = self.api
        yield "// The types of contdyn. Made by generate.py from ../api.json: do not edit."
        yield from (HERE / "runtime.d.ts.in").read_text(encoding="utf-8").splitlines()
        yield ""
        yield "export const VERSION: string;"
        for enum in api.api["enums"]:
            yield ""
            name = enum_name(enum["name"])
            yield from self.comment(enum["doc"] or "What a call of the library came to.", 0)
            yield f"export const {name}: {{"
            for value in enum["values"]:
                yield from self.comment(value["doc"], 2)
                yield f"  readonly {camel(value['short'])}: {value['value']};"
            yield "};"
            yield f"export type {name} = keyof typeof {name};"
        for function in api.of[None].values():
            yield ""
            yield from self.comment(function["doc"], 0)
            yield f"export function {camel(function['short'])}({self.parameters(function)}): {self.returned(function)};"
        for thing in api.objects.values():
            yield from self.a_class(thing)

    def type_of(self, p, function=None):
        if p["base"] in self.api.enums:
            return enum_name(p["base"])
        if p["role"] == "handle":
            return pascal(self.api.handles[p["base"]])
        if p["role"] == "bytes":
            return "ArrayBuffer | ArrayBufferView"
        if p["role"] == "array":
            return ARRAYS[p["base"]] if p["direction"] == "out" else "Numbers" + (" | null" if p["null"] else "")
        if p["base"] == "int32_t":
            return "boolean"
        if p["base"] == "uint64_t" and "hash" in p["name"]:
            return "bigint"
        return "number | null" if function and may_be_none(function, p) else "number"

    def parameters(self, function):
        inputs = self.api.inputs(function)
        needed = how_many_needed(function, inputs)
        return ", ".join(f"{variable(p['name'])}{'?' if i >= needed else ''}: {self.type_of(p, function)}"
                         for i, p in enumerate(inputs))

    def returned(self, function):
        results = self.api.results(function)
        if function["returns"] == "const char*":
            return "string"
        if function["returns"] == "uint32_t":
            return "number"
        if not results:
            return "void"
        if len(results) == 1:
            return self.type_of(results[0])
        return "{ " + "; ".join(f"{result_name(p)}: {self.type_of(p)}" for p in results) + " }"

    def a_class(self, thing):
        api, name = self.api, thing["name"]
        functions, Name = api.of[name], pascal(name)
        viewable = [camel(f["name"][3:].lower()) for f in thing["fields"] if f["viewable"]]
        fields = [camel(f["name"][3:].lower()) for f in thing["fields"]]
        sections = {s["title"]: s["doc"] for s in api.api["sections"] if s["header"] == thing["header"]}
        ranges = [p for p in functions["read_f64"]["parameters"] if p["role"] == "value" and p["base"] == "size_t"]
        create = functions["create"]
        yield ""
        yield from self.comment("The fields of a " + Name + ".\n\n" + sections.get("fields", ""), 0, name)
        yield from wrapped(f"export type {Name}Field = " + " | ".join(f'"{f}"' for f in fields) + ";", 0)
        yield ""
        yield "/** Part of a field; what is left out is all the rest. */"
        yield f"export interface {Name}Range {{"
        yield from (f"  {camel(p['name'])}?: number;" for p in ranges)
        yield "}"
        yield ""
        yield "/** What it is made with, and then any property that can be set, in this order. */"
        yield f"export interface {Name}Options {{"
        for p in create["parameters"]:
            if p["role"] == "value":
                optional = "?" if p["base"] == "cd_precision" else ""
                default = ' // default "float64"' if optional else ""
                yield f"  {variable(p['name'])}{optional}: {self.type_of(p)};{default}"
        for short, function in functions.items():
            if short.startswith("set_") and api.is_property(function) and not api.left_out(function):
                yield f"  {camel(short[4:])}?: {self.set_type(function)};"
        yield from (f"  {field}?: Numbers | number;" for field in viewable)
        yield "}"
        yield ""
        yield from self.comment(thing["doc"], 0, name)
        yield f"export class {Name} extends Handle {{"
        yield from self.comment(create["doc"], 2, name)
        yield f"  constructor(options: {Name}Options);"
        section = None
        for short, function in functions.items():
            if short in ("create", "destroy") or api.left_out(function):
                continue
            if function["section"] != section:
                section = function["section"]
                about = sections.get(section, "") if section != "fields" else ""
                yield ""
                yield f"  // ---- {section} " + "-" * max(3, WIDTH - 11 - len(section))
                for line in api.words(about, name).splitlines():
                    yield from textwrap.wrap(line, WIDTH, initial_indent="  // ", subsequent_indent="  // ") or ["  //"]
            yield from self.a_member(name, short, function, viewable)
        yield "}"

    def set_type(self, setter):
        inputs = self.api.inputs(setter)
        if len(inputs) == 1:
            return self.type_of(inputs[0])
        return "{ " + "; ".join(f"{variable(p['name'])}?: {self.type_of(p)}" for p in inputs) + " }"

    def a_member(self, name, short, function, viewable):
        api, Name = self.api, pascal(name)
        if api.is_property(function):
            setter = api.of[name].get("set_" + short[4:])
            if setter and api.left_out(setter):
                setter = None
            if short.startswith("set_"):
                return
            yield ""
            yield from self.comment((setter or function)["doc"], 2, name)
            yield f"  get {camel(short[4:])}(): {self.returned(function)};"
            if setter:
                yield f"  set {camel(short[4:])}(value: {self.set_type(setter)});"
        elif short == "read_f64":
            yield ""
            yield from self.comment(function["doc"], 2, name, "Without `out` a new array, of the object's precision.")
            yield f"  read(field: {Name}Field, range?: {Name}Range): Float32Array | Float64Array;"
            yield (f"  read<A extends Float32Array | Float64Array>(field: {Name}Field, range: {Name}Range | undefined, "
                   "out: A): A;")
        elif short == "write_f64":
            yield ""
            yield from self.comment(function["doc"], 2, name, "One number stands for all places.")
            yield f"  write(field: {Name}Field, values: Numbers | number, range?: {Name}Range): void;"
        elif short in ("read_f32", "write_f32"):
            return
        elif short == "view":
            yield ""
            yield from self.comment(function["doc"], 2, name, "Here as a `View`, which follows the field.")
            yield f"  view(field: {Name}Field): View;"
            for field in viewable:
                yield ""
                yield f"  /** `view(\"{field}\")`; assigned, the field is written. */"
                yield f"  get {field}(): View;"
                yield f"  set {field}(values: Numbers | number);"
        elif short == "save":
            yield ""
            yield from self.comment(function["doc"], 2, name)
            yield "  save(): Uint8Array;"
        else:
            yield ""
            yield from self.comment(function["doc"], 2, name)
            yield from wrapped(f"{camel(short)}({self.parameters(function)}): {self.returned(function)};", 2)


# ---- the files -------------------------------------------------------------------------------------------------------


def files():
    api = Api(json.loads(DESCRIPTION.read_text(encoding="utf-8")))
    names = [function["name"] for function in api.api["functions"] if not api.left_out(function)]
    return {
        "contdyn.mjs": "\n".join(Module(api).text()) + "\n",
        "contdyn.d.ts": "\n".join(Types(api).text()) + "\n",
        "exports.txt": "\n".join(f"--export={name}" for name in [*names, *LIBC]) + "\n",
    }


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    try:
        made = files()
    except NotUnderstood as why:
        sys.exit(f"generate.py: not understood: {why}")
    for name, text in made.items():
        path = HERE / name
        if not sys.argv[1:]:
            path.write_text(text, encoding="utf-8")
        elif path.read_text(encoding="utf-8") != text:
            sys.exit(f"{name} is out of date: run bindings/javascript/generate.py")


if __name__ == "__main__":
    main()
