#!/usr/bin/env python3
"""Makes the reference's page and checks it: all that bindings/api.json has is there, with an anchor and what is said of
it; links lead somewhere; nothing is fetched; the HTML is well formed, and its headings and tables can be followed.

    check_reference.py REFERENCE API    REFERENCE is the folder of the program that makes it
"""
import json
import re
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "bindings"))
import facts  # noqa: E402

VOID = {"meta", "input", "br", "hr", "img", "link", "wbr"}


class Reader(HTMLParser):
    """What a page consists of, and what is wrong with it."""

    def __init__(self, page):
        super().__init__()
        self.problems, self.open, self.ids, self.links, self.levels, self.tables = [], [], {}, [], [], []
        self.captions, self.words, self.texts = 0, {}, []
        self.attributes = {}
        self.feed(page)
        self.close()
        self.problems += [f"<{tag}> is never closed" for tag, _ in self.open]

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.attributes.setdefault(tag, []).append(values)
        if len(values) != len(attrs):
            self.problems.append(f"<{tag}> has an attribute twice: {attrs}")
        if "id" in values:
            if values["id"] in self.ids:
                self.problems.append(f"two anchors #{values['id']}")
            self.ids[values["id"]] = tag
        if "href" in values:
            self.links.append(values["href"])
        for name in ("src", "action", "srcset", "data"):
            if name in values:
                self.problems.append(f"<{tag} {name}> fetches {values[name]}")
        if re.fullmatch("h[1-6]", tag):
            self.levels.append(int(tag[1]))
        if tag == "th" and values.get("scope") not in ("col", "row"):
            self.problems.append("a head of a table without scope")
        if tag == "table":
            self.tables.append(0)
        if tag == "caption":
            self.tables[-1] += 1
        if tag == "p" and any(t == "p" for t, _ in self.open):
            self.problems.append("<p> within <p>")
        if tag not in VOID:
            self.open.append((tag, values))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.problems.append(f"</{tag}> closes {self.open[-1:]} at line {self.getpos()[0]}")
            return
        self.open.pop()

    def handle_data(self, data):
        if any(tag in ("style", "script") for tag, _ in self.open):
            return
        names = next((values["data-names"] for _, values in reversed(self.open) if "data-names" in values), None)
        if names is not None:
            self.words.setdefault(names, []).append(data)
        self.texts.append(data)


def anchors(api):
    """Every anchor that the page has to have."""
    yield from api["headers"]
    for kind in ("functions", "enums", "callbacks", "macros"):
        yield from (thing["name"] for thing in api[kind])
    yield from (value["name"] for enum in api["enums"] for value in enum["values"])
    yield from (f"{struct['name']}.{member['name']}" for struct in api["callbacks"] for member in struct["members"])
    for thing in api["objects"]:
        yield thing["handle"]
        yield from (f"{thing['name']}.{field['name']}" for field in thing["fields"])


def words_of(text):
    return re.findall(r"\w+", text)


