"""Units, ranges, defaults and errors of functions, as data. What the comments of the headers tell of one parameter is
found in them; prose.py has the rest. tests/bindings/check_ranges.py holds the library to it."""
import re
import sys
from itertools import groupby

from prose import DEFAULTS, LIMITS, RANGES, UNITS, WHEN

# ---- what comments tell of a parameter ----

NUMBER = r"(?:-?\d+(?:\.\d+)?(?:e-?\d+)?(?:/\d+)?|INFINITY|SIZE_MAX)"
LIMIT = rf"(?:{NUMBER}|nu|nv)"
FACTOR = r"(?:kg|Pa|rad|[NmsJ1])(?:\^(?:\d+|\([\d/]+\)))?"
UNIT = rf"\[(?P<unit>{FACTOR}(?:[ /]{FACTOR})*)\]"
INTERVAL = rf"\[{LIMIT}, {LIMIT}\]"
RANGE = (rf"(?P<range>(?:{NUMBER} or )?in {INTERVAL}|>=? {NUMBER}(?: and at most {NUMBER}(?: cells)?)?"
         rf"(?:, of ropes up to {NUMBER})?|{NUMBER} to {NUMBER}(?:, or {NUMBER})?"
         rf"|at most {NUMBER} in size(?:, in CD_FLOAT32 1e30)?)")
DEFAULT = rf"[Dd]efault (?P<default>{NUMBER}|CD_[A-Z0-9_]+)"
AFTER_NAME = re.compile(rf"(?: ?{UNIT})?(?:,?(?: each,)? ?{RANGE})?(?:[,;.]? ?{DEFAULT})?")
ANY_DEFAULT = re.compile(rf"\b{DEFAULT}|(?P<value>{NUMBER}|CD_[A-Z0-9_]+), the default")
RANGE_AND_DEFAULT = re.compile(rf"(?P<range>[Ii]n {INTERVAL}), default")

PREPOSITIONS = ("in", "out")  # parameters' names that sentences have without naming them


def word(parameter):
    """Its name as comments have it."""
    name = parameter["name"]
    return name[4:] if name.startswith("out_") else name


def of_named(name, names, doc):
    """What follows the first mention of a parameter, alone or with another, that a unit, range or default follows."""
    others = "|".join(map(re.escape, names))
    for mention in re.finditer(rf"(?<![\w*/^.])`?\b{re.escape(name)}\b`?(?:(?:,| and) `?(?:{others})\b`?)?", doc):
        found = AFTER_NAME.match(doc, mention.end())
        if any(found.groupdict().values()):
            return {key: value for key, value in found.groupdict().items() if value}
    return {}


def of_subject(doc):
    """Of what a setter sets, or a getter tells: it is what the comment begins with. And the rest of that sentence."""
    sentence = re.match(r"(?:[^.:]|\.(?=\d))*", doc).group(0)
    found, at = {}, 0
    unit = re.search(UNIT, sentence)
    if unit:
        found["unit"], at = unit["unit"], unit.end()
    interval = re.compile(r",? ?" + RANGE).match(doc, at) if unit else None
    interval = RANGE_AND_DEFAULT.search(doc) or interval
    if not interval:  # further on in the sentence, or what it ends in
        interval = (re.compile(rf", {RANGE}").search(sentence, at)
                    or re.compile(rf": {RANGE}").match(doc, len(sentence)))
    if interval:
        found["range"] = interval["range"]
    default = ANY_DEFAULT.search(doc)
    if default:
        found["default"] = default["default"] or default["value"]
    return found, sentence[at:]


