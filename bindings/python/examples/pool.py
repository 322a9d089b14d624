#!/usr/bin/env python3
"""A pool with a beach and an island; something falls in. Drawn with Matplotlib where it is installed, else told in
numbers.

    pool.py [FILE]      the picture; pool.png if none is given
"""
import math
from contdyn import Field, Momentum, Precision, Water

from show import show

NX, NY, CELL = 192, 128, 1 / 32  # 6 m x 4 m
LEVEL = 0.5  # m
RATE, SHOWN = 120, (24, 72, 144, 288)  # 1/s, steps after which the surface is shown


def bed(x, y):
    """Flat, a beach that rises at the right, an island."""
    beach = max(0.0, 0.35 * (x - 4.0))
    island = 0.65 * math.exp(-((x - 3.2) ** 2 + (y - 2.6) ** 2) / 0.18)
    return max(beach, island)


def make():
    pool = Water(NX, NY, CELL, CELL, Precision.FLOAT32)
    pool.momentum = Momentum.ADVECTED
    pool.manning = 0.01
    pool.bed = [[bed((i + 0.5) * CELL, (j + 0.5) * CELL) for i in range(NX)] for j in range(NY)]
    pool.write(Field.SURFACE, LEVEL)
    pool.splash(1.5, 1.5, 0.4, 0.25)
    pool.restart_account()
    return pool


def frames():
    """Time, surface, depth and volume at the times shown."""
    with make() as pool:
        for step in range(1, SHOWN[-1] + 1):
            pool.step(1 / RATE)
            if step in SHOWN:
                yield pool.time, pool.read(Field.SURFACE), pool.read(Field.DEPTH), pool.volume, pool.account.error


def tell():
    print("   time     lowest and highest water      volume     of which rounding")
    for time, surface, depth, volume, error in frames():
        wet = [h for row, depths in zip(surface.tolist(), depth.tolist()) for h, d in zip(row, depths) if d > 1e-3]
        print(f"{time:5.2f} s   {min(wet):6.3f} {max(wet):6.3f} m   {volume:14.6f} m^3   {error:9.1e} m^3")


def draw(pyplot, path):
    import numpy
    figure, axes = pyplot.subplots(2, 2, figsize=(11, 7), layout="constrained", sharex=True, sharey=True)
    for axis, (time, surface, depth, volume, _) in zip(axes.flat, frames()):
        sides = [0, NX * CELL, 0, NY * CELL]
        axis.imshow(surface - depth, cmap="pink", extent=sides, origin="lower", vmin=-0.5, vmax=1)
        height = numpy.ma.masked_where(depth < 1e-3, surface - LEVEL) * 1000
        shown = axis.imshow(height, cmap="Blues_r", extent=sides, origin="lower", vmin=-40, vmax=40)
        axis.contour(depth, [1e-3], colors="black", linewidths=0.6, extent=sides)
        axis.set(title=f"{time:.1f} s, {volume:.4f} m$^3$")
    for axis in axes[:, 0]:
        axis.set_ylabel("y [m]")
    for axis in axes[1]:
        axis.set_xlabel("x [m]")
    figure.colorbar(shown, ax=axes, label="water above its level [mm]", shrink=0.8, extend="both")
    figure.savefig(path, dpi=120)
    print(f"{path}: {NX} x {NY} cells, {SHOWN[-1]} steps")


if __name__ == "__main__":
    show(draw, tell, "pool")
