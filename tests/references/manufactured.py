#!/usr/bin/env python3
"""Reference of the scenes `axis_aligned` and `generalized_vortex`: the body forces that make a chosen motion exact.

For a motion x(X, t) of a neo-Hookean body in plane strain, P = mu (F - F^-T) + lambda ln(J) F^-T
(dissertation eq. 2.17), the force per mass is b = d2x/dt2 - Div P / rho. SymPy differentiates; the scenes
have the results in a shorter form by hand, which the tests compare.

Axis-aligned displacement in a unit square (Wallstedt & Guilkey 2008, section 5.1):
    u_x = A sin(pi X) sin(c pi t), u_y = A sin(pi Y) sin(c pi t + pi), c^2 = E / rho.
The faces move along themselves only.

Generalized vortex in a ring 0.75 <= R <= 1.25 (Kamojjala, Brannon, Sadeghirad & Guilkey 2015, section 4.3):
each circle turns by alpha = G sin(pi t / T) (1 - 4 s^2)^2 with s = (R - 1) / 0.5; the edges neither move nor
bear stress.

Prints the two motions' largest principal stretch and the body force at one point.
"""

import json
import sys

import numpy as np
import sympy as sp

X, Y, T = sp.symbols("x y t", real=True)


def neo_hookean(gradient, lam, mu):
    det = gradient.det()
    inverse_transposed = sp.Matrix([[gradient[1, 1], -gradient[1, 0]], [-gradient[0, 1], gradient[0, 0]]]) / det
    return mu * (gradient - inverse_transposed) + lam * sp.log(det) * inverse_transposed


def body_force(motion, lam, mu, rho):
    """Force per mass, as a function of reference coordinates and time."""
    stress = neo_hookean(motion.jacobian([X, Y]), lam, mu)
    divergence = sp.Matrix([sp.diff(stress[i, 0], X) + sp.diff(stress[i, 1], Y) for i in range(2)])
    return sp.diff(motion, T, 2) - divergence / rho


def lame(modulus, ratio):
    mu = modulus / (2 * (1 + ratio))
    return 2 * mu * ratio / (1 - 2 * ratio), mu


class AxisAligned:
    MODULUS, RATIO, DENSITY, AMPLITUDE = 1e7, 0.3, 1000.0, 0.05
    SPEED = np.sqrt(MODULUS / DENSITY)
    motion = sp.Matrix(
        [
            X + AMPLITUDE * sp.sin(sp.pi * X) * sp.sin(SPEED * sp.pi * T),
            Y - AMPLITUDE * sp.sin(sp.pi * Y) * sp.sin(SPEED * sp.pi * T),
        ]
    )
    period = 2 / SPEED

    @staticmethod
    def points(count, generator):
        return generator.uniform(0, 1, (2, count))


class GeneralizedVortex:
    MODULUS, RATIO, DENSITY, TURN, PERIOD = 1000.0, 0.3, 1000.0, 0.5, 1.0
    radius = sp.sqrt(X**2 + Y**2)
    s = (radius - 1) / sp.Rational(1, 2)
    angle = TURN * sp.sin(sp.pi * T / PERIOD) * (1 - 4 * s**2) ** 2
    motion = sp.Matrix([X * sp.cos(angle) - Y * sp.sin(angle), X * sp.sin(angle) + Y * sp.cos(angle)])
    period = 2 * PERIOD

    @staticmethod
    def points(count, generator):
        radius, turn = generator.uniform(0.75, 1.25, count), generator.uniform(0, 2 * np.pi, count)
        return np.stack([radius * np.cos(turn), radius * np.sin(turn)])


def body_force_function(case):
    """b(x, y, t) as two components, for arrays."""
    force = body_force(case.motion, *lame(case.MODULUS, case.RATIO), case.DENSITY)
    return sp.lambdify((X, Y, T), list(force), "numpy")


def velocity_function(case):
    return sp.lambdify((X, Y, T), list(sp.diff(case.motion, T)), "numpy")


def acceleration_function(case):
    return sp.lambdify((X, Y, T), list(sp.diff(case.motion, T, 2)), "numpy")


def gradient(case, x, y, t):
    """F at points, (n, 2, 2)."""
    function = sp.lambdify((X, Y, T), list(case.motion.jacobian([X, Y])), "numpy")
    return np.stack([np.broadcast_to(f, x.shape) for f in function(x, y, t)], -1).reshape(-1, 2, 2)


def stress(case, x, y, t):
    """P at points, (n, 2, 2)."""
    lam, mu = lame(case.MODULUS, case.RATIO)
    f = gradient(case, x, y, t)
    inverse_transposed = np.swapaxes(np.linalg.inv(f), -1, -2)
    return mu * (f - inverse_transposed) + lam * np.log(np.linalg.det(f))[:, None, None] * inverse_transposed


def largest_stretch(case, count=2000):
    x, y = case.points(count, np.random.default_rng(0))
    return float(np.linalg.svd(gradient(case, x, y, case.period / 4), compute_uv=False).max())


def reference():
    return {
        case.__name__: {
            "largest_stretch": largest_stretch(case),
            "body_force_at_0.6_0.5": [float(b) for b in body_force_function(case)(0.6, 0.5, case.period / 8)],
        }
        for case in (AxisAligned, GeneralizedVortex)
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
