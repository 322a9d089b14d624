"""The page: per header its text, its types, its fields and its functions by section, each with an anchor of its own:

    #chain.h            a header                  #cd_chain_step      a function
    #chain.h-life       a section of it           #cd_status, #CD_OK  an enumeration, a value of it
    #cd_chain           a handle, or a struct     #chain.CD_MASS      a field of an object
    #cd_parallel.run    a member of a struct      #CD_VERSION_MAJOR   a macro
"""
import re
from html import escape
from itertools import groupby
from pathlib import Path

import facts
from names import Names

HERE = Path(__file__).resolve().parent
TITLES = {"base.h": "What all share", "chain.h": "Chains and ropes", "membrane.h": "Membranes and cloth",
          "water.h": "Water"}
NAME = re.compile(r"\b(?:cd_[a-z0-9_]+|CD_[A-Z0-9_]+)\b")
ALIGNED = re.compile(r"^ +\S|\S {3,}\S")  # a line of a table or an equation, whose spaces count
ITEM = re.compile(r"^  (CD_[A-Z_]+(?:, CD_[A-Z_]+)*) {3,}", re.MULTILINE)  # what each of some values means
ROLES = {"self": "the object", "handle": "another object", "length": "length", "callbacks": "functions",
         "created": "new object", "address": "address"}


def section_id(header, title):
    return f"{header}-" + re.sub(r"[^a-z]+", "-", title).strip("-")


def row(cells, anchor=None, tag="td"):
    """A table's row; its first cell is its head."""
    head, *rest = cells
    start = f'<tr id="{anchor}" data-item>' if anchor else "<tr>"
    scope = "col" if tag == "th" else "row"
    return f'{start}<th scope="{scope}">{head}</th>' + "".join(
        f'<{tag}{" scope=col" if tag == "th" else ""}>{cell}</{tag}>' for cell in rest) + "</tr>"


def table(caption, head, rows):
    """Columns in which no row has anything are left out."""
    kept = [i for i in range(len(head)) if i == 0 or any(cells[i] for cells, _ in rows)]
    yield f'<div class="wide"><table><caption>{caption}</caption>'
    yield "<thead>" + row([head[i] for i in kept], tag="th") + "</thead><tbody>"
    yield from (row([cells[i] for i in kept], anchor) for cells, anchor in rows)
    yield "</tbody></table></div>"


