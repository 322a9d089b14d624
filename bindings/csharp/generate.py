#!/usr/bin/env python3
"""Makes src/Native.cs, src/Api.cs and tests/EveryFunction.cs from ../api.json.

    generate.py            writes them
    generate.py --check    fails if one of them is not what would be written
"""
import sys
from pathlib import Path
from xml.sax.saxutils import escape

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "generate"))
import sweep  # noqa: E402
from description import WIDTH, Description, bound_context, camel, comment, escaped, fitted, pascal  # noqa: E402
from description import written_or_checked  # noqa: E402

KEYWORDS = set("abstract as base bool break byte case catch char checked class const continue decimal default delegate "
               "do double else enum event explicit extern false finally fixed float for foreach goto if implicit in "
               "int interface internal is lock long namespace new null object operator out override params private "
               "protected public readonly ref return sbyte sealed short sizeof stackalloc static string struct switch "
               "this throw true try typeof uint ulong unchecked unsafe ushort using virtual void volatile while"
               .split())
MADE = "Made by generate.py from ../api.json: do not edit."
NATIVE = {"size_t": "UIntPtr", "int32_t": "int", "uint32_t": "uint", "uint64_t": "ulong", "float": "float",
          "double": "double", "void": "void", "uint8_t": "byte"}
PUBLIC = {"size_t": "long", "uint32_t": "uint", "uint64_t": "ulong", "float": "float", "double": "double"}

# Where the language and its library have spans. Arrays do without.
SPANS = ["#if NETSTANDARD2_1_OR_GREATER || NETCOREAPP2_1_OR_GREATER || UNITY_2021_2_OR_NEWER",
         "#define CONTDYN_SPANS",
         "#endif"]


def variable(name):
    return escaped(camel(name), KEYWORDS, "@{}")


def doc(text, tag="summary"):
    yield from comment(f"<{tag}>{escape(text)}</{tag}>", "/// ", WIDTH - 8)


# ---- the C functions ------------------------------------------------------------------------------------------------


def native_type(p):
    if p.role in ("self", "handle"):
        return f"{pascal(p.base)}Handle"
    if p.role == "callbacks":
        return "void*"
    if p.role == "created":
        return "IntPtr*"
    if p.role == "address":
        return "IntPtr*"
    if p.role == "bytes":
        return "void*"
    return ("int" if p.enum else NATIVE[p.base]) + "*" * p.type.count("*")


def plain_type(text, enums):
    """The type of a callback's parameter, and of what a function returns."""
    if "*" in text:
        return "IntPtr"
    return "int" if text in enums else NATIVE[text]


def native_module(api):
    yield f"// The C functions as they are: see the headers, include/contdyn/*.h. {MADE}"
    yield "using System;"
    yield "using System.Runtime.InteropServices;"
    yield ""
    yield "namespace Contdyn"
    yield "{"
    yield "    internal static unsafe partial class Native"
    yield "    {"
    yield f"        internal const uint Major = {api.version[0]}, Minor = {api.version[1]};"
    for f in api.functions:
        own = ["IntPtr" if p.role == "self" and f.short == "destroy" else native_type(p)
               for p in f.parameters]
        parameters = ", ".join(f"{kind} {variable(p.name)}" for kind, p in zip(own, f.parameters))
        yield ""
        yield "        [DllImport(Library, CallingConvention = CallingConvention.Cdecl)]"
        yield f"        internal static extern {plain_type(f.returns, api.enums)} {f.name}({parameters});"
    yield "    }"
    for thing in api.objects:
        name = f"{pascal(thing.name)}Handle"
        yield ""
        yield f"    internal sealed class {name} : ObjectHandle"
        yield "    {"
        yield f"        internal {name}(IntPtr handle) : base(handle) {{ }}"
        yield ""
        yield "        protected override bool ReleaseHandle()"
        yield "        {"
        yield f"            Native.{thing.destroy.name}(handle);"
        yield "            return true;"
        yield "        }"
        yield "    }"
    yield "}"


