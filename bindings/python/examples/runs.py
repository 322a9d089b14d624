#!/usr/bin/env python3
"""A thousand runs over the processors: how hard do gusts pull at the mast that holds a cable?

    runs.py [RUNS [PROCESSES]]      1000 runs, as many processes as there are processors
    runs.py RUNS ADDRESS            on a Dask cluster: the address of its scheduler, such as tcp://10.0.0.1:8786

Each run has its own gusts, by its number, and gives the same on every machine and in any order. The cable hangs still
once; objects pickle, and so every process gets it as it is then.
"""
import copy
import os
import random
import sys
from concurrent.futures import ProcessPoolExecutor
from math import hypot, inf

from contdyn import Chain, End, Node

SPAN, LENGTH, SPRINGS, RATE, GUST, GUSTS = 25.0, 25.5, 30, 60, 0.5, 20  # m, m, -, 1/s, s, -


def hang():
    """A cable of 0.4 kg/m and 12 mm between two masts, at rest: x along it, y across, z up."""
    cable = Chain(strands=1, springs=SPRINGS, components=3)
    cable.position = [[SPAN * i / SPRINGS, 0, 0] for i in range(SPRINGS + 1)]
    cable.rest_length, cable.stiffness, cable.mass = LENGTH, inf, 0.4 * LENGTH
    cable.gravity = 0, 0, -9.81
    cable.set_end(End.FIRST, Node.PINNED)
    cable.set_end(End.LAST, Node.PINNED)
    cable.lambda_ = 1  # it comes to rest soon
    cable.step(1 / RATE, 20 * RATE)
    cable.lambda_ = 0.5
    cable.air = 0, 0.5 * 1.2 * 1.1 * 0.012 * 20  # half density, coefficient, diameter, and some 20 m/s of wind
    return cable


def pull(cable, seed):
    """The hardest pull at the first mast in one run [N]."""
    gusts = random.Random(seed)
    hardest = 0.0
    with copy.copy(cable) as mine:
        for _ in range(GUSTS):
            mine.wind = gusts.gauss(0, 3), gusts.gauss(20, 7), gusts.gauss(0, 2)
            for _ in range(int(GUST * RATE)):
                mine.step(1 / RATE)
                hardest = max(hardest, hypot(*mine.get_reaction(0, 0)))
    return hardest


def start(cable):
    global prepared
    prepared = cable


def run(seed):
    return pull(prepared, seed)


def over_processes(cable, runs, processes):
    with ProcessPoolExecutor(processes, initializer=start, initargs=(cable,)) as pool:
        return list(pool.map(run, range(runs), chunksize=max(1, runs // (8 * processes))))


def over_cluster(cable, runs, address):
    from dask.distributed import Client

    with Client(address) as client:
        return client.gather(client.map(pull, [client.scatter(cable, broadcast=True)] * runs, range(runs)))


def main():
    runs = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    where = sys.argv[2] if len(sys.argv) > 2 else str(os.cpu_count())
    cable = hang()
    print(f"at rest    {hypot(*cable.get_reaction(0, 0)):5.0f} N")
    pulls = sorted(over_processes(cable, runs, int(where)) if where.isdigit() else over_cluster(cable, runs, where))
    for name, share in (("median", 0.5), ("1 in 10", 0.9), ("1 in 100", 0.99), ("hardest", 1)):
        print(f"{name:10} {pulls[min(runs - 1, int(share * runs))]:5.0f} N")


if __name__ == "__main__":
    main()
