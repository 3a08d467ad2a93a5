#!/usr/bin/env python3
"""Reference of the scene `toggle_frame`: the path of a frame that snaps through.

Williams' toggle (Williams 1964) as a plane body: two strips that rise towards the middle, clamped at their outer ends
and joined there; by symmetry one of them, from (0, 0) to (10, 1.4), of upright height 0.5, whose upper end neither moves
sideways nor turns. Plane strain, neo-Hookean, Young's modulus 1000, Poisson's ratio 0.3. A dead downward shear traction
of 1 times a load factor acts on the upper end. Elements of high degree; the mean deflection of the upper end is given
and the load factor found, so that limit loads are points like others.

Prints the load factors of the path's limit points, the deflections there and the deflection at which the load factor is
back at its first maximum.
"""

import json
import sys

import numpy as np
import scipy.interpolate
import scipy.sparse.linalg as spl

from plane_elements import Quadrilateral, graded, lame, neo_hookean

MODULUS, RATIO = 1000.0, 0.3
WIDTH, RISE, HEIGHT = 10.0, 1.4, 0.5
LAST_DEFLECTION = 3.2
# Columns, rows, degree, steps.
FINE, COARSE, COARSEST = (8, 2, 5, 40), (6, 1, 5, 32), (4, 1, 4, 32)


def path(columns, rows, degree, steps):
    """Deflections and load factors, from 0 on."""
    half = graded(0, 0.5, columns // 2, 1.7)
    lines = np.concatenate([half, 1 - half[-2::-1]])
    mesh = Quadrilateral(lines, np.linspace(0, 1, rows + 1), degree, WIDTH, (0, HEIGHT), (RISE, RISE + HEIGHT))
    held = np.repeat((mesh.points[:, 0] == 0)[:, None], 2, axis=1)
    held[mesh.points[:, 0] == 1, 0] = True
    free = mesh.free_unknowns(held)
    law = neo_hookean(*lame(MODULUS, RATIO))
    # The mesh's edge is of length 1.
    force = HEIGHT * mesh.right_edge_load(lambda t: np.stack([0 * t, -1 + 0 * t], -1))
    mean = force[free] / HEIGHT
    u, factor = np.zeros((len(mesh.points), 2)), 0.0
    deflections, factors = [0.0], [0.0]
    for deflection in np.linspace(0, LAST_DEFLECTION, steps + 1)[1:]:
        for _ in range(30):
            solve = spl.splu(mesh.stiffness(u, law)[free][:, free]).solve
            residual = (factor * force - mesh.internal_force(u, law))[free]
            by_residual, by_load = solve(residual), solve(force[free])
            change = (deflection - mean @ (u.ravel()[free] + by_residual)) / (mean @ by_load)
            correction = np.zeros(mesh.unknowns)
            correction[free] = by_residual + change * by_load
            u += correction.reshape(-1, 2)
            factor += change
            if np.abs(correction).max() <= 1e-9 * np.abs(u).max():
                break
        else:
            raise RuntimeError("Newton's method did not converge")
        deflections.append(float(deflection))
        factors.append(float(factor))
    return np.array(deflections), np.array(factors)


def limit_points(deflections, factors):
    """Maximum and minimum by a spline, and where the load factor is that of the maximum again."""
    curve = scipy.interpolate.CubicSpline(deflections, factors)
    places = [x for x in curve.derivative().roots(extrapolate=False) if 0 < x < LAST_DEFLECTION]
    assert len(places) == 2, places
    (first, second), (most, least) = places, curve(places)
    beyond = max(curve.solve(most, extrapolate=False))
    return {
        "maximum": float(most),
        "maximum_at": float(first),
        "minimum": float(least),
        "minimum_at": float(second),
        "snapped_to": float(beyond),
    }


def reference(fine=True):
    """All numbers with their numerical error, the difference to the next coarser discretisation."""
    levels = [COARSE, FINE] if fine else [COARSEST, COARSE]
    coarser, finer = (limit_points(*path(*level)) for level in levels)
    return finer | {f"{name}_error": abs(value - coarser[name]) for name, value in finer.items()}


if __name__ == "__main__":
    json.dump(reference("--coarse" not in sys.argv), sys.stdout, indent=2)
    print()
