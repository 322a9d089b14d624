"""Units, ranges, defaults and errors, as api.json's comments tell them. All that is found is a piece of the comment,
word for word. What the patterns do not find stays in the comment alone; nothing is concluded."""
import re

NUMBER = r"(?:-?\d+(?:\.\d+)?(?:e-?\d+)?(?:/\d+)?|INFINITY)"
FACTOR = r"(?:kg|Pa|[NmsJ1])(?:\^(?:\d+|\([\d/]+\)))?"
UNIT = rf"\[(?P<unit>{FACTOR}(?:[ /]{FACTOR})*)\]"
INTERVAL = rf"\[{NUMBER}, {NUMBER}\]"
RANGE = (rf"(?P<range>(?:{NUMBER} or )?in {INTERVAL}|>=? {NUMBER}(?: and at most {NUMBER}(?: [a-z]+)?)?"
         rf"(?:, of ropes up to {NUMBER})?|{NUMBER} to {NUMBER}(?:, or {NUMBER})?"
         rf"|(?:of either sign, )?at most {NUMBER} in size)")
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
    interval = re.compile(r",? ?" + RANGE).match(doc, at) if unit else re.search(f", {RANGE}", sentence)
    interval = RANGE_AND_DEFAULT.search(doc) or interval
    if interval:
        found["range"] = interval["range"]
    default = ANY_DEFAULT.search(doc)
    if default:
        found["default"] = default["default"] or default["value"]
    return found, sentence[at:]


def of_parameters(function):
    """{parameter: {"unit", "range", "default"}}, each where the comment tells it."""
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
        facts.update({p["name"]: subject for p in unnamed})
    return facts


ERRORS = re.compile(r"Errors(?P<whose>(?: [a-z]+)*):\s+")
CODE = re.compile(r"CD_ERROR_[A-Z]+")


def of_errors(doc):
    """(the comment without its errors, the table's caption, [(code, when)])."""
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
