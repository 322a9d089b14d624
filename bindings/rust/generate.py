#!/usr/bin/env python3
"""Makes src/sys.rs, src/api.rs and what is made of the tests from ../api.json.

    generate.py            writes them
    generate.py --check    fails if one of them is not what would be written
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE.parent / "generate"))
import sweep  # noqa: E402
from description import WIDTH, Description, comment, escaped, fitted, pascal, written_or_checked  # noqa: E402

KEYWORDS = set("as async await break const continue crate dyn else enum extern false fn for if impl in let loop match "
               "mod move mut pub ref return static struct super trait true type unsafe use where while abstract become "
               "box do final macro override priv try typeof unsized virtual yield".split())
MADE = "Made by generate.py from ../api.json: do not edit."
PLAIN = {"size_t": "usize", "int32_t": "i32", "uint32_t": "u32", "uint64_t": "u64", "float": "f32", "double": "f64",
         "void": "c_void", "char": "c_char", "uint8_t": "u8"}


def variable(name):
    return escaped(name, KEYWORDS, "r#{}")


def doc(text, start="/// "):
    for letter in "[]<>*":
        text = text.replace(letter, "\\" + letter)
    for line in comment(text, start, WIDTH - 4):
        rest = line[len(start):]
        yield start + "\\" + rest if rest[:2] in ("- ", "+ ") else line  # no list


# ---- the C functions ------------------------------------------------------------------------------------------------


def raw_type(text):
    """const double* -> *const f64."""
    base = text.replace("const ", "").rstrip("*")
    stars, name = text.count("*"), PLAIN.get(base, base)
    if not stars:
        return name
    first = "*const " if text.startswith("const ") else "*mut "
    return "*mut " * (stars - 1) + first + name


def member_type(entry):
    if not entry.get("function"):
        return raw_type(entry["type"])
    parameters = ", ".join(f"{variable(p['name'])}: {member_type(p)}" for p in entry["parameters"])
    returns = "" if entry["returns"] == "void" else f" -> {raw_type(entry['returns'])}"
    return f"Option<unsafe extern \"C\" fn({parameters}){returns}>"


def sys_module(api):
    yield "//! The C functions as they are: see the headers, include/contdyn/\\*.h."
    yield f"//! {MADE}"
    yield "use std::os::raw::{c_char, c_void};"
    yield ""
    for part, value in zip(("MAJOR", "MINOR", "PATCH"), api.version):
        yield f"pub const CD_VERSION_{part}: u32 = {value};"
    for name, enum in api.enums.items():
        yield ""
        yield f"pub type {name} = i32;"
        yield from (f"pub const {v['name']}: {name} = {v['value']};" for v in enum["values"])
    for thing in api.objects:
        yield ""
        yield "#[repr(C)]"
        yield f"pub struct {thing.handle} {{"
        yield "    _private: [u8; 0],"
        yield "}"
    for struct in api.callbacks:
        yield ""
        yield from doc(struct["doc"])
        yield "#[repr(C)]"
        yield "#[derive(Clone, Copy)]"
        yield f"pub struct {struct['name']} {{"
        yield from (f"    pub {variable(m['name'])}: {member_type(m)}," for m in struct["members"])
        yield "}"
    yield ""
    yield 'extern "C" {'
    for f in api.functions:
        parameters = ", ".join(f"{variable(p.name)}: {raw_type(p.type)}" for p in f.parameters)
        returns = "" if f.returns == "void" else f" -> {raw_type(f.returns)}"
        yield f"    pub fn {f.name}({parameters}){returns};"
    yield "}"


# ---- the safe layer -------------------------------------------------------------------------------------------------


def value_type(p):
    return pascal(p.enum) if p.enum else "bool" if p.is_flag else PLAIN[p.base]


def argument_type(p):
    if p.role == "value":
        return value_type(p)
    if p.role == "handle":
        return f"&{pascal(p.base)}"
    if p.role == "callbacks":
        return f"Option<&sys::{p.base}>"
    element = "u8" if p.role == "bytes" else PLAIN[p.base]
    slice_type = f"&{'' if p.is_in else 'mut '}[{element}]"
    return f"Option<{slice_type}>" if p.null else slice_type


def default(p):
    """What an out parameter holds before the call, in C's type."""
    return "std::ptr::null()" if p.role == "address" else "0.0" if p.base in ("double", "float") else "0"


