#!/usr/bin/env python3
"""A round drum is hit beside its middle: its skin in motion, and what it sounds like. Drawn with Matplotlib where it is
installed, else told in numbers.

    drum.py [FILE]      the picture; drum.png if none is given
"""
import cmath
import math
from contdyn import Edge, Field, Membrane, Node

from show import show

SIDE, RADIUS = 64, 0.25  # springs, m
RATE, SHOWN = 4000, (8, 24, 48, 96)  # 1/s, steps after which the skin is shown
LISTENED = 2000  # steps
TENSION, DENSITY = 60.0, 0.3  # N/m, kg/m^2
FIRST, THIRD = 2.404826, 3.831706  # zeros of the Bessel functions J0 and J1: where a round drum's notes come from


def make():
    """A square of side 2 RADIUS whose corners outside the circle are pinned; one component, the height [m]."""
    drum = Membrane(nu=SIDE, nv=SIDE, components=1)
    for edge in Edge:
        drum.set_edge(edge, Node.PINNED)
    drum.mass = DENSITY * (2 * RADIUS) ** 2
    drum.stiffness = TENSION, TENSION
    drum.drag = 4
    drum.enable_field(Field.PIN)
    middle = SIDE / 2
    drum.write(Field.PIN, [[int(math.hypot(u - middle, v - middle) >= middle) for u in range(SIDE + 1)]
                           for v in range(SIDE + 1)])
    drum.impulse(0.6 * SIDE, 0.5 * SIDE, 6, [0.01])
    return drum


def note(zero):
    """Frequency [Hz] of a mode of the ideal round drum."""
    return zero / (2 * math.pi * RADIUS) * math.sqrt(TENSION / DENSITY)


def play():
    """The skin at the times shown, and the height of the place that is listened to, step by step."""
    skins, heard = [], []
    with make() as drum:
        skin = drum.position  # shows the drum's own memory, step after step
        for step in range(1, LISTENED + 1):
            drum.step(1 / RATE)
            heard.append(float(skin[SIDE // 2, SIDE // 4, 0]))
            if step in SHOWN:
                skins.append((drum.time, drum.read(Field.POSITION)))
    return skins, heard


def loudness(heard, frequency):
    """How much of a frequency there is, by Fourier's sum with a window."""
    n = len(heard)
    return abs(sum(x * (1 - math.cos(2 * math.pi * k / n)) * cmath.exp(-2j * math.pi * frequency * k / RATE)
                   for k, x in enumerate(heard))) / n


def tell():
    skins, heard = play()
    print("   time     lowest and highest place of the skin")
    for time, skin in skins:
        heights = [place[0] for row in skin.tolist() for place in row]
        print(f"{1000 * time:5.1f} ms   {1000 * min(heights):7.3f} {1000 * max(heights):7.3f} mm")
    for zero in (FIRST, THIRD):
        near = [note(zero) * (0.9 + 0.002 * k) for k in range(101)]
        print(f"note: {max(near, key=lambda f: loudness(heard, f)):6.1f} Hz; ideal round drum: {note(zero):6.1f} Hz")


def draw(pyplot, path):
    skins, heard = play()
    figure, axes = pyplot.subplot_mosaic([[0, 1, 2, 3], ["sound"] * 4], figsize=(12, 6), layout="constrained")
    for k, (time, skin) in enumerate(skins):
        side = [-RADIUS, RADIUS]
        shown = axes[k].imshow(skin[:, :, 0] * 1000, cmap="RdBu", vmin=-8, vmax=8, extent=side + side, origin="lower")
        axes[k].set(title=f"{1000 * time:.0f} ms", xlabel="x [m]")
    axes[0].set_ylabel("y [m]")
    figure.colorbar(shown, ax=[axes[k] for k in range(4)], label="height [mm]", shrink=0.8, extend="both")
    frequencies = [0.5 * k for k in range(20, 400)]
    axes["sound"].semilogy(frequencies, [loudness(heard, f) for f in frequencies])
    for zero in (FIRST, THIRD):
        axes["sound"].axvline(note(zero), color="black", linestyle=":", linewidth=1)
    axes["sound"].set(title="What it sounds like; dotted: notes of the ideal round drum", xlabel="frequency [Hz]",
                      ylabel="loudness")
    figure.savefig(path, dpi=120)
    print(f"{path}: {SIDE + 1} x {SIDE + 1} nodes, {LISTENED} steps")


if __name__ == "__main__":
    show(draw, tell, "drum")
