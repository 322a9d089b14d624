#!/usr/bin/env python3
"""Writes the library as one C++ file and its public headers, for projects without a build of their own for it.

    amalgamate.py FOLDER        writes FOLDER/contdyn.cpp, FOLDER/contdyn/*.h and FOLDER/contdyn/contdyn.hpp

    c++ -std=c++17 -O3 -fno-math-errno -fno-trapping-math -c -I FOLDER FOLDER/contdyn.cpp
    cc game.c -I FOLDER contdyn.o -lm

It has all parts, and kernels for the instructions that the compiler may use: with -mavx2 those of AVX2, which every
machine that runs it must then have. -Wno-psabi silences what GCC says about wide vectors. On Windows programs that use
it are compiled with -DCD_STATIC; for a DLL it is compiled with -DCD_EXPORT.
"""
import collections
import re
import sys
from pathlib import Path

SOURCES = Path(__file__).resolve().parent
HEADERS = SOURCES.parent / "include" / "contdyn"
CPP_HEADER = SOURCES.parent / "bindings" / "cpp" / "include" / "contdyn" / "contdyn.hpp"
LAYERS = ["base", "solve", "model", "api", "kernel"]  # the kernels' own names are not seen by the others
INCLUDE = re.compile(r'^#include "(.*)"\n', re.MULTILINE)

HEAD = """\
// contdyn {version}: ropes, hair, cloth, drums and water, in one file. It was written by src/amalgamate.py, which says
// how to compile it; the sources that it was made of are easier to read.

#if defined(__FAST_MATH__)
#error "contdyn's results would not be the same on every machine: compile it without -ffast-math."
#endif

// Nothing is fused into multiply-adds, for the same reason.
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#ifdef __FMA__
#pragma GCC optimize("no-tree-slp-vectorize") // which fuses some all the same
#endif
#endif

#if defined(__MINGW32__) && !defined(__USE_MINGW_ANSI_STDIO)
#define __USE_MINGW_ANSI_STDIO 1
#endif
#if defined(_WIN32) && !defined(CD_EXPORT) && !defined(CD_STATIC)
#define CD_STATIC
#endif

{options}
"""


def version():
    text = (HEADERS / "base.h").read_text(encoding="utf-8")
    return ".".join(re.findall(r"#define CD_VERSION_\w+ (\d+)", text))


def without(text, opening, closing):
    """The text without what stands between brackets, nor those."""
    kept, depth = [], 0
    for letter in text:
        depth += letter == opening
        if depth == 0:
            kept.append(letter)
        depth -= letter == closing
    return "".join(kept)


def declared(head, body):
    """What a declaration declares, of which `head` is all up to its semicolon or brace, and `body` is in the braces."""
    head = re.sub(r"__attribute__\s*\(\(.*?\)\)|\balignas\(.*?\)|\[\[.*?\]\]", "", head)
    head = without(re.sub(r"\boperator\b.*", "", head), "<", ">").replace("template", "").strip()
    if head == "enum":
        return re.findall(r"(\w+)\s*(?:=[^,]*)?(?:,|$)", body)
    found = re.match(r"(?:struct|class|enum|using) (\w+)", head) or re.search(r"(\w+)\s*(?:[\[(=]|$)", head)
    return [found.group(1)] if found and found.group(1) != "static_assert" else []


def own_names(text):
    """Names that a source file has for itself: of what is static or in a namespace without a name. In one file with all
    others they need a number of their own."""
    text = re.sub(r"//.*|^#(?:.*\\\n)*.*", "", text, flags=re.MULTILINE)
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', text)
    names, scopes, head, at = {}, [], "", 0
    while at < len(text):
        letter = text[at]
        at += 1
        if letter not in "{};":
            head += letter
            continue
        if letter == "}":
            scopes.pop()
        body = ""
        if letter == "{":
            scope = re.fullmatch(r"\s*namespace\s*(\w*)\s*", head)
            if scope:
                scopes.append(scope.group(1))
                head = ""
                continue
            begin, depth = at, 1
            while depth:  # to the end of the body
                depth += {"{": 1, "}": -1}.get(text[at], 0)
                at += 1
            body = text[begin:at - 1]
        if "" in scopes or re.match(r"\s*(template\b.*)?static\b", head, re.DOTALL):
            names.update(dict.fromkeys(declared(head, body)))
        head = ""
    return set(names)


def source_files():
    return [path for layer in LAYERS for path in sorted((SOURCES / layer).rglob("*.cpp"))]


class Amalgamation:
    def __init__(self):
        self.parts, self.included, self.files = [], set(), 0
        times = collections.Counter(name for path in source_files() for name in own_names(path.read_text("utf-8")))
        self.ambiguous = {name for name, count in times.items() if count > 1}

    def add(self, path):
        """A file, after the headers that it includes first."""
        name = path.relative_to(SOURCES).as_posix()
        text = path.read_text(encoding="utf-8").replace("#pragma once\n", "")

        def include(match):
            header = match.group(1)
            if header.startswith("contdyn/"):
                return match.group()
            if header not in self.included:
                self.included.add(header)
                self.add(SOURCES / header)
            return ""

        text = INCLUDE.sub(include, text).strip()
        if path.suffix == ".cpp":
            self.files += 1
            for local in sorted(own_names(text) & self.ambiguous):
                text = re.sub(rf"\b{local}\b", f"{local}_{self.files}", text)
            macros = dict.fromkeys(re.findall(r"^#define (\w+)", text, re.MULTILINE))
            text += "".join(f"\n#undef {macro}" for macro in macros if not re.search(rf"^#undef {macro}$", text, re.M))
        self.parts.append(f"// ---- {name} ----\n\n{text}\n")

    def text(self):
        for source in source_files():
            self.add(source)
        names = ["CHAIN", "ROPE", "MEMBRANE", "CLOTH", "WATER", "HULL", "BEND", "CONTACT", "COUPLED", "ADVECTED",
                 "DRAW", "SLEEP", "SAVE", "FLOAT32", "FLOAT64"]
        options = "\n".join([*(f"#define CD_WITH_{name} 1" for name in names),
                             *(f"#define CD_WITH_{name} 0" for name in ("AVX2", "AVX512"))])
        return HEAD.format(version=version(), options=options) + "\n" + "\n".join(self.parts)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    (folder / "contdyn").mkdir(parents=True, exist_ok=True)
    (folder / "contdyn.cpp").write_text(Amalgamation().text(), encoding="utf-8", newline="\n")
    for header in [*HEADERS.glob("*.h"), CPP_HEADER]:
        (folder / "contdyn" / header.name).write_bytes(header.read_bytes())


if __name__ == "__main__":
    main()