# ---- methods --------------------------------------------------------------------------------------------------------


def value_type(p):
    return pascal(p.enum) if p.enum else "bool" if p.is_flag else PUBLIC[p.base]


def is_array(p):
    return p.role in ("array", "bytes")


def property_of(thing, f):
    """The name of the property that a setter and its getter make, if they do."""
    name = f.short[4:]
    if f.short[:4] not in ("set_", "get_"):
        return None
    setter, getter = thing.by_short.get(f"set_{name}"), thing.by_short.get(f"get_{name}")
    if not setter or not getter or getter.arguments or len(getter.results) != 1 or len(setter.arguments) != 1:
        return None
    given, told = setter.arguments[0], getter.results[0]
    return pascal(name) if given.role == "value" and given.base == told.base else None


class Method:
    def __init__(self, thing, function):
        self.thing, self.function = thing, function
        self.passed = {}
        room = next((p for p in function.arguments if p.role == "bytes" and not p.is_in), None)
        self.static = "" if thing else "static "
        self.own_room = bool(room and f"{function.short}_size" in thing.by_short)

    def struct_name(self):
        short = self.function.short
        owner = pascal(self.thing.name) if self.thing else ""
        return owner + pascal(short[4:] if short.startswith("get_") else short)

    def returns(self):
        results = self.function.results
        return "void" if not results else value_type(results[0]) if len(results) == 1 else self.struct_name()

    def parameter(self, p, last, form):
        """`form`: array, span or pointer."""
        name = variable(p.name)
        if is_array(p):
            element = NATIVE.get(p.base) if p.role == "array" else "T" if form == "array" else "byte"
            if form == "pointer":
                return f"{'void' if p.role == 'bytes' else element}* {name}, long {name}Length"
            if form == "span":
                return f"{'ReadOnly' if p.is_in else ''}Span<{element}> {name}"
            return f"{'params ' if last and p.is_in and p.role == 'array' else ''}{element}[] {name}"
        if p.role == "handle":
            return f"{pascal(p.base)} {name}"
        if p.role == "callbacks":
            return f"{pascal(p.base)}Callbacks {name}"
        after = self.function.arguments[self.function.arguments.index(p):]
        if p.default is not None and form != "pointer" and not any(map(is_array, after)):
            value = f"{pascal(p.enum)}.{pascal(p.default)}" if p.enum else p.default
            return f"{value_type(p)} {name} = {value}"
        return f"{value_type(p)} {name}"

    def parameters(self, form):
        given = self.function.arguments
        return ", ".join(self.parameter(p, p is given[-1], form) for p in given)

    def lengths(self):
        where = f'"{self.function.name}"'
        for length in self.function.lengths:
            v, first = variable(length.name), length.first
            self.passed[length.name] = f"Native.Size({v}, {where}, \"{length.name}\")"
            own = f"{variable(first.name)}Length"
            if first.role == "bytes":
                yield f"long {v} = {own};"
                continue
            if not length.given:
                for other in length.others:
                    own = f"({variable(first.name)} != null ? {own} : {variable(other.name)}Length)" \
                        if other is length.others[0] else f"Math.Max({own}, {variable(other.name)}Length)"
            yield f'long {v} = Native.Count({own}, {first.times}, {where}, "{first.name}");'
            for other in length.others:
                o = variable(other.name)
                times = variable(other.times) if isinstance(other.times, str) else other.times
                wanted = v if times == 1 else f"{v} * {times}"
                yield f'Native.Same({o}, {o}Length, {wanted}, {where}, "{other.name}");'

    def body(self, check="Check"):
        f = self.function
        yield from self.lengths()
        for p in f.arguments:
            v = variable(p.name)
            if p.enum:
                self.passed[p.name] = f"(int){v}"
            elif p.is_flag:
                self.passed[p.name] = f"{v} ? 1 : 0"
            elif p.role == "value" and p.base == "size_t":
                size = "SizeOrNone" if p.may_be_none else "Size"
                self.passed[p.name] = f'Native.{size}({v}, "{f.name}", "{p.name}")'
            elif p.role == "value":
                self.passed[p.name] = v
            elif p.role == "handle":
                self.passed[p.name] = f'Native.NotNull({v}, "{v}").Handle'
            elif p.role == "callbacks":
                self.passed[p.name] = f"{v}Struct"
                yield f"void* {v}Struct = {v} == null ? null : {v}.Struct();"
            else:
                self.passed[p.name] = v
        for p in f.results:
            v = variable(p.name)
            self.passed[p.name] = f"&{v}"
            kind = "IntPtr" if p.role == "address" else "int" if p.enum else NATIVE[p.base]
            yield f"{kind} {v};"
        if f.own and not f.is_const:
            yield "Changed();"
        values = ", ".join("Handle" if p.role == "self" else self.passed[p.name] for p in f.parameters)
        yield f"{'' if f.own else 'Native.'}Check(Native.{f.name}({values}));"
        for p in f.arguments:
            if p.role == "callbacks":
                numbered = "".join(f' + " " + {variable(q.name)}' for q in f.arguments if q.name == "index")
                yield f'Handle.Keep("{p.name}"{numbered}, {variable(p.name)});'
        if len(f.results) == 1:
            yield f"return {self.value(f.results[0])};"
        elif f.results:
            yield f"return new {self.struct_name()}({', '.join(map(self.value, f.results))});"

    @staticmethod
    def value(p):
        v = variable(p.name)
        if p.enum:
            return f"({pascal(p.enum)}){v}"
        return f"{v} != 0" if p.is_flag else f"(long){v}" if p.base == "size_t" else v

    def overload(self, form):
        """A method whose arrays are arrays or spans: it pins them."""
        f, arrays = self.function, [p for p in self.function.arguments if is_array(p)]
        generic = any(p.role == "bytes" for p in arrays) and form == "array"
        name = pascal(f.short) + ("<T>" if generic else "")
        yield f"public {self.static}{self.returns()} {name}({self.parameters(form)}){' where T : struct' if generic else ''}"
        yield "{"
        indent = "    "
        for p in arrays:
            v = variable(p.name)
            if p.role == "bytes" and form == "array":
                yield f"{indent}using (var {camel(p.name)}Pinned = new Pinned<T>({v}))"
            elif form == "array":
                yield f"{indent}fixed ({NATIVE[p.base]}* {camel(p.name)}Pointer = {v})"
            else:
                kind = "byte" if p.role == "bytes" else NATIVE[p.base]
                yield f"{indent}fixed ({kind}* {camel(p.name)}Pointer = &MemoryMarshal.GetReference({v}))"
        given = []
        for p in f.arguments:
            v, plain = variable(p.name), camel(p.name)
            if p.role == "bytes" and form == "array":
                given.append(f"{plain}Pinned.Pointer, {plain}Pinned.Length")
            elif is_array(p):
                given.append(f"{plain}Pointer, Native.Length({v})" if form == "array" else
                             f"{v}.Length == 0 ? null : {plain}Pointer, {v}.Length")
            else:
                given.append(v)
        call = f"{pascal(f.short)}Core({', '.join(given)});"
        yield indent + "    " + ("return " if f.results else "") + call
        yield "}"
        yield ""

    def text(self):
        f = self.function
        name, arrays = pascal(f.short), any(is_array(p) for p in f.arguments)
        if not arrays:
            yield from doc(f.doc)
            yield f"public {self.static}{self.returns()} {name}({self.parameters('array')})"
        else:
            yield from doc(f.doc)
            yield from self.overload("array")
            yield "#if CONTDYN_SPANS"
            yield from doc(f.doc)
            yield from self.overload("span")
            yield "#endif"
            yield f"private {self.static}{self.returns()} {name}Core({self.parameters('pointer')})"
        yield "{"
        yield from ("    " + line for line in self.body())
        yield "}"
        yield ""
        if self.own_room:
            yield from doc("The same into a new array.")
            yield f"public byte[] {name}()"
            yield "{"
            yield f"    var bytes = new byte[{pascal(f.short)}Size()];"
            yield f"    Array.Resize(ref bytes, (int){name}(bytes));"
            yield "    return bytes;"
            yield "}"
            yield ""

    def struct(self):
        f, name = self.function, self.struct_name()
        owner = pascal(self.thing.name) if self.thing else "Library"
        yield from doc(f"What {owner}.{pascal(f.short)} tells.")
        yield f"public struct {name}"
        yield "{"
        yield from (f"    public readonly {value_type(p)} {pascal(p.word)};" for p in f.results)
        yield ""
        parameters = ", ".join(f"{value_type(p)} {variable(p.word)}" for p in f.results)
        yield f"    internal {name}({parameters})"
        yield "    {"
        yield from (f"        {pascal(p.word)} = {variable(p.word)};" for p in f.results)
        yield "    }"
        yield "}"
        yield ""