class Method:
    def __init__(self, api, thing, function):
        self.api, self.thing, self.function = api, thing, function
        self.passed = {}

    def length(self, p):
        v = variable(p.name)
        return f"{v}.as_deref().map(<[_]>::len)" if p.null and not p.is_in else \
            f"{v}.map(<[_]>::len)" if p.null else f"Some({v}.len())"

    def pointer(self, p):
        v = variable(p.name)
        if p.role == "bytes":
            return f"{v}.{'as_ptr' if p.is_in else 'as_mut_ptr'}().cast()"
        if not p.null:
            return f"{v}.{'as_ptr' if p.is_in else 'as_mut_ptr'}()"
        if p.is_in:
            return f"{v}.map_or(std::ptr::null(), <[_]>::as_ptr)"
        return f"{v}.map_or(std::ptr::null_mut(), <[_]>::as_mut_ptr)"

    def lengths(self):
        where = f'"{self.function.name}"'
        for length in self.function.lengths:
            v, first = variable(length.name), length.first
            self.passed[length.name] = v
            if first.role == "bytes":
                yield f"let {v} = {variable(first.name)}.len();"
                continue
            known = f"{variable(first.name)}.len()"
            if first.null:
                yield f"let {v} = {self.length(first)};"
                for other in [] if length.given else length.others:
                    yield f"let {v} = {v}.or({self.length(other)});"
                known = f"{v}.unwrap_or(0)"
            yield f'let {v} = count_of({known}, {first.times}, {where}, "{first.name}")?;'
            for other in length.others:
                times = other.times if isinstance(other.times, str) else str(other.times)
                yield (f"same({self.length(other)}, {v}.checked_mul({times}), "
                       f'{where}, "{other.name}")?;')

    def out_type(self):
        f = self.function
        if not f.results:
            return "()"
        if len(f.results) == 1:
            return value_type(f.results[0])
        return self.struct_name()

    def struct_name(self):
        short = self.function.short
        owner = pascal(self.thing.name) if self.thing else ""
        return owner + pascal(short[4:] if short.startswith("get_") else short)

    def value(self, p):
        v = variable(p.name)
        if p.enum:
            return f'known({pascal(p.enum)}::from_raw({v}), {v}, "{self.function.name}")?'
        return f"{v} != 0" if p.is_flag else v

    def body(self):
        f = self.function
        yield from self.lengths()
        for p in f.arguments:
            v = variable(p.name)
            if p.enum:
                self.passed[p.name] = f"{v} as i32"
            elif p.is_flag:
                self.passed[p.name] = f"i32::from({v})"
            elif p.role == "value":
                self.passed[p.name] = v
            elif p.role == "handle":
                self.passed[p.name] = f"{v}.as_ptr()"
            elif p.role == "callbacks":
                self.passed[p.name] = f"{v}.map_or(std::ptr::null(), |c| c as *const _)"
            else:
                self.passed[p.name] = self.pointer(p)
        for p in f.results:
            self.passed[p.name] = f"&mut {variable(p.name)}"
            yield f"let mut {variable(p.name)} = {default(p)};"
        values = ", ".join("self.as_ptr()" if p.role == "self" else self.passed[p.name] for p in f.parameters)
        last = f"check(unsafe {{ sys::{f.name}({values}) }})"
        if not f.results:
            yield last
            return
        yield f"{last}?;"
        if len(f.results) == 1:
            text = self.value(f.results[0])
            yield text[:-1] if text.endswith("?") else f"Ok({text})"
        else:
            yield f"Ok({self.struct_name()} {{"
            yield from (f"    {variable(p.word)}: {self.value(p)}," for p in f.results)
            yield "})"

    def text(self):
        f = self.function
        room = next((p for p in f.arguments if p.role == "bytes" and not p.is_in), None)
        own_room = bool(room and f"{f.short}_size" in self.thing.by_short)
        name = f"{f.short}_into" if own_room else f.short
        yield from doc(f.doc)
        if f.has_callbacks:
            yield from safety()
        own = ["&self" if f.is_const else "&mut self"] if f.own else []
        parameters = ", ".join([*own, *(f"{variable(p.name)}: {argument_type(p)}" for p in f.arguments)])
        unsafe = "unsafe " if f.has_callbacks else ""
        yield f"pub {unsafe}fn {variable(name)}({parameters}) -> Result<{self.out_type()}> {{"
        for line in self.body():
            yield "    " + line
        yield "}"
        yield ""
        if own_room:
            yield f"/// The same into a new vector."
            yield f"pub fn {f.short}(&self) -> Result<Vec<u8>> {{"
            yield f"    let mut bytes = vec![0; self.{f.short}_size()?];"
            yield f"    let written = self.{name}(&mut bytes)?;"
            yield "    bytes.truncate(written);"
            yield "    Ok(bytes)"
            yield "}"
            yield ""

    def struct(self):
        f = self.function
        owner = f"{pascal(self.thing.name)}::" if self.thing else ""
        yield f"/// What [`{owner}{f.short}`] tells."
        yield "#[derive(Clone, Copy, Debug, PartialEq)]"
        yield f"pub struct {self.struct_name()} {{"
        yield from (f"    pub {variable(p.word)}: {value_type(p)}," for p in f.results)
        yield "}"
        yield ""


