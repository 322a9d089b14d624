#!/usr/bin/env python3
"""Breaks the library in one place at a time, at random places, and shows which test notices.

    mutate.py FOLDER [COUNT [SEED [TIERS]]]          200 places of seed 1, with all processors; in some hours of two
    mutate.py --only STEP FOLDER [COUNT [SEED [TIERS]]]   STEP: make, ask or inside

Three steps, each of which goes on where it was stopped: `make` builds a library for each mutation; `ask` asks the
tests, several mutations side by side; `inside` asks the unit tests, which are linked with what is inside the library,
about those that nothing has noticed.
TIERS: those of tests/CMakeLists.txt that are asked, as a regular expression; all if it is left out.

Counted are mutations that compile and change the library file. Exit status 0: at least 97% are noticed, or are
explained below.
"""

import hashlib
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from heapq import heapify, heappop, heappush
from pathlib import Path
from threading import Lock, Thread

from tree import copy_and_configure, run

NOTICED_AT_LEAST = 0.97
MEMORY = 4 << 30  # [bytes] that a test may take
PROCESSORS = len(os.sched_getaffinity(0))
JOBS = str(PROCESSORS)
SONAME = "libcontdyn.so.0.2"
OF_API = ["bindings.behaviour", "bindings.ranges", "bindings.pointers"]  # programs that api.json tells what to try
OPTIONS = ("-DCONTDYN_AVX2=OFF", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG")
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
    ("line.hh", "if (any_positive(-least)) limit(-least);", "changes nothing where no cell gives too much"),
    ("sheet_planes.cpp", "const size_t pairs = across == 2 ?", "pairs, or one column after the other"),
    ("planes.hh", "per_part = length < numbers ?", "how work is dealt out to threads"),
    ("tiles.hh", "__builtin_prefetch", "time only"),
    ("line_lanes.hh", "__builtin_prefetch", "time only"),
    ("sheet_explicit.cpp", "&& fetches", "time only"),
    ("water_hull_step.cpp", "stop = to > low ?", "the same number where they are equal"),
    ("water_hull_step.cpp", "due < credit ? positive(2 * due - credit) : due", "the same number where they are equal"),
    ("water_hull_step.cpp", "if (!(share > 0)) return;", "a share of 0 adds 0"),
    ("water_hull_step.cpp", "inverse_mass = 0, sum = 0", "without water nothing is given, and no sum looked at"),
    ("water_step.cpp", "finite = true;", "only the first step that is not finite counts"),
    ("lanes.hh", "if (count >= size_t(kWidest))", "the same in narrower bundles"),
    ("chain_step.cpp", "closing[i] = welded(c, i) ? 0 : 1", "there is one place more than springs, never looked at"),
    ("chain_step.cpp", "if (refactor) {", "factors made again are the same"),
    ("chain_step.cpp", "return finite || (chain.has_welds", "what is not finite is found once more"),
    ("advance.cpp", "if (ring.constraints > 0)", "of no constraints there are no forces"),
    ("water_hull.cpp", "along + 0.0", "the sign of a 0"),
    ("sheet_lines.cpp", "const bool last = r + 1 == grid.rows", "the last node's pull is 0"),
    ("velocity.hh", "if (any_bounded)", "bounds of no line bound nothing"),
    ("sheet_filters.hh", "rows[i] = tile[i].v", "one more than there are, never looked at; sanitizers see it"),
    ("membrane_cloth_step.cpp", "if (!(energy > 0)) break;", "0 only where squares underflow"),
    ("rod_sweep.cpp", "d = settled(", "numbers next to 0 take time only"),
    ("sheet_shift.cpp", "t[at + u] = 0", "beyond the rows, and without weight"),
    ("membrane_work.cpp", "size_t numbers = 0;", "overwritten"),
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


class Tests:
    """The tests of the library as it is, the quickest first, with the time that each may take."""

    def __init__(self, build, tiers, inside):
        self.build = build
        self.programs = [test["name"].replace(".", "_", 1) for test in self.told(tiers, inside)
                         if test["name"] not in OF_API]
        if self.programs:
            must(run("cmake", "--build", build, "-j", JOBS, "--target", *self.programs))
        self.tests = [(test["name"], test["command"]) for test in self.told(tiers, inside)]

    def told(self, tiers, inside):
        told = json.loads(run("ctest", "--test-dir", self.build, "--show-only=json-v1").stdout)
        labels = {test["name"]: next(p["value"] for p in test["properties"] if p["name"] == "LABELS")
                  for test in told["tests"]}
        of_api = [] if inside else OF_API
        return [test for test in told["tests"] if test["name"] in of_api or
                re.fullmatch(tiers, labels[test["name"]][0]) and test["name"].startswith("unit.") == inside]

    def timed(self):
        with ThreadPoolExecutor(PROCESSORS) as pool:
            took = list(pool.map(lambda test: self.time_of(*test), self.tests))
        return [(name, command, SLOWER * seconds + 10)
                for seconds, (name, command) in sorted(zip(took, self.tests), key=lambda one: one[0])]

    def time_of(self, name, command):
        began = time.monotonic()
        if fails(command, 3600):
            sys.exit(f"{name} fails with nothing broken")
        return time.monotonic() - began


def must(made):
    if made.returncode:
        sys.exit(made.stdout[-3000:])


def fails(command, limit, library_folder=None):
    """Whether a test fails, with the library of that folder."""
    told = dict(os.environ)
    if library_folder:
        command = [re.sub(r".*/libcontdyn\.so[.\d]*", f"{library_folder}/{SONAME}", part) for part in command]
        told["LD_LIBRARY_PATH"] = f"{library_folder}:{told.get('LD_LIBRARY_PATH', '')}"
    began = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
                             env=told,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY)))
    try:
        return began.wait(limit) != 0
    except subprocess.TimeoutExpired:
        os.killpg(began.pid, signal.SIGKILL)
        began.wait()
        return True