def a_property(thing, name, getter, setter):
    get, put = Method(thing, getter), Method(thing, setter)
    yield from doc(setter.doc)
    yield f"public {get.returns()} {name}"
    yield "{"
    for word, method in (("get", get), ("set", put)):
        yield f"    {word}"
        yield "    {"
        if word == "set":
            p = setter.arguments[0]
            if variable(p.name) != "value":
                yield f"        var {variable(p.name)} = value;"
        yield from ("        " + line for line in method.body())
        yield "    }"
    yield "}"
    yield ""


def view(thing, f):
    strides = [p for p in f.results if p.role == "result"]
    yield from doc(f.doc)
    yield f"public View {pascal(f.short)}(Field field)"
    yield "{"
    yield "    return new View(this, field);"
    yield "}"
    yield ""
    yield "internal override IntPtr Lie(Field field, long[] strides)"
    yield "{"
    yield "    IntPtr data;"
    yield "    UIntPtr* s = stackalloc UIntPtr[4];"
    outputs = ", ".join(["&data", *(f"s + {k}" for k in range(len(strides)))])
    yield f"    Check(Native.{f.name}(Handle, (int)field, {outputs}));"
    yield from (f"    strides[{k}] = (long)s[{k}];" for k in range(len(strides)))
    yield "    return data;"
    yield "}"
    yield ""


