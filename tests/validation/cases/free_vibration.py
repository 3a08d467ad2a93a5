"""Tables 6 to 9 and figures 13 to 17: natural frequencies and mode shapes of beams on four pairs of ends."""

import numpy as np
import scipy.interpolate

import beam_frequencies
from beam_elements import LEVELS, Beam
from validation import beams, plots

TITLE = "Free vibration of beams"
SOURCE = "sections 4.1.7 to 4.1.10, tables 6 to 9, figures 13 to 17"
RESOLUTION = "not stated but for the points in pictures; the rows for it have the cells and points of its static beams"

# Printed: Euler and Bernoulli's frequencies and those of the dissertation's MPM.
PRINTED = {
    "cantilever": ((0.138, 0.866, 2.426), (0.146, 0.879, 2.441)),
    "simply_supported": ((0.388, 1.552, 3.498), (0.391, 1.563, 3.516)),
    "fixed_fixed": ((0.880, 2.425, 4.754), (0.879, 2.441, 4.736)),
    "fixed_hinged": ((0.606, 1.965, 4.099), (0.586, 1.953, 4.102)),
}
FIGURES = {"cantilever": 13, "simply_supported": 14, "fixed_fixed": 15, "fixed_hinged": 17}
TABLES = {"cantilever": 6, "simply_supported": 7, "fixed_fixed": 8, "fixed_hinged": 9}
MODES = (1, 2, 3)
GOAL = 1e-3
PLANE = "plane elasticity, finite elements: tests/references/beam_frequencies.py"
LENGTHS = (8, 16, 32, 64)
SLENDER_LEVEL = (24, 8, 5)
# Clamped corners, where the stress is singular, want finer cells.
CELLS = {"cantilever": 1 / 12, "simply_supported": 1 / 16, "fixed_fixed": 1 / 16, "fixed_hinged": 1 / 16}
AMPLITUDE = 1e-4  # of the deflection: the motion is linear
PERIODS = 6  # of the first mode; the spectrum's estimate needs four


def theory_shapes(beam, x, length=beams.LENGTH):
    """Euler and Bernoulli's modes (dissertation eq. 4.13, 4.16 and 4.18), each with its largest value 1."""
    shapes = []
    for k in beam_frequencies.wave_numbers(beam) / length:
        if beam_frequencies.theory_ends(beam) == ("hinged", "hinged"):
            shape = np.sin(k * x)
        else:
            shape = np.cos(k * x) - np.cosh(k * x) - ratio(beam, k * length) * (np.sin(k * x) - np.sinh(k * x))
        shapes.append(shape / shape[np.abs(shape).argmax()])
    return np.array(shapes)


def ratio(beam, k):
    """What makes the shape meet the conditions at the right end; the left one is clamped."""
    if beam == "cantilever":
        return (np.cos(k) + np.cosh(k)) / (np.sin(k) + np.sinh(k))
    return (np.cos(k) - np.cosh(k)) / (np.sin(k) - np.sinh(k))


def start(beam, modes=3, length=beams.LENGTH):
    """The dissertation's start, a velocity across the beam, in its first modes at once."""
    terms = []
    frequencies = beam_frequencies.euler_bernoulli(beam, length)
    for k, frequency in zip(beam_frequencies.wave_numbers(beam)[:modes] / length, frequencies):
        shape = f"sin({k!r}*x)"
        if beam_frequencies.theory_ends(beam) != ("hinged", "hinged"):
            shape = f"(cos({k!r}*x)-cosh({k!r}*x)-({ratio(beam, k * length)!r})*({shape}-sinh({k!r}*x)))"
        terms.append(f"{AMPLITUDE * 2 * np.pi * frequency!r}*{shape}")
    return f'initial_velocity {{ y: "{" + ".join(terms)}" }}'


def ranges(frequencies):
    """Between neighbouring frequencies."""
    between = (frequencies[:-1] + frequencies[1:]) / 2
    return zip([frequencies[0] / 2, *between], [*between, frequencies[-1] * 1.25])


