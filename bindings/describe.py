#!/usr/bin/env python3
"""Describes the C API as JSON, from the public headers alone.

    describe.py                 writes bindings/api.json
    describe.py --check         fails if bindings/api.json is not what would be written
    describe.py --include DIR   reads DIR/contdyn/*.h instead of the headers beside this script's folder
    describe.py --output FILE   another file; - is standard output

What the file holds is told in README.md. A line of a header that is not understood is an error, never skipped.
"""
import argparse
import difflib
import json
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from facts import LIMITS, Facts, NotUnderstood  # noqa: E402

HERE = Path(__file__).resolve().parent
HEADERS = ["base.h", "chain.h", "membrane.h", "water.h"]
NUMBERS = {"int32_t": 32, "uint32_t": 32, "uint64_t": 64, "size_t": 0, "float": 32, "double": 64}

# ---- what the declarations do not say ----
# But the comments above them do, and tests/bindings/check_api.py holds the library to it. Units, ranges, defaults and
# errors are found by facts.py.

# Pointers that may be null, beyond allocators, callbacks and what a comment says of "each output".
NULLABLE = {
    "cd_chain_destroy": ["chain"],
    "cd_membrane_destroy": ["membrane"],
    "cd_water_destroy": ["water"],
    "cd_chain_attach": ["target"],
    "cd_membrane_attach": ["target"],
    "cd_chain_teleport": ["rotation"],
    "cd_membrane_teleport": ["rotation"],
    "cd_chain_set_callback": ["origin"],
    "cd_membrane_set_callback": ["origin"],
    "cd_membrane_get_collider": ["out_shape", "out_first", "out_second", "out_velocity", "out_radius", "out_friction"],
    "cd_water_add_volume": ["out_added"],
    "cd_water_set_hull": ["heights"],
    "cd_water_add_volume_rectangle": ["out_added"],
}
# Tables of callbacks that may not.
NEEDED = {"cd_distance"}
EACH_MAY_BE_NULL = re.compile(r"each\s+(output\s+)?may\s+be\s+null", re.IGNORECASE)

# Arrays that hold more than one number for each place that their length counts, or have no length after them: the
# parameter that counts, and how many numbers there are for each that it counts, or the parameter that says how many.
LENGTHS = {
    ("cd_chain_set_plane", "point"): ("count", 1),
    ("cd_chain_set_capsule", "first"): ("count", 1),
    ("cd_chain_get_collider", "out_first"): ("count", 1),
    ("cd_chain_get_collider", "out_second"): ("count", 1),
    ("cd_membrane_set_plane", "point"): ("count", 1),
    ("cd_membrane_set_capsule", "first"): ("count", 1),
    ("cd_membrane_get_collider", "out_first"): ("count", 1),
    ("cd_membrane_get_collider", "out_second"): ("count", 1),
    ("cd_chain_set_bed", "heights"): ("height_count", 1),
    ("cd_chain_get_bed", "out_heights"): ("height_count", 1),
    ("cd_membrane_set_bed", "heights"): ("height_count", 1),
    ("cd_membrane_get_bed", "out_heights"): ("height_count", 1),
    ("cd_chain_teleport", "rotation"): ("count", "count"),
    ("cd_membrane_teleport", "rotation"): ("count", "count"),
    ("cd_membrane_sample", "at"): ("n", 2),
    ("cd_water_sample", "at"): ("n", 2),
    ("cd_water_sample_heads", "at"): ("n", 2),
    ("cd_water_sample_heads", "out_heads"): ("n", 1),
    ("cd_water_sample", "out_surface"): ("n", 1),
    ("cd_water_sample", "out_depth"): ("n", 1),
    ("cd_water_sample", "out_normal"): ("n", 3),
    ("cd_water_sample", "out_velocity"): ("n", 2),
}

