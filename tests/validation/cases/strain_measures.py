"""Table 14: the frequency of a beam on immovable hinges by the measure of strain."""

import json

import numpy as np

import nonlinear_vibration
from validation import plots
from validation.cases import nonlinear_free_vibration

KIND, LENGTH = "simply_supported", 8.0
# Printed frequencies by a/r: Green and Lagrange's strain, linear strain.
PRINTED = {
    0.1: (0.38845, 0.38938),
    0.2: (0.38985, 0.38985),
    0.4: (0.39698, 0.39698),
    0.6: (0.40521, 0.40521),
    0.8: (0.41733, 0.41733),
    1.0: (0.43210, 0.43210),
    1.5: (0.48344, 0.48344),
}
GOAL = 1e-3
# Law, what its strain is, the key of its reference, and which of the printed columns it is compared with.
MEASURES = (
    ("st_venant_kirchhoff", "Green and Lagrange's strain", f"{KIND} {LENGTH:g}", 0),
    ("linear_elastic", "linear strain increments (rate form)", f"{KIND} {LENGTH:g} logarithmic", 1),
    ("linear_strain_elastic", "linear strain of the whole motion", None, None),
)
SOURCE = "nonlinear plane finite elements: tests/references/nonlinear_vibration.py"
SETTINGS = "time history, TLMPM, linear functions, cells of 1/8"
# Functions and points along a cell's side at the dissertation's cells.
OWN_CELL, OWN = 1 / 2, (("linear", 2), ("quadratic_bspline", 4))
OWN_AMPLITUDES = (0.4, 1.0)


def run(section):
    stored = json.loads(nonlinear_free_vibration.STORED.read_text(encoding="utf-8"))
    green, logarithmic = (nonlinear_free_vibration.true_ratio(stored[key])(1.0) for _, _, key, _ in MEASURES[:2])
    lower = 1 - np.sqrt(logarithmic / green)
    section.remark(f"""Table 14, strain measures. Linear strain increments, summed up step by step, follow the rotations and
        stiffen the beam as Green and Lagrange's strain does, to the first order; what they sum up to is the logarithmic
        strain, whose law is another one at finite strain: at a/r 1 the reference's frequency is {lower:.1%} lower. That
        the dissertation's two columns agree in all digits says that both are sums of increments, whose squares vanish
        with the time step. The linear strain of the whole motion does not stiffen the beam at all. Frequencies are at
        the printed amplitude, to which the reference's curve moves those at the amplitude reached.""")
    figure, axes = plots.axes()
    line = np.linspace(0, 1.5, 61)
    for number, ((law, name, key, column), colour) in enumerate(zip(MEASURES, plots.COLOURS)):
        rows = stored[key or MEASURES[0][2]]
        # What does not stiffen keeps the linear frequency.
        curve = nonlinear_free_vibration.true_ratio(rows) if key else lambda a: 1.0
        found = frequencies(section, rows, law, name, column, curve)
        exact = [rows["linear_frequency"] * np.sqrt(curve(a)) for a in line]
        axes.plot(line, exact, label=None if number else "plane finite elements", **plots.REFERENCE)
        axes.plot(list(PRINTED), found, "o", color=colour, markersize=5, label=f"Trajan, {name}")
    axes.plot(list(PRINTED), [printed[0] for printed in PRINTED.values()], "kx", label="dissertation, Green-Lagrange")
    axes.set(xlabel="a/r", ylabel="frequency")
    axes.legend(fontsize=8)
    section.picture("strain_measures", figure, "Table 14: frequency by amplitude and strain measure")

    own_resolution(section, stored[MEASURES[0][2]])


def own_resolution(section, stored):
    section.remark("""At the dissertation's cells wide functions are no gain for a frequency by explicit steps, whose lumped
        mass slows them; the ratios of tables 10 to 12, where that cancels, gain by them.""")
    law, name, *_ = MEASURES[0]
    curve = nonlinear_free_vibration.true_ratio(stored)
    for shapes, particles in OWN:
        settings = nonlinear_free_vibration.SETTINGS | {"shapes": shapes, "particles": particles, "law": law}
        beam = nonlinear_free_vibration.Beam(section, stored, KIND, LENGTH, cell=OWN_CELL, **settings)
        for amplitude, row in zip(PRINTED, stored["rows"]):
            if amplitude not in OWN_AMPLITUDES:
                continue
            frequency, reached, (result, *_) = beam.at(f"{amplitude:g}", row["velocity"])
            true = stored["linear_frequency"] * np.sqrt(curve(amplitude))
            section.row(
                f"table 14, a/r {amplitude}: frequency by {name}", true, SOURCE,
                frequency + true - stored["linear_frequency"] * np.sqrt(curve(reached)),
                f"time history, TLMPM, {shapes.replace('_', ' ')} functions, 16 × 2 cells, {particles} x {particles} points",
                result.core_seconds, PRINTED[amplitude][0], own=True,
            )


def frequencies(section, stored, law, name, column, curve):
    """Adds a row for each amplitude; the frequencies there."""
    linear = stored["linear_frequency"]
    settings = nonlinear_free_vibration.SETTINGS | {"law": law}
    beam = nonlinear_free_vibration.Beam(section, stored, KIND, LENGTH, cell=1 / 8, **settings)
    found = []
    for amplitude, row in zip(PRINTED, stored["rows"]):
        frequency, reached, (result, *_) = beam.at(f"{amplitude:g}", row["velocity"])
        true = linear * np.sqrt(curve(amplitude))
        found.append(frequency + true - linear * np.sqrt(curve(reached)))
        section.row(
            f"table 14, a/r {amplitude}: frequency by {name}", true, SOURCE, found[-1], f"{SETTINGS}, {law}",
            result.core_seconds, None if column is None else PRINTED[amplitude][column], goal=GOAL,
        )
    return found