def frequency_measures(column, expected):
    kinds = [f"dominant_frequency {{ lowest: {low!r} highest: {high!r} }}" for low, high in ranges(expected)]
    return "\n".join(
        f'measures {{ name: "f{mode}" quantity: "{column}" {kind} }}' for mode, kind in zip(MODES, kinds)
    )


def watched(reference):
    """The station where all modes move most."""
    places = np.linspace(0, beams.LENGTH, beams.STATIONS)
    return np.abs(exact_shapes(reference)(places)).min(axis=0).argmax()


def exact_shapes(reference):
    return scipy.interpolate.CubicSpline(reference.x, reference.shapes, axis=1)


def vibrate(section, name, beam, reference, cell, **numerics):
    """Result of a time history that three modes are measured in."""
    expected = reference.frequencies
    samples = int(PERIODS / expected[0] * expected[-1] * 12)
    return section.run(
        name, "beam", **beams.values(
            beam_frequencies.BEAMS[beam], cell, motion=start(beam),
            analysis=f"end_time: {PERIODS / expected[0]!r}",
            outputs=f"samples: {samples} snapshots: 1\n{beams.stations(cell)}",
            measures=frequency_measures(f"station_{watched(reference)}.displacement.y", expected), **numerics,
        ),
    )


def moved_shapes(result, frequencies):
    """Stations, and the mode shapes there: the histories' Fourier coefficients at the frequencies, (modes, stations)."""
    time, x, moved = beams.deflections(result)
    waves = np.sin(2 * np.pi * np.outer(frequencies, time)) * np.hanning(len(time))
    shapes = waves @ moved
    return np.array(x), np.array([shape / shape[np.abs(shape).argmax()] for shape in shapes])


def assurance(a, b):
    """Modal assurance criterion of two shapes, 1 if they are the same (Allemang 2003)."""
    return (a @ b) ** 2 / ((a @ a) * (b @ b))


def run(section):
    section.remark("""The tables belong to L 8, h 1, E 3000, rho 1 (the text says L 10 and E 10000): so their reference
        columns are met. nu 0.3 and plane stress are our choice. The dissertation's frequencies are multiples of
        25/512 Hz, the Fourier bin of its run, and agree with Euler and Bernoulli's theory, which at L/h = 8 lies above
        what a plane body has (how far is said below); the true reference is the plane body's, by finite elements.
        Clamped is an edge whose displacements are held, hinged one that is held across the beam over its whole height.""")
    levels = beam_frequencies.COARSE if section.quick else beam_frequencies.FINE
    errors, above = [], 0.0
    for beam in ("fixed_fixed", "mean_mean") if section.quick else beam_frequencies.BEAMS:
        reference, error = beam_frequencies.beam_reference(beam, levels=levels)
        errors.append(f"{beam} {error:.1g}")
        above = max(above, *(beam_frequencies.euler_bernoulli(beam) / reference.frequencies - 1))
        modal_analysis(section, beam, reference)
        if beam in PRINTED:
            time_history(section, beam, reference)
    section.remark(
        f"Largest differences to the references at the next coarser discretisation: {', '.join(errors)}. "
        f"Euler and Bernoulli's theory lies up to {above:.1%} above the references."
    )
    if not section.quick:
        at_times(section)
        slenderness(section)


