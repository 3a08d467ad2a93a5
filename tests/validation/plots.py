"""Pictures in one style: the reference is a black line, what Trajan found is coloured."""

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402: the backend must be chosen first

REFERENCE = {"color": "black", "linewidth": 1.2}
COLOURS = ("tab:red", "tab:blue", "tab:green", "tab:orange", "tab:purple", "tab:brown", "tab:cyan")


def marks(drawn, x, y, number, of, **options):
    """Points of a curve; each of several that coincide has places of its own."""
    apart = max(of, len(x) * of // 90)
    shown = slice(number * apart // of, None, apart)
    drawn.plot(x[shown], y[shown], "o", markersize=3, color=COLOURS[number], **options)


def axes(count=1, width=6.4, height=4.0, **options):
    """A figure with `count` axes beside each other; one axes, or an array of them."""
    figure, drawn = pyplot.subplots(1, count, figsize=(width * count, height), **options)
    for one in [drawn] if count == 1 else drawn:
        one.grid(alpha=0.3)
    return figure, drawn