def of_comment(function):
    """{parameter: {"unit", "range", "default"}}, each a piece of the comment, where that tells it."""
    doc = " ".join(function["doc"].split())
    numbers = [p for p in function["parameters"] if p["role"] in ("value", "array", "result")]
    quantities = [p for p in numbers if p["base"] in ("double", "float")]
    names = [word(p) for p in numbers]
    facts = {p["name"]: of_named(word(p), names, doc) for p in numbers if p in quantities or p["base"] == "size_t"}
    facts = {name: found for name, found in facts.items() if found}
    if not function["short"].startswith(("set_", "get_")) or any(p["name"] in facts for p in quantities):
        return facts
    subject, rest = of_subject(doc)
    if not quantities and len(numbers) == 1:
        keys = ("range", "default") if numbers[0]["base"] == "size_t" else ("default",)
        facts[numbers[0]["name"]] = {key: subject[key] for key in keys if key in subject}
    elif len(quantities) == 1 or "unit" in subject:
        unnamed = [p for p in quantities
                   if len(quantities) == 1 or word(p) in PREPOSITIONS or not re.search(rf"\b{word(p)}\b", rest)]
        facts.update({p["name"]: dict(subject) for p in unnamed})
    return facts


# ---- as data ----

TABLES = (RANGES, WHEN, UNITS, DEFAULTS)


class NotUnderstood(Exception):
    pass


def number_of(text):
    """A number; a word such as INFINITY, CD_METHOD_IMPLICIT or nx * dx stays one."""
    text = text.strip()
    if re.fullmatch(r"-?\d+", text):
        return int(text)
    if not re.fullmatch(NUMBER, text) or text in ("INFINITY", "SIZE_MAX"):
        return text
    above, _, below = text.partition("/")
    return float(above) / float(below or 1)


def range_of(text, is_integer, ends):
    """A range in the comments' words as data. `ends`: the least positive and the largest number where none is told."""
    found, rest = {}, text[:1].lower() + text[1:]
    rest = rest.replace("1e60 in size, in CD_FLOAT32 1e30", "largest in size")
    for pattern, key in ((r"(.+), or (.+)", "values"), (r"(.+), of ropes up to (.+)", "in_ropes")):
        match = re.fullmatch(pattern, rest)
        if match:
            rest, found[key] = match[1], [number_of(match[2])]
    match = re.fullmatch(rf"({NUMBER}) or (.+)", rest)
    if match:
        first, rest = match.groups()
        found["values"] = [number_of(first)]
        if re.fullmatch(NUMBER, rest):
            return {"values": [number_of(first), number_of(rest)]}
    for pattern, keys in ((r"in \[(.+), (.+)\]", ("least", "most")), (r"(.+) to (.+)", ("least", "most")),
                          (r"less than (.+)", ("below",)), (r">= (.+) and at most (.+)", ("least", "most")),
                          (r"> (.+) and at most (.+)", ("above", "most")), (r">= (.+)", ("least",))):
        match = re.fullmatch(pattern, rest)
        if match:
            limits = {key: number_of(limit.replace(" cells", " * cell")) for key, limit in zip(keys, match.groups())}
            break
    else:
        size = re.fullmatch(r"at most (.+) in size", rest)
        if size:
            limits = {"least": number_of("-" + size[1]), "most": number_of(size[1])}
        elif rest == "> 0" and not is_integer:
            limits = {"least": ends[0]}
        else:
            raise NotUnderstood(f"the range '{text}'")
    if "below" in limits and len(limits) == 1:
        limits = {"least": 0, **limits}
    if not is_integer and "most" not in limits:
        limits["most"] = ends[1]
    return {**limits, **found}


def said(number):
    """A number, or the word for one, for people."""
    return re.sub(r"e\+?(-?)0*", r"e\1", f"{number:g}") if isinstance(number, float) else str(number)


def words_of(told):
    """A range for people, but for when it counts."""
    if isinstance(told, list):
        return "; ".join(words for words, _ in groupby(map(words_of, told)))
    least, most = said(told.get("least")), said(told.get("most"))
    if "least" not in told and "above" not in told:
        words = " or ".join(map(said, told["values"]))
    elif "above" in told:
        words = f"> {said(told['above'])} and at most {most}"
    elif "below" in told:
        words = f"less than {said(told['below'])}" if least == "0" else f"{least} to less than {said(told['below'])}"
    elif "most" not in told:
        words = f">= {least}"
    else:
        words = f"at most {most} in size" if least == f"-{most}" else f"in [{least}, {most}]"
    if "values" in told and words.startswith("in ["):
        others = " or ".join(map(said, told["values"]))
        words = f"{others} or {words}" if others == "0" else f"{words}, or {others}"
    if "in_ropes" in told:
        words += ", of ropes up to " + said(told["in_ropes"][-1])
    return words