def modal_analysis(section, beam, reference):
    """Frequencies and shapes without a history; hinges of other kinds are compared with the dissertation's tables too."""
    table = {"mean_mean": "simply_supported", "patch_patch": "simply_supported", "fixed_mean": "fixed_hinged"}.get(beam, beam)
    theory, printed = PRINTED[table]
    for name, cell, numerics, settings, goal in (
        ("coarse", 1 / 2, {}, "linear functions, 16 × 2 cells, 32 × 4 points", None),
        ("coarse_quadratic", 1 / 2, beams.BEST, f"{beams.BEST_NAME}, 16 × 2 cells, 64 × 8 points", None),
        # The stress is singular at the ends of a patch.
        ("fine", 1 / (64 if "patch" in beam else 32), {}, f"linear functions, cells of 1/{64 if 'patch' in beam else 32}", GOAL),
    ):
        result = find_modes(section, f"{beam}_modal_{name}", beam, beams.LENGTH, cell, **numerics)
        frequencies, x, shapes = beams.modes(result)
        for mode in MODES:
            section.row(
                f"table {TABLES[table]}, {beam}, f{mode}", reference.frequencies[mode - 1], PLANE, frequencies[mode - 1],
                f"modal analysis, {settings}", result.core_seconds, printed[mode - 1], theory[mode - 1], goal,
                own=goal is None,
            )
            if goal:
                section.row(
                    f"{beam}, mode {mode}: modal assurance", 1.0, "the reference's own shape",
                    assurance(shapes[mode - 1], exact_shapes(reference)(x)[mode - 1]), "modal analysis",
                    result.core_seconds, goal=GOAL,
                )


def find_modes(section, name, beam, length, cell, count=8, **numerics):
    analysis, samples = beams.modal(count)
    return section.run(
        name, "beam", **beams.values(
            beam_frequencies.BEAMS[beam], cell, length=length, analysis=analysis,
            outputs=f"{samples} snapshots: 1\n{beams.stations(cell, length)}", **numerics,
        ),
    )


def slenderness(section):
    """First frequencies approach Euler and Bernoulli's as beams get longer."""
    figure, axes = plots.axes()
    for beam, colour in zip(PRINTED, plots.COLOURS):
        ratios, exact = [], []
        for length in LENGTHS:
            theory = beam_frequencies.euler_bernoulli(beam, length)[0]
            true = beam_frequencies.finite_elements(beam, length, SLENDER_LEVEL).frequencies[0]
            result = find_modes(section, f"{beam}_{length}", beam, length, 1 / 16, count=4)
            found = beams.modes(result)[0][0]
            section.row(
                f"{beam}, L/h {length}: f1 over Euler and Bernoulli's", true / theory, PLANE, found / theory,
                "modal analysis, linear functions, cells of 1/16", result.core_seconds, goal=GOAL,
            )
            ratios.append(found / theory)
            exact.append(true / theory)
        axes.plot(LENGTHS, exact, **plots.REFERENCE)
        axes.plot(LENGTHS, ratios, "o", color=colour, label=beam.replace("_", " "))
    axes.set(xlabel="L / h", ylabel="f1 over Euler and Bernoulli's", xscale="log", xticks=LENGTHS, xticklabels=LENGTHS)
    axes.minorticks_off()
    axes.legend()
    section.picture("slenderness", figure, "First frequencies approach beam theory as L/h grows; lines: plane elasticity")


def time_history(section, beam, reference):
    runs = [
        ("dissertation_1", 0.5, {"scheme": "MUSL", "particles": 1},
         "MUSL, linear functions, 16 × 2 cells and points as in the dissertation", None),
        ("dissertation_2", 0.5, {"scheme": "MUSL", "particles": 2},
         "MUSL, linear functions, 16 × 2 cells, 32 × 4 points", None),
        ("fine", CELLS[beam], {"scheme": "TLMPM"},
         f"time history, TLMPM, linear functions, cells of 1/{1 / CELLS[beam]:.0f}", GOAL),
    ]
    theory, printed = PRINTED[beam]
    for name, cell, numerics, settings, goal in runs:
        result = vibrate(section, f"{beam}_{name}", beam, reference, cell, **numerics)
        for mode in MODES:
            section.row(
                f"table {TABLES[beam]}, {beam}, f{mode}", reference.frequencies[mode - 1],
                PLANE, result.measures[f"f{mode}"],
                settings, result.core_seconds, printed[mode - 1], theory[mode - 1], goal, own=goal is None,
            )
    show_shapes(section, beam, reference, result)