def problems(page, api):
    reader = Reader(page)
    found = list(reader.problems)
    found += [f"no anchor #{name}" for name in anchors(api) if name not in reader.ids]
    found += [f"a link to {link}, which is no anchor" for link in reader.links
              if not link.startswith("#") or link[1:] not in reader.ids]
    fetched = re.search(r"//[a-z0-9.-]+\.[a-z]|https?:|@import|\burl\(|\bfetch\(|XMLHttpRequest|<iframe|<link", page)
    if fetched:
        found.append(f"the page needs the network: {fetched.group(0)}")
    if ">None<" in page:
        found.append("a cell holds None")
    if reader.levels[:1] != [1] or reader.levels.count(1) != 1 or any(
            b > a + 1 for a, b in zip(reader.levels, reader.levels[1:])):
        found.append("headings are not in order")
    if not reader.tables or any(captions != 1 for captions in reader.tables):
        found.append("a table without a caption")
    if reader.attributes["html"][0].get("lang") != "en" or "title" not in reader.attributes or not any(
            meta.get("name") == "viewport" for meta in reader.attributes["meta"]):
        found.append("no language, title or viewport")

    found += check_ranges(page, api)

    said = {name: set(words_of(" ".join(texts))) for names, texts in reader.words.items() for name in names.split()}
    for function in api["functions"]:
        wanted = {*words_of(facts.of_errors(function["doc"])[0]), *(p["name"] for p in function["parameters"]),
                  *(w for error in function["errors"] for text in error.values() for w in words_of(text))}
        missing = wanted - said.get(function["name"], set())
        if missing:
            found.append(f"{function['name']}: not said: {sorted(missing)}")
    for enum in [*api["enums"], *api["callbacks"]]:
        missing = {*words_of(enum["doc"]), *(w for v in enum.get("values", []) for w in words_of(v["doc"]))} - said.get(
            enum["name"], set())
        if missing:
            found.append(f"{enum['name']}: not said: {sorted(missing)}")
    every = set(words_of(" ".join(reader.texts)))
    for thing in [*api["sections"], *api["objects"], api]:
        if set(words_of(thing["doc"])) - every - {"field", "values", "_V"}:
            found.append(f"of {thing.get('title', thing.get('name', 'the headers'))} not said: "
                         f"{sorted(set(words_of(thing['doc'])) - every)}")
    return found