def whole_fields(api, thing):
    ring, own = thing.results_of("get_ring"), any(ropes for _, _, ropes in thing.field_rows())
    yield "private static readonly Dictionary<Field, FieldRow> rows = new Dictionary<Field, FieldRow>"
    yield "{"
    for field, numbers, ropes in thing.field_rows():
        flags = f"{str(field['components']).lower()}, {str(ropes).lower()}"
        extents = ", ".join(map(str, numbers))
        yield f"    {{ Field.{pascal(field['name'])}, new FieldRow(new[] {{ {extents} }}, {flags}) }},"
    yield "};"
    yield ""
    yield "internal override Whole Extents(Field field)"
    yield "{"
    yield "    FieldRow row;"
    yield "    if (!rows.TryGetValue(field, out row)) return new Whole();"
    yield "    var shape = GetShape();"

    def property_or_call(short, word, only):
        name = property_of(thing, thing.by_short[short])
        if only and name:
            return name
        return f"{pascal(short)}().{pascal(word)}" if not only else f"{pascal(short)}()"

    flags = ", ".join(property_or_call("get_ring", word, len(ring) == 1) for word in ring)
    flags = f"new[] {{ {flags} }}" if ring else "new bool[0]"
    rope = f"row.OneButInRopes && {property_or_call('get_rest_length', 'length', True)} > 0" if own else "false"
    sizes = ", ".join(f"shape.{pascal(word)}" for word in thing.sizes)
    components = "shape.Components" if thing.has_components else "1"
    yield f"    return new Whole(row, new[] {{ {sizes} }}, {flags}, {rope}, {components});"
    yield "}"
    yield ""
    yield "internal override Precision Stored { get { return GetShape().Precision; } }"
    yield ""
    alternates = str(thing.range_alternates).lower()
    for verb, p in (("Read", "outValues"), ("Write", "values")):
        for kind, element in (("F32", "float"), ("F64", "double")):
            yield f"internal override void {verb}Whole(Field field, Whole whole, {element}* {p}, long count)"
            yield "{"
            yield f"    var range = whole.Range({alternates});"
            yield f"    {verb}{kind}Core(field, range[0], range[1], range[2], range[3], {p}, count);"
            yield "}"
            yield ""


