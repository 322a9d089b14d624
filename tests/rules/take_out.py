#!/usr/bin/env python3
"""Takes the rules of water's step out, one after the other, and shows which tests fail without each.

    take_out.py FOLDER [RULE...]     builds in FOLDER, some minutes a rule; without a rule's name all of them

Exit status 0: every rule has a test that fails without it, and that passes with it. The table in src/README.md is what
this prints.
"""

import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WATER = "src/kernel/water/"

# Name: file, what is there, what takes its place, tests to run (the first one that fails ends a rule).
RULES = {
    "a dry bed pushes nothing": (
        "face.hh", "return select(rise, select(r.depth, rise, none), select(l.depth, rise, none));", "return rise;",
        ["physics_water_lake"]),
    "a face shallower than the mean beside a shallow giver": (
        "face.hh", "const L shallower = smaller(mean, most),", "const L shallower = mean,",
        ["physics_water_dams", "physics_water_thacker", "stability_water_energy"]),
    "a face deeper than the mean where water falls": (
        "face.hh", "deeper = larger(mean, smaller(fall, over));", "deeper = mean;",
        ["physics_water_dams", "physics_water_sides", "physics_water_thacker", "stability_water_energy"]),
    "water climbs as far as its speed lifts it": (
        "face.hh", "over + kClimbedHeads * head", "L::splat(1e300)", ["physics_water_symmetry"]),
    "what runs dry keeps more than rounding": (
        "face.hh", "constexpr double kGives = 1 - 0x1p-40;", "constexpr double kGives = 1 - 0x1p-53;",
        ["physics_water_symmetry"]),
    "a stream carries changes of depth along": (
        "surface.hh", "k = theta * cells,", "k = 0.0 * cells,",
        ["stability_water_currents"]),
    "the stream's acceleration counts in fluxes": (
        "surface.hh", "advected = theta * stream;", "advected = 0.0 * stream;",
        ["physics_water_sides"]),
    "no cell gives more than it has and gets": (
        "line.hh", "if (any_positive(-least)) limit(-least);", "", ["stability_water_volume"]),
    "no more comes in at a side than to an empty cell": (
        "limiter.hh", "    if (!ring) { //", "    if (false) { //", ["stability_water_extremes"]),
    "what fills a cell at a side ends at the level outside": (
        "side.hh", "d_out > d ? most / (d_out - d) : 0", "0", ["physics_water_sides", "stability_water_extremes"]),
    "velocities follow what the limiter lets through": (
        "velocity.hh", "if (any_limited)", "if (false)", ["stability_water_energy"]),
    "the energy bound of long steps": (
        "line.hh", "if (kind.any_long) balance(kind);", "", ["stability_water_energy"]),
    "a long step is rough from a change of 5% on": (
        "velocity.hh", "constexpr double kRoughChange = 0.05;", "constexpr double kRoughChange = 1;",
        ["stability_water_energy"]),
    "and at shores": (
        "surface.hh", "select(smaller(l.depth, r.depth), uneven, mean)", "uneven", ["stability_water_energy"]),
    "what pushes from outside does work": (
        "velocity.hh", "return acceleration ? rise - acceleration[i] / L::splat(sweep.courant) : rise;", "return rise;",
        ["physics_water_forces"]),
    "parts of half a cell": (
        "line.hh", "constexpr double kPartRun = 0.5;", "constexpr double kPartRun = 1e9;", ["stability_water_currents"]),
    "what resolves waves fades out": (
        "line.hh", "resolves = within(", "resolves = L::splat(1) + 0.0 * within(", ["stability_water_currents"]),
    "slopes of velocities within cells": (
        "stream.hh", "const L part = smaller(run, positive(L::splat(1) - run)) * even_depth(cell);", "const L part = 0.0 * run;",
        ["physics_water_sides"]),
    "slopes only where depths are even": (
        "stream.hh", "return positive(smaller(least,", "return least; return positive(smaller(least,",
        ["stability_water_currents", "stability_water_energy", "physics_water_thacker"]),
    "slopes add no more than goes through": (
        "stream.hh", "smaller(part, size_of(through))", "part", ["physics_water_symmetry"]),
    "half of the momentum goes with old velocities": (
        "carry.hh", "const Lanes<N> e = 0.5 *", "const Lanes<N> e = 0.0 *", ["physics_water_dams", "physics_water_thacker"]),
    "dry faces take the speed of what comes": (
        "velocity.hh", "sweep.advected ? near : none", "none", ["physics_water_thacker", "physics_water_dams"]),
    "slopes across": (
        "across.cpp", "return smaller(q, positive(given - q)) * half_slope(through, u);", "return 0.0 * q;",
        ["physics_water_thacker", "physics_water_momentum"]),
    "a side's depth is that of half a cell before": (
        "surface.hh", "- L::load(half_cell))", "- 0.0 * L::load(half_cell))", ["physics_water_sides"]),
    "what leaves runs no faster than it came": (
        "velocity.hh", "larger(-most, smaller(most, u))", "u", ["physics_water_symmetry"]),
    "what rounding takes is handed on": (
        "sweep.cpp", "rest.owed = rest.owed + one.owed;", "(void)one;", ["physics_water_lake"]),
}


def run(*command, cwd=None):
    return subprocess.run(command, cwd=cwd, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


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
    folder = Path(sys.argv[1]).resolve()
    names = sys.argv[2:] or list(RULES)
    tree, build = folder / "tree", folder / "build"
    shutil.rmtree(tree, ignore_errors=True)
    shutil.copytree(ROOT, tree, ignore=shutil.ignore_patterns("build*", ".git"))
    configured = run("cmake", "-S", tree, "-B", build, "-DCMAKE_BUILD_TYPE=Release", "-DCONTDYN_REPORT=OFF",
                     "-DCONTDYN_AVX512=OFF")
    if configured.returncode:
        sys.exit(configured.stdout)
    for test in sorted({test for name in names for test in RULES[name][3]}):
        found = failure(build, test)
        if found:
            sys.exit(f"{test} fails with all rules in: {found}")
    unguarded = 0
    for name in names:
        file, there, instead, tests = RULES[name]
        path = tree / WATER / file
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
