#!/usr/bin/env python3
"""Reference of the soft cube that hangs from its top face: compliant_bar.py's block in all of space.

A cube of side 1, neo-Hookean (dissertation eq. 2.17) with E 1e6, nu 0.3, rho 1050; its top face is fixed, its sides
are free, and the gravity 1000 acts from time 0 on (de Vaucorbeil et al. 2020; dissertation section 4.2.5). A quarter of
it between two planes of symmetry; spectral finite elements of space (mass lumped at the Gauss-Lobatto points), total
Lagrangian, in explicit steps.

With --write FILE writes time and extension (mean of the lowest face) as CSV and prints the difference to a coarser mesh.
"""

import argparse

import numpy as np

from compliant_bar import DENSITY, END_TIME, GRAVITY, MODULUS, RATIO, SAMPLES, SIDE
from plane_elements import graded, lagrange, lame, lobatto_points


def line(cuts, degree):
    """Nodes along an axis, their lumped lengths, and their numbers in each element, (elements, degree + 1)."""
    points = lobatto_points(degree)
    weights = 2 / (degree * (degree + 1) * np.polynomial.legendre.Legendre.basis(degree)(points) ** 2)
    numbers = degree * np.arange(len(cuts) - 1)[:, None] + np.arange(degree + 1)
    nodes, lengths = np.zeros(numbers.max() + 1), np.zeros(numbers.max() + 1)
    for a, b, own in zip(cuts[:-1], cuts[1:], numbers):
        nodes[own] = a + (b - a) * (points + 1) / 2
        lengths[own] += (b - a) / 2 * weights
    return nodes, lengths, numbers


class Cube:
    """Elements between the cuts; integrals by the Gauss-Lobatto points, at which the nodes lie."""

    def __init__(self, across, up, degree):
        axes = [line(cuts, degree) for cuts in (across, across, up)]
        self.shape = tuple(len(nodes) for nodes, _, _ in axes)
        mass = np.einsum("i,j,k->ijk", *(lengths for _, lengths, _ in axes))
        self.volume = mass.ravel()
        self.nodes = np.stack(np.meshgrid(*(nodes for nodes, _, _ in axes), indexing="ij"), -1).reshape(-1, 3)
        index = np.arange(self.volume.size).reshape(self.shape)
        sizes, places = [], []
        for i, wide in zip(axes[0][2], np.diff(across)):
            for j, deep in zip(axes[1][2], np.diff(across)):
                for k, high in zip(axes[2][2], np.diff(up)):
                    places.append(index[np.ix_(i, j, k)])
                    sizes.append((wide, deep, high))
        self.places, self.scale = np.array(places), 2 / np.array(sizes)
        reference = lobatto_points(degree)
        self.slopes = lagrange(reference, reference)[1]
        weights = 2 / (degree * (degree + 1) * np.polynomial.legendre.Legendre.basis(degree)(reference) ** 2)
        self.weights = np.einsum("i,j,k->ijk", weights, weights, weights) / self.scale.prod(1)[:, None, None, None]
        self.gap = min(np.diff(nodes).min() for nodes, _, _ in axes)

    def forces(self, u, law):
        """Minus the internal forces of displacements (nodes, 3)."""
        local = u[self.places]
        d, scale = self.slopes, self.scale[:, None, None, None, :, None]
        gradient = np.empty(local.shape + (3,))
        gradient[..., 0] = np.einsum("ai,eijkc->eajkc", d, local)
        gradient[..., 1] = np.einsum("aj,eijkc->eiakc", d, local)
        gradient[..., 2] = np.einsum("ak,eijkc->eijac", d, local)
        gradient *= np.swapaxes(scale, -1, -2)
        stress = law(gradient + np.eye(3)) * np.swapaxes(scale, -1, -2) * self.weights[..., None, None]
        force = np.einsum("ai,eajkc->eijkc", d, stress[..., 0])
        force += np.einsum("aj,eiakc->eijkc", d, stress[..., 1])
        force += np.einsum("ak,eijac->eijkc", d, stress[..., 2])
        places = (3 * self.places[..., None] + np.arange(3)).ravel()
        return -np.bincount(places, force.ravel(), u.size).reshape(u.shape)


def neo_hookean(gradient):
    """P = mu (F - F^-T) + lambda ln(J) F^-T."""
    lam, mu = lame(MODULUS, RATIO)
    columns = [gradient[..., i] for i in range(3)]
    cofactor = np.stack([np.cross(columns[i - 2], columns[i - 1]) for i in range(3)], -1)
    volume = np.einsum("...c,...c->...", columns[0], cofactor[..., 0])[..., None, None]
    return mu * gradient + (lam * np.log(volume) - mu) / volume * cofactor


def extension_history(elements_across, elements_up, degree):
    """Mean downward displacement of the lowest face at every sample."""
    # The face x = 0 and y = 0 are planes of symmetry; elements shrink towards the clamp's edges.
    across = SIDE / 2 - graded(0, SIDE / 2, elements_across, 1.5)[::-1]
    cube = Cube(across, SIDE - graded(0, SIDE, elements_up, 1.3)[::-1], degree)
    x, y, z = cube.nodes.T
    free = np.column_stack([x > 0, y > 0, np.ones(len(x), bool)]) & (z < SIDE)[:, None]
    bottom = np.where(z == 0, cube.volume, 0)
    bottom /= bottom.sum()
    speed = np.sqrt((lame(MODULUS, RATIO)[0] + 2 * lame(MODULUS, RATIO)[1]) / DENSITY)
    steps = int(np.ceil(END_TIME / SAMPLES / (0.45 * cube.gap / speed)))
    dt = END_TIME / SAMPLES / steps
    mass = DENSITY * cube.volume[:, None]
    u, v = np.zeros_like(cube.nodes), np.zeros_like(cube.nodes)
    history = [0.0]
    # Velocities half a step later than displacements; the first kick is half a step.
    kick = dt / 2
    for _ in range(SAMPLES):
        for _ in range(steps):
            acceleration = cube.forces(u, neo_hookean) / mass
            acceleration[:, 2] -= GRAVITY
            v += kick * acceleration * free
            u += dt * v
            kick = dt
        history.append(-bottom @ u[:, 2])
    return np.array(history)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", metavar="FILE", required=True)
    arguments = parser.parse_args()
    coarse, fine = extension_history(2, 3, 4), extension_history(3, 5, 5)
    print("largest extension", fine.max(), "error", np.abs(fine - coarse).max())
    times = np.linspace(0, END_TIME, SAMPLES + 1)
    np.savetxt(arguments.write, np.column_stack([times, fine]), "%.6g", ",", header="time,extension", comments="")


if __name__ == "__main__":
    main()