def an_object(api, thing):
    name, create = pascal(thing.name), thing.create
    methods = {f.name: Method(thing, f) for f in thing.methods if not f.is_view}
    for m in methods.values():
        if len(m.function.results) > 1:
            yield from m.struct()
    yield from doc(thing.doc)
    yield f"public sealed unsafe class {name} : LibraryObject"
    yield "{"
    lines = [f"internal new {name}Handle Handle {{ get {{ return ({name}Handle)base.Handle; }} }}", ""]
    maker = Method(thing, create)
    given = []
    for p in create.arguments:
        text = maker.parameter(p, False, "array")
        given.append(f"{text} = null" if p.role == "callbacks" else text)
    lines += doc(create.doc)
    lines.append(f"public {name}({', '.join(given)})")
    lines.append("{")
    passed = []
    for p in create.arguments:
        v = variable(p.name)
        if p.role == "callbacks":
            lines.append(f"    void* {v}Struct = {v} == null ? null : {v}.Struct();")
            passed.append(f"{v}Struct")
        elif p.base == "size_t":
            passed.append(f'Native.Size({v}, "{create.name}", "{p.name}")')
        else:
            passed.append(f"(int){v}" if p.enum else v)
    callbacks = [variable(p.name) for p in create.arguments if p.role == "callbacks"]
    lines.append("    IntPtr made;")
    lines.append("    Native.CheckVersion();")
    lines.append("    int status;")
    lines += ["    try", "    {"]
    lines.append(f"        status = Native.{create.name}({', '.join(passed)}, &made);")
    lines += ["    }", "    catch (EntryPointNotFoundException)", "    {"]
    lines.append(f'        throw Native.LeftOut("{create.name}");')
    lines.append("    }")
    lines.append(f"    Native.Check(status, {callbacks[0]});")
    lines.append(f"    Own(new {name}Handle(made));")
    lines += [f'    Handle.Keep("{v}", {v});' for v in callbacks]
    lines += ["}", ""]
    lines += whole_fields(api, thing)
    done = set()
    for f in thing.methods:
        name_of = property_of(thing, f)
        if f.is_view:
            lines += view(thing, f)
        elif name_of and name_of not in done:
            done.add(name_of)
            short = f.short[4:]
            lines += a_property(thing, name_of, thing.by_short[f"get_{short}"], thing.by_short[f"set_{short}"])
        elif not name_of:
            lines += methods[f.name].text()
    while not lines[-1]:
        lines.pop()
    yield from ("    " + line if line and not line.startswith("#") else line for line in lines)
    yield "}"
    yield ""