# Of each object's fields: those with a component per value, those always there, those cd_*_view shows, those that only
# what has rest lengths has, ropes and cloth, and those that cannot be written.
FIELD_FACTS = {
    "chain": {
        "components": "POSITION VELOCITY FORCE TARGET WIND",
        "always": "POSITION VELOCITY PIN TENSION STRAIN",
        "viewable": "POSITION VELOCITY FORCE TARGET",
        "lengths": "REST_LENGTH TENSION WIND STRENGTH STRAIN REST_ANGLE",
        "read_only": "STRAIN",
    },
    "membrane": {
        "components": "POSITION VELOCITY FORCE TARGET WIND",
        "always": "POSITION VELOCITY TENSION_U TENSION_V STRAIN_U STRAIN_V",
        "viewable": "POSITION VELOCITY FORCE TARGET",
        "lengths": "REST_LENGTH_U REST_LENGTH_V BREAKING_STRAIN_U BREAKING_STRAIN_V WIND TENSION_U TENSION_V STRAIN_U "
                   "STRAIN_V",
        "read_only": "TENSION_U TENSION_V STRAIN_U STRAIN_V",
    },
    "water": {
        "components": "",
        "always": "DEPTH BED SURFACE VELOCITY_X VELOCITY_Y",
        "viewable": "DEPTH BED VELOCITY_X VELOCITY_Y SOURCE PRESSURE FORCE_X FORCE_Y",
        "lengths": "",
        "read_only": "",
    },
}

# What a field may have its values per.
PLACES = {"strand", "node", "spring", "cell", "x-face", "y-face"}


# ---- comments -------------------------------------------------------------------------------------------------------


def text_of(comment):
    """The comment's words, line by line, without its stars."""
    lines = comment[2:-2].split("\n")
    return "\n".join(re.sub(r"^\s*\*? ?", "", line) if i else line.strip() for i, line in enumerate(lines)).strip()


SECTION = re.compile(r"/\* ---- ([a-z :]+?) -+( ?\*/|$)")

# ---- declarations ---------------------------------------------------------------------------------------------------

PARAMETER = re.compile(r"^(const )?([a-z_0-9]+)(\*{0,2}) ([a-z_0-9]+)$")
FUNCTION = re.compile(r"^CD_API ((?:const )?[a-z_0-9]+\*?) (cd_[a-z_0-9]+)\((.*)\);$")
MEMBER_FUNCTION = re.compile(r"^((?:const )?[a-z_]+\*?) \(\*([a-z_]+)\)\((.*)\)$")