ENDS = ("least", "above", "most", "below")


def depends(told):
    """Whether limits depend on the object or on other arguments."""
    return any(isinstance(told.get(key), str) for key in ENDS)


def ends_of(doc):
    """The least positive and the largest number that parameters may be, where an object's comment tells them."""
    found = [re.search(rf"{what} as (?:large|small) as ({NUMBER})", doc) for what in ("masses", "Parameters may be")]
    return [float(end[1]) if end else None for end in found]


def range_of_values(told, before, enums, ends):
    """The range of a field's values, which its table's row begins with. `before`: that of the row above."""
    flags = re.match(r"(\d): [^;]*; (\d): ", told)
    kind = re.match(r"an?y? (cd_[a-z]+)(?: but (CD_[A-Z_]+))?", told)
    interval = re.match(RANGE, told)
    if told == "likewise" and before:
        return before
    if flags:
        return {"values": [int(flags[1]), int(flags[2])]}
    if kind:
        return {"values": [value["name"] for value in enums[kind[1]] if value["name"] != kind[2]]}
    if told.startswith("finite, >= 0"):
        return {"least": 0, "most": "finite"}
    if told.startswith("finite"):
        largest = str(sys.float_info.max) if told.startswith("finite double") else "finite"
        return range_of(f"at most {largest} in size", False, ends)
    if not interval:
        raise NotUnderstood(f"the values of a field, '{told}'")
    found = range_of(interval[0], False, ends)
    return {**found, "values": ["INFINITY"]} if " INFINITY: " in told else found