def callback_struct(struct, enums):
    """A class of delegates, and the C struct of them."""
    name = f"{pascal(struct['name'])}Callbacks"
    functions = [m for m in struct["members"] if m.get("function")]
    yield from doc(struct["doc"])
    yield f"public sealed unsafe class {name} : Callbacks"
    yield "{"
    for m in functions:
        inner = {p["name"]: (p, bound_context(m, p)) for p in m["parameters"] if p.get("function")}
        bound = {context for _, context in inner.values()}
        given, native, call = [], [], []
        for p in m["parameters"]:
            v = variable(p["name"])
            if p["name"] in inner:
                rest = [q for q in p["parameters"] if q["name"] != inner[p["name"]][1]]
                kinds = ", ".join(public_type(q["type"], enums) for q in rest)
                given.append(f"Action<{kinds}> {v}")
                native.append(f"IntPtr {v}")
                names = ", ".join(variable(q["name"]) for q in rest)
                values = ", ".join(variable(q["name"]) if q["name"] == inner[p["name"]][1] else
                                   to_native(variable(q["name"]), q["type"], enums) for q in p["parameters"])
                call.append(f"({names}) => {v}Function({values})")
            else:
                native.append(f"{plain_type(p['type'], enums)} {v}")
                if p["name"] != "user" and p["name"] not in bound:
                    given.append(f"{public_type(p['type'], enums)} {v}")
                    call.append(from_native(v, p["type"], enums))
        kind, returns = pascal(m["name"]), m["returns"]
        result = "void" if returns == "void" else public_type(returns, enums)
        raw = "void" if returns == "void" else plain_type(returns, enums)
        yield f"    public delegate {result} {kind}Function({', '.join(given)});"
        yield ""
        yield f"    public {kind}Function {kind};"
        yield ""
        yield "    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]"
        yield f"    private delegate {raw} {kind}Native({', '.join(native)});"
        yield ""
        for inner_name, (p, _) in inner.items():
            parameters = ", ".join(f"{plain_type(q['type'], enums)} {variable(q['name'])}" for q in p["parameters"])
            yield "    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]"
            yield f"    private delegate void {pascal(inner_name)}Native({parameters});"
            yield ""
        yield f"    private {raw} Call{kind}({', '.join(native)})"
        yield "    {"
        yield "        try"
        yield "        {"
        for inner_name in inner:
            v, t = variable(inner_name), f"{pascal(inner_name)}Native"
            yield f"            var {v}Function = ({t})Marshal.GetDelegateForFunctionPointer({v}, typeof({t}));"
        value = f"{kind}({', '.join(call)})"
        if raw == "void":
            yield f"            {value};"
        else:
            yield f"            return {to_native(value, returns, enums)};"
        yield "        }"
        yield "        catch (Exception raised)"
        yield "        {"
        yield "            Raised(raised);"
        if raw != "void":
            yield f"            return default({raw});"
        yield "        }"
        yield "    }"
        yield ""
    yield "    internal override void* Struct()"
    yield "    {"
    members = []
    for m in struct["members"]:
        if m.get("function"):
            kind = pascal(m["name"])
            members.append(f"{kind} == null ? null : new {kind}Native(Call{kind})")
        else:
            members.append("null")
    yield "        return Made(" + ", ".join(f"({m})" if " " in m else m for m in members) + ");"
    yield "    }"
    yield "}"
    yield ""


def public_type(text, enums):
    return "IntPtr" if "*" in text else pascal(text) if text in enums else PUBLIC.get(text, NATIVE[text])


def to_native(value, text, enums):
    return f"(UIntPtr)(ulong){value}" if text == "size_t" else f"(int){value}" if text in enums else value


def from_native(value, text, enums):
    return f"(long){value}" if text == "size_t" else f"({pascal(text)}){value}" if text in enums else value