class Mutation:
    """One place: `by` names the test that noticed; None so far. `passed` tests of the library have not, nor, with
    `whole`, has any other."""

    def __init__(self, kind, path, number, old, new, by=None, passed=0, whole=False):
        self.kind, self.path, self.number, self.old, self.new = kind, path, number, old, new
        self.by, self.passed, self.whole = by, passed, whole

    def broken(self, tree):
        """Breaks the file and returns how it was."""
        text = (tree / self.path).read_text()
        lines = text.split("\n")
        lines[self.number] = self.new
        (tree / self.path).write_text("\n".join(lines))
        return text

    def explained(self):
        return next((why for file, there, why in EXPLAINED if Path(self.path).match(file) and there in self.old), None)

    def says(self):
        why = self.explained()
        return (f"noticed by {self.by}" if self.by else f"explained: {why}" if why else
                "SURVIVED" if self.whole else f"not noticed by {self.passed} tests so far")


class Run:
    def __init__(self, folder, count, seed, tiers):
        self.folder, self.count, self.tiers = Path(folder).resolve(), count, tiers
        self.tree, self.build = self.folder / "tree", self.folder / "build"
        self.library = self.build / "src" / SONAME
        self.kept = self.folder / "mutations.json"
        self.lock = Lock()
        self.mutations, self.tests, self.whole = [], [], None
        if self.kept.exists():
            kept = json.loads(self.kept.read_text())
            self.mutations, self.tests, self.whole = [Mutation(**m) for m in kept["m"]], kept["tests"], kept["whole"]
        self.chance = random.Random(f"{seed} {len(self.mutations)}" if self.mutations else seed)

    def keep(self):
        new = self.kept.with_suffix(".new")
        new.write_text(json.dumps({"m": [vars(m) for m in self.mutations], "tests": self.tests, "whole": self.whole}))
        new.replace(self.kept)

    def of(self, number):
        """The folder of a mutation's library."""
        return self.folder / "libraries" / str(number)

    def make(self):
        if self.whole is None:
            copy_and_configure(self.folder, *OPTIONS)
            must(run("cmake", "--build", self.build, "-j", JOBS, "--target", "contdyn"))
            self.whole = hashlib.sha256(self.library.read_bytes()).hexdigest()
            self.tests = Tests(self.build, self.tiers, False).timed()
            self.keep()
        found = places(self.tree)
        print(f"{sum(map(len, found.values()))} places, {len(self.tests)} tests", flush=True)
        while len(self.mutations) < self.count:
            kind, path, number, old, new = self.chance.choice(found[self.chance.choice(list(KINDS))])
            mutation = Mutation(kind, str(path.relative_to(self.tree)), number, old, new)
            text = mutation.broken(self.tree)
            made = run("cmake", "--build", self.build, "--target", "contdyn", "-j", JOBS)
            if made.returncode == 0 and hashlib.sha256(self.library.read_bytes()).hexdigest() != self.whole:
                at = self.of(len(self.mutations))
                at.mkdir(parents=True, exist_ok=True)
                shutil.copy(self.library, at / SONAME)
                self.mutations.append(mutation)
                self.keep()
            path.write_text(text)

    def ask(self):
        """One test at a time for the mutation that fewest have been asked about."""
        waiting = [(m.passed, number) for number, m in enumerate(self.mutations) if not m.by]

        def work():
            while True:
                with self.lock:
                    passed, number = heappop(waiting) if waiting else (len(self.tests), 0)
                if passed == len(self.tests):
                    return
                name, command, limit = self.tests[passed]
                failed = fails(command, limit, self.of(number))
                with self.lock:
                    if failed:
                        self.mutations[number].by = name
                    else:
                        self.mutations[number].passed += 1
                        heappush(waiting, (passed + 1, number))
                    self.keep()

        heapify(waiting)
        threads = [Thread(target=work) for _ in range(PROCESSORS)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def inside(self):
        left = [m for m in self.mutations if not m.by and not m.whole]
        if not left:
            return
        tests = Tests(self.build, self.tiers, True)
        must(run("cmake", "--build", self.build, "-j", JOBS, "--target", "contdyn"))
        timed = tests.timed()
        for mutation in left:
            text = mutation.broken(self.tree)
            made = run("cmake", "--build", self.build, "-j", JOBS, "--target", *tests.programs)
            mutation.by = "the compiler" if made.returncode else next(
                (name for name, command, limit in timed if fails(command, limit)), None)
            mutation.whole = True
            (self.tree / mutation.path).write_text(text)
            self.keep()


def main():
    arguments = sys.argv[1:]
    only = None
    if arguments[:1] == ["--only"]:
        only, arguments = arguments[1], arguments[2:]
    if not arguments or arguments[0].startswith("-") or only not in (None, "make", "ask", "inside"):
        sys.exit(__doc__)
    count, seed = (int(arguments[i]) if len(arguments) > i else default for i, default in ((1, 200), (2, 1)))
    of = Run(arguments[0], count, seed,
             arguments[3] if len(arguments) > 3 else "unit|api|physics|stability|determinism|memory")
    for step in [only] if only else ["make", "ask", "inside"]:
        getattr(of, step)()
    for number, m in enumerate(of.mutations):
        print(f"{number}. {m.path}:{m.number + 1}, {m.kind}, {m.says()}\n    {m.old.strip()}\n    {m.new.strip()}")
    noticed = sum(m.by is not None for m in of.mutations)
    explained = sum(m.by is None and m.explained() is not None for m in of.mutations)
    print(f"{noticed} of {len(of.mutations)} noticed, {explained} of the others explained")
    return 0 if noticed + explained >= NOTICED_AT_LEAST * len(of.mutations) else 1


if __name__ == "__main__":
    sys.exit(main())