def safety():
    yield "///"
    yield "/// # Safety"
    yield "/// The functions and `user` must be good for as long as the object may call them, from whichever threads"
    yield "/// it is used on, and must not unwind."


def view(thing, f):
    strides = [p for p in f.results if p.role == "result"]
    yield from doc(f.doc)
    yield f"pub fn {f.short}(&self, field: Field) -> Result<View<'_>> {{"
    yield "    let mut data = std::ptr::null();"
    yield "    let mut strides = [0; 3];"
    outputs = ", ".join(["&mut data", *(f"&mut strides[{k}]" for k in range(len(strides)))])
    if len(strides) > 1:
        yield f"    let [{', '.join(f's{k}' for k in range(len(strides)))}, ..] = &mut strides;" if len(strides) < 3 \
            else "    let [s0, s1, s2] = &mut strides;"
        outputs = ", ".join(["&mut data", *(f"s{k}" for k in range(len(strides)))])
    yield f"    check(unsafe {{ sys::{f.name}(self.as_ptr(), field as i32, {outputs}) }})?;"
    yield "    Ok(View::new(data.cast(), strides, self.whole(field)?, self.get_shape()?.precision))"
    yield "}"
    yield ""


def whole_fields(thing):
    ring, own = thing.results_of("get_ring"), any(ropes for _, _, ropes in thing.field_rows())
    yield "fn whole(&self, field: Field) -> Result<Whole> {"
    yield f"    const ROWS: [FieldRow; {len(thing.fields)}] = ["
    for field, numbers, ropes in thing.field_rows():
        yield (f"        FieldRow {{ field: Field::{pascal(field['name'])}, extents: {numbers}, "
               f"components: {str(field['components']).lower()}, one_but_in_ropes: {str(ropes).lower()} }},")
    yield "    ];"
    yield "    let row = match ROWS.iter().find(|row| row.field == field) {"
    yield "        Some(row) => row,"
    yield "        None => return Ok(Whole::default()),"
    yield "    };"
    yield "    let shape = self.get_shape()?;"
    if not ring:
        flags = "[]"
    elif len(ring) == 1:
        flags = "[self.get_ring()?]"
    else:
        yield "    let ring = self.get_ring()?;"
        flags = "[" + ", ".join(f"ring.{variable(word)}" for word in ring) + "]"
    rope = "row.one_but_in_ropes && self.get_rest_length()? > 0.0" if own else "false"
    sizes = ", ".join(f"shape.{variable(word)}" for word in thing.sizes)
    components = "shape.components" if thing.has_components else "1"
    yield f"    Ok(Whole::new(row, &[{sizes}], &{flags}, {rope}, {components}))"
    yield "}"
    yield ""
    yield "/// How many values a whole field has."
    yield "pub fn get_size(&self, field: Field) -> Result<usize> {"
    yield "    let count = self.whole(field)?.count();"
    yield "    if count == 0 {"
    yield "        self.read_f64(field, 0, 0, 0, 0, &mut [])?; // says which fields there are"
    yield "    }"
    yield "    Ok(count)"
    yield "}"
    yield ""
    alternates = str(thing.range_alternates).lower()
    for verb, own, values, given, pointer in (
            ("read", "&self", "", "Vec<T>", "values.as_mut_ptr().cast()"),
            ("write", "&mut self", ", values: &[T]", "()", "values.as_ptr().cast()")):
        what = "All values of a field" if verb == "read" else "Writes all values of a field"
        yield f"/// {what}, as `{verb}_f32` or `{verb}_f64`."
        yield f"pub fn {verb}<T: Number>({own}, field: Field{values}) -> Result<{given}> {{"
        yield "    let whole = self.whole(field)?;"
        if verb == "read":
            yield "    let mut values = vec![T::default(); whole.count()];"
        yield f"    let [a, b, c, d] = whole.range({alternates});"
        yield "    let field = field as i32;"
        yield "    check(unsafe {"
        yield "        if T::SINGLE {"
        for kind in ("f32", "f64"):
            yield (f"            sys::{thing.handle}_{verb}_{kind}(self.as_ptr(), field, a, b, c, d, {pointer}, "
                   "values.len())")
            yield "        } else {" if kind == "f32" else "        }"
        yield "    })?;" if verb == "read" else "    })"
        if verb == "read":
            yield "    Ok(values)"
        yield "}"
        yield ""


