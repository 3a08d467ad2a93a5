#!/usr/bin/env python3
"""Natural frequencies of beams as plane bodies: references of the dissertation's tables 6 to 9.

The beams and their ends are those of beam_elements.py. For two hinged ends the finite elements meet the exact waves
of Rayleigh and Lamb, which are computed as well, as are the frequencies of Euler and Bernoulli's theory and, for two
hinged ends, of Timoshenko's. Prints the first three of each beam in Hz.
"""

import json
import sys
from dataclasses import dataclass

import numpy as np
import scipy.optimize

from beam_elements import DENSITY, HEIGHT, LEVELS, MODULUS, RATIO, Beam

BEAMS = {
    "cantilever": ("clamped", "free"),
    "simply_supported": ("hinged", "hinged"),
    "fixed_fixed": ("clamped", "clamped"),
    "fixed_hinged": ("clamped", "hinged"),
    "mean_mean": ("mean", "mean"),
    "patch_patch": ("patch", "patch"),
    "fixed_mean": ("clamped", "mean"),
}
# Frequency equations whose roots are beta_n L of dissertation eq. 4.14; each root is within 0.4 of those beside it.
EULER_BERNOULLI = {
    ("clamped", "free"): (lambda x: np.cos(x) + 1 / np.cosh(x), (1.8, 4.7, 7.8)),
    ("hinged", "hinged"): (np.sin, (3.1, 6.3, 9.4)),
    ("clamped", "clamped"): (lambda x: np.cos(x) - 1 / np.cosh(x), (4.7, 7.8, 11.0)),
    ("clamped", "hinged"): (lambda x: np.tan(x) - np.tanh(x), (3.9, 7.1, 10.2)),
}
# The coarser level measures the finer one's error.
FINE, COARSE = LEVELS[2:], LEVELS[:2]


@dataclass
class Modes:
    """Bending modes: frequencies, Hz, shape (modes,), and the transverse displacement's mean over the cross-section at x,
    shape (modes, positions), with its largest value 1."""

    frequencies: np.ndarray
    x: np.ndarray
    shapes: np.ndarray


def theory_ends(beam):
    """The ends of beam theory, which knows one kind of hinge."""
    return tuple("hinged" if end in ("mean", "patch") else end for end in BEAMS[beam])


def wave_numbers(beam):
    """beta_n L of Euler and Bernoulli's theory, the first three."""
    equation, near = EULER_BERNOULLI[theory_ends(beam)]
    return np.array([scipy.optimize.brentq(equation, root - 0.4, root + 0.4, xtol=1e-14) for root in near])


def euler_bernoulli(beam, length=8.0):
    """Hz, the first three."""
    return (wave_numbers(beam) / length) ** 2 * np.sqrt(MODULUS * HEIGHT**2 / (12 * DENSITY)) / (2 * np.pi)


def timoshenko(mode, length=8.0, correction=5 * (1 + RATIO) / (6 + 5 * RATIO)):
    """Of a beam on two hinges, Hz: the lower root of Timoshenko's (1921) equation, with Cowper's (1966) correction."""
    k = mode * np.pi / length
    radius2 = HEIGHT**2 / 12
    bar, shear = MODULUS / DENSITY, correction * MODULUS / (2 * (1 + RATIO)) / DENSITY
    # w^4 / (bar shear) - w^2 (1 / (bar r^2) + k^2 / bar + k^2 / shear) + k^4 = 0
    linear = 1 / (bar * radius2) + k**2 / bar + k**2 / shear
    return np.sqrt((linear - np.sqrt(linear**2 - 4 * k**4 / (bar * shear))) * bar * shear / 2) / (2 * np.pi)


def rayleigh_lamb(mode, length=8.0):
    """Of a beam on two hinged ends, Hz: the lowest flexural wave of the wave number mode pi / L, which meets these ends
    exactly (Graff 1975, Wave Motion in Elastic Solids, section 8.1, with the longitudinal speed of plane stress)."""
    k, half = mode * np.pi / length, HEIGHT / 2

    def mismatch(frequency):
        a, b = decay_rates(k, frequency)
        return 4 * k**2 * a * b * np.tanh(b * half) - (k**2 + b**2) ** 2 * np.tanh(a * half)

    guess = timoshenko(mode, length)
    return scipy.optimize.brentq(mismatch, 0.97 * guess, 1.02 * guess, xtol=1e-15, rtol=1e-14)


