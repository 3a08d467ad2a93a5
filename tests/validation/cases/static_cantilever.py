"""Table 4 and figure 9: a cantilever under an end load, at rest and when the load grows as fast as the dissertation's."""

import numpy as np
import scipy.interpolate

import cantilever
from beam_elements import LEVELS, Beam
from validation import beams, plots

TITLE = "Static cantilever"
SOURCE = "section 4.1.4, table 4, figure 9"
RESOLUTION = "32 cells, 16 and 32 points; 16 cannot fill so many cells and are not shown"

PRINTED_REFERENCE = -0.683
PRINTED = {16: -0.787, 32: -0.681}
GOAL = 1e-3
SMALL = 1e-4  # share of the load 1 that leaves the deflection linear to 1e-6
RAMP = 4.44
PLANE = "plane elasticity, finite elements: tests/references/beam_elements.py"
CLAMPS = {
    "clamped": "both displacements of the whole edge held",
    "axial": "axial displacement of the edge held, transverse in the mean",
}
SETTLED = {
    "quasi_static": "end_time: 1 quasi_static { load_steps: 1 }",
    "relaxation": "end_time: 1 relaxation { tolerance: 1e-6 }",
}


def bend(section, name, clamp, cell, analysis, load=SMALL, time="ramp { duration: 1 }", samples=1, **numerics):
    """The result, and times, stations and deflections under the load 1."""
    result = section.run(
        name, "beam", **beams.values(
            (clamp, "free"), cell, loads=beams.end_shear(-load, time), analysis=analysis,
            outputs=f"samples: {samples} snapshots: 1\n{beams.stations(cell)}", **numerics,
        ),
    )
    moments, x, across = beams.deflections(result)
    return result, moments, x, across / load


def run(section):
    section.remark("""L 8, h 1, E 3000, P 1, and nu 0.3 in plane stress, our choice. The dissertation's -0.683 is
        P L^3 / 3 E I = 0.6827 of beam theory without shear. Its two clamps are the whole edge held, and the axial
        displacement held with the transverse one of the edge's centre; a point cannot carry a plane body's reaction
        (the deflection grows without bound, as the logarithm of what is held), so that here the edge's mean is held.
        Linear answers are at a load of 1e-4, scaled; at the full load the beam bends a little less than linearly.""")
    for clamp, words in CLAMPS.items():
        body = Beam((clamp, "free"), level=LEVELS[1 if section.quick else 3])
        across = body.section_means(body.equilibrium(body.end_shear(-1)))[:, 1]
        lines = linear(section, clamp, words, across[-1])
        if clamp == "clamped":
            draw_deflection(section, body, across, lines)
    if not section.quick:
        full_load(section)
        dissertation_ramp(section)


def linear(section, clamp, words, true):
    """Small loads at rest, at the dissertation's resolution and finer: by name stations and deflections there."""
    runs = [
        ("coarse_1", 1 / 2, "quasi_static", {"particles": 1}, "linear functions, 16 × 2 cells, 32 points", 32, None),
        ("coarse_2", 1 / 2, "quasi_static", {"particles": 2}, "linear functions, 16 × 2 cells, 128 points", 32, None),
        ("coarse_4", 1 / 2, "quasi_static", beams.BEST, f"{beams.BEST_NAME}, 16 × 2 cells, 512 points", 32, None),
        ("medium", 1 / 16, "quasi_static", {"particles": 3, "shapes": "quadratic_bspline"},
         "quadratic B-splines, cells of 1/16, 9 points each", 32, GOAL),
        ("fine", 1 / 32, "quasi_static", {}, "linear functions, cells of 1/32", 32, GOAL),
        ("relaxed", 1 / 16, "relaxation", {}, "linear functions, cells of 1/16", 32, GOAL),
    ]
    if clamp == "axial":  # one point in each cell leaves cells motions without strain, which only a clamp stops
        runs = runs[1:]
    if section.quick:
        runs = runs[:-1]
    lines = {}
    for name, cell, kind, numerics, settings, points, goal in runs:
        result, _, x, across = bend(section, f"{clamp}_{name}", clamp, cell, SETTLED[kind], **numerics)
        lines[name] = x, across[-1]
        section.row(
            f"end deflection, {words}", true, PLANE, beams.free_end(x, across)[-1], f"{kind}, {settings}",
            result.core_seconds, PRINTED[points], PRINTED_REFERENCE, goal, own=cell == 1 / 2,
        )
    return lines


