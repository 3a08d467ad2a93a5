"""Section 7: strain measures, cross-sections of vibrating beams, element size and number of points."""

import numpy as np

import beam_frequencies
from beam_elements import LEVELS, Beam
from validation import beams, plots
from validation.cases import free_vibration, static_cantilever, strain_measures

TITLE = "Strain measures, cross-sections, element size and number of points"
SOURCE = "sections 7.1 and 7.3 to 7.5, table 14, figures 34 to 38"
RESOLUTION = "cells of 2^-1 to 2^-4 in figure 38; for sections not stated; for table 14 as for tables 10 to 12"

GOAL = 1e-3
WAVE = "wave of Rayleigh and Lamb: tests/references/beam_frequencies.py"
BEAM = "simply_supported"
FIGURES = {8: (34, 35), 16: (36, 37)}
AMPLITUDE = 1e-4
SHAPES = {
    "linear": "linear",
    "gimp": "GIMP",
    "quadratic_bspline": "quadratic B-splines",
    "cubic_bspline": "cubic B-splines",
    "bernstein": "Bernstein",
}
SIZES = (1, 2, 3, 4, 5)  # cells of 2^-k


def run(section):
    section.remark("""Cross-sections at a quarter of the first mode of a beam on two hinged ends (L 8 and 16, as tables 6 to
        9 otherwise), against the exact wave: neither Bernoulli's nor Timoshenko's straight line, but near Timoshenko's.""")
    for length in (8,) if section.quick else FIGURES:
        cross_section(section, length)
    element_size(section)
    if not section.quick:
        peaks(section)
        number_of_points(section)
        strain_measures.run(section)


def near(places, x, cell):
    """Which particles are within half a cell of x."""
    return np.abs(places - x) <= cell / 2 * (1 + 1e-6)


