#!/usr/bin/env python3
"""A rope, held at one end, falls and swings: drawn with Matplotlib where it is installed, else told in numbers.

    rope.py [FILE]      the picture; rope.png if none is given
"""
from math import inf

from contdyn import Chain, End, Node

from show import show

LENGTH, NODES, FRAMES, RATE = 2.0, 201, 90, 60  # m, -, -, 1/s


def make():
    """It lies straight beside its hook."""
    rope = Chain(strands=1, springs=NODES - 1, components=2)
    rope.position = [[LENGTH * i / (NODES - 1), 0] for i in range(NODES)]
    rope.set_end(End.FIRST, Node.PINNED)
    rope.rest_length, rope.stiffness = LENGTH, inf  # it does not stretch
    rope.mass, rope.gravity, rope.drag = 0.5, (0, -9.81), 0.3
    return rope


def frames():
    """Time, positions and energies at each frame."""
    with make() as rope:
        for frame in range(FRAMES):
            if frame:
                rope.step(1 / RATE)
            yield rope.time, rope.position[0].tolist(), rope.energy


def tell():
    print("   time     end of the rope     energy")
    for frame, (time, nodes, energy) in enumerate(frames()):
        if frame % 10 == 0:
            print(f"{time:5.2f} s   {nodes[-1][0]:6.3f}  {nodes[-1][1]:6.3f} m   {sum(energy):8.4f} J")


def draw(pyplot, path):
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 5), layout="constrained")
    shades = pyplot.get_cmap("viridis")
    times, kinetic, elastic, lifted = [], [], [], []
    for frame, (time, nodes, energy) in enumerate(frames()):
        times.append(time)
        kinetic.append(energy.kinetic)
        elastic.append(energy.elastic)
        lifted.append(energy.gravity)
        if frame % 5 == 0:
            left.plot(*zip(*nodes), color=shades(frame / FRAMES), linewidth=1.5)
    left.plot(0, 0, "o", color="black")
    left.set(title="A rope let go: every 1/12 s, dark to bright", xlabel="x [m]", ylabel="y [m]", aspect="equal")
    for values, label in ((kinetic, "kinetic"), (elastic, "elastic"), (lifted, "gravity")):
        right.plot(times, values, label=label)
    right.plot(times, [sum(each) for each in zip(kinetic, elastic, lifted)], "k--", label="sum: drag takes some")
    right.set(title="Energy", xlabel="time [s]", ylabel="energy [J]")
    right.legend()
    figure.savefig(path, dpi=120)
    print(f"{path}: {NODES} nodes, {FRAMES} frames")


if __name__ == "__main__":
    show(draw, tell, "rope")