def api_module(api):
    yield f"// The library's objects. {MADE}"
    yield from SPANS
    yield "using System;"
    yield "using System.Collections.Generic;"
    yield "using System.Runtime.InteropServices;"
    yield ""
    yield "namespace Contdyn"
    yield "{"
    lines = []
    for name, enum in api.enums.items():
        lines += doc(enum["doc"] or "What a call of the C library returns.")
        lines.append(f"public enum {pascal(name)}")
        lines.append("{")
        for value in enum["values"]:
            if value["doc"]:
                lines += ("    " + line for line in doc(value["doc"]))
            lines.append(f"    {pascal(value['short'])} = {value['value']},")
        lines += ["}", ""]
    for struct in api.callbacks:
        lines += callback_struct(struct, api.enums)
    lines += doc("The library's functions that belong to no object.")
    lines += ["public static unsafe class Library", "{"]
    lines += ["    /// <summary>C's SIZE_MAX, for offsets that may be it.</summary>",
              "    public const long SizeMax = -1;", ""]
    structs = []
    for f in api.free:
        if f.returns == "cd_status":
            method = Method(None, f)
            structs += method.struct()
            lines += ("    " + line if line and not line.startswith("#") else line for line in method.text())
            continue
        lines += ("    " + line for line in doc(f.doc))
        parameters = ", ".join(f"{value_type(p)} {variable(p.name)}" for p in f.arguments)
        values = ", ".join(f"(int){variable(p.name)}" if p.enum else variable(p.name) for p in f.arguments)
        text = f.returns == "const char*"
        call = f"Native.{f.name}({values})"
        lines += [f"    public static {'string' if text else PUBLIC[f.returns]} {pascal(f.short)}({parameters})",
                  "    {", f"        return {f'Native.Text({call})' if text else call};", "    }", ""]
    lines.pop()
    lines += ["}", "", *structs]
    for thing in api.objects:
        lines += an_object(api, thing)
    lines.pop()
    yield from ("    " + line if line and not line.startswith("#") else line for line in lines)
    yield "}"


# ---- tests ----------------------------------------------------------------------------------------------------------


def literal(p, kind, value):
    if kind == "number":
        return repr(value)
    if kind == "flag":
        return str(value).lower()
    if kind == "enum":
        return f"{pascal(p.enum)}.{pascal(value)}"
    if kind == "array":
        element = NATIVE[p.base]
        numbers = ", ".join(f"{x!r}f" if element == "float" else repr(x) for x in value)
        return f"new {element}[] {{ {numbers} }}"
    if kind == "room":
        return f"new {NATIVE[p.base]}[{value}]"
    if kind == "made":
        return f"Make{pascal(value)}()"
    return {"bytes": "saved", "buffer": f"new byte[{value}]", "other": "other", "none": "null"}[kind]


def tests(api):
    yield "// Every method with arguments with which it succeeds, and what getters say after setters."
    yield f"// {MADE}"
    yield "using System;"
    yield "using Contdyn;"
    yield ""
    yield "static class EveryFunction"
    yield "{"
    for thing in api.objects:
        name = pascal(thing.name)
        sizes = ", ".join(map(repr, sweep.sizes(thing)))
        yield f"    public static {name} Make{name}() {{ return new {name}({sizes}); }}"
        yield ""
        yield f"    public static readonly Call<{name}>[] {name}Calls ="
        yield "    {"
        for f in thing.methods:
            given = {p.name: literal(p, kind, value) for p, kind, value in sweep.arguments(thing, f, api.enums)}
            values = ", ".join(given[p.name] for p in f.arguments)
            prop = property_of(thing, f)
            if prop:
                call = f"o.{prop} = {values}" if f.short.startswith("set_") else f"Call.Use(o.{prop})"
            else:
                call = f"o.{pascal(f.short)}({values})"
            may = str(sweep.may_fail(f)).lower()
            getter = sweep.told_by(thing, f)
            if not getter:
                told = "true"
            elif prop:
                told = f"o.{prop} == {values}"
            else:
                asked = ", ".join(given[p.name] for p in getter.arguments)
                said = f"o.{pascal(getter.short)}({asked})"
                results = getter.results
                told = f"{said} == {given[results[0].word]}" if len(results) == 1 else " && ".join(
                    f"{said}.{pascal(p.word)} == {given[p.word]}" for p in results)
            yield f'        new Call<{name}>("{f.name}", {may}, (o, other, saved) => {call}, o => {told}),'
        yield "    };"
        yield ""
    yield "}"


def main():
    api = Description()
    texts = {
        HERE / "src" / "Native.cs": native_module(api),
        HERE / "src" / "Api.cs": api_module(api),
        HERE / "tests" / "EveryFunction.cs": tests(api),
    }
    written_or_checked(__doc__, {path: "\n".join(fitted(lines)).rstrip("\n") + "\n" for path, lines in texts.items()})


if __name__ == "__main__":
    main()
