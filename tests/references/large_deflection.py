#!/usr/bin/env python3
"""References of the large deflection of a cantilever under a uniform load, the dissertation's figure 23.

The figure shows no numbers but the load parameter q L^3 / (E I) from 0 to 10 and the deflection of the end over L. The
beam of this comparison is that of Bathe, Ramm & Wilson (1975): L 10, h 1, E 12000, nu 0.2, under dead load. Three answers:
- the elastica, which neither stretches nor shears;
- a beam that does both (Reissner 1972): strain N / (E A), shear angle V / (k G A), curvature M / (E I), with k of
  the plane rectangle, 5 (1 + nu) / (6 + 5 nu);
- the plane body of Saint Venant-Kirchhoff's law with its left edge clamped, in plane stress, the load as a force
  per volume: total Lagrangian finite elements.

With --write FILE writes large_deflection.csv: the mean deflection of the section at PLACE, downwards, over L.
"""

import argparse

import numpy as np
import scipy.integrate

from plane_elements import Mesh, graded, graded_to_both_ends, lame, plane_stress_lambda, saint_venant_kirchhoff, solve_static

LENGTH, HEIGHT, MODULUS, RATIO = 10.0, 1.0, 12000.0, 0.2
STIFFNESS = MODULUS * HEIGHT**3 / 12
PLACE = LENGTH - 1 / 24  # of a section that the table follows as well
LOADS = np.arange(0, 10.5, 0.5)


def beam(parameters, stretches):
    """Deflection and shortening of the end over L for each load parameter; `stretches`: Reissner's beam."""
    softness = stretches * STIFFNESS / LENGTH**2
    shear_factor = 5 * (1 + RATIO) / (6 + 5 * RATIO)
    axial, shear = softness / (MODULUS * HEIGHT), softness / (shear_factor * lame(MODULUS, RATIO)[1] * HEIGHT)
    s = np.linspace(0, 1, 41)
    state = np.zeros((4, s.size))  # x, deflection, slope, moment
    result = []
    for load in parameters:

        def rates(place, y, load=load):
            cos, sin, carried = np.cos(y[2]), np.sin(y[2]), load * (1 - place)
            along, across = 1 + axial * carried * sin, shear * carried * cos
            x = along * cos - across * sin
            return np.array([x, along * sin + across * cos, y[3], -x * carried])

        ends = lambda a, b: np.array([a[0], a[1], a[2], b[3]])
        found = scipy.integrate.solve_bvp(rates, ends, s, state, tol=1e-9, max_nodes=20000)
        assert found.success, found.message
        state = found.sol(s)
        result.append([state[1, -1], 1 - state[0, -1]])
    return np.array(result)


def plane_body(parameters, places, columns=10, rows=4, degree=5):
    """Deflection and shortening over L of the means of sections: (parameters, places, 2)."""
    mesh = Mesh(graded(0, LENGTH, columns, 1.25), graded_to_both_ends(0, HEIGHT, rows, 1.5), degree)
    law = saint_venant_kirchhoff(plane_stress_lambda(MODULUS, RATIO), lame(MODULUS, RATIO)[1])
    held = np.repeat((mesh.points[:, 0] == 0)[:, None], 2, axis=1)
    unit = mesh.body_load(1, (0, -STIFFNESS / LENGTH**3 / HEIGHT))
    u, result = np.zeros((len(mesh.points), 2)), []
    for parameter in parameters:
        u = solve_static(mesh, law, parameter * unit, held, steps=1, start=u)
        result.append([-mesh.mean_along_y(u, place)[::-1] / LENGTH for place in places])
    return np.array(result)


def table(place, **discretisation):
    """Load parameter, then deflections and shortenings: elastica, Reissner's beam, the plane body's end and `place`."""
    end, inner = np.moveaxis(plane_body(LOADS[1:], (LENGTH, place), **discretisation), 1, 0)
    beams = [beam(LOADS[1:], stretches) for stretches in (False, True)]
    return np.vstack([np.zeros(9), np.column_stack([LOADS[1:], *beams, end, inner])])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", metavar="FILE", required=True)
    arguments = parser.parse_args()
    fine = table(PLACE)
    coarse = table(PLACE, columns=8, degree=4)
    print("the plane body's error:", np.abs(fine - coarse)[:, 5:].max())
    header = "load,elastica,elastica_shortening,reissner,reissner_shortening,plane,plane_shortening,place,place_shortening"
    np.savetxt(arguments.write, fine, "%.7g", ",", header=header, comments="")


if __name__ == "__main__":
    main()
