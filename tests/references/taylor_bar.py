#!/usr/bin/env python3
"""Reference of the scene `taylor_bar`: a copper bar hits a smooth rigid wall.

Bilinear axisymmetric finite elements that move with the material, the law of the scene (isotropic elasticity in
rate form with the Jaumann rate, von Mises' yield stress with linear hardening, radial return), lumped masses, central
differences. Four integration points, and the mean of the dilatation over the element (Nagtegaal, Parks & Rice 1974)
against locking. Stays as simple as that: no viscosity, no hourglass control, no contact, since the foot stays on the
wall. Units: mm, ms, g, N, MPa.

Prints what the bar is like at the scene's end, for 2, 4 and 8 elements across (a minute). The length converges to
21.42; the radius of the foot (7.09 and 7.17) and of the scene's particle (6.97 and 7.05) grow to about 7.2 and 7.1, at
first order, because of the foot's corner; the largest strain at its centre has not settled (2.98 and 3.25).
"""

import json
import sys

import numpy as np

RADIUS, LENGTH, SPEED, END = 3.2, 32.4, 227.0, 0.08
YOUNG, POISSON, DENSITY, YIELD, HARDENING = 117e3, 0.35, 8.93e-3, 400.0, 100.0
SHEAR, BULK = YOUNG / (2 * (1 + POISSON)), YOUNG / (3 * (1 - 2 * POISSON))
CELL = 0.4  # of the scene, with two particles along a side
COURANT = 0.8

CORNERS = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
POINTS = CORNERS / np.sqrt(3)
SHAPES = np.array([[(1 + c[0] * p[0]) * (1 + c[1] * p[1]) / 4 for c in CORNERS] for p in POINTS])
SLOPES = np.array(
    [[(c[0] * (1 + c[1] * p[1]) / 4, c[1] * (1 + c[0] * p[0]) / 4) for c in CORNERS] for p in POINTS]
)


def mesh(across):
    """Nodes and elements, about square."""
    along = round(across * LENGTH / RADIUS)
    r, z = np.meshgrid(np.linspace(0, RADIUS, across + 1), np.linspace(0, LENGTH, along + 1))
    number = np.arange(r.size).reshape(r.shape)
    elements = np.stack((number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1]), -1)
    return np.stack((r.ravel(), z.ravel()), -1), elements.reshape(-1, 4)


def geometry(x, elements):
    """Gradients (element, point, corner, axis), radii and volumes per radian (element, point)."""
    corners = x[elements]
    jacobian = np.einsum("pcj,eci->epij", SLOPES, corners)
    determinant = jacobian[..., 0, 0] * jacobian[..., 1, 1] - jacobian[..., 0, 1] * jacobian[..., 1, 0]
    inverse = np.empty_like(jacobian)
    inverse[..., 0, 0], inverse[..., 1, 1] = jacobian[..., 1, 1], jacobian[..., 0, 0]
    inverse[..., 0, 1], inverse[..., 1, 0] = -jacobian[..., 0, 1], -jacobian[..., 1, 0]
    inverse /= determinant[..., None, None]
    gradients = np.einsum("pcj,epji->epci", SLOPES, inverse)
    radius = corners[..., 0] @ SHAPES.T
    return gradients, radius, radius * determinant


