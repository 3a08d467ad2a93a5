"""Figure 23: large deflection of a cantilever under a uniform load."""

import pathlib

import large_deflection as reference
import numpy as np

from validation import plots

TITLE = "Large deflection of a cantilever"
SOURCE = "section 4.2.5, figure 23"
RESOLUTION = "not stated; see the coarsest rows"
GOAL = 1e-3
STORED = pathlib.Path(reference.__file__).with_suffix(".csv")
COLUMNS = (
    "load", "elastica", "elastica_shortening", "reissner", "reissner_shortening", "plane", "plane_shortening", "place",
    "place_shortening",
)
# Functions, cells, points along a cell's side, and whether the goals are for them. Sums over n layers of points make the
# bending stiffness 1 / n^2 too small, which wide functions feel before their own error.
SETTINGS = (
    ("linear", 0.25, 2, False),
    ("linear", 0.125, 2, False),
    ("linear", 0.0625, 2, True),
    ("quadratic_bspline", 0.25, 4, False),
    ("quadratic_bspline", 0.125, 4, False),
)


def run(section):
    true = dict(zip(COLUMNS, np.loadtxt(STORED, delimiter=",", skiprows=1).T))
    missed = {name: abs(1 - true[name][-1] / true["plane"][-1]) for name in ("elastica", "reissner")}
    section.remark(f"""The figure has the load parameter q L^3 / (E I) from 0 to 10 on its axis and shows no
        numbers; the text states neither length nor height. The beam here is that of Bathe, Ramm and Wilson
        (1975), which such figures show: L 10, h 1, E 12000, nu 0.2, a load that keeps its direction, in plane
        stress. The true reference is the plane body of Saint Venant-Kirchhoff's law with its whole edge
        clamped, by finite elements (tests/references/large_deflection.py, exact to 3e-5 of L). Beside it: the
        elastica, which neither stretches nor shears, and Reissner's beam, which does. Of a beam as thick as
        this one both miss a part: {missed["elastica"]:.1%} and {missed["reissner"]:.1%} of the deflection at
        the largest load. "More deflection than finite elements", as the dissertation says of its result, is no
        property of the particles: the body of its law deflects more than beams do.""")
    figure, drawn = plots.axes(1)
    drawn.plot(true["load"], true["plane"], **plots.REFERENCE, label="plane finite elements")
    drawn.plot(true["load"], true["reissner"], color="gray", label="Reissner's beam")
    drawn.plot(true["load"], true["elastica"], color="gray", linestyle=":", label="elastica")
    for number, (shapes, cell, particles, goal) in enumerate(SETTINGS):
        place = reference.LENGTH - cell / particles / 2
        result = section.run(
            f"{shapes}_{cell:g}_{particles}", "large_deflection", cell=cell, particles=particles, shapes=shapes,
            last=place - 0.1 * cell,
        )
        _, displacement = result.history("end", "displacement")
        found = -displacement[:, ::-1] / reference.LENGTH + at_the_end(true, place)
        name = {"linear": "linear", "quadratic_bspline": "B-spline"}[shapes]
        drawn.plot(
            true["load"], found[:, 0], "s+ox."[number], color=plots.COLOURS[number], label=f"Trajan, {name}, cells {cell:g}",
        )
        settings = f"quasi-static, TLMPM, {name} functions, cells of {cell:g}, {particles} x {particles} points"
        rows(section, true, found, result, settings, GOAL if goal else None)
    drawn.set(xlabel="load parameter $q L^3 / (E I)$", ylabel="deflection of the end / L")
    drawn.legend(fontsize=8)
    section.picture("deflection", figure, "Figure 23: deflection of the end over the load")


def at_the_end(true, place):
    """What the end deflects and shortens more than the section of the last points, over L: (loads, 2)."""
    share = (reference.LENGTH - place) / (reference.LENGTH - reference.PLACE)
    return share * np.column_stack(
        [true["plane"] - true["place"], true["plane_shortening"] - true["place_shortening"]]
    )


def rows(section, true, found, result, settings, goal):
    for load in (2, 4, 6, 8, 10) if goal else (10,):
        i = int(np.flatnonzero(true["load"] == load)[0])
        for name, column, value in (("deflection", "plane", found[i, 0]), ("shortening", "plane_shortening", found[i, 1])):
            section.row(
                f"load {load}: {name} of the end / L", true[column][i], "plane finite elements (large_deflection.py)", value,
                settings, result.core_seconds, goal=goal,
            )