def cross_section(section, length):
    """The axial displacement over the height for a mean deflection of 1 at mid-span."""
    cell = 1 / 16
    analysis, samples = beams.modal(4)
    result = section.run(
        f"sections_{length}", "beam", **beams.values(
            beam_frequencies.BEAMS[BEAM], cell, length=length, analysis=analysis, axial_support=beams.axially_held(),
            outputs=f"{samples} snapshots: 4\n{beams.stations(cell, length)}",
        ),
    )
    position, moved = result.snapshot("displacement", index=1)
    places = position - moved
    amplitude = moved[near(places[:, 0], length / 2, cell), 1].mean()
    at_quarter = near(places[:, 0], length / 4, cell)
    heights, found = mean_by(places[at_quarter, 1] - beams.HEIGHT / 2, moved[at_quarter, 0] / amplitude)
    wave = beam_frequencies.flexural_wave(1, length)
    cosine = np.cos(wave.k * length / 4)
    true = wave.axial(heights) * cosine
    mode_figure, section_figure = FIGURES[length]
    worst = np.abs(found - true).max() / np.abs(true).max()
    settings = "modal analysis, linear functions, cells of 1/16"
    section.row(
        f"figure {section_figure}, L {length}: largest distance from the exact section, of its largest displacement", 0.0, WAVE,
        worst, settings, result.core_seconds, goal=GOAL, scale=1.0,
    )
    rotation, straight = beam_frequencies.timoshenko_rotation(1, length), np.array([-0.5, 0.5])
    for name, slope in (("Timoshenko", rotation), ("Bernoulli", wave.k)):
        section.row(
            f"L {length}: the same of {name}'s section", 0.0, WAVE,
            np.abs(-slope * heights * cosine - true).max() / np.abs(true).max(), "theory", 0.0, scale=1.0,
        )
    figure, (shape, axes, departure) = plots.axes(3, width=4.4, height=3.6)
    _, x, across = beams.modes(result)
    line = np.linspace(0, length, 101)
    shape.plot(line, np.sin(wave.k * line), label="exact", **plots.REFERENCE)
    shape.plot(x, across[0] / across[0][beams.STATIONS // 2], "o", markersize=3, color=plots.COLOURS[0], label="Trajan")
    shape.set(xlabel="x", ylabel="deflection")
    axes.plot(wave.axial(np.linspace(-0.5, 0.5, 101)) * cosine, np.linspace(0, 1, 101), label="exact", **plots.REFERENCE)
    axes.plot(-rotation * straight * cosine, straight + 0.5, color="tab:green", linestyle="--", label="Timoshenko")
    axes.plot(-wave.k * straight * cosine, straight + 0.5, color="tab:blue", linestyle=":", label="Bernoulli")
    axes.plot(found, heights + 0.5, "o", markersize=3, color=plots.COLOURS[0], label="Trajan")
    axes.set(xlabel="axial displacement at x = L/4", ylabel="y")
    fine = np.linspace(-0.5, 0.5, 101)
    departure.plot((wave.axial(fine) + rotation * fine) * cosine, fine + 0.5, label="exact", **plots.REFERENCE)
    departure.plot(found + rotation * heights * cosine, heights + 0.5, "o", markersize=3, color=plots.COLOURS[0], label="Trajan")
    departure.plot((rotation - wave.k) * straight * cosine, straight + 0.5, color="tab:blue", linestyle=":", label="Bernoulli")
    departure.set(xlabel="the same less Timoshenko's section", ylabel="y")
    departure.locator_params(axis="x", nbins=4)
    for one in (shape, axes, departure):
        one.legend(fontsize=8)
    section.picture(
        f"section_{length}", figure, f"Figures {mode_figure} and {section_figure}: first mode and cross-section, L {length}"
    )


def mean_by(keys, values):
    """The different keys, and the means of the values that have them."""
    rounded = np.round(keys, 9)
    different = np.unique(rounded)
    return different, np.array([values[rounded == key].mean() for key in different])


def element_size(section):
    """The first frequency by cells of 2^-k for every kind of shape function, and the order at which it converges."""
    true = beam_frequencies.rayleigh_lamb(1)
    sizes = SIZES[:-1] if section.quick else SIZES
    figure, axes = plots.axes()
    lines = []
    runs = [(shapes, name, {"shapes": shapes, "particles": 3}) for shapes, name in SHAPES.items()]
    runs.append(("gauss", beams.BEST_NAME, beams.BEST))
    for (kind, name, numerics), colour in list(zip(runs, plots.COLOURS))[: 1 if section.quick else None]:
        errors = []
        for k in sizes:
            result = free_vibration.find_modes(
                section, f"size_{kind}_{k}", BEAM, beams.LENGTH, 2.0**-k, count=4, **numerics,
            )
            found = beams.modes(result)[0][0]
            errors.append(found / true - 1)
        section.row(
            f"f1, {name}", true, WAVE, found,
            f"modal analysis, cells of 2^-{k}, {numerics['particles']} × {numerics['particles']} points",
            result.core_seconds, goal=GOAL,
        )
        orders = np.log2(np.abs(np.array(errors[:-1]) / np.array(errors[1:])))
        lines.append([name, *(f"{error:.2g}" for error in errors), f"{orders[-1]:.2f}"])
        axes.loglog(2.0 ** -np.array(sizes), np.abs(errors), "o-", color=colour, markersize=10 - len(lines), label=name)
    size = np.array([2.0 ** -sizes[-1], 0.5])
    axes.loglog(size, 0.05 * size**2, "k:", linewidth=1, label="second order")
    ticks = 2.0 ** -np.array(sizes)
    axes.set(xlabel="cell size", ylabel="error of the first frequency, share", xticks=ticks, xticklabels=[f"1/{1 / t:g}" for t in ticks])
    axes.minorticks_off()
    axes.legend(fontsize=8)
    section.table(
        "Errors of the first frequency by cell size, modal analysis, and the order between the last two. Evenly spaced points, "
        "3 × 3 in a cell, limit all functions to the second order; Gauss points, 4 × 4, do not:",
        ["functions", *(f"2^-{k}" for k in sizes), "order"], lines,
    )
    section.picture("sizes", figure, "Error of the first frequency by element size")


def wave_motion(wave):
    """The exact wave as the velocity at the start."""
    y = "(y - 0.5)"
    a, b = f"{wave.a!r} * {y}", f"{wave.b!r} * {y}"
    axial = f"({wave.p * wave.k!r} * sinh({a}) + {wave.q * wave.b!r} * sinh({b}))"
    transverse = f"({wave.p * wave.a!r} * cosh({a}) + {wave.q * wave.k!r} * cosh({b}))"
    x = f"{wave.k!r} * x"
    return f'initial_velocity {{ x: "{AMPLITUDE} * {axial} * cos({x})" y: "{AMPLITUDE} * {transverse} * sin({x})" }}'


def peaks(section):
    """Figure 38: the largest deflection of the vibrating beam by element size."""
    frequency = beam_frequencies.rayleigh_lamb(1)
    wave = beam_frequencies.flexural_wave(1)
    true = AMPLITUDE / (2 * np.pi * frequency)
    figure, axes = plots.axes()
    for scheme, shapes, particles, colour in (
        ("MUSL", "linear", 2, 1), ("TLMPM", "linear", 2, 0), ("TLMPM", "quadratic_bspline", 3, 2),
    ):
        found = []
        for k in SIZES[:-1]:
            cell, goal = 2.0**-k, GOAL if (scheme, shapes, k) == ("TLMPM", "linear", SIZES[-2]) else None
            result = section.run(
                f"peak_{scheme}_{shapes}_{k}", "beam", **beams.values(
                    beam_frequencies.BEAMS[BEAM], cell, scheme=scheme, shapes=shapes, particles=particles,
                    motion=wave_motion(wave), analysis=f"end_time: {1 / frequency!r}",
                    outputs=f"samples: 400 snapshots: 1\n{beams.stations(cell)}",
                ),
            )
            found.append(np.abs(beams.deflections(result)[2][:, beams.STATIONS // 2]).max())
            section.row(
                f"figure 38: peak of the mid-span deflection over v0 / omega, cells of 2^-{k}", 1.0, WAVE, found[-1] / true,
                f"time history, {scheme}, {SHAPES[shapes]}, {particles} × {particles} points", result.core_seconds,
                goal=goal, own=goal is None,
            )
        axes.plot(SIZES[:-1], np.array(found) / true, "o-", color=plots.COLOURS[colour], markersize=8 if scheme == "MUSL" else 4,
                  label=f"{scheme}, {SHAPES[shapes]}")
    axes.axhline(1, label="exact", **plots.REFERENCE)
    axes.set(xlabel="k, cells of 2^-k", ylabel="largest deflection over v0 / omega", xticks=SIZES[:-1])
    axes.legend()
    section.picture("peaks", figure, "Figure 38: largest deflection of the vibrating beam by element size")


def number_of_points(section):
    """Deflection and frequency by the points along a side of a cell, in cells of 1/4."""
    body = Beam(("clamped", "free"), level=LEVELS[3])
    deflection = body.section_means(body.equilibrium(body.end_shear(-1)))[-1, 1]
    frequency = beam_frequencies.rayleigh_lamb(1)
    counts = (1, 2, 3, 4, 6, 8)
    figure, drawn = plots.axes(2, width=5, height=3.6)
    lines = []
    for shapes, colour in (("linear", 0), ("quadratic_bspline", 1), ("bernstein", 2)):
        bent, frequencies = [], []
        for count in counts[1:] if shapes != "linear" else counts:
            numerics = {"shapes": shapes, "particles": count}
            _, _, x, across = static_cantilever.bend(
                section, f"points_{shapes}_{count}_bent", "clamped", 1 / 4, static_cantilever.SETTLED["quasi_static"],
                **numerics,
            )
            bent.append(beams.free_end(x, across)[-1] / deflection - 1)
            result = free_vibration.find_modes(
                section, f"points_{shapes}_{count}_modes", BEAM, beams.LENGTH, 1 / 4, count=4, **numerics,
            )
            frequencies.append(beams.modes(result)[0][0] / frequency - 1)
            lines.append([SHAPES[shapes], f"{count} × {count}", f"{bent[-1]:+.2%}", f"{frequencies[-1]:+.2%}"])
        for axes, errors in zip(drawn, (bent, frequencies)):
            axes.plot(counts[-len(errors):], 100 * np.array(errors), "o-", color=plots.COLOURS[colour], markersize=4,
                      label=SHAPES[shapes])
    for axes, name in zip(drawn, ("static deflection of the cantilever", "f1 of the simply supported beam")):
        axes.set(xlabel="points along a side of a cell", ylabel="error, %", title=name)
        axes.axhline(0, **plots.REFERENCE)
        axes.legend(fontsize=8)
    section.remark("""The dissertation finds that the number of points does not matter for frequencies. It does: points are
        the quadrature of the stiffness, and with few of them bending is too soft. Its twelve frequencies are multiples of
        one Fourier bin, which hid the difference.""")
    section.table("Errors by the number of points in a cell of 1/4:", ["functions", "points", "deflection", "f1"], lines)
    section.picture("points", figure, "Section 7.1: errors by the number of points in cells of 1/4")
