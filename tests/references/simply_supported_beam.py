#!/usr/bin/env python3
"""Reference of the scenes `ss_beam` and `beam_modes`: natural frequencies in bending by 2D elasticity.

A beam 8 long, 1 high, E 3000, rho 1, nu 0.3, plane stress; both end edges held in the transverse
direction and free along the beam. The flexural wave of Rayleigh and Lamb with wave number n pi / length
meets these end conditions exactly (transverse displacement ~ sin(k x) and axial stress ~ sin(k x) vanish
at both ends), so its frequency is exact (Graff 1975, Wave Motion in Elastic Solids, section 8.1, with the
longitudinal speed of plane stress). Prints it with the value of a finite element solution, which shares
no formula with it, and the values of beam theory.
"""

import json
import sys

import numpy as np
import scipy.optimize
import scipy.sparse.linalg as spl

from plane_elements import Mesh, lame, plane_stress_lambda, saint_venant_kirchhoff

LENGTH, HEIGHT, MODULUS, RATIO, DENSITY = 8.0, 1.0, 3000.0, 0.3, 1.0


def euler_bernoulli(number=1):
    """pi^2 / L^2 sqrt(E I / rho A) / 2 pi (dissertation eq. 4.16 and table 7)."""
    return number**2 * np.pi / (2 * LENGTH**2) * np.sqrt(MODULUS * HEIGHT**2 / (12 * DENSITY))


def timoshenko(correction=5 * (1 + RATIO) / (6 + 5 * RATIO)):
    """The lower root of Timoshenko's (1921) frequency equation for hinged ends, with Cowper's (1966) shear
    correction for a narrow rectangle under plane stress, k = 5 (1 + nu) / (6 + 5 nu), by default."""
    k = np.pi / LENGTH
    radius2 = HEIGHT**2 / 12
    bar, shear = MODULUS / DENSITY, correction * MODULUS / (2 * (1 + RATIO)) / DENSITY
    # w^4 / (bar shear) - w^2 (1 / (bar r^2) + k^2 / bar + k^2 / shear) + k^4 = 0
    linear = 1 / (bar * radius2) + k**2 / bar + k**2 / shear
    return np.sqrt((linear - np.sqrt(linear**2 - 4 * k**4 / (bar * shear))) * bar * shear / 2) / (2 * np.pi)


def rayleigh_lamb(number=1):
    """The lowest antisymmetric root at wave number n pi / L."""
    k, half = number * np.pi / LENGTH, HEIGHT / 2
    longitudinal2 = MODULUS / (DENSITY * (1 - RATIO**2))
    shear2 = MODULUS / (2 * (1 + RATIO) * DENSITY)

    def mismatch(frequency):
        w2 = (2 * np.pi * frequency) ** 2
        a, b = np.sqrt(k**2 - w2 / longitudinal2), np.sqrt(k**2 - w2 / shear2)
        return 4 * k**2 * a * b * np.tanh(b * half) - (k**2 + b**2) ** 2 * np.tanh(a * half)

    guess = euler_bernoulli(number)
    return scipy.optimize.brentq(mismatch, 0.75 * guess, 0.995 * guess, xtol=1e-15, rtol=1e-14)


def finite_elements(columns, rows, degree):
    mesh = Mesh(np.linspace(0, LENGTH, columns + 1), np.linspace(0, HEIGHT, rows + 1), degree)
    law = saint_venant_kirchhoff(plane_stress_lambda(MODULUS, RATIO), lame(MODULUS, RATIO)[1])
    ends = (mesh.points[:, 0] == 0) | (mesh.points[:, 0] == LENGTH)
    free = mesh.free_unknowns(np.column_stack([np.zeros_like(ends), ends]))
    stiffness = mesh.stiffness(np.zeros((len(mesh.points), 2)), law)[free][:, free]
    mass = mesh.mass(DENSITY)[free][:, free]
    # The shift is below the first bending mode; the rigid motion along the beam has frequency 0.
    values = spl.eigsh(stiffness, k=4, M=mass, sigma=4.0, which="LM", return_eigenvectors=False)
    frequencies = np.sqrt(np.maximum(np.sort(values), 0)) / (2 * np.pi)
    return frequencies[frequencies > 0.1][:3]


def reference(fine=True):
    elements = finite_elements(8, 2, 5 if fine else 3)
    exact = np.array([rayleigh_lamb(number) for number in (1, 2, 3)])
    return {
        "euler_bernoulli_frequency": euler_bernoulli(),
        "timoshenko_frequency": timoshenko(),
        "rayleigh_lamb_frequency": exact[0],
        "rayleigh_lamb_frequencies": list(exact),
        "finite_element_frequency": float(elements[0]),
        "finite_element_error": float(abs(elements[0] / exact[0] - 1)),
        "finite_element_errors": [float(error) for error in abs(elements / exact - 1)],
    }


if __name__ == "__main__":
    json.dump(reference("--coarse" not in sys.argv), sys.stdout, indent=2)
    print()