class Bar:
    def __init__(self, across):
        self.x, self.elements = mesh(across)
        self.size = RADIUS / across
        self.across = across
        self.v = np.tile((0.0, -SPEED), (len(self.x), 1))
        points = (len(self.elements), 4)
        # rr, zz, hoop, rz of the stress deviator; the pressure is one per element.
        self.deviator = np.zeros(points + (4,))
        self.pressure = np.zeros(len(self.elements))
        self.plastic_strain = np.zeros(points)
        volume = geometry(self.x, self.elements)[2]
        self.mass = self.gather(DENSITY * np.einsum("ep,pc->ec", volume, SHAPES))
        self.axis, self.wall = self.x[:, 0] == 0, self.x[:, 1] == 0
        self.hold()

    def gather(self, values):
        return np.bincount(self.elements.ravel(), values.ravel(), len(self.x))

    def hold(self):
        self.v[self.axis, 0] = 0
        self.v[self.wall, 1] = 0

    def radius_at(self, r, z):
        """Where the point (r, z) of the bar at rest is now, between the nodes of its element."""
        i, j = min(int(r / self.size), self.across - 1), int(z / self.size)
        a, b = r / self.size - i, z / self.size - j
        corners = self.x[self.elements[j * self.across + i], 0]
        return corners @ ((1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b)

    def time_step(self, volume):
        corners = self.x[self.elements]
        diagonals = np.linalg.norm(corners[:, 2:] - corners[:, :2], axis=-1).max(1)
        area = (volume / (corners[..., 0] @ SHAPES.T)).sum(1)
        return COURANT * (area / diagonals).min() / np.sqrt((BULK + 4 / 3 * SHEAR) / DENSITY)

    def step(self, remaining):
        gradients, radius, volume = geometry(self.x, self.elements)
        dt = min(self.time_step(volume), remaining)
        self.v += dt * self.force(gradients, radius, volume) / self.mass[:, None]
        self.hold()
        self.x += dt / 2 * self.v
        self.strain(dt, *geometry(self.x, self.elements))
        self.x += dt / 2 * self.v
        return dt

    def force(self, gradients, radius, volume):
        s = self.deviator
        rr, zz, hoop = np.moveaxis(s[..., :3], -1, 0) - self.pressure[:, None]
        rz = s[..., 3]
        f_r = np.einsum("epc,ep->ec", gradients[..., 0], rr * volume)
        f_r += np.einsum("epc,ep->ec", gradients[..., 1], rz * volume) + (hoop * volume / radius) @ SHAPES
        f_z = np.einsum("epc,ep->ec", gradients[..., 0], rz * volume)
        f_z += np.einsum("epc,ep->ec", gradients[..., 1], zz * volume)
        return -np.stack((self.gather(f_r), self.gather(f_z)), -1)

    def strain(self, dt, gradients, radius, volume):
        v = self.v[self.elements]
        g = dt * np.einsum("eci,epcj->epij", v, gradients)
        hoop = dt * (v[..., 0] @ SHAPES.T) / radius
        dilatation = g[..., 0, 0] + g[..., 1, 1] + hoop
        self.pressure -= BULK * (dilatation * volume).sum(1) / volume.sum(1)
        rate = np.stack((g[..., 0, 0], g[..., 1, 1], hoop, (g[..., 0, 1] + g[..., 1, 0]) / 2), -1)
        rate[..., :3] -= dilatation[..., None] / 3
        spin = (g[..., 0, 1] - g[..., 1, 0]) / 2
        s = self.deviator
        turn = spin[..., None] * np.stack(
            (2 * s[..., 3], -2 * s[..., 3], np.zeros_like(spin), s[..., 1] - s[..., 0]), -1
        )
        s = s + turn + 2 * SHEAR * rate
        equivalent = np.sqrt(1.5 * ((s[..., :3] ** 2).sum(-1) + 2 * s[..., 3] ** 2))
        excess = equivalent - YIELD - HARDENING * self.plastic_strain
        growth = np.maximum(excess, 0) / (3 * SHEAR + HARDENING)
        self.plastic_strain += growth
        self.deviator = s * (1 - 3 * SHEAR * growth / np.maximum(equivalent, YIELD))[..., None]


def impact(across):
    """At the scene's end: length, radius of the foot, largest plastic strain, and the radius of the scene's particle
    next to the foot's edge, a quarter of its cell away from wall and side."""
    bar = Bar(across)
    time = 0.0
    while time < END:
        time += bar.step(END - time)
    return {
        "length": bar.x[:, 1].max(),
        "foot_radius": bar.x[bar.wall, 0].max(),
        "particle_radius": bar.radius_at(RADIUS - CELL / 4, CELL / 4),
        "plastic_strain": bar.plastic_strain.max(),
    }


def reference(across=(2, 4, 8)):
    return {number: impact(number) for number in across}


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
