#!/usr/bin/env python3
"""Takes the rules of the steps of water, hulls, ropes and cloth out, one after the other, and shows which tests fail without.

    take_out.py FOLDER [RULE...]     builds in FOLDER, some minutes a rule; without a rule's name all of them
    take_out.py --check              fails unless these rules are in the sources, and those of the tables

Exit status 0: every rule has a test that fails without it, and that passes with it. The tables in src/README.md and
src/rules.md are what this prints.
"""

import subprocess
import sys

from rules import RULES
from tree import ROOT, copy_and_configure, run

KERNELS = "src/kernel/"


def check():
    """What is wrong with the rules as they are told here."""
    told = (ROOT / "src/README.md").read_text().split("\n## The rules of ")[1] + (ROOT / "src/rules.md").read_text()
    rows = {line.split(" | ")[0].removeprefix("| "): line for line in told.splitlines() if line.startswith("| ")}
    for name, (file, there, instead, tests) in RULES.items():
        times = (ROOT / KERNELS / file).read_text().count(there)
        if times != 1:
            yield f"{name}: {file} has {times} times {there!r}"
        if not any(f"`{test}`" in rows.get(name, "") for test in tests):
            yield f"{name}: no table names any of {tests}"
    yield from (f"{name}: no rule here" for name in rows.keys() - RULES.keys() - {"rule"})


def failure(build, test):
    """The name of what fails in a test program, or None."""
    made = run("cmake", "--build", build, "--target", test, "-j", "2")
    if made.returncode:
        sys.exit(f"{test} does not build\n{made.stdout[-3000:]}")
    try:
        played = subprocess.run([build / "tests" / test], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                timeout=900)
    except subprocess.TimeoutExpired:
        return "does not end"
    if not played.returncode:
        return None
    failed = [line.split("] ")[1] for line in played.stdout.splitlines() if line.startswith("[  FAILED  ]")]
    return failed[0] if failed else f"ends with {played.returncode}"


def main():
    if sys.argv[1:] == ["--check"]:
        wrong = list(check())
        print("\n".join(wrong))
        return 1 if wrong else 0
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    names = sys.argv[2:] or list(RULES)
    tree, build = copy_and_configure(sys.argv[1])
    for test in sorted({test for name in names for test in RULES[name][3]}):
        found = failure(build, test)
        if found:
            sys.exit(f"{test} fails with all rules in: {found}")
    unguarded = 0
    for name in names:
        file, there, instead, tests = RULES[name]
        path = tree / KERNELS / file
        text = path.read_text()
        if text.count(there) != 1:
            sys.exit(f"{name}: {file} has {text.count(there)} times {there!r}")
        path.write_text(text.replace(there, instead))
        fails = next(((test, found) for test in tests if (found := failure(build, test))), None)
        path.write_text(text)
        unguarded += fails is None
        print(f"| {name} | {f'`{fails[0]}`: {fails[1]}' if fails else '**none**'} |", flush=True)
    return 1 if unguarded else 0


if __name__ == "__main__":
    sys.exit(main())
