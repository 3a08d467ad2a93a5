#!/usr/bin/env python3
"""Reference of the scenes `cook_membrane...`: the vertical displacement of the loaded edge.

Cook's membrane (Cook 1974; nearly incompressible and at finite strain: Simo and Armero 1992): a panel with the corners
(0, 0), (48, 44), (48, 60), (0, 44) in plane strain, its left edge held, under the dead vertical load 100, uniform over
its right edge. Young's modulus 240.565, Poisson's ratio 0.3 or 0.4999, neo-Hookean, or linearised at rest. Elements of
high degree do not lock; they become small towards the corners, where stresses are singular.

Published: at finite strain and with Poisson's ratio 0.4999 the upper right corner rises by 6.9083 (Elguedj, Bazilevs,
Calo and Hughes 2008, Comput. Methods Appl. Mech. Engrg. 197). Cook's own panel, plane stress with Young's modulus 1,
Poisson's ratio 1/3 and load 1: the middle of the right edge rises by 23.9 (Cook 1974), 23.96 in later tables.

Prints the mean rise of the loaded edge for each ratio, of the published numbers their own.
"""

import json
import sys

import numpy as np

from plane_elements import Quadrilateral, graded, lame, neo_hookean, plane_stress_lambda, solve_linear, solve_neo_hookean

MODULUS, LOAD, WIDTH = 240.565, 100.0, 48.0
RATIOS = {"compressible": 0.3, "incompressible": 0.4999}
# Columns at the left and at the right, rows at either end, degree.
FINE, COARSE, COARSEST = (5, 4, 3, 6), (4, 3, 2, 5), (3, 2, 2, 4)


class Membrane(Quadrilateral):
    def __init__(self, left, right, rows, degree):
        columns = np.concatenate([graded(0, 0.4, left, 3), graded(0.4, 1, right, 1 / 3)[1:]])
        below = np.append(graded(0, 0.25, rows, 3), 0.5)
        super().__init__(columns, np.concatenate([below, 1 - below[-2::-1]]), degree, WIDTH, (0, 44), (44, 60))
        self.held = np.repeat((self.points[:, 0] == 0)[:, None], 2, axis=1)

    def loaded(self, load):
        return self.right_edge_load(lambda t: np.stack([0 * t, load + 0 * t], -1))

    def rise(self, displacement):
        """Of the right edge: its mean, by how much more that is than the mean half a length before it, per length, its
        middle and its upper end."""
        heights, edge = self.along_y(displacement, 1.0)
        mean, before = (self.mean_along_y(displacement, s)[1] for s in (1.0, 1 - 0.5 / WIDTH))
        return (
            float(mean),
            float((mean - before) / 0.5),
            float(np.interp(0.5, heights, edge[:, 1])),
            float(edge[-1, 1]),
        )


def rises(level, ratio, linear, steps=4):
    mesh, constants = Membrane(*level), lame(MODULUS, ratio)
    if linear:
        return mesh.rise(solve_linear(mesh, neo_hookean(*constants), mesh.loaded(LOAD), mesh.held))
    return mesh.rise(solve_neo_hookean(mesh, *constants, mesh.loaded(LOAD), mesh.held, steps))


def cook(level):
    """The middle of the edge of Cook's own panel."""
    mesh = Membrane(*level)
    law = neo_hookean(plane_stress_lambda(1, 1 / 3), lame(1, 1 / 3)[1])
    return mesh.rise(solve_linear(mesh, law, mesh.loaded(1), mesh.held))[2]


def reference(fine=True):
    """All numbers with their numerical error, the difference to the next coarser discretisation."""
    levels = [COARSE, FINE] if fine else [COARSEST, COARSE]
    numbers = {"cook": cook(levels[1])}
    for name, ratio in RATIOS.items():
        for kind in ("linear", "finite"):
            coarser, finer = (rises(level, ratio, kind == "linear") for level in levels)
            numbers[f"{name}_{kind}"] = finer[0]
            numbers[f"{name}_{kind}_error"] = abs(finer[0] - coarser[0])
            numbers[f"{name}_{kind}_slope"] = finer[1]
            numbers[f"{name}_{kind}_corner"] = finer[3]
    return numbers


if __name__ == "__main__":
    json.dump(reference("--coarse" not in sys.argv), sys.stdout, indent=2)
    print()
