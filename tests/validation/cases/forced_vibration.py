"""Figure 12: a cantilever whose end is driven, through its first three resonances."""

import numpy as np
import scipy.optimize

from beam_elements import LEVELS, Beam
from beam_elements import MODULUS as REFERENCE_MODULUS
from validation import beams, plots

TITLE = "Forced vibration of a cantilever"
SOURCE = "section 4.1.6, figure 12"
RESOLUTION = "not stated; the rows for it have cells of 1/2, as its static beams"

LENGTH, MODULUS, FORCE = 10.0, 1e4, 0.002
CELL = 1 / 10
SETTINGS = "time history, TLMPM, linear functions, cells of 1/10"
PLANE = "plane elasticity, finite elements: tests/references/beam_elements.py"
# Driving frequencies over each resonance, and the periods of the resonance that are run.
DRIVEN = (
    (6, (0.5, 0.75, 0.875, 1.0, 1.15, 1.4)),
    (10, (0.6, 0.85, 1.0, 1.15, 1.4)),
    (12, (0.75, 0.9, 1.0, 1.1)),
)
# The dissertation's resolution, and other functions on its cells.
OWN_CELL, OWN_SHARE, OWN_PERIODS = 1 / 2, 0.5, 6
OWN = {
    "linear functions, 2 x 2 points": {},
    "linear functions, full-mass transfer, 2 x 2 points": {"transfer": ' transfer: "FMPM" transfer_order: 4'},
    "quadratic B-splines, 4 x 4 points": {"particles": 4, "shapes": "quadratic_bspline"},
}
GOAL_FREQUENCY, GOAL_AMPLITUDE = 1e-3, 1e-2


class Reference:
    """The driven plane body by modal superposition and by its harmonic answer."""

    def __init__(self, level):
        # Lengths are the same; stiffness, and with it squared frequencies, are as the moduli.
        self._softer = MODULUS / REFERENCE_MODULUS
        self._body = Beam(("clamped", "free"), LENGTH, level)
        self._force = self._body.end_shear(FORCE)
        angular, shapes = self._body.modes(6, 0.3)
        self.angular = angular * np.sqrt(self._softer)
        ends = np.array([self._body.section_means(shape)[-1, 1] for shape in shapes])
        # Of each mode, the end's motion for a unit of what drives it.
        self.parts = ends * (shapes.reshape(len(shapes), -1) @ self._force)

    def steady(self, angular):
        """The end's amplitude of the motion with the force's frequency, signed."""
        moved = self._body.vibration(self._force, angular / np.sqrt(self._softer))
        return self._body.section_means(moved)[-1, 1] / self._softer


def drive(section, name, frequencies, end_time, samples, cell=CELL, **numerics):
    """A study over driving frequencies: for each the result, the times and the end's motion."""
    results = section.sweep(
        name, "loads[end_shear].time.sine.frequency", frequencies, "beam", **beams.values(
            ("clamped", "free"), cell, length=LENGTH, modulus=MODULUS,
            loads=beams.end_shear(FORCE, f"sine {{ frequency: {frequencies[0]!r} }}"),
            analysis=f"end_time: {end_time!r}",
            outputs=f"samples: {samples} snapshots: 1\n{beams.stations(cell, LENGTH)}", **numerics,
        ),
    )
    motions = []
    for result in results:
        time, x, across = beams.deflections(result)
        motions.append((result, time, beams.free_end(x, across, LENGTH)))
    return motions


def waves(time, angular):
    return np.concatenate([np.sin(np.outer(angular, time)), np.cos(np.outer(angular, time))]).T


def analyse(time, moved, driving, natural, mode):
    """Splits a motion from rest into that with the driving frequency and free vibrations, by least squares: its amplitude,
    and the angular frequency of a mode, found with it; the other modes' frequencies are given."""

    def split(angular):
        parts = waves(time, [driving, *natural[:mode], angular, *natural[mode + 1 :]])
        coefficients, *_ = np.linalg.lstsq(parts, moved, rcond=None)
        return coefficients, parts @ coefficients - moved

    scale = natural[mode]
    found = scipy.optimize.least_squares(lambda x: split(x[0] * scale)[1], [1.0], x_scale=1e-3, ftol=1e-14, xtol=1e-14, gtol=1e-14)
    return split(found.x[0] * scale)[0][0], found.x[0] * scale