def at_times(section, beam="fixed_fixed"):
    """Figure 16: the beam at several times of half a period, from the start in its first mode of beam theory."""
    body = Beam(beam_frequencies.BEAMS[beam], level=LEVELS[2])
    k = beam_frequencies.wave_numbers(beam)[0] / beams.LENGTH
    frequency = beam_frequencies.euler_bernoulli(beam)[0]
    x = body.mesh.points[:, 0]
    across = np.cos(k * x) - np.cosh(k * x) - ratio(beam, k * beams.LENGTH) * (np.sin(k * x) - np.sinh(k * x))
    velocity = np.column_stack([0 * x, AMPLITUDE * 2 * np.pi * frequency * across])
    cell, samples = CELLS[beam], 40
    result = section.run(
        f"{beam}_times", "beam", **beams.values(
            beam_frequencies.BEAMS[beam], cell, motion=start(beam, 1), analysis=f"end_time: {1 / frequency!r}",
            outputs=f"samples: {samples} snapshots: 1\n{beams.stations(cell)}",
        ),
    )
    time, places, found = beams.deflections(result)
    exact = body.free_motion(velocity, time, 10, np.pi * frequency)[..., 1]
    exact = scipy.interpolate.CubicSpline(body.mesh.axis_x, exact, axis=1)
    section.row(
        "figure 16, fixed_fixed: largest distance from the exact motion in a period, of the peak", 0.0,
        "plane elasticity, modal superposition: tests/references/beam_elements.py",
        np.abs(found - exact(places)).max() / np.abs(found).max(), "time history, TLMPM, linear functions, cells of 1/16",
        result.core_seconds, goal=0.01, scale=1.0,
    )
    figure, axes = plots.axes()
    line = np.linspace(0, beams.LENGTH, 201)
    for row, colour in zip((2, 5, 10, 25, 30), plots.COLOURS):
        axes.plot(line, exact(line)[row], **plots.REFERENCE)
        axes.plot(places, found[row], "o", markersize=3, color=colour, label=f"t {time[row]:.2f}")
    axes.set(xlabel="x", ylabel="deflection")
    axes.legend(fontsize=8)
    section.picture("times", figure, "Figure 16: first mode of the fixed-fixed beam at several times")


def show_shapes(section, beam, reference, result):
    found = np.array([result.measures[f"f{mode}"] for mode in MODES])
    x, shapes = moved_shapes(result, found)
    exact = exact_shapes(reference)
    line = np.linspace(0, beams.LENGTH, 201)
    theory = theory_shapes(beam, line)
    figure, drawn = plots.axes(3, width=3.6, height=2.8)
    for mode, axes in zip(MODES, drawn):
        shape, true, classical = shapes[mode - 1], exact(x)[mode - 1], theory[mode - 1]
        shape = shape * np.sign(shape @ true)
        classical = classical * np.sign(classical @ exact(line)[mode - 1])
        axes.plot(line, exact(line)[mode - 1], label="plane elasticity", **plots.REFERENCE)
        axes.plot(line, classical, "k:", linewidth=1, label="Euler and Bernoulli")
        axes.plot(x, shape, "o", color=plots.COLOURS[0], markersize=3, label="Trajan")
        axes.set(title=f"mode {mode}, {found[mode - 1]:.4f} Hz", xlabel="x")
        section.row(
            f"figure {FIGURES[beam]}, {beam}, mode {mode}: modal assurance", 1.0, "the reference's own shape",
            assurance(shape, true), "time history, TLMPM", result.core_seconds, goal=GOAL,
        )
    drawn[0].legend(fontsize=7)
    section.picture(
        f"{beam}_modes", figure, f"Figure {FIGURES[beam]}: first three modes of the {beam.replace('_', ' ')} beam",
    )
