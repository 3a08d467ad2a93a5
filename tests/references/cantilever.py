#!/usr/bin/env python3
"""Reference of the scene `cantilever`: tip deflection and slope by 2D elasticity.

A beam 8 long, 1 high, E 3000, nu 0.3, plane stress, whole left edge fixed in both directions, under the
end load 1 as the parabolic shear traction of Timoshenko & Goodier (1970, section 21), which keeps its
direction. This clamp has no closed form: their solution fixes one point and one line element. Prints the
mean over the end edge of the transverse displacement, and its slope along the beam, for small
displacements and for finite ones.

The finite-displacement answer is computed with three laws that agree for small strain, since the
outer fibre strains by 1.6 %: what they differ by bounds what the choice of a strain measure can change.
"""

import json
import sys

import numpy as np

from plane_elements import (
    Mesh,
    graded,
    graded_to_both_ends,
    hencky,
    lame,
    plane_stress_lambda,
    saint_venant_kirchhoff,
    solve_linear,
    solve_static,
)

LENGTH, HEIGHT, MODULUS, RATIO, LOAD = 8.0, 1.0, 3000.0, 0.3, 1.0


def tip(mesh, displacement):
    """Mean transverse displacement over the end edge and its slope, by a difference over 0.01."""
    end = mesh.mean_along_y(displacement, LENGTH)[1]
    before = mesh.mean_along_y(displacement, LENGTH - 0.01)[1]
    return np.array([end, (end - before) / 0.01])


def solve(columns, rows, degree, law=None):
    """The tip's deflection and slope; without a law for small displacements."""
    # Elements shrink by a third towards the clamp's corners, where the stress is singular.
    mesh = Mesh(graded(0, LENGTH, columns, 1.5), graded_to_both_ends(0, HEIGHT, rows, 1.5), degree)
    held = np.repeat((mesh.points[:, 0] == 0)[:, None], 2, axis=1)
    parabola = lambda y: np.stack([0 * y, -6 * LOAD / HEIGHT * (y / HEIGHT) * (1 - y / HEIGHT)], -1)
    force = mesh.right_edge_load(parabola)
    if law is None:
        return tip(mesh, solve_linear(mesh, saint_venant_kirchhoff(*constants()), force, held))
    return tip(mesh, solve_static(mesh, law, force, held, steps=2))


def constants():
    _, mu = lame(MODULUS, RATIO)
    return plane_stress_lambda(MODULUS, RATIO), mu


def reference(fine=True):
    """All numbers with their numerical error, the difference to the next coarser discretisation."""
    inertia = HEIGHT**3 / 12
    shear = MODULUS / (2 * (1 + RATIO))
    beam = LOAD * LENGTH**3 / (3 * MODULUS * inertia)
    levels = [(14, 10, 4), (18, 14, 6)] if fine else [(10, 8, 3), (14, 10, 4)]
    lam, mu = constants()
    linear = [solve(*level) for level in levels]
    finite = [solve(*level, law=saint_venant_kirchhoff(lam, mu)) for level in levels]
    logarithmic = solve(*levels[0], law=hencky(lam, mu))
    return {
        "beam_theory_deflection": beam,
        "timoshenko_goodier_deflection": beam + LOAD * (HEIGHT / 2) ** 2 * LENGTH / (2 * inertia * shear),
        "linear_deflection": -linear[-1][0],
        "linear_slope": -linear[-1][1],
        "linear_error": float(np.abs(linear[-1] - linear[-2]).max()),
        "finite_deflection": -finite[-1][0],
        "finite_slope": -finite[-1][1],
        "finite_error": float(np.abs(finite[-1] - finite[-2]).max()),
        "finite_difference_between_laws": float(abs(logarithmic[0] - finite[0][0])),
    }


if __name__ == "__main__":
    json.dump(reference("--coarse" not in sys.argv), sys.stdout, indent=2)
    print()