class Facts:
    """Gives fields and the parameters of functions `unit`, `range` and `default`, and functions their `errors`."""

    def __init__(self, functions, objects, sections, enums):
        self.functions = {f["name"]: f for f in functions}
        self.docs = {o["name"]: o["doc"] for o in objects}
        self.sections = {(s["header"], s["title"]): s["doc"] for s in sections}
        self.enums, self.used = [enum["name"] for enum in enums], set()
        values_of = {enum["name"]: enum["values"] for enum in enums}
        for thing in objects:
            before, ends = None, self.ends(thing["name"])
            for field in thing["fields"]:
                if not field["read_only"]:
                    before = field["range"] = range_of_values(field["values"], before, values_of, ends)
        for function in functions:
            known = of_comment(function)
            for p in function["parameters"]:
                if p["role"] in ("value", "array", "result"):
                    self.quantity(function, p, known.get(p["name"], {}))
        for function in functions:
            function["errors"] = Errors(self, function).all()
        self.check_limits()
        unused = [key for i, table in enumerate(TABLES) for key in table if (i, key) not in self.used]
        if unused:
            raise NotUnderstood(f"in a table of prose.py, but the comments tell it, or no function needs it: {unused}")

    def check_limits(self):
        """Every word in a range is one of LIMITS, of the object's shape, or another argument; and every one is used."""
        used = set()
        for function in self.functions.values():
            shape = self.functions.get(f"cd_{function['object']}_get_shape", {"parameters": []})
            known = {*LIMITS, *map(word, shape["parameters"]), *(p["name"] for p in function["parameters"])}
            for p in function["parameters"]:
                told = p.get("range", [])
                limits = [one.get(key) for one in (told if isinstance(told, list) else [told]) for key in ENDS]
                words = {w for limit in limits if isinstance(limit, str) for w in re.findall(r"[a-z]\w*", limit)}
                if words - known:
                    raise NotUnderstood(f"{function['name']}: the range of {p['name']}: {sorted(words - known)}")
                used |= words
        if set(LIMITS) - used:
            raise NotUnderstood(f"in LIMITS of prose.py, but in no range: {sorted(set(LIMITS) - used)}")

    def of_table(self, table, function, name):
        for owner in (function["name"], f"cd_{function['object']}", "cd"):
            if (owner, name) in table:
                self.used.add((TABLES.index(table), (owner, name)))
                return table[owner, name]
        return None

    def like(self, function):
        """The function whose comment counts for this one too: of a getter its setter, and what a section says."""
        if function["short"].startswith("get_"):
            yield self.functions.get(f"cd_{function['object']}_set_{function['short'][4:]}")
        for doc in self.section_docs(function):
            other = re.search(r"Errors and ranges are those of the\s+functions\s+of\s+cd_([a-z]+)", doc)
            if other:
                yield self.functions.get(f"cd_{other[1]}_{function['short']}")
                return

    @staticmethod
    def is_shared(f, function):
        """A getter has its setter's range where it has its comment: others tell, too, that there is nothing."""
        return f["doc"] == function["doc"] or f["object"] != function["object"]

    def section_docs(self, function):
        """What a section says, and the comments in it down to this function's own."""
        of = function["header"], function["section"]
        yield self.sections.get(of, "")
        for f in self.functions.values():
            if (f["header"], f["section"]) == of:
                yield f["doc"]
            if f is function:
                return

    def quantity(self, function, p, known):
        is_enum, is_flag = p["base"] in self.enums, p["base"] == "int32_t"
        alike = [(f, q) for f in self.like(function) if f for q in f["parameters"]
                 if word(q) == word(p) and q["base"] == p["base"] and q["role"] in ("value", "array", "result")]
        table = {"unit": UNITS, "range": RANGES, "default": DEFAULTS}
        for key in ("unit", "range", "default"):
            told = known.get(key)
            if told is None:
                told = next((q[key] for f, q in alike if key in q and (key != "range" or self.is_shared(f, function))),
                            None)
                if told is None and self.may_have(function, p, key, is_enum or is_flag):
                    told = self.of_table(table[key], function, p["name"])
            if told is None and key == "range" and is_flag:
                told = {"least": 0, "most": 1}
            if told is not None:
                p[key] = self.data(function, p, key, told)
        when = self.of_table(WHEN, function, word(p)) if isinstance(p.get("range"), dict) else None
        if when and "when" not in p["range"]:
            p["range"] = {**p["range"], "when": when}
        needed = [] if is_enum or p["role"] != "value" else ["range", "unit"] if p["base"] == "double" else ["range"]
        for key in needed:
            if key not in p:
                raise NotUnderstood(f"{function['name']}: {p['name']} has no {key}: neither its comment nor prose.py "
                                    "tells it")

    @staticmethod
    def may_have(function, p, key, is_choice):
        if key == "unit":
            return p["base"] in ("double", "float") and p["name"] != "values"
        if key == "range":
            return not is_choice and p["direction"] == "in"
        return function["short"].startswith("set_")

    def ends(self, name):
        return ends_of(" ".join(self.docs[name].split()))

    def data(self, function, p, key, told):
        if key == "default" and isinstance(told, str):
            return number_of(told)
        if key != "range" or isinstance(told, (dict, list)):
            return told
        ends = self.ends(function["object"])
        is_integer = p["base"] not in ("double", "float")
        if not is_integer and ends[1] is None:
            raise NotUnderstood(f"how large parameters of {function['object']} may be")
        if isinstance(told, tuple):
            return [range_of(text, is_integer, ends) for text in told]
        return range_of(told, is_integer, ends)


# ---- errors ----

ERRORS = re.compile(r"Errors(?P<whose>(?: [a-z]+)*):\s+")
CODE = re.compile(r"CD_ERROR_[A-Z]+")


def of_errors(doc):
    """(the comment without its errors, whose they are, [(code, when)])."""
    start = ERRORS.search(doc)
    if not start:
        return doc, None, []
    prose, rows = [doc[:start.start()].strip()], []
    for sentence in re.split(r"(?<=\.)\s+(?=[A-Z][a-z])", doc[start.end():]):
        if not CODE.search(sentence):
            prose.append(sentence)
            continue
        for part in re.split(r";\s+|\.\s+(?=[a-z]+: )", " ".join(sentence.split()).rstrip(".")):
            codes = list(CODE.finditer(part))
            if not codes:  # the rest of what was said of the code before
                rows[-1] = (rows[-1][0], f"{rows[-1][1]}; {part}")
                continue
            before = part[:codes[0].start()].strip()
            said = [part[code.end():after.start() if after else None].strip(" ,")
                    for code, after in zip(codes, [*codes[1:], None])]
            if said[-1].startswith(":"):  # CD_ERROR_RANGE, CD_ERROR_VALUE: nothing has moved
                said = [said[-1][1:].strip()] * len(said)
            for code, text in zip(codes, said):
                text = re.sub(r"(^|,? )and$", "", text)
                rows.append((code.group(0), " ".join(x for x in (before, text) if x)))
    return "\n\n".join(text for text in prose if text), "Errors" + start["whose"], rows