def run(section):
    section.remark("""L 10, h 1, E 10000, nu 0.3, force 0.002 at the end as the parabola of beam theory, from rest; plane
        stress and rho 1 are our choice. Nothing damps: free vibrations stay, and at a resonance the motion grows without
        bound. The steady amplitude is that of the part with the driving frequency, by least squares; a resonance is the
        frequency of the free part. The dissertation prints a picture and no numbers, and beam theory's sum over modes
        (4.8), whose resonances lie above those of the plane body: the picture has both.""")
    reference = Reference(LEVELS[1 if section.quick else 2])
    driven = []
    for mode, (periods, shares) in enumerate(DRIVEN):
        if section.quick and mode != 2:  # the third resonance needs the shortest history
            continue
        natural = reference.angular[mode]
        samples = int(periods * reference.angular[4] / natural * 4)
        free = []
        shares = (0.9,) if section.quick else shares
        frequencies = [float(share * natural / (2 * np.pi)) for share in shares]
        motions = drive(section, f"mode_{mode + 1}", frequencies, periods * 2 * np.pi / natural, samples)
        for share, (result, time, moved) in zip(shares, motions):
            driving = share * natural
            if share == 1.0:
                growth(section, reference, mode, time, moved, result)
                continue
            amplitude, angular = analyse(time, moved, driving, reference.angular, mode)
            free.append(angular)
            driven.append((driving, amplitude))
            section.row(
                f"steady amplitude of the end at {share} f{mode + 1}", reference.steady(driving), PLANE, amplitude,
                SETTINGS, result.core_seconds, goal=GOAL_AMPLITUDE,
            )
        section.row(
            f"resonance {mode + 1}", natural / (2 * np.pi), PLANE, np.median(free) / (2 * np.pi), SETTINGS,
            result.core_seconds, goal=GOAL_FREQUENCY,
        )
    if not section.quick:
        draw(section, reference, np.array(driven))
        own_resolution(section, reference)


def growth(section, reference, mode, time, moved, result):
    """At resonance a mode moves as -part / (2 w) (t cos(w t) - sin(w t) / w)."""
    w = reference.angular[mode]
    others = np.delete(reference.angular, mode)
    parts = np.column_stack([time * np.cos(w * time), waves(time, [w, *others])])
    rate = np.linalg.lstsq(parts, moved, rcond=None)[0][0]
    section.row(
        f"growth of the end's amplitude per time at resonance {mode + 1}", -reference.parts[mode] / (2 * w), PLANE, rate,
        SETTINGS, result.core_seconds, goal=GOAL_AMPLITUDE,
    )


def own_resolution(section, reference):
    """The first resonance and the answer before it by histories, and resonances by modes, all with few cells."""
    natural = reference.angular[0]
    driving, end_time = OWN_SHARE * natural, OWN_PERIODS * 2 * np.pi / natural
    samples = int(OWN_PERIODS * reference.angular[4] / natural * 4)
    for number, (name, numerics) in enumerate(OWN.items()):
        ((result, time, moved),) = drive(
            section, f"own_{number}", [float(driving / (2 * np.pi))], end_time, samples, OWN_CELL, **numerics
        )
        amplitude, angular = analyse(time, moved, driving, reference.angular, 0)
        settings = f"time history, TLMPM, {name}, 20 × 2 cells"
        section.row(
            f"steady amplitude of the end at {OWN_SHARE} f1", reference.steady(driving), PLANE, amplitude, settings,
            result.core_seconds, own=True,
        )
        section.row(
            "resonance 1", natural / (2 * np.pi), PLANE, angular / (2 * np.pi), settings, result.core_seconds, own=True,
        )
    analysis, samples = beams.modal(6)
    result = section.run(
        "own_modes", "beam", **beams.values(
            ("clamped", "free"), OWN_CELL, length=LENGTH, modulus=MODULUS, analysis=analysis,
            outputs=f"{samples} snapshots: 1\n{beams.stations(OWN_CELL, LENGTH)}", **beams.BEST,
        ),
    )
    for mode, frequency in enumerate(beams.modes(result)[0][:3]):
        section.row(
            f"resonance {mode + 1}", reference.angular[mode] / (2 * np.pi), PLANE, frequency,
            f"modal analysis, {beams.BEST_NAME}, 20 × 2 cells", result.core_seconds, own=True,
        )


def theory(angular):
    """The end's amplitude by Euler and Bernoulli's theory: equation 4.8 with its sum over modes in closed form."""
    bending = MODULUS / 12
    k = LENGTH * (angular**2 / bending) ** 0.25
    share = np.sin(k) * np.cosh(k) - np.cos(k) * np.sinh(k)
    return FORCE * LENGTH**3 / bending * share / (k**3 * (1 + np.cos(k) * np.cosh(k)))


def draw(section, reference, driven):
    figure, axes = plots.axes(width=9)
    line = np.linspace(0.3 * reference.angular[0], 1.2 * reference.angular[2], 400)
    coarse = Reference(LEVELS[0])  # as near as a picture shows
    axes.semilogy(line / (2 * np.pi), [abs(coarse.steady(w)) for w in line], label="plane elasticity", **plots.REFERENCE)
    axes.semilogy(line / (2 * np.pi), np.abs(theory(line)), "k:", linewidth=1, label="Euler and Bernoulli (4.8)")
    axes.semilogy(driven[:, 0] / (2 * np.pi), np.abs(driven[:, 1]), "o", color=plots.COLOURS[0], label="Trajan")
    axes.set(xlabel="driving frequency", ylabel="steady amplitude of the end", ylim=(1e-6, 1e-1))
    axes.legend()
    section.picture("response", figure, "Figure 12: steady amplitude of the driven end over the driving frequency")
