#!/usr/bin/env python3
"""Breaks the library in one place at a time, at random places, and shows which test notices.

    mutate.py FOLDER [COUNT [SEED [TIERS]]]    builds in FOLDER; 200 places of seed 1, in some hours of two cores

TIERS: those of tests/CMakeLists.txt that are asked, as a regular expression; all if it is left out. Unit tests, which
are linked with what is inside the library, are built anew and asked last.

Counted are mutations that compile and change the library file. Exit status 0: at least 97% are noticed, or are
explained below.
"""

import hashlib
import json
import os
import random
import re
import resource
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tree import copy_and_configure, run

NOTICED_AT_LEAST = 0.97
MEMORY = 4 << 30  # [bytes] that a test may take
SLOWER = 10       # a test that takes so many times as long, and 10 s, does not end

# Kind: what is there, and what takes its place. One line each.
KINDS = {
    "sign": [(r" \+ ", " - "), (r" - ", " + "), (r" \+= ", " -= "), (r" -= ", " += ")],
    "factor": [(r" \* ", " / "), (r" / ", " * "), (r"\b0\.5 \*", "1.0 *"), (r"\b2 \*", "1 *")],
    "bound": [(r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > ")],
    "neighbour": [(r"(\w) \+ 1([\])])", r"\1\2"), (r"(\w) - 1([\])])", r"\1\2"), (r" = 0;", " = 1;")],
    "condition": [(r" && ", " || "), (r" \|\| ", " && "), (r"if \(", "if (true || "), (r" == ", " != "),
                  (r" != ", " == "), (r" \? ", " && false ? ")],
    "dropped": [(r"^(\s+)[\w.>\[\]()-]+(?: [-+*/]?=|\()[^{}]*;$", r"\1;")],
    "swapped": [(r"\((\w+), (\w+)([,)])", r"(\2, \1\3"), (r", (\w+), (\w+)\)", r", \2, \1)")],
}

# Survivors that change nothing that a user could see: file, what was there, and why.
EXPLAINED = [
    ("across.cpp", "for (size_t lane = 0; lane < N; ++lane) {", "one too many is the next cell's, which follows"),
    ("fields.hh", "return n > SIZE_MAX / 4 ?", "nobody has so many places"),
    ("keep.cpp", "all - at < kBedHead", "what is read beyond the end is refused as well"),
    ("packed.hh", "< least ? 0 : a;", "differs for one number"),
    ("water_hull_step.cpp", "better = then < now;", "an equal energy ends the search one way or the other"),
]


def places(tree):
    """All that could be broken: kind, path, line number, line, what it becomes."""
    found = {kind: [] for kind in KINDS}
    for path in sorted((tree / "src").rglob("*")):
        if path.suffix not in (".cpp", ".hh"):
            continue
        for number, line in enumerate(path.read_text().split("\n")):
            code = line.split("//")[0].rstrip()
            if not code or code.lstrip().startswith(("#", "*", "/*", "template", "static_assert", "using")):
                continue
            for kind, rules in KINDS.items():
                for pattern, instead in rules:
                    for match in re.finditer(pattern, code):
                        new = code[:match.start()] + match.expand(instead) + code[match.end():]
                        if new != code:
                            found[kind].append((kind, path, number, code, new))
    return found


def told_by(build, tiers, inside):
    told = json.loads(run("ctest", "--test-dir", build, "--show-only=json-v1", "-L", f"^({tiers})$").stdout)
    return [test for test in told["tests"] if test["name"].startswith("unit.") == inside]


class Tests:
    """The programs of the tests, the quickest first."""

    def __init__(self, build, tiers):
        made = run("cmake", "--build", build, "-j", "2")
        if made.returncode:
            sys.exit(made.stdout[-3000:])
        self.build = build
        self.of_library, self.of_inside = (self.timed(told_by(build, tiers, inside)) for inside in (False, True))

    def timed(self, tests):
        with ThreadPoolExecutor(2) as pool:
            timed = list(pool.map(lambda test: (self.time_of(test["name"], test["command"]), test), tests))
        return [(test["name"], test["command"], SLOWER * took + 10)
                for took, test in sorted(timed, key=lambda one: one[0])]

    def time_of(self, name, command):
        began = time.monotonic()
        if self.play(command, 3600):
            sys.exit(f"{name} fails with nothing broken")
        return time.monotonic() - began

    @staticmethod
    def play(command, limit):
        """Whether a test fails."""
        began = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
                                 preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
        try:
            return began.wait(limit) != 0
        except subprocess.TimeoutExpired:
            os.killpg(began.pid, signal.SIGKILL)
            began.wait()
            return True

    def first_failure(self):
        by = self.first_of(self.of_library)
        if by or not self.of_inside:
            return by
        programs = [Path(command[0]).name for _, command, _ in self.of_inside]
        made = run("cmake", "--build", self.build, "-j", "2", "--target", *programs)
        return "the compiler" if made.returncode else self.first_of(self.of_inside)

    def first_of(self, tests):
        failed = []

        def try_one(test):
            name, command, limit = test
            if not failed and self.play(command, limit):
                failed.append(name)

        with ThreadPoolExecutor(2) as pool:
            list(pool.map(try_one, tests))
        return failed[0] if failed else None


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    chance = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    tree, build = copy_and_configure(sys.argv[1], "-DCONTDYN_AVX2=OFF", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG")
    tests = Tests(build, sys.argv[4] if len(sys.argv) > 4 else "unit|api|physics|stability|determinism|memory")
    library = build / "src/libcontdyn.so"
    whole = hashlib.sha256(library.read_bytes()).digest()
    found = places(tree)
    print(f"{sum(map(len, found.values()))} places, {len(tests.of_library + tests.of_inside)} tests", flush=True)
    tried = noticed = explained = 0
    while tried < count:
        kind, path, number, old, new = chance.choice(found[chance.choice(list(KINDS))])
        text = path.read_text()
        lines = text.split("\n")
        lines[number] = new
        path.write_text("\n".join(lines))
        made = run("cmake", "--build", build, "--target", "contdyn", "-j", "2")
        if made.returncode == 0 and hashlib.sha256(library.read_bytes()).digest() != whole:
            by = tests.first_failure()
            tried += 1
            noticed += by is not None
            why = next((why for file, there, why in EXPLAINED if path.match(file) and there in old), None)
            explained += by is None and why is not None
            says = f"noticed by {by}" if by else f"explained: {why}" if why else "SURVIVED"
            print(f"{tried}. {path.relative_to(tree)}:{number + 1}, {kind}, {says}\n    {old.strip()}\n    {new.strip()}",
                  flush=True)
        path.write_text(text)
    print(f"{noticed} of {tried} noticed, {explained} of the others explained")
    return 0 if noticed + explained >= NOTICED_AT_LEAST * tried else 1


if __name__ == "__main__":
    sys.exit(main())