class Page:
    def __init__(self, api):
        self.api, self.json, self.names = api, api.json, Names(api)
        self.entries = {f["name"]: f for f in self.json["functions"]}
        self.anchors = {f["name"] for f in self.json["functions"]}
        self.anchors |= {e["name"] for e in self.json["enums"]} | {c["name"] for c in self.json["callbacks"]}
        self.anchors |= {v["name"] for e in self.json["enums"] for v in e["values"]}
        self.anchors |= {m["name"] for m in self.json["macros"]} | {o["handle"] for o in self.json["objects"]}
        self.fields = {o["header"]: {f["name"] for f in o["fields"]} for o in self.json["objects"]}
        self.sections = {(s["header"], s["title"]): s["doc"] for s in self.json["sections"]}

    def object_of(self, header):
        return next((o for o in self.json["objects"] if o["header"] == header), None)

    # -- text --

    def linked(self, text, header):
        """Escaped, with links from each name that the page has; a field's leads to this header's own."""
        def link(match):
            name = match.group(0)
            if name in self.fields.get(header, ()):
                return f'<a href="#{header[:-2]}.{name}"><code>{name}</code></a>'
            return f'<a href="#{name}"><code>{name}</code></a>' if name in self.anchors else f"<code>{name}</code>"
        parts = re.split(r"`([^`]+)`", text)
        return "".join(f"<code>{escape(part)}</code>" if i % 2 else NAME.sub(link, escape(part, quote=False))
                       for i, part in enumerate(parts))

    def prose(self, text, header):
        """A comment's paragraphs and lists; lines whose spaces count keep them."""
        for paragraph in re.split(r"\n\s*\n", text.strip("\n")):
            items = re.split(r"^ *- ", paragraph, flags=re.MULTILINE)
            if len(items) > 1:
                yield from self.prose(items[0], header) if items[0].strip() else ()
                yield "<ul>" + "".join(f"<li>{self.linked(item.strip(), header)}</li>" for item in items[1:]) + "</ul>"
                continue
            for aligned, lines in groupby(paragraph.split("\n"), lambda line: bool(ALIGNED.search(line))):
                text = "\n".join(lines)
                if ITEM.match(text):
                    parts = ITEM.split(text)[1:]
                    yield "<dl>" + "".join(
                        f"<dt>{self.linked(name, header)}</dt><dd>{self.linked(' '.join(said.split()), header)}</dd>"
                        for name, said in zip(parts[::2], parts[1::2])) + "</dl>"
                elif aligned:
                    yield f'<pre>{self.linked(text, header)}</pre>'
                else:
                    yield f"<p>{self.linked(text, header)}</p>"

    def type_of(self, text):
        return NAME.sub(lambda m: f'<a href="#{m[0]}">{m[0]}</a>' if m[0] in self.anchors else m[0], escape(text))

    def declaration(self, entry):
        """A parameter or member in C; of a function, as one writes it."""
        if entry.get("function"):
            inner = ", ".join(map(self.declaration, entry["parameters"]))
            return f"{self.type_of(entry['returns'])} (*{entry['name']})({inner})"
        return f"{self.type_of(entry['type'])} <var>{entry['name']}</var>"

    # -- functions --

    def function(self, group):
        first = group[0]
        header = first["header"]
        described, _, _ = facts.of_errors(first["doc"])
        yield f'<article class="entry" data-names="{" ".join(f["name"] for f in group)}">'
        for f in group:
            inner = ", ".join(map(self.declaration, f["parameters"])) or "void"
            yield f'<h4 id="{f["name"]}" data-item><a href="#{f["name"]}">{f["name"]}</a></h4>'
            yield (f'<pre class="c">{self.type_of(f["returns"])} <b>{f["name"]}</b>({inner});</pre>')
        yield from self.prose(described, header)
        for f in group:
            yield from self.parameters(f)
        yield from self.errors(group)
        yield from self.also(group)
        yield "</article>"

    def errors(self, group):
        """One row for each error and what it is for; of a part of the group, with their names."""
        general = {v["name"]: v["doc"] for v in self.api.enums["cd_status"]["values"]}
        whose = {}
        for f in group:
            for error in f["errors"]:
                whose.setdefault((error["code"], error["when"] or general[error["code"]]), []).append(f["name"])
        rows = [([*(self.linked(text, group[0]["header"]) for text in error),
                  "" if len(names) == len(group) else self.linked(", ".join(names), group[0]["header"])], None)
                for error, names in whose.items()]
        if rows:
            yield from table("Errors", ["Status", "When", "Of"], rows)

    def parameters(self, f):
        """One row for each parameter."""
        if not f["parameters"]:
            return
        rows = []
        for p in f["parameters"]:
            what = ROLES.get(p["role"], "")
            if p["role"] == "length":
                what = "length of " + ", ".join(f"<var>{name}</var>" for name in p["of"])
            elif p["role"] in ("array", "bytes"):
                times = p["times"]
                count = f"<var>{p['length']}</var>" + (f" × {times}" if times != 1 else "")
                what = f"{count} {'bytes' if p['role'] == 'bytes' else 'numbers'}"
            interval = facts.words_of(p["range"]) if "range" in p else ""
            if p["base"] == "int32_t" and interval:
                interval = "0 or 1"
            interval = f'<span class="range">{escape(interval)}</span>' if interval else ""
            if interval and "when" in p["range"]:
                interval += " " + self.linked(p["range"]["when"], f["header"])
            default = facts.said(p["default"]) if "default" in p else ""
            rows.append(([f"<var>{p['name']}</var>", f"<code>{self.type_of(p['type'])}</code>", p["direction"], what,
                          escape(p.get("unit", "")), interval, self.linked(default, f["header"]),
                          "yes" if p.get("null") else ""], None))
        yield from table(f"Parameters of <code>{f['name']}</code>",
                         ["Name", "Type", "In or out", "What", "Unit", "Range", "Default", "May be null"], rows)

    def also(self, group):
        """What belongs to it, and its names in other languages."""
        header, lines = group[0]["header"], []
        for f in group:
            for here, there, word in (("set_", "get_", "Getter"), ("get_", "set_", "Setter")):
                pair = f["name"].replace(f"_{here}", f"_{there}", 1)
                if f["short"].startswith(here) and pair in self.entries:
                    lines.append((word, self.linked(pair, header)))
        spelled = {}
        for f in group:
            function = next(x for x in self.api.functions if x.name == f["name"])
            for language, name in self.names.of(function, f):
                if name not in spelled.setdefault(language, []):
                    spelled[language].append(name)
        lines += [(language, ", ".join(f"<code>{escape(name)}</code>" for name in names))
                  for language, names in spelled.items()]
        if lines:
            yield '<dl class="also">' + "".join(f"<div><dt>{a}</dt><dd>{b}</dd></div>" for a, b in lines) + "</dl>"

    def groups(self, header, title):
        """Functions that share a comment, as a setter and its getter do."""
        own = [f for f in self.json["functions"] if (f["header"], f["section"]) == (header, title)]
        return [list(group) for _, group in groupby(own, lambda f: f["doc"])]

    # -- types --

    def entry(self, name, kind, doc, header, body):
        yield f'<article class="entry" data-names="{name}">'
        yield f'<h4 id="{name}" data-item><a href="#{name}">{name}</a> <small>{kind}</small></h4>'
        yield from self.prose(doc, header) if doc else ()
        yield from body
        yield "</article>"

    def enum(self, enum):
        rows = [([f'<a href="#{v["name"]}"><code>{v["name"]}</code></a>', str(v["value"]),
                  self.linked(v["doc"], enum["header"])], v["name"]) for v in enum["values"]]
        return self.entry(enum["name"], enum["type"], enum["doc"], enum["header"],
                          table(f"Values of <code>{enum['name']}</code>", ["Name", "Value", "Meaning"], rows))

    def struct(self, struct):
        name = struct["name"]
        rows = [([f'<a href="#{name}.{m["name"]}"><code>{m["name"]}</code></a>',
                  f"<code>{self.declaration(m)}</code>"], f"{name}.{m['name']}") for m in struct["members"]]
        return self.entry(name, "struct", struct["doc"], struct["header"],
                          table(f"Members of <code>{name}</code>", ["Member", "Declaration"], rows))

    def field_table(self, thing):
        rows = []
        for f in thing["fields"]:
            anchor = f"{thing['name']}.{f['name']}"
            per = [*f["per"], *(["component"] if f["components"] else [])]
            if f["own_in_ropes"]:
                per[0] += " (in ropes)"
            access = [word for key, word in (("read_only", "read only"), ("viewable", "view")) if f[key]]
            there = ("always" if f["always"] else "if enabled") + (
                ", with rest lengths" if f["lengths"] else "")
            rows.append(([f'<a href="#{anchor}"><code>{f["name"]}</code></a>', ", ".join(per), escape(f["unit"]),
                          self.linked(f["values"], thing["header"]), there, ", ".join(access)], anchor))
        yield from table(f"Fields of <code>{thing['handle']}</code>",
                         ["Field", "One value per", "Unit", "Values", "There", "Access"], rows)

    def macros(self, header):
        rows = [([f'<a href="#{m["name"]}"><code>{m["name"]}</code></a>', str(m["value"])], m["name"])
                for m in self.json["macros"] if m["header"] == header]
        if rows:
            yield f'<article class="entry" data-names="macros"><h4 id="{header}-macros">Macros</h4>'
            yield from table("Version of the header", ["Name", "Value"], rows)
            yield "</article>"

    # -- the whole --

    def of_header(self, header):
        """(title, lines) of each part of a header that is listed in the contents."""
        thing = self.object_of(header)
        enums = [e for e in self.json["enums"] if e["header"] == header]
        structs = [c for c in self.json["callbacks"] if c["header"] == header]
        types = [line for thing in (*map(self.enum, enums), *map(self.struct, structs)) for line in thing]
        types += self.macros(header)
        if types:
            yield "types", types
        for (of, title), doc in self.sections.items():
            if of != header:
                continue
            lines = []
            if title == "fields" and thing:  # its table is written from the data
                doc = "\n".join(line for line in doc.split("\n") if not line.startswith(" "))
            lines += self.prose(doc, header) if doc else ()
            if title == "fields" and thing:
                lines.append('<article class="entry" data-names="fields">')
                lines += self.field_table(thing)
                lines.append("</article>")
            for group in self.groups(header, title):
                lines += self.function(group)
            if lines:
                yield title, lines

    def body(self):
        contents, content = [], []
        for header in self.json["headers"]:
            thing = self.object_of(header)
            name = TITLES.get(header, header)
            contents.append(f'<li class="of-header"><a class="header" href="#{header}">{name}</a><ul>')
            content.append(f'<section><h2 id="{header}">{name} '
                           f"<small>&lt;contdyn/{header}&gt;</small></h2>")
            if thing:
                contents.append(f'<li><a href="#{thing["handle"]}">{thing["handle"]}</a></li>')
                content += [f'<div class="entry" data-names="{thing["handle"]}">',
                            f'<h3 id="{thing["handle"]}" data-item><a href="#{thing["handle"]}">{thing["handle"]}</a> '
                            "<small>opaque struct</small></h3>", *self.prose(thing["doc"], header), "</div>"]
            else:
                content += self.prose(self.json["doc"], header)
            for title, lines in self.of_header(header):
                anchor = section_id(header, title)
                text = "\n".join(lines)
                names = re.findall(r'id="([^"]+)" data-item', text)
                title = title[:1].upper() + title[1:]
                links = [("About these", anchor), *((name, name) for name in names)]
                contents.append(f"<li><details><summary>{title}</summary><ul>" + "".join(
                    f'<li><a href="#{to}">{name}</a></li>' for name, to in links) + "</ul></details></li>")
                content += [f'<section><h3 id="{anchor}"><a href="#{anchor}">{title}</a></h3>', text, "</section>"]
            contents.append("</ul></li>")
            content.append("</section>")
        return contents, content

    def text(self):
        contents, content = self.body()
        return "\n".join([
            "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            f"<title>contdyn {self.json['version']}: reference</title>",
            "<style>", (HERE / "page.css").read_text(encoding="utf-8"), "</style>", "</head>", "<body>",
            '<a class="skip" href="#content">To the content</a>',
            '<header><h1><a href="#content">contdyn</a> <small>' + self.json["version"] + "</small></h1>",
            '<form role="search"><label for="search">Find</label> <input id="search" type="search" '
            'placeholder="function, value, field, struct …" autocomplete="off" spellcheck="false"> '
            '<kbd class="keyboard" title="focuses the search">/</kbd> <span id="found" role="status"></span>'
            "</form></header>",
            '<div class="page"><nav aria-label="Contents">',
            '<details class="contents" open><summary>Contents</summary><ul>', *contents, "</ul></details></nav>",
            '<main id="content">', self.intro(), *content, "</main></div>",
            "<script>", (HERE / "page.js").read_text(encoding="utf-8"), "</script>", "</body>", "</html>", ""])

    def intro(self):
        return (
            '<div class="intro"><p>The whole C interface of contdyn '
            f"{self.json['version']}, and what its functions are called in other languages. "
            f"{len(self.json['functions'])} functions, "
            f"{len(self.json['enums'])} enumerations, {sum(len(o['fields']) for o in self.json['objects'])} fields. "
            '<span class="keyboard">Press <kbd>/</kbd> to search.</span></p><details><summary>Words in ranges</summary>'
            '<p>They are other parameters, what <code>get_shape</code> tells, or these:</p><dl>' + "".join(
                f"<dt><code>{limit['name']}</code></dt><dd>{escape(limit['doc'])}</dd>"
                for limit in self.json["limits"]) + "</dl></details></div>")
