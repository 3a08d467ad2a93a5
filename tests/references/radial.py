#!/usr/bin/env python3
"""References of `thick_cylinder`, `compressed_cylinder`, `rotating_disc` and `hollow_sphere`.

Closed forms of linear elasticity (Timoshenko & Goodier 1970, sections 28 and 32 for the cylinder and the
disc, 136 for the sphere), and for finite strain the radial equilibrium of a neo-Hookean body, P = mu (F -
F^-T) + lambda ln(J) F^-T (dissertation eq. 2.17): with the radius r(R) the stretches are r' along the radius,
r / R around it, and

    dP_R/dR + n (P_R - P_T) / R = 0,    n = 1 (cylinder, axial stretch 1) or 2 (sphere),

solved by collocation. Prints the numbers of the scenes.
"""

import json
import sys

import numpy as np
import scipy.integrate
import scipy.optimize


def lame(modulus, ratio):
    mu = modulus / (2 * (1 + ratio))
    return 2 * mu * ratio / (1 - 2 * ratio), mu


def cylinder_displacement(r, inner, outer, pressure, modulus, ratio):
    """Lame's cylinder in plane strain under inner pressure."""
    factor = pressure * inner**2 * (1 + ratio) / (modulus * (outer**2 - inner**2))
    return factor * ((1 - 2 * ratio) * r + outer**2 / r)


def cylinder_stress(r, inner, outer, pressure):
    """Radial and hoop stress of Lame's cylinder."""
    factor = pressure * inner**2 / (outer**2 - inner**2)
    return factor * (1 - outer**2 / r**2), factor * (1 + outer**2 / r**2)


def sphere_displacement(r, inner, outer, pressure, modulus, ratio):
    """Lame's hollow sphere under inner pressure."""
    factor = pressure * inner**3 / (modulus * (outer**3 - inner**3))
    return factor * ((1 - 2 * ratio) * r + (1 + ratio) * outer**3 / (2 * r**2))


def sphere_mean_displacement(inner, outer, pressure, modulus, ratio):
    """The mean of it over the volume."""
    displacement = lambda r: sphere_displacement(r, inner, outer, pressure, modulus, ratio)
    return scipy.integrate.quad(lambda r: displacement(r) * r**2, inner, outer)[0] * 3 / (outer**3 - inner**3)


def disc_displacement(r, outer, force, modulus, ratio):
    """A thin solid disc that rotates, mean over its thickness; force = rho omega^2. With Chree's terms for the
    thickness (Timoshenko & Goodier 1970, section 132) this mean stays what it is."""
    return (1 - ratio) * force * r / (8 * modulus) * ((3 + ratio) * outer**2 - (1 + ratio) * r**2)


def disc_stress(r, outer, force, ratio):
    """Radial and hoop stress of the rotating disc."""
    radial = (3 + ratio) / 8 * force * (outer**2 - r**2)
    return radial, force / 8 * ((3 + ratio) * outer**2 - (1 + 3 * ratio) * r**2)


class NeoHookeanShell:
    """Radial equilibrium of a hollow cylinder (n = 1) or sphere (n = 2) under a traction on its inner surface.

    `inner_traction` is the radial traction per reference area (dead), or `pressure` acts on the deformed surface."""

    def __init__(self, n, inner, outer, modulus, ratio, inner_traction=0.0, pressure=0.0):
        self.n, self.inner, self.outer = n, inner, outer
        self.lam, self.mu = lame(modulus, ratio)
        self.traction, self.pressure = inner_traction, pressure

    def nominal(self, radial, hoop):
        """P along and around the radius."""
        log = self.lam * np.log(radial * hoop**self.n)
        return (self.mu * (s - 1 / s) + log / s for s in (radial, hoop))

    def radial_stretch(self, hoop, nominal):
        """From P_R by Newton's method; P_R grows with the stretch."""
        s = np.ones_like(hoop)
        for _ in range(50):
            log = self.lam * np.log(s * hoop**self.n)
            residual = self.mu * (s - 1 / s) + log / s - nominal
            slope = self.mu * (1 + 1 / s**2) + (self.lam - log) / s**2
            step = residual / slope
            s = np.maximum(s - step, s / 2)
            if np.abs(step).max() < 1e-15:
                break
        return s

    def solve(self):
        """Displacement and P_R as functions of R."""

        def slopes(radius, state):
            displacement, nominal = state
            hoop = 1 + displacement / radius
            radial = self.radial_stretch(hoop, nominal)
            _, around = self.nominal(radial, hoop)
            return np.stack([radial - 1, -self.n * (nominal - around) / radius])

        def ends(at_inner, at_outer):
            area = (1 + at_inner[0] / self.inner) ** self.n
            return np.array([at_inner[1] + self.pressure * area + self.traction, at_outer[1]])

        radius = np.linspace(self.inner, self.outer, 41)
        rest = np.zeros((2, radius.size))
        solution = scipy.integrate.solve_bvp(slopes, ends, radius, rest, tol=1e-11, max_nodes=20000)
        if not solution.success:
            raise RuntimeError(solution.message)
        return solution.sol


def compressed_lateral_stretch(axial, modulus, ratio):
    """A neo-Hookean cylinder shortened to `axial` with free sides: mu (a^2 - 1) + lambda ln(a^2 s) = 0."""
    lam, mu = lame(modulus, ratio)
    return scipy.optimize.brentq(lambda a: mu * (a * a - 1) + lam * np.log(a * a * axial), 0.5, 3, xtol=1e-15)


def compressed_axial_stress(axial, modulus, ratio):
    """Cauchy stress along the axis."""
    lam, mu = lame(modulus, ratio)
    a = compressed_lateral_stretch(axial, modulus, ratio)
    volume = a * a * axial
    return (mu * (axial**2 - 1) + lam * np.log(volume)) / volume


# What the scenes have.
MODULUS, RATIO, DENSITY = 1000.0, 0.3, 1.0
INNER, OUTER = 1.0, 2.0
CYLINDER_TRACTION = 150.0
SPHERE_PRESSURE = 0.1
SHORTENED = 0.6


def reference():
    shell = NeoHookeanShell(1, INNER, OUTER, MODULUS, RATIO, inner_traction=CYLINDER_TRACTION)
    cylinder = shell.solve()

    def slope(radius):
        displacement, nominal = cylinder(np.array([radius]))
        return float(shell.radial_stretch(1 + displacement / radius, nominal)[0] - 1)

    return {
        "cylinder_inner_displacement": float(cylinder(INNER)[0]),
        "cylinder_inner_slope": slope(INNER),
        "cylinder_outer_displacement": float(cylinder(OUTER)[0]),
        "cylinder_outer_slope": slope(OUTER),
        "cylinder_inner_displacement_small_strain": cylinder_displacement(
            INNER, INNER, OUTER, CYLINDER_TRACTION, MODULUS, RATIO
        ),
        "compressed_lateral_stretch": compressed_lateral_stretch(SHORTENED, MODULUS, RATIO),
        "compressed_axial_stress": compressed_axial_stress(SHORTENED, MODULUS, RATIO),
        "sphere_mean_displacement": sphere_mean_displacement(INNER, OUTER, SPHERE_PRESSURE, MODULUS, RATIO),
        "sphere_inner_displacement": sphere_displacement(INNER, INNER, OUTER, SPHERE_PRESSURE, MODULUS, RATIO),
        "sphere_outer_displacement": sphere_displacement(OUTER, INNER, OUTER, SPHERE_PRESSURE, MODULUS, RATIO),
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
