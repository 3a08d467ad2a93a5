#!/usr/bin/env python3
"""Reference of the scene `hanging_bar`: a neo-Hookean bar that hangs under its own weight.

P = mu (F - F^-T) + lambda ln(J) F^-T (dissertation eq. 2.17). The section at X of a bar that is held at X = 0
carries the weight below it, P(X) = rho g (L - X), whatever the deformation. With the sides held (uniaxial
strain, F = diag(1, s)) or free (uniaxial stress, F = diag(a, s, a) with P_xx = 0) the stretch s follows from
P; with X as a function of s the displacement is an integral over the stretch, u(X) = int (s - 1) P'(s) ds /
(rho g).

Prints displacement of the end, stretch and lateral stress at the top.
"""

import json
import sys

import numpy as np
import scipy.integrate
import scipy.optimize

LENGTH, MODULUS, RATIO, DENSITY, GRAVITY = 1.0, 1e6, 0.3, 1050.0, 400.0
MU = MODULUS / (2 * (1 + RATIO))
LAMBDA = 2 * MU * RATIO / (1 - 2 * RATIO)


def lateral_stretch(s, free):
    """The stretch across the bar: 1 if its sides are held, else from mu (a^2 - 1) + lambda ln(a^2 s) = 0."""
    if not free:
        return 1.0
    balance = lambda a: MU * (a * a - 1) + LAMBDA * np.log(a * a * s)
    return scipy.optimize.brentq(balance, 0.1, 2.0, xtol=1e-15)


def nominal_stress(s, free=False):
    """P along the bar at the stretch s."""
    a = lateral_stretch(s, free)
    return MU * (s - 1 / s) + LAMBDA * np.log(a * a * s) / s


def stretch(stress, free=False):
    return scipy.optimize.brentq(lambda s: nominal_stress(s, free) - stress, 0.5, 5.0, xtol=1e-15)


def displacement(x, free=False):
    """Of the section at reference distance x from the top, by partial integration of int (s - 1) dP / (rho g)."""
    weight = lambda at: DENSITY * GRAVITY * (LENGTH - at)
    top, here = stretch(weight(0), free), stretch(weight(x), free)
    integral, _ = scipy.integrate.quad(lambda s: nominal_stress(s, free), here, top, epsabs=0, epsrel=1e-13)
    return ((top - 1) * weight(0) - (here - 1) * weight(x) - integral) / (DENSITY * GRAVITY)


def displacement_by_ode(x, free=False):
    """The same by integrating du/dX = s(P(X)) - 1."""
    slope = lambda at, _: stretch(DENSITY * GRAVITY * (LENGTH - at), free) - 1
    return scipy.integrate.solve_ivp(slope, (0, x), [0.0], rtol=1e-10, atol=1e-13).y[0, -1]


def reference():
    top = stretch(DENSITY * GRAVITY * LENGTH)
    return {
        "end_displacement": displacement(LENGTH),
        "top_stretch": top,
        # Cauchy stress: F^-T's lateral part is 1, and J = s.
        "top_lateral_stress": LAMBDA * np.log(top) / top,
        "end_displacement_free_sides": displacement(LENGTH, free=True),
        "end_displacement_small_strain": DENSITY * GRAVITY * LENGTH**2 / (2 * (LAMBDA + 2 * MU)),
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
