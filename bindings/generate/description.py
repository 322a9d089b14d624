"""bindings/api.json as generators read it: what the caller of a function gives, what comes back, how long arrays are,
and the names that several languages share. A generator says at its end

    written_or_checked(__doc__, {path: text, ...})
"""
import json
import sys
import textwrap
from pathlib import Path

BINDINGS = Path(__file__).resolve().parents[1]
WIDTH = 120

# How many places a whole field has, along the two directions of its range: "nodes" are one more than the size of that
# direction, "springs" as many, and one more in a ring; "strands" are one where the strands share the field.
EXTENTS = {
    ("chain", "node"): ("strands", "nodes"),
    ("chain", "spring"): ("strands", "springs"),
    ("membrane", "node"): ("nodes", "nodes"),
    ("membrane", "spring u"): ("springs", "nodes"),
    ("membrane", "spring v"): ("nodes", "springs"),
    ("water", "cell"): ("cells", "cells"),
    ("water", "x-face"): ("nodes", "cells"),
    ("water", "y-face"): ("cells", "nodes"),
}

# Arguments that a caller may leave out: a number, or the short name of an enumerator.
DEFAULTS = {("create", "precision"): "float64", ("step", "count"): 1, ("sample", "outside"): "refused",
            ("sample_heads", "outside"): "refused"}


class NotUnderstood(Exception):
    pass


def pascal(name):
    """mass_rule -> MassRule; the prefix cd_ is left out."""
    name = name[3:] if name.lower().startswith("cd_") else name
    return "".join(part[:1].upper() + part[1:].lower() for part in name.split("_"))


def camel(name):
    """first_strand -> firstStrand."""
    word = pascal(name)
    return word[:1].lower() + word[1:]


def escaped(name, keywords, form):
    """A name, or what `form` makes of it where it is a keyword of the language."""
    return form.format(name) if name in keywords else name


def comment(text, start, width=WIDTH):
    """The lines of a comment, each after `start`; its paragraphs are filled anew."""
    for paragraph in text.split("\n\n"):
        yield from textwrap.wrap(" ".join(paragraph.split()), width, initial_indent=start, subsequent_indent=start,
                                 break_long_words=False, break_on_hyphens=False)


def fitted(lines, width=WIDTH):
    """The lines, those that are too long broken after commas outside of quotes; what goes on is indented by four."""
    for line in lines:
        if line.lstrip().startswith(("//", "--")):
            yield line
            continue
        indent = " " * (len(line) - len(line.lstrip()) + 4)
        while len(line) > width:
            places = [at for at in range(len(indent), width) if line[at - 1:at + 1] == ", " and
                      line.count('"', 0, at) % 2 == 0]
            if not places:
                break
            at = places[-1]
            yield line[:at]
            line = indent + line[at + 1:]
        yield line


class Parameter:
    def __init__(self, entry, enums):
        self.name, self.type, self.base, self.role = entry["name"], entry["type"], entry["base"], entry["role"]
        self.is_in = entry["direction"] == "in"
        self.null = entry.get("null", False)
        self.length, self.times, self.of = entry.get("length"), entry.get("times"), entry.get("of", [])
        if self.role == "array" and self.base in enums:
            self.base = "int32_t"  # enumerators in arrays are plain numbers
        self.enum = self.base if self.base in enums else None
        self.is_flag = self.base == "int32_t" and self.role in ("value", "result")
        self.is_const = self.type.startswith("const ")
        allowed = entry.get("range") or {}
        self.may_be_none = self.role == "value" and "SIZE_MAX" in allowed.get("values", [])

    @property
    def word(self):
        """Its name, of an output without out_."""
        return self.name[4:] if self.name.startswith("out_") else self.name


class Length:
    """A parameter that says how long arrays are: it follows from `first`, and the others must agree."""

    def __init__(self, parameter, arrays):
        self.name = parameter.name
        given = [a for a in arrays if a.is_in] or arrays
        self.first = next((a for a in given if isinstance(a.times, int)), given[0])
        self.arrays = arrays
        self.others = [a for a in arrays if a is not self.first]
        self.given = self.first.is_in