def split_parameters(text):
    """The parameters between commas that no parenthesis holds."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter == "(") - (letter == ")")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


class Description:
    def __init__(self):
        self.enums, self.objects, self.callbacks, self.functions, self.macros, self.sections = [], [], [], [], [], []
        self.doc = ""
        self.used = set()  # entries of the tables above

    # -- types --

    def enum_names(self):
        return [enum["name"] for enum in self.enums]

    def handles(self):
        return {thing["handle"]: thing["name"] for thing in self.objects}

    def check_type(self, base, where):
        known = [*NUMBERS, "void", "char", *self.enum_names(), *self.handles(), *(c["name"] for c in self.callbacks)]
        if base not in known:
            raise NotUnderstood(f"{where}: type '{base}' is not declared")

    # -- the kinds of declaration --

    def enum(self, header, name, body, doc):
        values, after, doc_of = [], -1, {}
        for match in re.finditer(r"/\*(?:.|\n)*?\*/|([A-Z_0-9]+) = (-?\d+)(,?)|(\S)", body):
            if match.group(4):
                raise NotUnderstood(f"{header}: enum {name}: '{match.group(4)}' in '{body}'")
            if match.group(1):
                values.append((match.group(1), int(match.group(2))))
                after = len(values) - 1
            elif after < 0 or after in doc_of:
                raise NotUnderstood(f"{header}: enum {name}: a comment that belongs to no value")
            else:
                doc_of[after] = " ".join(text_of(match.group(0)).split())
        if not values or len({value for _, value in values}) != len(values):
            raise NotUnderstood(f"{header}: enum {name} has no values, or one twice")
        words = [value_name.split("_") for value_name, _ in values]
        common = 0
        while common < 2 and all(len(w) > common + 1 and w[common] == words[0][common] for w in words):
            common += 1
        self.enums.append({
            "name": name, "header": header, "type": "int32_t", "doc": doc,
            "values": [{"name": value_name, "short": "_".join(value_name.split("_")[common:]).lower(), "value": value,
                        "doc": doc_of.get(i, "")} for i, (value_name, value) in enumerate(values)],
        })

    def callback(self, header, name, body, doc):
        members = []
        for declaration in body.split(";"):
            declaration = " ".join(declaration.split())
            if not declaration:
                continue
            function, plain = MEMBER_FUNCTION.match(declaration), PARAMETER.match(declaration)
            if function:
                members.append({"name": function.group(2), "function": True, **self.signature(
                    name, function.group(1), function.group(3))})
            elif plain:
                members.append({"name": plain.group(4), "function": False, "type": plain.group(2) + plain.group(3)})
            else:
                raise NotUnderstood(f"{header}: {name}: '{declaration}'")
        self.callbacks.append({"name": name, "header": header, "doc": doc, "members": members})

    def signature(self, name, returns, parameters):
        result = {"returns": returns, "parameters": []}
        for text in [] if parameters == "void" else split_parameters(parameters):
            function, plain = MEMBER_FUNCTION.match(text), PARAMETER.match(text)
            if function:
                result["parameters"].append({"name": function.group(2), "function": True, **self.signature(
                    name, function.group(1), function.group(3))})
            elif plain:
                const, base, stars, parameter = plain.groups()
                self.check_type(base, name)
                result["parameters"].append({"name": parameter, "type": f"{const or ''}{base}{stars}"})
            else:
                raise NotUnderstood(f"{name}: parameter '{text}'")
        return result

    def function(self, header, section, text, doc):
        match = FUNCTION.match(text)
        if not match:
            raise NotUnderstood(f"{header}: '{text}'")
        returns, name, parameters = match.groups()
        self.check_type(returns.replace("const ", "").rstrip("*"), name)
        thing = next((t["name"] for t in self.objects if name.startswith(f"cd_{t['name']}_")), None)
        if (thing or "base") + ".h" != header:
            raise NotUnderstood(f"{name} is in {header}")
        function = {"name": name, "header": header, "section": section, "object": thing,
                    "short": name[len(f"cd_{thing}_" if thing else "cd_"):], "returns": returns,
                    "parameters": self.signature(name, returns, parameters)["parameters"], "doc": doc}
        for i, parameter in enumerate(function["parameters"]):
            self.explain(function, i, parameter)
        for parameter in function["parameters"]:
            counts = [p["name"] for p in function["parameters"] if p.get("length") == parameter["name"]]
            if counts:
                parameter.update(role="length", of=counts)
        self.functions.append(function)

    def explain(self, function, i, parameter):
        """Direction, role, length and whether it may be null, of one parameter."""
        name, parameters = parameter["name"], function["parameters"]
        const, base, stars, _ = PARAMETER.match(f"{parameter['type']} {name}").groups()
        out = stars and name.startswith("out_")
        direction, role = "in", "value"
        if stars and not const and not out and base == "void":
            direction = "inout" if function["short"] == "write_vertices" else "out"
            role = "bytes"
        elif base in self.handles() and stars == "*" and not out:
            role = "self" if i == 0 else "handle"
            if self.handles()[base] != function["object"]:
                raise NotUnderstood(f"{function['name']}: a handle of another kind, '{name}'")
            direction = "in" if const else "inout"
        elif base in self.handles() and stars == "**" and out:
            direction, role = "out", "created"
        elif stars == "*" and const and base in [c["name"] for c in self.callbacks]:
            role = "callbacks"
        elif stars == "*" and const and base == "void":
            role = "bytes"
        elif stars == "**" and const and base == "void" and out:
            direction, role = "out", "address"
        elif stars == "*" and (base in NUMBERS or base in self.enum_names()) and bool(const) != bool(out):
            direction = "out" if out else "in"
            follower = parameters[i + 1]["name"] if i + 1 < len(parameters) else ""
            counted = follower in ("count", "n", "out_count") or (function["name"], name) in LENGTHS
            role = "array" if counted else "result"
            if role == "result" and not out:
                raise NotUnderstood(f"{function['name']}: how many numbers is '{name}'?")
        elif stars or out or const:
            raise NotUnderstood(f"{function['name']}: parameter '{parameter['type']} {name}'")
        parameter.update(direction=direction, role=role, base=base)
        if role in ("array", "bytes"):
            length, times = self.table(LENGTHS, (function["name"], name)) or (parameters[i + 1]["name"], 1)
            sizes = [p["name"] for p in parameters if p["type"] == "size_t"]
            if length not in sizes or not (isinstance(times, int) or times in sizes):
                raise NotUnderstood(f"{function['name']}: '{name}' has no length")
            parameter.update(length=length, times=times)
        if stars:
            each = direction == "out" and role in ("result", "array") and EACH_MAY_BE_NULL.search(function["doc"])
            parameter["null"] = bool(
                (role == "callbacks" and base not in NEEDED) or each or name in (self.table(NULLABLE, function["name"]) or []))

    def table(self, table, key):
        if key in table:
            self.used.add((id(table), key))
        return table.get(key)

    # -- a whole header --

    def read(self, header, text):
        for kept, name, value in re.findall(r"^#define ((\w+)[ \t]*(.*))$", text, re.MULTILINE):
            if re.fullmatch(r"CD_VERSION_[A-Z]+", name) and value.isdigit():
                self.macros.append({"name": name, "header": header, "value": int(value)})
            elif kept != f"CONTDYN_{header.upper().replace('.', '_')}":
                raise NotUnderstood(f"{header}: #define {kept}")
        text = re.sub(r'#ifdef __cplusplus\n(extern "C" \{|\})\n#endif\n', "", text)
        text = re.sub(r"^#(define|include|ifndef|endif).*\n?", "", text, flags=re.MULTILINE)
        if re.search(r"^#", text, re.MULTILINE):
            raise NotUnderstood(f"{header}: a directive: {re.search('^#.*', text, re.MULTILINE).group(0)}")
        head, text = re.match(r"(/\*(?:.|\n)*?\*/)\n*((?:.|\n)*)", text).groups()
        thing = re.search(r"^typedef struct (cd_[a-z]+) \1;$", text, re.MULTILINE)
        if not thing:
            self.doc = text_of(head)
        else:
            name = thing.group(1)[3:]
            self.objects.append({"name": name, "handle": thing.group(1), "header": header, "doc": text_of(head),
                                 "fields": []})
        self.read_parts(header, text, self.objects[-1] if thing else None)

    def read_parts(self, header, text, thing):
        section, doc, alone = "", "", True
        part = re.compile(r"(?P<comment>/\*(?:.|\n)*?\*/)|(?P<blank>\n[ \t]*\n)|(?P<space>\s+)"
                          r"|typedef struct (?P<opaque>cd_[a-z]+) (?P=opaque);"
                          r"|typedef struct (?P<callback>cd_[a-z]+) \{(?P<members>[^}]*)\} (?P=callback);"
                          r"|typedef int32_t (?P<enum>cd_[a-z_]+);\nenum \{(?P<values>(?:[^}/]|/\*(?:.|\n)*?\*/)*)\};"
                          r"|(?P<function>CD_API [^;]*;)")
        at = 0
        while at < len(text):
            match = part.match(text, at)
            if not match:
                raise NotUnderstood(f"{header}: '{text[at:at + 80].splitlines()[0]}...'")
            at = match.end()
            if match["comment"]:
                title = SECTION.match(match["comment"].split("\n")[0])
                if match["comment"].startswith("/* ---") and not title:
                    raise NotUnderstood(f"{header}: the section '{match['comment'].splitlines()[0]}'")
                if title or alone and section and re.match(r"\n[ \t]*\n", text[at:]):
                    if title:
                        section = title.group(1)
                    doc = ""
                    self.section(header, section, match["comment"], thing)
                elif re.match(r"\s*\n/\* ", text[at:]) and section and not doc:
                    self.section(header, section, match["comment"], thing)
                else:
                    doc = text_of(match["comment"])
            elif match["blank"]:
                doc = ""
            elif match["callback"]:
                self.callback(header, match["callback"], match["members"], doc)
            elif match["enum"]:
                self.enum(header, match["enum"], match["values"], doc)
            elif match["function"]:
                self.function(header, section, " ".join(match["function"].split()), doc)

    def section(self, header, title, comment, thing):
        """A comment of a section's own; the one of fields ends in a table."""
        if not self.sections or (self.sections[-1]["header"], self.sections[-1]["title"]) != (header, title):
            self.sections.append({"header": header, "title": title, "doc": ""})
        lines = [line for line in text_of(comment).split("\n") if not re.match(r"-{4}", line)]
        self.sections[-1]["doc"] = (self.sections[-1]["doc"] + "\n" + "\n".join(lines)).strip("\n")
        if thing and title == "fields":
            self.field_table(thing, text_of(comment).split("\n"))

    def field_table(self, thing, lines):
        columns = [re.match(r"^ *field +per +unit +values$", line) and line for line in lines]
        head = next(line for line in columns if line)
        starts = [head.index(word) for word in ("field", "per", "unit", "values")]
        facts = {key: value.split() for key, value in FIELD_FACTS[thing["name"]].items()}
        row = []
        for line in lines[lines.index(head) + 1:]:
            cells = [line[a:b].strip() for a, b in zip(starts, starts[1:] + [None])]
            shorts = self.fields_of_row(cells[0])
            if shorts:
                row = [self.field(thing, short, facts, *cells[1:]) for short in shorts]
                thing["fields"] += row
            elif line[:starts[3]].strip() == "":
                for field in row:
                    field["values"] += " " + line.strip()
            else:
                break
        names = [field["name"][3:] for field in thing["fields"]]
        known = next(enum for enum in self.enums if enum["name"] == "cd_field")["values"]
        if not names or set(sum(facts.values(), [])) - set(names) or {f["name"] for f in thing["fields"]} - {
                value["name"] for value in known}:
            raise NotUnderstood(f"{thing['header']}: the table of fields, {names}")

    @staticmethod
    def fields_of_row(cell):
        """CD_STRAIN_U, _V: two fields alike."""
        pair = re.fullmatch(r"CD_([A-Z_]+)(_[A-Z]), (_[A-Z])", cell)
        if pair:
            return [pair.group(1) + pair.group(2), pair.group(1) + pair.group(3)]
        return [cell[3:]] if re.fullmatch(r"CD_[A-Z_]+", cell) else []

    @staticmethod
    def field(thing, short, facts, per, unit, values):
        per = per.replace(" ", "")
        places = per.replace("(strand)", "strand").split(",")
        if set(places) - PLACES or not unit:
            raise NotUnderstood(f"{thing['header']}: the table of fields, CD_{short} per '{per}'")
        return {"name": f"CD_{short}", "per": places, "unit": unit, "values": values,
                "components": short in facts["components"], "always": short in facts["always"],
                "viewable": short in facts["viewable"], "lengths": short in facts["lengths"],
                "own_in_ropes": "(strand)" in per, "read_only": short in facts["read_only"]}

    def check(self, include):
        unused = [key for table in (NULLABLE, LENGTHS) for key in table if (id(table), key) not in self.used]
        if unused:
            raise NotUnderstood(f"in a table of describe.py, but in no header: {unused}")
        for function in self.functions:
            if not function["doc"]:
                raise NotUnderstood(f"{function['name']} has no comment")
        Facts(self.functions, self.objects, self.sections, self.enums)
        beside = sorted(path.name for path in (include / "contdyn").glob("*.h"))
        if beside != sorted([*HEADERS, "contdyn.h", "export.h"]):
            raise NotUnderstood(f"the headers are {beside}")


