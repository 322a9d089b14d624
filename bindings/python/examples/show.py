"""What the examples share: draw where Matplotlib is installed, else tell in numbers."""
import sys


def show(draw, tell, name):
    """draw(pyplot, path) draws into the file that the command line names, NAME.png if none."""
    try:
        import matplotlib
    except ImportError:
        tell()
        return
    matplotlib.use("Agg")  # into files; needs no screen
    from matplotlib import pyplot
    draw(pyplot, sys.argv[1] if len(sys.argv) > 1 else f"{name}.png")