class Function:
    def __init__(self, entry, enums):
        self.name, self.short, self.object = entry["name"], entry["short"], entry["object"]
        self.doc, self.returns, self.section = entry["doc"], entry["returns"], entry["section"]
        self.parameters = [Parameter(p, enums) for p in entry["parameters"]]
        self.own = next((p for p in self.parameters if p.role == "self"), None)
        self.is_const = bool(self.own and self.own.is_const)
        self.by_name = {p.name: p for p in self.parameters}
        for p in self.parameters:
            p.default = DEFAULTS.get((self.short, p.name))
        roles = ("value", "handle", "array", "bytes", "callbacks")
        self.arguments = [p for p in self.parameters if p.role in roles]
        self.results = [p for p in self.parameters if p.role in ("result", "address")]
        self.created = next((p for p in self.parameters if p.role == "created"), None)
        self.lengths = [Length(p, [self.by_name[name] for name in p.of])
                        for p in self.parameters if p.role == "length"]
        self.is_method = self.own is not None and self.short != "destroy"
        self.is_view = any(p.role == "address" for p in self.parameters)
        self.has_callbacks = any(p.role == "callbacks" for p in self.parameters)
        self.is_range = self.short in ("read_f32", "read_f64", "write_f32", "write_f64")

    def length_of(self, array):
        return next(length for length in self.lengths if array in length.arrays)

    def out_count(self, array, has_components):
        """How many values an output array has, as far as it follows from other arguments: a list of factors, each a
        number, the name of a size, ("count", length) for a length that input arrays give, or "components"; None where
        it does not follow."""
        length, times = self.length_of(array), array.times
        if length.given:
            return [("count", length), times]
        if any(p.base == "cd_field" for p in self.parameters):
            return [*self.range_sizes(), "values"]
        if length.name == "height_count":  # as large as a bed that the caller knows
            return None
        if array.name == "out_load" and has_components:  # force and moment, in any number of components
            return [6]
        each = ["components"] if has_components else None
        places = next((other for other in self.lengths if other.given), None)
        if each and places:
            return [("count", places), *each, times]
        return each and [*each, times]

    def range_values(self):
        """The four numbers of a range: (name, whether it is where the range begins)."""
        sizes = [p for p in self.arguments if p.role == "value" and not p.enum]
        return [(p.name, p.name.startswith("first")) for p in sizes]

    def range_sizes(self):
        return [name for name, begins in self.range_values() if not begins]


class Object:
    def __init__(self, entry, functions):
        self.name, self.handle, self.doc, self.fields = entry["name"], entry["handle"], entry["doc"], entry["fields"]
        self.header = entry["header"]
        own = [f for f in functions if f.object == self.name]
        self.create = next(f for f in own if f.short == "create")
        self.destroy = next(f for f in own if f.short == "destroy")
        self.methods = [f for f in own if f.is_method]
        self.by_short = {f.short: f for f in own}
        self.shape = [p.word for p in self.by_short["get_shape"].results]
        self.sizes = self.shape[:2]
        self.has_components = "components" in self.shape
        self.view_axes = [p.word[: -len("_stride")] for p in self.by_short["view"].results if p.role == "result"]

    @property
    def range_alternates(self):
        """Whether the four numbers of a range are first, n, first, n instead of first, first, n, n."""
        return self.by_short["read_f64"].range_values()[1][1] is False

    def results_of(self, short):
        """The outputs' names of a function that the object may lack."""
        return [p.word for p in self.by_short[short].results] if short in self.by_short else []

    def extents(self, field):
        """Of the two directions of a field's range: (the size that counts it or None for 1, how many more, the flag of
        get_ring that adds one or None, whether only ropes have each strand's own)."""
        per = field["per"][-1]
        if per == "spring" and field["name"][-2:] in ("_U", "_V"):
            per += " " + field["name"][-1].lower()
        if (self.name, per) not in EXTENTS:
            raise NotUnderstood(f"{field['name']} of {self.name}: how many places per {per}?")
        ring = self.results_of("get_ring")
        for k, what in enumerate(EXTENTS[self.name, per]):
            if what == "strands":
                shared = "strand" not in field["per"]
                yield None if shared else self.sizes[k], int(shared), None, field["own_in_ropes"]
            else:
                flag = ring[min(k, len(ring) - 1)] if what == "springs" else None
                yield self.sizes[k], int(what == "nodes"), flag, False

    def field_rows(self):
        """(field, its two extents as numbers that a table holds): (which size, 0 for none; how many more; which flag
        of get_ring, 0 for none), and then whether the first extent is 1 but in ropes."""
        ring = self.results_of("get_ring")
        for field in self.fields:
            extents = list(self.extents(field))
            numbers = []
            for size, more, flag, _ in extents:
                numbers += [self.sizes.index(size) + 1 if size else 0, more, ring.index(flag) + 1 if flag else 0]
            yield field, numbers, extents[0][3]


class Description:
    def __init__(self, path=BINDINGS / "api.json"):
        self.json = json.loads(path.read_text(encoding="utf-8"))
        self.version = [macro["value"] for macro in self.json["macros"]]
        self.enums = {enum["name"]: enum for enum in self.json["enums"]}
        self.callbacks = self.json["callbacks"]
        self.functions = [Function(f, self.enums) for f in self.json["functions"]]
        self.objects = [Object(o, self.functions) for o in self.json["objects"]]
        self.free = [f for f in self.functions if f.object is None]

    def field_value(self, name):
        return next(v["value"] for v in self.enums["cd_field"]["values"] if v["name"] == name)


def bound_context(member, function):
    """Of a callback's parameter that is itself a function: the parameter that it must be called with, by its name."""
    names = [p["name"] for p in member["parameters"] if not p.get("function")]
    return next((p["name"] for p in function["parameters"] if p.get("type") == "void*" and p["name"] in names), None)


def written_or_checked(usage, files):
    """Writes the texts, or with --check fails if one of them is not what its file holds."""
    if sys.argv[1:] == ["--check"]:
        for path, text in files.items():
            if not path.exists() or path.read_text(encoding="utf-8") != text:
                sys.exit(f"{path} is out of date: run {Path(sys.argv[0])}")
    elif sys.argv[1:]:
        sys.exit(usage)
    else:
        for path, text in files.items():
            path.write_text(text, encoding="utf-8")