def describe(include):
    description = Description()
    for header in HEADERS:
        description.read(header, (include / "contdyn" / header).read_text(encoding="utf-8"))
    description.check(include)
    version = {macro["name"][len("CD_VERSION_"):]: macro["value"] for macro in description.macros}
    return {
        "schema": 1,
        "library": "contdyn",
        "version": f"{version['MAJOR']}.{version['MINOR']}.{version['PATCH']}",
        "headers": HEADERS,
        "doc": description.doc,
        "macros": description.macros,
        "enums": description.enums,
        "callbacks": description.callbacks,
        "objects": description.objects,
        "sections": description.sections,
        "limits": [{"name": name, "doc": doc} for name, doc in LIMITS.items()],
        "functions": description.functions,
    }


def written(value, indent=0):
    """JSON whose lists and objects stand on one line where they fit."""
    line = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, (dict, list)) or not value or len(line) + indent <= 150:
        return line
    pad = " " * (indent + 1)
    if isinstance(value, list):
        return "[\n" + ",\n".join(pad + written(item, indent + 1) for item in value) + "\n" + " " * indent + "]"
    items = (f"{pad}{json.dumps(key)}: {written(item, indent + 1)}" for key, item in value.items())
    return "{\n" + ",\n".join(items) + "\n" + " " * indent + "}"


def main():
    arguments = argparse.ArgumentParser(description="Describes the C API as JSON, from the public headers.")
    arguments.add_argument("--include", type=Path, default=HERE.parent / "include")
    arguments.add_argument("--output", default=str(HERE / "api.json"))
    arguments.add_argument("--check", action="store_true")
    options = arguments.parse_args()
    try:
        text = written(describe(options.include)) + "\n"
    except NotUnderstood as why:
        sys.exit(f"describe.py: not understood: {why}")
    if options.check:
        kept = Path(options.output).read_text(encoding="utf-8")
        if kept != text:
            lines = difflib.unified_diff(kept.splitlines(), text.splitlines(), options.output, "headers", lineterm="")
            sys.exit("\n".join(lines) + f"\n{options.output} is out of date: run bindings/describe.py")
    elif options.output == "-":
        sys.stdout.write(text)
    else:
        Path(options.output).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
