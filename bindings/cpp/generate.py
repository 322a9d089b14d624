#!/usr/bin/env python3
"""Makes contdyn.hpp of the texts in templates/ and of bindings/api.json.

    generate.py            writes include/contdyn/contdyn.hpp
    generate.py --check    fails if it is out of date

In a template a line between @ stands for what is made of api.json: @enum cd_node@ for an enumeration, @include FILE@
for another template, and, in a class, @set_mass get_mass@ for the functions of these names, whose calls follow from
their arguments. @set_tolerance(most_iterations = 100)@ tells a default, @get_tolerance -> stopping@ the struct that
several results are returned in. Functions that do more than to call are written in the templates.
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "generate"))
from description import WIDTH, Description, NotUnderstood, written_or_checked  # noqa: E402

HERE = Path(__file__).resolve().parent
TYPES = {"size_t": "std::size_t", "uint64_t": "std::uint64_t", "int32_t": "bool", "double": "double"}
INDENT = "    "


def type_of(parameter):
    return parameter.enum[3:] if parameter.enum else TYPES[parameter.base]


def name_of(parameter):
    """A parameter that has its type's name is called by its first letter."""
    return parameter.word[0] if parameter.enum and parameter.word == parameter.enum[3:] else parameter.word


def filled(before, items, after, indent):
    """The lines of before + items, with commas between them, + after; they go on below what follows `before`."""
    lines, column = [indent + before], len(indent + before)
    for i, item in enumerate(items):
        item += after if i + 1 == len(items) else ","
        space = " " if i and lines[-1].strip() else ""
        if len(lines[-1]) + len(space) + len(item) > WIDTH and i:
            lines.append(" " * column + item)
        else:
            lines[-1] += space + item
    return lines if items else [lines[0] + after]


class Member:
    def __init__(self, function, struct=None, defaults=""):
        self.function, self.struct = function, struct
        self.defaults = dict(part.split(" = ") for part in re.split(r", (?=\w+ = )", defaults) if part)
        self.results = [p for p in function.parameters if p.role == "result"]
        self.parameters, self.arguments = [], []
        for p in function.parameters:
            if p.role == "value":
                self.add(f"{type_of(p)} {name_of(p)}", name_of(p))
            elif p.role == "callbacks":
                self.add(f"{p.type} {p.word}", p.word)
            elif p.role == "array" and p.times == 1:
                self.add(f"span<{'const ' if p.is_in else ''}{p.base}> {p.word}", f"{p.word}.data()")
            elif p.role == "length" and len(p.of) == 1:
                self.arguments.append(f"{function.by_name[p.of[0]].word}.size()")
            elif p.role == "result" and struct and not p.enum and not p.is_flag:
                self.arguments.append(f"&out.{p.word}")
            elif p.role != "self" and (p.role != "result" or len(self.results) > 1):
                raise NotUnderstood(f"{function.name}: {p.name} is more than an argument: write the function")
        if set(self.defaults) - {name for name in map(name_of, function.arguments)}:
            raise NotUnderstood(f"{function.name}: defaults of {', '.join(self.defaults)}")

    def add(self, parameter, argument):
        name = parameter.split(" ")[-1]
        self.parameters.append(parameter + (f" = {self.defaults[name]}" if name in self.defaults else ""))
        self.arguments.append(argument)

    def text(self):
        """The lines of the definition."""
        c, short = self.function.name, self.function.short
        const = " const" if self.function.is_const else ""
        if self.struct:
            call = [f"return detail::got({c}(", ["handle_", *self.arguments], "), out);"]
            result, before = self.struct, [f"{self.struct} out{{}};"]
        elif self.results:
            result, before = type_of(self.results[0]), []
            call = [f"return value<{result}>(", [c, *self.arguments], ");"]
        else:
            result, before = "", []
            call = ["return call(", [c, *self.arguments], ");"]
        head = f"outcome<{result}> {short}("
        line = f"{INDENT}{head}{', '.join(self.parameters)}){const} {{ {call[0]}{', '.join(call[1])}{call[2]} }}"
        if not before and len(line) <= WIDTH:
            return [line]
        inner = INDENT * 2
        body = filled(*call, inner)
        if self.struct and len(body) > 1:  # the call on a line of its own
            body = [inner + "return detail::got(", *filled(f"{c}(", call[1], call[2], inner + INDENT)]
        return [*filled(head, self.parameters, f"){const} {{", INDENT), *[inner + b for b in before], *body, INDENT + "}"]


KEYWORDS = {"auto"}  # of C++, which no enumerator may be


def enumeration(enum):
    name = enum["name"][3:]
    attribute = "[[nodiscard]] " if name == "status" else ""
    items = [f"{value['short']}{'_' * (value['short'] in KEYWORDS)} = {value['name']}" for value in enum["values"]]
    line = f"enum class {attribute}{name} : std::int32_t {{ {', '.join(items)} }};"
    if len(line) <= WIDTH:
        return [line]
    return [line[:line.index("{") + 1], *[f"{INDENT}{item}," for item in items[:-1]], INDENT + items[-1], "};"]


class Header:
    def __init__(self, api):
        self.api, self.made = api, set()

    def lines(self, name):
        """A template's lines, with what stands between @ made."""
        thing = next((o for o in self.api.objects if name == f"{o.name}.hpp.in"), None)
        for line in (HERE / "templates" / name).read_text(encoding="utf-8").splitlines():
            told = re.fullmatch(r" *@(.+)@", line)
            if not told:
                yield line
            elif told[1].startswith("include "):
                yield from self.lines(told[1][len("include "):])
            elif told[1].startswith("enum "):
                self.made.add(told[1][len("enum "):])
                yield from enumeration(self.api.enums[told[1][len("enum "):]])
            else:
                for short, defaults, struct in re.findall(r"(\w+)(?:\((.*?)\))?(?: -> ([\w:<>]+))?(?: |$)", told[1]):
                    function = thing.by_short[short]
                    self.made.add(function.name)
                    yield from Member(function, struct, defaults).text()

    def text(self):
        lines = "\n".join(self.lines("contdyn.hpp.in")) + "\n"
        names = {f.name for f in self.api.functions} | set(self.api.enums)
        missing = sorted(name for name in names - self.made if not re.search(rf"\b{name}\b", lines))
        if missing:
            raise NotUnderstood(f"in no template: {', '.join(missing)}")
        return lines


def main():
    written_or_checked(__doc__, {HERE / "include/contdyn/contdyn.hpp": Header(Description()).text()})


if __name__ == "__main__":
    main()