def life(thing):
    name, create = pascal(thing.name), thing.create
    given = [p for p in create.arguments if p.role != "callbacks"]
    safe = ", ".join(f"{variable(p.name)}: {argument_type(p)}" for p in given)
    every = ", ".join(f"{variable(p.name)}: {argument_type(p)}" for p in create.arguments)
    yield from doc(create.doc)
    yield f"pub fn new({safe}) -> Result<{name}> {{"
    values = ", ".join(variable(p.name) if p.role != "callbacks" else "None" for p in create.arguments)
    yield f"    unsafe {{ {name}::create({values}) }}"
    yield "}"
    yield ""
    yield f"/// [`{name}::new`] with callbacks."
    yield from safety()
    yield f"pub unsafe fn create({every}) -> Result<{name}> {{"
    yield "    check_version()?;"
    yield "    let mut made = std::ptr::null_mut();"
    passed = []
    for p in create.arguments:
        v = variable(p.name)
        if p.role == "callbacks":
            passed.append(f"{v}.map_or(std::ptr::null(), |c| c as *const _)")
        else:
            passed.append(f"{v} as i32" if p.enum else v)
    yield f"    check(unsafe {{ sys::{create.name}({', '.join([*passed, '&mut made'])}) }})?;"
    yield f"    Ok(unsafe {{ {name}::from_raw(made) }})"
    yield "}"
    yield ""
    yield "/// Takes a handle over."
    yield "///"
    yield "/// # Safety"
    yield "/// It must be one of the library's, alive, and of this kind, and nobody else may use it from then on."
    yield f"pub unsafe fn from_raw(handle: *mut sys::{thing.handle}) -> {name} {{"
    yield f"    {name} {{ handle: NonNull::new(handle).expect(\"a handle\") }}"
    yield "}"
    yield ""
    yield "/// The handle, for functions of [`sys`]; it stays this object's."
    yield f"pub fn as_ptr(&self) -> *mut sys::{thing.handle} {{"
    yield "    self.handle.as_ptr()"
    yield "}"
    yield ""
    yield "/// Gives the handle away, to be released by the caller."
    yield f"pub fn into_raw(self) -> *mut sys::{thing.handle} {{"
    yield "    std::mem::ManuallyDrop::new(self).handle.as_ptr()"
    yield "}"
    yield ""


