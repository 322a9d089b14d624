#!/usr/bin/env python3
"""Which lines and branches of src/ the tests, or the fuzzer, reach. Needs gcovr.

    coverage.py FOLDER                 builds in FOLDER and runs the tests, in a quarter of an hour
    coverage.py FOLDER fuzz SECONDS    the fuzzer alone

Prints the shares, those of each file that is not reached as a whole, and its lines that are not. A line or branch of a
kernel counts as reached where one instruction set or width reaches it. Branches that only exceptions take do not count.
"""

import json
import sys
from pathlib import Path

from tree import ROOT, configure, run


def share(reached, all_there):
    return 100 * reached / all_there if all_there else 100


def main():
    if len(sys.argv) not in (2, 4):
        sys.exit(__doc__)
    build = Path(sys.argv[1]).resolve() / "build"
    configure(ROOT, build, "-DCMAKE_CXX_FLAGS=--coverage", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
              "-DCMAKE_SHARED_LINKER_FLAGS=--coverage", "-DCMAKE_EXE_LINKER_FLAGS=--coverage", "-DCONTDYN_OPTIMIZE=OFF")
    made = run("cmake", "--build", build, "-j", "2")
    if made.returncode:
        sys.exit(made.stdout[-3000:])
    for counts in build.rglob("*.gcda"):
        counts.unlink()
    if len(sys.argv) == 4:
        done = run(build / "tests/fuzz/fuzz", "1", sys.argv[3])
    else:
        done = run("ctest", "--test-dir", build, "-j", "2", "-L",
                   "^(unit|api|physics|stability|determinism|memory|bindings)$")
    print("\n".join(done.stdout.splitlines()[-12:]))
    table = build / "coverage.json"
    told = run("gcovr", "--root", ROOT, "--filter", f"{ROOT}/src/", "--exclude-throw-branches",
               "--gcov-ignore-parse-errors",  # a few counts that threads have made less than 0
               "--json", table, build)
    if told.returncode:
        sys.exit(told.stdout)
    lines = branches = lines_reached = branches_reached = 0
    for file in json.loads(table.read_text())["files"]:
        there = [line for line in file["lines"] if not line["gcovr/noncode"]]
        missed = [line["line_number"] for line in there if not line["count"]]
        ways = [branch["count"] > 0 for line in there for branch in line["branches"]]
        lines, lines_reached = lines + len(there), lines_reached + len(there) - len(missed)
        branches, branches_reached = branches + len(ways), branches_reached + sum(ways)
        if missed or not all(ways):
            print(f"{file['file']}: lines {share(len(there) - len(missed), len(there)):.1f}%, branches "
                  f"{share(sum(ways), len(ways)):.1f}%", *[f"\n    {number}" for number in missed[:20]])
    print(f"lines {share(lines_reached, lines):.2f}% of {lines}, branches {share(branches_reached, branches):.2f}% of "
          f"{branches}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
