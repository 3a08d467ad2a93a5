"""Table 5 and figure 11: a beam on two hinges under a uniform load, at rest."""

import numpy as np
import scipy.interpolate

from beam_elements import LEVELS, Beam
from validation import beams, plots

TITLE = "Static simply supported beam"
SOURCE = "section 4.1.5, table 5, figure 11"
RESOLUTION = "32 cells, 16, 32 and 64 points, in section 7.1 as 8 × 2, 16 × 2 and 16 × 4"

PRINTED_REFERENCE = -0.212
PRINTED = {16: -0.333, 32: -0.346, 64: -0.206}
GOAL = 1e-3
SMALL = 1e-4  # share of the load 1 that leaves the deflection linear
PLANE = "plane elasticity, finite elements: tests/references/beam_elements.py"
ENDS = {
    "hinged": "whole edges held across the beam",
    "mean": "mean over the edges held",
    "patch": "middle quarters of the edges held",
}
LOADS = {"top": (beams.top_load, "load on the top edge"), "body": (beams.body_load, "load over the cross-section")}
LEVELS_OF_LOAD = 5


def bend(section, name, end, load, cell, samples=1, **numerics):
    """The result, stations and deflections under the load 1, shape (load levels, stations)."""
    result = section.run(
        name, "beam", **beams.values(
            (end, end), cell, loads=LOADS[load][0](-SMALL, "ramp { duration: 1 }"), axial_support=beams.axially_held(),
            analysis="end_time: 1 quasi_static { load_steps: 1 }",
            outputs=f"samples: {samples} snapshots: 1\n{beams.stations(cell)}", **numerics,
        ),
    )
    _, x, across = beams.deflections(result)
    return result, x, across[1:] / SMALL


def exact(end, load, quick):
    """Places, deflections under the load 1, and that at mid-span."""
    body = Beam((end, end), level=LEVELS[1 if quick else 2])
    force = body.top_load(-1) if load == "top" else body.body_load(-1)
    places, deflections = body.mesh.axis_x, body.section_means(body.equilibrium(force))[:, 1]
    return places, deflections, deflections[np.abs(places - beams.LENGTH / 2).argmin()]


def run(section):
    section.remark("""L 8, h 1, E 3000, load 1 per length, and nu 0.3 in plane stress, our choice. Beam theory gives
        5 w L^4 / 384 E I = 0.2133 at mid-span; the dissertation prints 0.212. A plane body also shears, and it matters
        how it is held: an ideal hinge, a point, has no answer (the deflection grows as the logarithm of what is held),
        so that three hinges are told apart. The dissertation held grid nodes at the ends, probably of the whole edges.
        Deflections are means over the cross-section. Its 16 × 2 cells with one point each are not shown: at one point a
        cell's bending has no strain, and hinges do not stop it, so that there is no equilibrium.""")
    places, true, middle = exact("hinged", "top", section.quick)
    lines = resolutions(section, middle)
    draw(section, places, true, lines)
    for end in ENDS:
        for load in LOADS:
            if (end, load) != ("hinged", "top") and not (section.quick and load == "top"):
                *_, middle = exact(end, load, section.quick)
                at_middle(section, f"{end}_{load}", end, load, middle, 1 / 32, "linear functions, cells of 1/32", 64, GOAL)


def at_middle(section, name, end, load, true, cell, settings, points, goal, samples=1, **numerics):
    """Adds a row for the middle of the beam; stations and deflections there."""
    result, x, across = bend(section, name, end, load, cell, samples, **numerics)
    section.row(
        f"mid-span deflection, {ENDS[end]}, {LOADS[load][1]}", true, PLANE, across[-1, beams.STATIONS // 2],
        f"quasi-static, {settings}", result.core_seconds, PRINTED[points], PRINTED_REFERENCE, goal,
        own=goal is None,
    )
    return x, across


def resolutions(section, true):
    """The dissertation's resolutions and finer ones, at its supports and load; the finest one's deflections."""
    runs = [
        ("16", 1, {}, "linear functions, 8 × 1 cells, 32 points", 32, None),
        ("32", 1 / 2, {"particles": 2}, "linear functions, 16 × 2 cells, 128 points", 64, None),
        ("32_quadratic", 1 / 2, beams.BEST, f"{beams.BEST_NAME}, 16 × 2 cells, 512 points", 64, None),
        ("quadratic", 1 / 16, {"particles": 3, "shapes": "quadratic_bspline"},
         "quadratic B-splines, cells of 1/16, 9 points each", 64, GOAL),
        ("linear", 1 / 32, {"samples": LEVELS_OF_LOAD}, "linear functions, cells of 1/32", 64, GOAL),
    ]
    for name, cell, more, settings, points, goal in runs:
        lines = at_middle(section, f"hinged_top_{name}", "hinged", "top", true, cell, settings, points, goal, **more)
    return lines


def draw(section, places, true, lines):
    figure, (whole, growing) = plots.axes(2, width=5, height=3.6)
    line = np.linspace(0, beams.LENGTH, 201)
    curve = scipy.interpolate.CubicSpline(places, true)(line)
    length = beams.LENGTH
    theory = -line * (length**3 - 2 * length * line**2 + line**3) / (24 * beams.MODULUS / 12)
    x, across = lines
    whole.plot(line, curve, label="plane elasticity", **plots.REFERENCE)
    whole.plot(line, theory, "k:", linewidth=1, label="Euler and Bernoulli (4.6)")
    whole.plot(x, across[-1], "o", markersize=3, color=plots.COLOURS[0], label="Trajan, cells of 1/32")
    for level, colour in zip(range(LEVELS_OF_LOAD), plots.COLOURS):
        share = (level + 1) / LEVELS_OF_LOAD
        growing.plot(line, share * curve, **plots.REFERENCE)
        growing.plot(x, across[level], "o", markersize=3, color=colour, label=f"load {share:.1f}")
    for axes in (whole, growing):
        axes.set(xlabel="x", ylabel="deflection")
        axes.legend(fontsize=8)
    section.picture("deflection", figure, "Figure 11: deflection under the load 1, and while the load grows")
