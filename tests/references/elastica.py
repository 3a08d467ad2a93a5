#!/usr/bin/env python3
"""Reference of the scenes `elastica_end_load` and `elastica_uniform_load`: large deflection of a cantilever.

The elastica (Bisshopp and Drucker 1945; uniform load: Rohde 1953): a beam without extension and shear, of length 1 and
bending stiffness 1, clamped level at s = 0 and free at s = 1, under dead transverse load. With the slope angle
theta(s) and the transverse force q(s) that the part beyond s carries, theta'' = -q cos(theta), theta(0) = 0,
theta'(1) = 0. The end load's deflection also follows from elliptic integrals, an independent check.

Prints for each kind of load the load in units of E I / L^2 (of the whole uniform load) at which the end deflects by
0.8 of the length, how far the end then lies from the clamp along the axis, and its slope angle.
"""

import json
import sys

import numpy as np
import scipy.integrate
import scipy.optimize
import scipy.special

DEFLECTION = 0.8


def load_for_deflection(uniform):
    """The load, x of the end and its slope angle: a shooting method for the load and the curvature at the clamp."""

    def end(load, curvature):
        carried = (lambda s: load * (1 - s)) if uniform else (lambda s: load)
        rates = lambda s, state: [state[1], -carried(s) * np.cos(state[0]), np.cos(state[0]), np.sin(state[0])]
        start = [0, curvature, 0, 0]
        return scipy.integrate.solve_ivp(rates, (0, 1), start, method="DOP853", rtol=1e-11, atol=1e-12).y[:, -1]

    def missed(unknowns):
        _, moment, _, deflection = end(*unknowns)
        return [moment, deflection - DEFLECTION]

    found = scipy.optimize.root(missed, [16.0, 5.05] if uniform else [9.0, 4.0], tol=1e-10)
    assert found.success, found.message
    load, curvature = found.x
    angle, _, x, _ = end(load, curvature)
    return load, x, angle


def end_load_by_elliptic_integrals():
    """The load, x of the end and its angle: with k^2 = (1 + sin theta_end) / 2 and sin(phi) = 1 / (k sqrt 2), sqrt(load)
    is K(k) - F(phi, k), the deflection 1 - 2 (E(k) - E(phi, k)) / sqrt(load), x sqrt(2 sin(theta_end) / load)."""

    def solution(end_angle):
        m = (1 + np.sin(end_angle)) / 2
        phi = np.arcsin(1 / np.sqrt(2 * m))
        root = scipy.special.ellipk(m) - scipy.special.ellipkinc(phi, m)
        deflection = 1 - 2 * (scipy.special.ellipe(m) - scipy.special.ellipeinc(phi, m)) / root
        return root**2, deflection, np.sqrt(2 * np.sin(end_angle)) / root

    angle = scipy.optimize.brentq(lambda a: solution(a)[1] - DEFLECTION, 0.1, 1.55, xtol=1e-13)
    load, _, x = solution(angle)
    return load, x, angle


def reference():
    end, uniform = load_for_deflection(uniform=False), load_for_deflection(uniform=True)
    difference = float(np.abs(np.subtract(end, end_load_by_elliptic_integrals())).max())
    numbers = {"end_load_difference": difference}
    for name, (load, x, angle) in {"end_load": end, "uniform_load": uniform}.items():
        numbers |= {name: float(load), f"{name}_x": float(x), f"{name}_angle": float(angle)}
    return numbers


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