def an_object(api, thing):
    name = pascal(thing.name)
    methods = [Method(api, thing, f) for f in thing.methods if not f.is_view]
    for m in methods:
        if len(m.function.results) > 1:
            yield from m.struct()
    yield from doc(thing.doc)
    yield f"pub struct {name} {{"
    yield f"    handle: NonNull<sys::{thing.handle}>,"
    yield "}"
    yield ""
    yield "// The library ties objects to no thread. They are not Sync, as NonNull is not."
    yield f"unsafe impl Send for {name} {{}}"
    yield ""
    yield f"impl Drop for {name} {{"
    yield "    fn drop(&mut self) {"
    yield f"        unsafe {{ sys::{thing.destroy.name}(self.as_ptr()) }}"
    yield "    }"
    yield "}"
    yield ""
    yield f"impl std::fmt::Debug for {name} {{"
    yield "    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {"
    yield "        std::fmt::Debug::fmt(&self.get_shape(), f)"
    yield "    }"
    yield "}"
    yield ""
    yield f"impl {name} {{"
    lines = list(life(thing)) + list(whole_fields(thing))
    for f in thing.methods:
        lines += view(thing, f) if f.is_view else Method(api, thing, f).text()
    while not lines[-1]:
        lines.pop()
    yield from ("    " + line if line else line for line in lines)
    yield "}"
    yield ""


def enumeration(name, enum):
    kind = pascal(name)
    yield from doc(enum["doc"] or f"{name}.")
    yield "#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]"
    yield "#[repr(i32)]"
    yield f"pub enum {kind} {{"
    for value in enum["values"]:
        yield from doc(value["doc"], "    /// ")
        yield f"    {pascal(value['short'])} = {value['value']},"
    yield "}"
    yield ""
    yield f"impl {kind} {{"
    yield "    /// Every one of them."
    yield f"    pub const ALL: [{kind}; {len(enum['values'])}] = ["
    yield from (f"        {kind}::{pascal(v['short'])}," for v in enum["values"])
    yield "    ];"
    yield ""
    yield "    /// The one with C's value."
    yield f"    pub fn from_raw(value: i32) -> Option<{kind}> {{"
    yield f"        {kind}::ALL.into_iter().find(|known| *known as i32 == value)"
    yield "    }"
    yield "}"
    yield ""


def free_function(f):
    if f.returns == "cd_status":
        method = Method(None, None, f)
        yield from method.struct()
        yield from method.text()
        return
    yield from doc(f.doc)
    parameters = ", ".join(f"{variable(p.name)}: {value_type(p)}" for p in f.arguments)
    values = ", ".join(f"{variable(p.name)} as i32" if p.enum else variable(p.name) for p in f.arguments)
    returns = "String" if f.returns == "const char*" else PLAIN[f.returns]
    call = f"sys::{f.name}({values})"
    yield f"pub fn {f.short}({parameters}) -> {returns} {{"
    yield f"    unsafe {{ {f'string_of({call})' if returns == 'String' else call} }}"
    yield "}"
    yield ""


def api_module(api):
    yield f"//! The library's objects. {MADE}"
    yield "use crate::support::{check, check_version, count_of, known, same, string_of, FieldRow, Whole};"
    yield "use crate::{sys, Number, Result, View};"
    yield "use std::ptr::NonNull;"
    yield ""
    for name, enum in api.enums.items():
        yield from enumeration(name, enum)
    for f in api.free:
        yield from free_function(f)
    for thing in api.objects:
        yield from an_object(api, thing)


# ---- tests ----------------------------------------------------------------------------------------------------------


def literal(p, kind, value):
    if kind == "number":
        return repr(float(value)) if p.base in ("double", "float") else repr(value)
    if kind == "flag":
        return str(value).lower()
    if kind == "enum":
        return f"{pascal(p.enum)}::{pascal(value)}"
    if kind == "array":
        text = f"&[{', '.join(map(repr, value))}]"
    elif kind == "room":
        text = f"&mut [{'0.0' if p.base in ('double', 'float') else '0'}; {value}]"
    elif kind == "made":
        return f"&make_{value}()"
    else:
        return {"bytes": "saved", "buffer": f"&mut vec![0; {value}]", "other": "other", "none": "None"}[kind]
    return f"Some({text})" if p.null else text


def same_as(told, given):
    return {"true": told, "false": f"!{told}"}.get(given, f"{told} == {given}")