def must_fail(page, api):
    """Pages with something wrong, each of which the checks have to find."""
    function = api["functions"][len(api["functions"]) // 2]["name"]
    article = re.search(rf'<article class="entry" data-names="[^"]*\b{function}\b.*?</article>', page, re.DOTALL)
    yield "a function left out", page.replace(article.group(0), "")
    yield "a function's heading left out", re.sub(rf'<h4 id="{function}".*?</h4>', "", page)
    yield "a value left out", page.replace('id="CD_NODE_POSED" ', "")
    yield "a field left out", page.replace('id="water.CD_MASK" ', "")
    yield "a link to nothing", page.replace(f'href="#{function}"', 'href="#nothing"')
    yield "a table without its end", page.replace("</table>", "", 1)
    yield "a heading that skips a level", page.replace("<h2", "<h5", 1).replace("</h2>", "</h5>", 1)
    yield "a script from elsewhere", page.replace("<script>", '<script src="https://example.org/a.js">')
    yield "a function's comment cut", page.replace("Never allocates", "")
    yield "a number without a range", re.sub(r'<span class="range">in .0, nu.</span>', "", page, count=1)
    yield "another range", page.replace(">in [0, 1e60]<", ">in [0, 1e6]<")
    yield "an error left out", page.replace(">CD_ERROR_DISABLED<", "><")


def check_facts(api):
    """What is found in comments are pieces of them, no error that one tells is lost, and some are known."""
    known, codes = {}, {}
    for function in api["functions"]:
        doc = " ".join(function["doc"].split())
        for name, told in facts.of_comment(function).items():
            for key, text in told.items():
                if (f"[{text}]" if key == "unit" else text) not in doc:
                    return f"{function['name']}: {key} of {name} is not in its comment: {text}"
        codes.setdefault(doc, set()).update(error["code"] for error in function["errors"])
        for p in function["parameters"]:
            known[function["name"], p["name"]] = {key: p[key] for key in ("unit", "range", "default") if key in p}
    for doc, listed in codes.items():
        errors = re.search(r"Errors[a-z ]*:", doc)
        missing = set(re.findall(r"CD_ERROR_[A-Z]+", doc[errors.start():])) - listed if errors else None
        if missing:
            return f"errors that only a comment tells: {missing}: {doc}"
    for name, told in (
            (("cd_chain_set_mass", "mass"), {"unit": "kg", "range": {"least": 1e-60, "most": 1e60}, "default": 1}),
            (("cd_chain_get_rest_length", "out_length"),
             {"unit": "m", "range": {"least": 1e-60, "most": 1e60, "values": [0]}, "default": 0}),
            (("cd_chain_step", "dt"), {"unit": "s", "range": {"least": 1e-30, "most": 1e30, "values": [0]}}),
            (("cd_membrane_attach", "damping"), {"unit": "N s/m", "range": {"least": 0, "most": 1e60}}),
            (("cd_membrane_set_plane", "index"), {"range": {"least": 0, "below": "colliders"}}),
            (("cd_water_set_manning", "manning"),
             {"unit": "s/m^(1/3)", "range": {"least": 0, "most": 1e3}, "default": 0}),
            (("cd_water_set_hull_drag", "friction"), {"unit": "1", "range": {"least": 0, "most": 1e30}}),
            (("cd_water_set_bed_rule", "rule"), {"default": "CD_BED_LIFTS_WATER"})):
        if known[name] != told:
            return f"{name}: described as {known[name]}, not {told}"
    return None


def check_ranges(page, api):
    """Every number that is passed has a cell with each number and name of its range."""
    enums = {enum["name"] for enum in api["enums"]}
    tables = dict(re.findall(r"<caption>Parameters of <code>(\w+)</code></caption>(.*?)</table>", page, re.DOTALL))
    for function in api["functions"]:
        rows = dict(re.findall(r'<th scope="row"><var>(\w+)</var></th>(.*?)</tr>', tables.get(function["name"], "")))
        for p in function["parameters"]:
            if p["role"] != "value" or p["base"] in enums:
                continue
            cell = re.search(r'<td><span class="range">([^<]+)</span>', rows.get(p["name"], ""))
            if not cell:
                yield f"{function['name']}: {p['name']} has no range"
                continue
            shown = {float(x) for x in re.findall(r"\d+(?:\.\d+)?(?:e-?\d+)?", cell.group(1))}
            ends = {key: limit for key, limit in p["range"].items() if key != "when" and limit != 0}
            for end in (x for limit in ends.values() for x in (limit if isinstance(limit, list) else [limit])):
                words = set(words_of(end)) - set(words_of(cell.group(1))) if isinstance(end, str) else set()
                if words or not isinstance(end, str) and abs(end) not in shown:
                    yield f"{function['name']}: the range of {p['name']} is shown as {cell.group(1)}"


SOURCES = {"C++": "cpp/include/contdyn/contdyn.hpp", "Python": "python/contdyn/*.py", "Lua": "lua/contdyn/*.lua",
           "JavaScript": "javascript/contdyn.d.ts", "Rust": "rust/src/*.rs", "C#": "csharp/src/*.cs"}


def check_names(page, bindings):
    """Each name in another language is a word of that binding's own source."""
    words = {language: set(words_of("".join(path.read_text(encoding="utf-8") for path in bindings.glob(pattern))))
             for language, pattern in SOURCES.items()}
    for language in SOURCES:
        places = re.findall(rf"<dt>{re.escape(language)}</dt><dd>(.*?)</dd>", page)
        names = {w for place in places for w in words_of(re.sub(r"</?code>", "", place))} - {"contdyn", "r"}
        if len(places) < 100 or names - words[language]:
            return f"{language}: {len(places)} places; not in the binding: {sorted(names - words[language])}"
    return None


def main():
    reference, path = map(Path, sys.argv[1:])
    api = json.loads(path.read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, "-B", reference, folder], check=True)
        files = [file.name for file in Path(folder).iterdir()]
        page = (Path(folder) / "index.html").read_text(encoding="utf-8")
    found = problems(page, api)
    if files != ["index.html"]:
        found.append(f"the reference is {files}")
    found += [what for what in (check_facts(api), check_names(page, reference.parent)) if what]
    if found:
        sys.exit("check_reference: " + "\n".join(found))
    for what, broken in must_fail(page, api):
        if broken == page or not problems(broken, api):
            sys.exit(f"check_reference: not found out: {what}")


if __name__ == "__main__":
    main()
