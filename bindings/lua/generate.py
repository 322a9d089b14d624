#!/usr/bin/env python3
"""Makes contdyn/api.lua and tests/every_function.lua from ../api.json.

    generate.py            writes them
    generate.py --check    fails if one of them is not what would be written
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "generate"))
import sweep  # noqa: E402
from description import Description, bound_context, comment, escaped, fitted, pascal, written_or_checked  # noqa: E402

KEYWORDS = set("and break do else elseif end false for function goto if in local nil not or repeat return then true "
               "until while self".split())
MADE = "Made by generate.py from ../api.json: do not edit."


def variable(name):
    return escaped(name, KEYWORDS, "{}_")


# ---- declarations ---------------------------------------------------------------------------------------------------


def member(entry, name):
    """A member of a struct, or a parameter of a function, in C."""
    if entry.get("function"):
        parameters = ", ".join(member(p, p["name"]) for p in entry["parameters"])
        return f"{entry['returns']} (*{name})({parameters})"
    return f"{entry['type']} {name}"


def declarations(api):
    yield from (f"typedef int32_t {name};" for name in api.enums)
    yield from (f"typedef struct {o.handle} {o.handle};" for o in api.objects)
    for struct in api.callbacks:
        members = " ".join(f"{member(m, m['name'])};" for m in struct["members"])
        yield f"typedef struct {struct['name']} {{ {members} }} {struct['name']};"
    for f in api.functions:
        parameters = ", ".join(f"{p.type} {variable(p.name)}" for p in f.parameters) or "void"
        yield f"{f.returns} {f.name}({parameters});"


# ---- methods --------------------------------------------------------------------------------------------------------


def taken(function):
    """The arguments in the order in which Lua gives them: output arrays, which may be left out, come last."""
    outputs = [p for p in function.arguments if p.role == "array" and not p.is_in]
    return [p for p in function.arguments if p not in outputs] + outputs


def product(factors, function):
    """How many values an output has."""
    words = []
    for factor in factors:
        if isinstance(factor, tuple):
            words.append(factor[1].name)
        elif factor == "components":
            words.append("components_of(self)")
        elif factor == "values":
            words.append("values_of(self, field)")
        else:
            words.append(str(factor))
    return " * ".join(w for w in words if w != "1") or "1"


def default(p):
    value = f'"{p.default}"' if p.enum else p.default
    return f"if {variable(p.name)} == nil then {variable(p.name)} = {value} end"


class Method:
    def __init__(self, thing, function):
        self.thing, self.function = thing, function
        self.passed = {}

    def array_in(self, p):
        v, null = variable(p.name), ", true" if p.null else ""
        self.passed[p.name] = f"p_{p.name}"
        return f'local p_{p.name}, n_{p.name} = array_in("{p.base}", {v}, where, "{v}"{null})'

    def array_out(self, p):
        v, factors = variable(p.name), self.function.out_count(p, self.thing.has_components)
        wanted = product(factors, self.function) if factors else "nil"
        self.passed[p.name] = f"p_{p.name}"
        return f'local p_{p.name}, n_{p.name} = array_out("{p.base}", {v}, {wanted}, where, "{v}")'

    def lengths(self):
        for length in self.function.lengths:
            self.passed[length.name] = length.name
            first = length.first
            if first.role == "bytes":
                yield f"local {length.name} = n_{first.name}"
            elif length.given:
                yield f'local {length.name} = count_of(n_{first.name}, {first.times}, where, "{variable(first.name)}")'
                for other in length.others:
                    if other.is_in:
                        yield f'same(n_{other.name}, {length.name} * {other.times}, where, "{variable(other.name)}")'

    def out_lengths(self):
        for length in self.function.lengths:
            if length.given or length.first.role == "bytes":
                outs = [a for a in length.others if not a.is_in]
            else:
                every = [f"n_{a.name}" for a in length.arrays]
                yield f"local {length.name} = {' or '.join(every)} or 0"
                outs = length.others
            for other in outs:
                yield f'same(n_{other.name}, {length.name} * {other.times}, where, "{variable(other.name)}")'

    def body(self):
        f, results = self.function, []
        yield f'local where = "{f.name}"'
        for p in f.arguments:
            v = variable(p.name)
            if p.default is not None:
                yield default(p)
            if p.enum:
                self.passed[p.name] = v
                yield f'{v} = enum_in("{p.enum}", {v}, where, "{p.name}")'
            elif p.is_flag:
                self.passed[p.name] = v
                yield f'{v} = flag_in({v}, where, "{v}")'
            elif p.role == "value":
                self.passed[p.name] = v
                yield f'{v} = {"number" if p.base == "double" else "integer"}_in({v}, where, "{v}")'
            elif p.role == "handle":
                self.passed[p.name] = f"handle_of({v})"
            elif p.role == "callbacks":
                self.passed[p.name] = v
            elif p.role == "bytes" and p.is_in:
                self.passed[p.name] = f"p_{p.name}"
                yield f'local p_{p.name}, n_{p.name} = bytes_in({v}, where, "{v}")'
            elif p.role == "bytes":
                size = f"{f.short}_size"
                room = f"self:{size}()" if size in self.thing.by_short else "nil"
                self.passed[p.name] = f"p_{p.name}"
                yield f'local p_{p.name}, n_{p.name} = bytes_out({v}, {room}, where, "{v}")'
            elif p.role == "array" and p.is_in:
                yield self.array_in(p)
        yield from self.lengths()
        yield from (self.array_out(p) for p in f.arguments if p.role == "array" and not p.is_in)
        yield from self.out_lengths()
        for p in f.results:
            self.passed[p.name] = p.name
            yield f"local {p.name} = {p.base}_1()"
            results.append((p, self.result(p)))
        for p in f.arguments:
            if p.role == "array" and not p.is_in:
                results.append((p, f"array_result({variable(p.name)}, p_{p.name}, n_{p.name})"))
        results.sort(key=lambda pair: f.parameters.index(pair[0]))
        if f.own and not f.is_const:
            yield "self._version = self._version + 1"
        own = "handle_of(self)"
        values = [own if p.role == "self" else self.passed[p.name] for p in f.parameters]
        yield f"check(lib.{f.name}({', '.join(values)}))"
        for p in f.arguments:
            if p.role == "callbacks":
                yield f"self._kept.{p.name} = {variable(p.name)}"
        room = next((p for p in f.arguments if p.role == "bytes" and not p.is_in), None)
        if room and f"{f.short}_size" in self.thing.by_short and len(results) == 1:
            yield f"if {room.name} == nil then return string_of(p_{room.name}, {results[0][1]}) end"
        if results:
            yield f"return {', '.join(text for _, text in results)}"

    @staticmethod
    def result(p):
        if p.enum:
            return f'enum_out("{p.enum}", {p.name}[0])'
        if p.is_flag:
            return f"{p.name}[0] ~= 0"
        if p.base == "uint64_t":
            return f"{p.name}[0]"
        return f"tonumber({p.name}[0])"

    def text(self):
        f = self.function
        names = [variable(p.name) for p in taken(f)]
        yield from comment(f.doc, "-- ")
        owner = f"{pascal(self.thing.name)}:" if self.thing else "api."
        yield f"function {owner}{f.short}({', '.join(names)})"
        yield from ("  " + line for line in self.body())
        yield "end"
        yield ""


def view(thing, function):
    yield from comment(function.doc, "-- ")
    strides = [p for p in function.results if p.role == "result"]
    yield f"function {pascal(thing.name)}:{function.short}(field)"
    yield f'  return support.view(self, enum_in("cd_field", field, "{function.name}", "field"), function(handle, value)'
    yield "    local data, strides = address_1(), strides_4()"
    outputs = ", ".join(["data", *(f"strides + {k}" for k in range(len(strides)))])
    yield f"    check(lib.{function.name}(handle, value, {outputs}))"
    yield "    return data[0], strides"
    yield f"  end, {len(strides)})"
    yield "end"
    yield ""


def free_function(f):
    if f.returns == "cd_status":
        yield from Method(None, f).text()
        return
    arguments = ", ".join(variable(p.name) for p in f.arguments)
    yield from comment(f.doc, "-- ")
    yield f"function api.{f.short}({arguments})"
    values = ", ".join(f'enum_in("{p.enum}", {variable(p.name)}, "{f.name}", "{variable(p.name)}")' if p.enum else
                       variable(p.name) for p in f.arguments)
    wrapped = "ffi.string" if f.returns == "const char*" else "tonumber"
    yield f"  return {wrapped}(lib.{f.name}({values}))"
    yield "end"
    yield ""


def an_object(api, thing):
    name, create = pascal(thing.name), thing.create
    yield from comment(thing.doc, "-- ")
    yield f'local {name} = support.class("{name}", "{thing.destroy.name}")'
    yield f"api.{name} = {name}"
    yield f"{name}._range_alternates = {str(thing.range_alternates).lower()}"
    components = thing.shape.index("components") + 1 if thing.has_components else "nil"
    yield f"{name}._components = {components} -- which result of get_shape"
    yield f"{name}._fields = {{"
    for field, numbers, ropes in thing.field_rows():
        flags = f"{str(field['components']).lower()}, {str(ropes).lower()}"
        yield f"  [{api.field_value(field['name'])}] = {{{', '.join(map(str, numbers))}, {flags}}},"
    yield "}"
    yield ""
    names = [variable(p.name) for p in create.arguments]
    yield from comment(create.doc, "-- ")
    yield f"function {name}.create({', '.join(names)})"
    yield f'  local where, made = "{create.name}", ffi.new("{thing.handle}*[1]")'
    yield f"  support.check_built({name}, where)"
    values = []
    for p in create.arguments:
        v = variable(p.name)
        if p.default is not None:
            yield f"  {default(p)}"
        if p.enum:
            values.append(f'enum_in("{p.enum}", {v}, where, "{v}")')
        elif p.role == "value":
            values.append(f'{"number" if p.base == "double" else "integer"}_in({v}, where, "{v}")')
        else:
            values.append(v)
    yield f"  check(lib.{create.name}({', '.join([*values, 'made'])}))"
    kept = ", ".join(f"{p.name} = {variable(p.name)}" for p in create.arguments if p.role == "callbacks")
    yield f"  return support.own({name}, made[0], {{{kept}}})"
    yield "end"
    yield ""
    for f in thing.methods:
        yield from view(thing, f) if f.is_view else Method(thing, f).text()


def callbacks(struct):
    """A function that makes the struct of Lua functions."""
    functions = [m for m in struct["members"] if m.get("function")]
    yield from comment(struct["doc"], "-- ")
    yield f"function api.{struct['name'][3:]}(functions)"
    yield f'  return support.callbacks("{struct["name"]}", {{'
    for m in functions:
        inner = {p["name"]: bound_context(m, p) for p in m["parameters"] if p.get("function")}
        names = ", ".join(variable(p["name"]) for p in m["parameters"])
        given = []
        for p in m["parameters"]:
            v = variable(p["name"])
            if p["name"] in inner:
                rest = [variable(q["name"]) for q in p["parameters"] if q["name"] != inner[p["name"]]]
                called = ", ".join(variable(q["name"]) for q in p["parameters"])
                given.append(f"function({', '.join(rest)}) return {v}({called}) end")
            elif p["name"] != "user" and p["name"] not in inner.values():
                given.append(v if "*" in p["type"] else f"tonumber({v})")
        yield f'    {m["name"]} = {{"{member(m, "")}", function({names})'
        yield f"      return functions.{m['name']}({', '.join(given)})"
        yield "    end},"
    yield "  })"
    yield "end"
    yield ""


def module(api):
    yield f"-- contdyn's functions for LuaJIT. {MADE}"
    yield 'local ffi = require("ffi")'
    yield 'local support = require("contdyn.support")'
    yield "local api = {}"
    yield ""
    yield "ffi.cdef [["
    yield from fitted(declarations(api))
    yield "]]"
    yield ""
    yield f"local lib = support.load({', '.join(map(str, api.version))})"
    for name in ("check", "handle_of", "number_in", "integer_in", "flag_in", "enum_in", "enum_out", "array_in",
                 "array_out", "array_result", "bytes_in", "bytes_out", "string_of", "count_of", "same",
                 "components_of", "values_of"):
        yield f"local {name} = support.{name}"
    bases = sorted({p.base for f in api.functions for p in f.results if p.role == "result"})
    yield from (f'local {base}_1 = ffi.typeof("{base}[1]")' for base in bases)
    yield 'local address_1, strides_4 = ffi.typeof("const void*[1]"), ffi.typeof("size_t[4]")'
    yield ""
    for name, enum in api.enums.items():
        yield from comment(enum["doc"], "-- ")
        yield f'api["{name[3:]}"] = support.enumeration("{name}", {{'
        for value in enum["values"]:
            yield from comment(value["doc"], "  -- ")
            yield f'  ["{value["short"]}"] = {value["value"]},'
        yield "})"
        yield ""
    for struct in api.callbacks:
        yield from callbacks(struct)
    for f in api.free:
        yield from free_function(f)
    for thing in api.objects:
        yield from an_object(api, thing)
    yield "return api"


# ---- tests ----------------------------------------------------------------------------------------------------------


def literal(kind, value, api):
    if kind == "made":
        thing = next(o for o in api.objects if o.name == value)
        return f'require("contdyn").{pascal(value)}({", ".join(map(repr, sweep.sizes(thing)))})'
    if kind == "number":
        return repr(value)
    if kind == "flag":
        return str(value).lower()
    if kind == "enum":
        return f'"{value}"'
    if kind == "array":
        return "{" + ", ".join(map(repr, value)) + "}"
    return {"room": "nil", "bytes": "saved", "buffer": f'ffi.new("uint8_t[?]", {value})', "other": "other",
            "none": "nil"}[kind]


def tests(api):
    yield "-- Every method with arguments with which it succeeds, and what getters say after setters."
    yield f"-- {MADE}"
    yield 'local ffi = require("ffi")'
    yield "return {"
    for thing in api.objects:
        name = pascal(thing.name)
        sizes = ", ".join(map(repr, sweep.sizes(thing)))
        yield f'  {{class = "{name}", sizes = {{{sizes}}}, calls = {{'
        for f in thing.methods:
            given = {p.name: literal(kind, value, api) for p, kind, value in sweep.arguments(thing, f, api.enums)}
            for p in f.arguments:
                if p.role == "array" and not p.is_in and not f.out_count(p, thing.has_components):
                    given[p.name] = f'ffi.new("{p.base}[?]", {sweep.elements(f, p)})'
            may = ", may_fail = true" if sweep.may_fail(f) else ""
            values = ", ".join(given[p.name] for p in taken(f))
            yield f'    {{name = "{f.name}"{may}, call = function(o, other, saved)'
            yield f"      return o:{f.short}({values})"
            getter = sweep.told_by(thing, f)
            if getter:
                asked = ", ".join(given[p.name] for p in getter.arguments)
                told = ", ".join(given[p.word] for p in getter.results)
                yield "    end, told = function(o)"
                yield f"      return {{o:{getter.short}({asked})}}, {{{told}}}"
            yield "    end},"
        yield "  }},"
    yield "}"


def main():
    api = Description()
    written_or_checked(__doc__, {
        HERE / "contdyn" / "api.lua": "\n".join(fitted(module(api))) + "\n",
        HERE / "tests" / "every_function.lua": "\n".join(fitted(tests(api))) + "\n",
    })


if __name__ == "__main__":
    main()
