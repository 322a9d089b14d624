#!/usr/bin/env python3
"""What a step costs from Python over the same step from C, in one process: the same objects, stepped by turns from a
loop in C (step.c, compiled here by `cc`) and from a loop in Python; the least of many rounds of each."""
import ctypes
import platform
import subprocess
import tempfile
from pathlib import Path
from time import perf_counter

from contdyn import Chain, End, Membrane, Node, Water, build_info
from contdyn import _library

ROUNDS, CALLS, DT = 400, 500, 1e-3


def loop_in_c(folder):
    """time_steps of step.c."""
    built = Path(folder, "step.so")
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", "-o", built, Path(__file__).with_name("step.c")], check=True)
    function = ctypes.CDLL(str(built)).time_steps
    function.restype = ctypes.c_double
    function.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_double, ctypes.c_size_t]
    return function


def time_in_python(an_object):
    step = an_object.step
    begin = perf_counter()
    for _ in range(CALLS):
        step(DT)
    return perf_counter() - begin


def objects():
    """Small ones: the smaller the step, the plainer what is added to it."""
    rope = Chain(1, 10, 3)
    rope.position = [[i / 10, 0, 0] for i in range(11)]
    rope.set_end(End.FIRST, Node.PINNED)
    yield "chain, 11 nodes", "chain", rope
    hair = Chain(1, 1000, 3)
    hair.position = [[i / 1000, 0, 0] for i in range(1001)]
    hair.set_end(End.FIRST, Node.PINNED)
    yield "chain, 1001 nodes", "chain", hair
    sheet = Membrane(4, 4, 1)
    sheet.impulse(2, 2, 1, [0.01])
    yield "membrane, 5 x 5 nodes", "membrane", sheet
    pool = Water(4, 4, 0.1, 0.1)
    pool.depth = 0.1
    yield "water, 4 x 4 cells", "water", pool


def main():
    print(f"Python {platform.python_version()}, contdyn {build_info()}")
    print(f"{'microseconds per step':24}{'from C':>10}{'from Python':>14}{'added':>10}")
    with tempfile.TemporaryDirectory() as folder:
        time_in_c = loop_in_c(folder)
        for name, kind, an_object in objects():
            c_step = ctypes.cast(getattr(_library.library, f"cd_{kind}_step"), ctypes.c_void_p)
            in_c, in_python = [], []
            for _ in range(ROUNDS):
                in_c.append(time_in_c(c_step, an_object._handle, DT, CALLS))
                in_python.append(time_in_python(an_object))
            c, python = (min(times) / CALLS * 1e6 for times in (in_c, in_python))
            print(f"{name:24}{c:10.3f}{python:14.3f}{python - c:10.3f}")


if __name__ == "__main__":
    main()