def every_function(api):
    yield "// Every method with arguments with which it succeeds, and what getters say after setters."
    yield f"// {MADE}"
    yield "use super::functions::Call;"
    yield "use contdyn::*;"
    yield ""
    for thing in api.objects:
        name = pascal(thing.name)
        sizes = ", ".join(repr(float(x)) if isinstance(x, float) else repr(x) for x in sweep.sizes(thing))
        yield f"pub fn make_{thing.name}() -> {name} {{"
        yield f"    {name}::new({sizes}, Precision::Float64).unwrap()"
        yield "}"
        yield ""
        yield f"pub const {thing.name.upper()}: [Call<{name}>; {len([f for f in thing.methods])}] = ["
        for f in thing.methods:
            given = {p.name: literal(p, kind, value) for p, kind, value in sweep.arguments(thing, f, api.enums)}
            values = ", ".join(given[p.name] for p in f.arguments)
            short = f"{f.short}_into" if f.short == "save" else f.short
            call = f"o.{variable(short)}({values})"
            if f.has_callbacks:
                call = f"unsafe {{ {call} }}"
            uses = [name if f"{name}" in values else f"_{name}" for name in ("other", "saved")]
            yield "    Call {"
            yield f'        name: "{f.name}",'
            yield f"        may_fail: {str(sweep.may_fail(f)).lower()},"
            yield f"        call: |o, {', '.join(uses)}| {call}.map(drop),"
            getter = sweep.told_by(thing, f)
            if getter:
                asked = ", ".join(given[p.name] for p in getter.arguments)
                results = getter.results
                if len(results) == 1:
                    told = same_as(f"o.{variable(getter.short)}({asked}).unwrap()", given[results[0].word])
                    yield f"        told: |o| {told},"
                else:
                    yield "        told: |o| {"
                    yield f"            let told = o.{variable(getter.short)}({asked}).unwrap();"
                    equal = " && ".join(same_as(f"told.{variable(p.word)}", given[p.word]) for p in results)
                    yield f"            {equal}"
                    yield "        },"
            else:
                yield "        told: |_| true,"
            yield "    },"
        yield "];"
        yield ""


def scene_calls(api):
    yield "// How the words of a call in scenes.txt become the arguments of a method."
    yield f"// {MADE}"
    yield "use super::conformance::Words;"
    yield "use contdyn::*;"
    for thing in api.objects:
        name = pascal(thing.name)
        yield ""
        yield f"pub fn make_{thing.name}(w: &Words) -> std::result::Result<{name}, i32> {{"
        given = [p for p in thing.create.arguments if p.role != "callbacks"]
        yield f"    {name}::new({', '.join(word(p, k) for k, p in enumerate(given))}).map_err(|error| error.code())"
        yield "}"
        yield ""
        yield f"pub fn call_{thing.name}(o: &mut {name}, name: &str, w: &Words) -> std::result::Result<(), i32> {{"
        yield "    let result = match name {"
        for f in thing.methods:
            if f.is_const or any(p.role not in ("value", "array") or not p.is_in for p in f.arguments):
                continue
            values = ", ".join(word(p, k) for k, p in enumerate(f.arguments))
            yield f'        "{f.short}" => o.{variable(f.short)}({values}).map(drop),'
        yield '        _ => panic!("no call {name}"),'
        yield "    };"
        yield "    result.map_err(|error| error.code())"
        yield "}"


def word(p, k):
    if p.role == "array":
        kind = {"double": "doubles", "float": "floats"}.get(p.base, f"integers::<{PLAIN[p.base]}>")
        text = f"w.{kind}({k}).as_deref()"
        return text if p.null else f"{text}.unwrap()"
    if p.enum:
        return f"w.enumerator({k}, {pascal(p.enum)}::from_raw)?"
    if p.is_flag:
        return f"w.flag({k})"
    return f"w.{'number' if p.base == 'double' else 'size'}({k})"


def enumerators(api):
    yield ""
    yield "pub const ENUMERATORS: &[(&str, i32)] = &["
    for enum in api.enums.values():
        yield from (f'    ("{v["name"]}", {v["value"]}),' for v in enum["values"])
    yield "];"


def main():
    api = Description()
    tests = HERE / "tests" / "all"
    texts = {
        HERE / "src" / "sys.rs": sys_module(api),
        HERE / "src" / "api.rs": api_module(api),
        tests / "every_function.rs": every_function(api),
        tests / "scene_calls.rs": [*scene_calls(api), *enumerators(api)],
    }
    written_or_checked(__doc__, {path: "\n".join(fitted(lines)).rstrip("\n") + "\n" for path, lines in texts.items()})


if __name__ == "__main__":
    main()
