#!/usr/bin/env python3
"""Reference of the scene `oblique_discs`: two equal elastic discs collide obliquely, with friction that slides.

What one disc does the other does turned by half a turn, and their tangential tractions, friction times pressure as
long as they slide, deform both alike: they meet on a plane through the middle, across the line between their centres.
One disc against that plane, which turns with its centre, is therefore enough: explicit finite elements with bilinear
quadrilaterals, lumped masses, the finite law of the scene, and nodes of the rim that are put back onto the plane by
impulses, with friction times as much along it.

Of rigid discs that slide throughout (Maw, Barber & Fawcett 1976 give the regimes) follow, with the coefficient of
restitution e and the impulse J = (1 + e) v per mass, the change of the tangential velocity -mu J and the spin
2 mu J / R. The elements say what e is, since some energy stays as vibration, and by how much the plane turns meanwhile.
"""

import json
import sys

import numpy as np

import plane_elements

RADIUS, MODULUS, RATIO, DENSITY = 1.0, 1000.0, 0.3, 1.0
NORMAL, TANGENTIAL, FRICTION = 0.5, 0.75, 0.15  # speeds of each disc towards the other one, and across
CORNERS = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])


def disc_mesh(cells):
    """A square of cells by cells, bent into the disc (Shirley & Chiu 1997): points and quadrilaterals."""
    side = np.linspace(-1, 1, cells + 1)
    y, x = np.meshgrid(side, side, indexing="ij")
    larger = np.maximum(np.abs(x), np.abs(y))
    wide = np.abs(x) >= np.abs(y)
    with np.errstate(divide="ignore", invalid="ignore"):
        angle = np.where(wide, np.pi / 4 * y / x, np.pi / 2 - np.pi / 4 * x / y)
    radius = np.where(wide, x, y)
    angle[larger == 0] = 0
    points = RADIUS * np.stack([radius * np.cos(angle), radius * np.sin(angle)], -1).reshape(-1, 2)
    first = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    return points, np.column_stack([first, first + 1, first + cells + 2, first + cells + 1])


class Disc:
    def __init__(self, cells):
        # The square's corners, where elements are flat, must not be where the disc touches: below is the middle of a side.
        self.points, self.elements = disc_mesh(cells)
        gauss = CORNERS / np.sqrt(3)
        slopes = 0.25 * np.stack(
            [
                CORNERS[:, 0] * (1 + gauss[:, 1, None] * CORNERS[:, 1]),
                CORNERS[:, 1] * (1 + gauss[:, 0, None] * CORNERS[:, 0]),
            ],
            -1,
        )
        jacobian = np.einsum("eai,qaj->eqij", self.points[self.elements], slopes)
        self.weights = np.linalg.det(jacobian)
        self.gradients = np.einsum("qaj,eqji->eqai", slopes, np.linalg.inv(jacobian))
        share = 0.25 * DENSITY * self.weights.sum(1)
        self.mass = np.bincount(self.elements.ravel(), np.repeat(share, 4), len(self.points))
        self.law = plane_elements.neo_hookean(*plane_elements.lame(MODULUS, RATIO))
        lam, mu = plane_elements.lame(MODULUS, RATIO)
        size = np.sqrt(self.weights.min() * 4)
        self.step = 0.3 * size / np.sqrt((lam + 2 * mu) / DENSITY)

    def force(self, displacement):
        u = displacement[self.elements]
        gradient = np.eye(2) + np.einsum("eai,eqaj->eqij", u, self.gradients)
        stress = self.law(gradient) * self.weights[..., None, None]
        nodal = np.einsum("eqij,eqaj->eai", stress, self.gradients)
        return np.stack([np.bincount(self.elements.ravel(), nodal[..., i].ravel(), len(self.points)) for i in (0, 1)], 1)

    def motion(self, position, velocity):
        """Velocity of the centre of mass, and spin."""
        total = self.mass.sum()
        centre, mean = self.mass @ position / total, self.mass @ velocity / total
        arm, relative = position - centre, velocity - mean
        inertia = self.mass @ (arm**2).sum(1)
        return mean, self.mass @ (arm[:, 0] * relative[:, 1] - arm[:, 1] * relative[:, 0]) / inertia


def collide(cells, friction, end=0.4):
    """The disc above the other one, from when they touch: velocity of its centre of mass, spin at the end."""
    disc = Disc(cells)
    points = disc.points + [0, RADIUS]
    velocity = np.tile([TANGENTIAL, -NORMAL], (len(points), 1))
    position = points.copy()
    slides = True
    for _ in range(int(np.ceil(end / disc.step))):
        velocity -= disc.step * disc.force(position - points) / disc.mass[:, None]
        normal = disc.mass @ position / np.linalg.norm(disc.mass @ position)
        along = np.array([normal[1], -normal[0]])
        # Onto the plane at the end of the step.
        below = np.flatnonzero((position + disc.step * velocity) @ normal < 0)
        push = -(position[below] / disc.step + velocity[below]) @ normal
        slides &= bool((velocity[below] @ along > friction * push).all())
        velocity[below] += push[:, None] * (normal - friction * along)
        position += disc.step * velocity
    if not slides:
        raise RuntimeError("the discs stick somewhere")
    mean, spin = disc.motion(position, velocity)
    return {"x": mean[0], "y": mean[1], "spin": spin}


def rigid(restitution, friction):
    """The same of discs that touch for no time."""
    impulse = (1 + restitution) * NORMAL
    return {"x": TANGENTIAL - friction * impulse, "y": restitution * NORMAL, "spin": 2 * friction * impulse / RADIUS}


def reference(cells=32):
    result = {"smooth": collide(cells, 0.0), "rough": collide(cells, FRICTION)}
    coarse = collide(cells // 2, FRICTION)
    # Of second order in the elements.
    result["error"] = max(abs(coarse[key] - value) / 3 for key, value in result["rough"].items())
    return result


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