def decay_rates(k, frequency):
    """Of the longitudinal and of the shear part of a wave over the height."""
    w2 = (2 * np.pi * frequency) ** 2
    longitudinal2 = MODULUS / (DENSITY * (1 - RATIO**2))
    shear2 = MODULUS / (2 * (1 + RATIO) * DENSITY)
    return np.sqrt(k**2 - w2 / longitudinal2), np.sqrt(k**2 - w2 / shear2)


@dataclass
class FlexuralWave:
    """The wave of Rayleigh and Lamb that is a mode of a beam on two hinged ends: axial displacement u(y) cos(k x) and
    transverse v(y) sin(k x), y from the mid-line, where the mean of v over the height is 1:
    u = p k sinh(a y) + q b sinh(b y), v = p a cosh(a y) + q k cosh(b y)."""

    k: float
    a: float
    b: float
    p: float
    q: float

    def axial(self, y):
        return self.p * self.k * np.sinh(self.a * y) + self.q * self.b * np.sinh(self.b * y)

    def transverse(self, y):
        return self.p * self.a * np.cosh(self.a * y) + self.q * self.k * np.cosh(self.b * y)


def flexural_wave(mode, length=8.0):
    """Surfaces without shear stress give the ratio of its parts."""
    k, half = mode * np.pi / length, HEIGHT / 2
    a, b = decay_rates(k, rayleigh_lamb(mode, length))
    ratio = -2 * k * a * np.cosh(a * half) / ((b**2 + k**2) * np.cosh(b * half))
    mean = (np.sinh(a * half) + ratio * k / b * np.sinh(b * half)) / half
    return FlexuralWave(k, a, b, 1 / mean, ratio / mean)


def timoshenko_rotation(mode, length=8.0, correction=5 * (1 + RATIO) / (6 + 5 * RATIO)):
    """Of cross-sections for a unit deflection, of a beam on two hinges: less than Bernoulli's k by the shear strain."""
    k = mode * np.pi / length
    shear = correction * MODULUS / (2 * (1 + RATIO))
    return k - DENSITY * (2 * np.pi * timoshenko(mode, length)) ** 2 / (shear * k)


def finite_elements(beam, length, level, modes=3):
    """The first bending modes."""
    body = Beam(BEAMS[beam], length, level)
    # Below the lowest bending mode: a beam on two hinges may move along itself at frequency 0.
    angular, shapes = body.modes(modes, 0.5 * 2 * np.pi * euler_bernoulli(beam, length)[0])
    across = np.array([body.section_means(shape)[:, 1] for shape in shapes])
    largest = across[np.arange(len(across)), np.abs(across).argmax(axis=1)]
    return Modes(angular / (2 * np.pi), body.mesh.axis_x, across / largest[:, None])


def beam_reference(beam, length=8.0, levels=FINE):
    """Modes by finite elements, and their largest relative error, the difference to the coarser level."""
    coarse, fine = (finite_elements(beam, length, level) for level in levels)
    return fine, float(np.abs(coarse.frequencies / fine.frequencies - 1).max())


def reference(fine=True):
    result = {}
    for beam in BEAMS:
        modes, error = beam_reference(beam, levels=FINE if fine else COARSE)
        result[beam] = {
            "euler_bernoulli": euler_bernoulli(beam).tolist(),
            "finite_elements": modes.frequencies.tolist(),
            "finite_element_error": error,
        }
    result["simply_supported"]["rayleigh_lamb"] = [rayleigh_lamb(mode) for mode in (1, 2, 3)]
    result["simply_supported"]["timoshenko"] = [timoshenko(mode) for mode in (1, 2, 3)]
    return result


if __name__ == "__main__":
    json.dump(reference("--coarse" not in sys.argv), sys.stdout, indent=2)
    print()