class Errors:
    """Of one function: what its comment says, what is said of the section's functions, and what any may return. A
    function that shares a comment has those of them that its arguments can be the reason for."""

    def __init__(self, facts, function):
        self.facts, self.function = facts, function
        self.values = [p for p in function["parameters"] if p["role"] == "value"]
        self.is_const = any(p["role"] == "self" and p["direction"] == "in" for p in function["parameters"])

    def all(self):
        function, rows = self.function, []
        if function["returns"] != "cd_status":
            return rows
        for code, when in [*self.own(), *self.of_section({code for code, _ in self.own()})]:
            if self.can_be(code) and (code, when) not in rows:
                rows.append((code, when))
        pointers = [p for p in function["parameters"] if "null" in p and not p["null"]]
        if pointers and not any(code == "CD_ERROR_NULL" for code, _ in rows):
            rows.append(("CD_ERROR_NULL", ""))
        if any(p["role"] in ("self", "handle") for p in pointers):
            rows.append(("CD_ERROR_HANDLE", ""))
        return [{"code": code, "when": when} for code, when in rows]

    def own(self):
        _, _, rows = of_errors(self.function["doc"])
        for code, when in rows:
            whose = re.match(r"([a-z]+):\s*", when)
            if not whose or f"{self.function['short']}_".startswith(whose[1] + "_"):
                when = re.sub(r"^here and below ?|^too,? ?", "", when[whose.end():] if whose else when)
                yield code, when
        yield from (row for f in self.facts.like(self.function) if f and f["object"] != self.function["object"]
                    for row in Errors(self.facts, f).own())

    def of_section(self, own):
        """What the section says of all, of setters, or of all that set; and what an earlier comment in it says of all
        below. Getters have but errors of index and length of it."""
        docs = [doc for doc in self.facts.section_docs(self.function) if doc != self.function["doc"]]
        for f in self.facts.like(self.function):
            if f and f["object"] != self.function["object"]:
                docs.append(self.facts.sections[f["header"], f["section"]])
        for doc in docs:
            _, whose, rows = of_errors(doc)
            for code, when in rows:
                if self.function["short"].startswith("get_") and code != "CD_ERROR_RANGE":
                    continue
                if whose == "Errors of all" or whose == "Errors here and below" or (
                        when.startswith("here and below ")) or not self.is_const and (
                        whose == "Errors of all that set" or
                        whose == "Errors of all setters" and self.function["short"].startswith("set_") and
                        code not in own):
                    yield code, when.removeprefix("here and below ")

    def can_be(self, code):
        """Whether the function has anything that this error may be said of."""
        numbers = [p for p in self.values if p["base"] not in self.facts.enums]
        if code == "CD_ERROR_VALUE":
            return any(p["base"] != "size_t" or not depends(p["range"]) for p in numbers) or any(
                p["role"] == "array" and p["direction"] == "in" for p in self.function["parameters"])
        if code == "CD_ERROR_ENUM":
            return len(self.values) > len(numbers)
        if code == "CD_ERROR_RANGE":
            return any(p["role"] == "length" for p in self.function["parameters"]) or any(
                p["base"] == "size_t" and depends(p["range"]) for p in numbers)
        if code == "CD_ERROR_MEMORY":
            return not self.is_const
        shares = self.function["short"].startswith("get_") and any(
            f and self.facts.is_shared(f, self.function) for f in self.facts.like(self.function))
        return not shares or code not in ("CD_ERROR_UNSUPPORTED", "CD_ERROR_DIVERGED", "CD_ERROR_DISABLED")