def full_load(section):
    true = cantilever.solve(14, 10, 4, law=cantilever.saint_venant_kirchhoff(*cantilever.constants()))[0]
    result, _, x, across = bend(
        section, "full_load", "clamped", 1 / 32, "end_time: 1 quasi_static { load_steps: 4 }", load=1.0,
    )
    section.row(
        "end deflection, whole edge held, full load", true,
        "plane elasticity at finite displacements, finite elements: tests/references/cantilever.py",
        beams.free_end(x, across)[-1], "quasi-static, linear functions, cells of 1/32", result.core_seconds, PRINTED[32],
        PRINTED_REFERENCE, GOAL,
    )


def ramped(body, time):
    """The end's deflection under a load that grows to -1 within RAMP: modal superposition."""
    force = body.end_shear(-1)
    angular, shapes = body.modes(6, 0.4)
    parts = np.array([body.section_means(shape)[-1, 1] for shape in shapes]) * (shapes.reshape(len(shapes), -1) @ force)
    late = np.maximum(time - RAMP, 0)
    moved = body.section_means(body.equilibrium(force))[-1, 1] * np.minimum(time / RAMP, 1)
    for w, part in zip(angular, parts):
        moved = moved - part / w**2 * (np.sin(w * time) - np.sin(w * late)) / (w * RAMP)
    return moved


def dissertation_ramp(section):
    body = Beam(("clamped", "free"), level=LEVELS[1])
    above = ramped(body, np.array([RAMP]))[0] / body.section_means(body.equilibrium(body.end_shear(-1)))[-1, 1] - 1
    section.remark(f"""The dissertation's load grows to its full value within 4.44 time units, and its answer is read at
        that moment. The beam's first period is 7.3: this is no static load, and the exact deflection then is
        {100 * above:.0f} % above that at rest.""")
    result, time, x, across = bend(
        section, "ramp", "clamped", 1 / 12, "end_time: 22.2", time=f"ramp {{ duration: {RAMP} }}", samples=300,
    )
    found, true = beams.free_end(x, across), ramped(body, time)
    at_end = np.argmin(np.abs(time - RAMP))
    settings = "time history, TLMPM, linear functions, cells of 1/12"
    source = "plane elasticity, modal superposition: tests/references/beam_elements.py"
    section.row("end deflection at the end of the ramp, t 4.44", true[at_end], source, found[at_end], settings,
                result.core_seconds, PRINTED[32], PRINTED_REFERENCE, 0.01)
    section.row("largest distance from the exact motion in 5 ramps, of the peak", 0.0, source,
                np.abs(found - true).max() / np.abs(true).max(), settings, result.core_seconds, goal=0.01, scale=1.0)
    figure, axes = plots.axes()
    axes.plot(time, true, label="plane elasticity", **plots.REFERENCE)
    axes.plot(time[::6], found[::6], "o", markersize=3, color=plots.COLOURS[0], label="Trajan")
    axes.axhline(body.section_means(body.equilibrium(body.end_shear(-1)))[-1, 1], color="grey", linestyle=":", label="at rest")
    axes.axvline(RAMP, color="grey", linewidth=0.8)
    axes.set(xlabel="t", ylabel="deflection of the end")
    axes.legend()
    section.picture("ramp", figure, "The dissertation's ramp of 4.44 (vertical line) overshoots the deflection at rest")


def draw_deflection(section, body, true, lines):
    figure, axes = plots.axes()
    x = body.mesh.axis_x
    line = np.linspace(0, beams.LENGTH, 201)
    axes.plot(line, scipy.interpolate.CubicSpline(x, true)(line), label="plane elasticity", **plots.REFERENCE)
    theory = -(line**2) * (3 * beams.LENGTH - line) / (6 * beams.MODULUS / 12)
    axes.plot(line, theory, "k:", linewidth=1, label="Euler and Bernoulli")
    for name, words, colour in (("coarse_1", "32 points", 1), ("fine", "cells of 1/32", 0)):
        axes.plot(*lines[name], "o", markersize=3, color=plots.COLOURS[colour], label=f"Trajan, {words}")
    axes.set(xlabel="x", ylabel="deflection")
    axes.legend()
    section.picture("deflection", figure, "Figure 9: deflection of the cantilever under P 1")
