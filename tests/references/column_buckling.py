#!/usr/bin/env python3
"""Reference of the scene `column_buckling`: the critical load of a cantilevered column by 2D elasticity.

A column 8 long, 0.5 thick, E 3000, nu 0.3, plane stress, one whole end fixed in both directions, under a uniform
axial dead traction on the other. Prints Euler's load pi^2 E I / (4 L^2), the load at which the linearised problem
(K + factor K') phi = 0 has a solution (K' is the derivative of the tangent along the linear answer to the load, by
the law of Saint Venant and Kirchhoff), and the load at which the tangent on the true path of the straight column
becomes singular, with two laws: what they differ by bounds what linearisation and the choice of a law can change.
"""

import json
import sys

import numpy as np
import scipy.sparse.linalg as spl

from plane_elements import (
    Mesh,
    graded,
    hencky,
    lame,
    plane_stress_lambda,
    saint_venant_kirchhoff,
    solve_linear,
    solve_static,
)

LENGTH, HEIGHT, MODULUS, RATIO = 8.0, 0.5, 3000.0, 0.3


def euler():
    return np.pi**2 * MODULUS * HEIGHT**3 / 12 / (4 * LENGTH**2)


def problem(columns, rows, degree):
    """The mesh, the unit load and what is held."""
    # Elements shrink towards the fixed end, whose corners are singular.
    mesh = Mesh(graded(0, LENGTH, columns, 1.3), np.linspace(0, HEIGHT, rows + 1), degree)
    held = np.repeat((mesh.points[:, 0] == 0)[:, None], 2, axis=1)
    traction = lambda y: np.stack([0 * y - 1 / HEIGHT, 0 * y], -1)
    return mesh, mesh.right_edge_load(traction), held


def constants():
    _, mu = lame(MODULUS, RATIO)
    return plane_stress_lambda(MODULUS, RATIO), mu


def linearised(columns, rows, degree, count=2, step=1e-3):
    """The lowest critical loads of the linearised problem."""
    mesh, force, held = problem(columns, rows, degree)
    law = saint_venant_kirchhoff(*constants())
    free = mesh.free_unknowns(held)
    answer = solve_linear(mesh, law, force, held)
    tangent = lambda u: mesh.stiffness(u, law)[free][:, free]
    change = (tangent(step * answer) - tangent(-step * answer)) / (2 * step)
    inverse = spl.eigsh(-change, k=count, M=tangent(0 * answer), which="LA", return_eigenvectors=False)
    return np.sort(1 / inverse)


def on_the_path(columns, rows, degree, law):
    """The load at which the tangent of the straight column is singular, by a secant of its lowest value."""
    mesh, force, held = problem(columns, rows, degree)
    free = mesh.free_unknowns(held)
    # The straight column is symmetric; holding its middle keeps Newton's method from bending it.
    middle = np.abs(mesh.points[:, 1] - HEIGHT / 2) < 1e-9
    straight = held | np.column_stack([np.zeros_like(middle), middle])

    def lowest(load):
        u = solve_static(mesh, law, load * force, straight, steps=1)
        stiffness = mesh.stiffness(u, law)[free][:, free]
        return spl.eigsh(stiffness, k=1, sigma=-1e-3, which="LM", return_eigenvectors=False)[0]

    a, b = 0.97 * euler(), 0.99 * euler()
    at_a, at_b = lowest(a), lowest(b)
    for _ in range(6):
        a, b, at_a = b, b - at_b * (b - a) / (at_b - at_a), at_b
        at_b = lowest(b)
        if abs(b - a) <= 1e-9 * b:
            break
    return b


def reference(fine=True):
    """All loads, with the difference to the next coarser discretisation."""
    size, coarser = ((12, 2, 6), (10, 2, 5)) if fine else ((8, 2, 4), (6, 2, 4))
    factors, before = linearised(*size), linearised(*coarser)
    lam, mu = constants()
    return {
        "euler": euler(),
        "linearised": factors[0],
        "linearised_second": factors[1],
        "linearised_error": abs(factors[0] - before[0]),
        "path_saint_venant_kirchhoff": on_the_path(*size, saint_venant_kirchhoff(lam, mu)),
        "path_hencky": on_the_path(*size, hencky(lam, mu)),
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
