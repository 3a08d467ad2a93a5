"""Beams as plane bodies, linear, by high-order finite elements: equilibria, bending modes and forced vibration.

A beam of length L and height 1, plane stress, E 3000, nu 0.3, rho 1. An end is
  free;
  clamped   both displacements held over the whole edge;
  axial     the displacement along the beam held over the whole edge, across it the mean over the edge;
  hinged    the transverse displacement held over the whole edge, which may move along the beam;
  mean      the mean of the transverse displacement over the edge held: its reaction is a uniform traction;
  patch     the transverse displacement held over the middle quarter of the edge.
"""

from functools import cached_property

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl

from plane_elements import Mesh, gauss_points, graded_to_both_ends, lagrange, lame, plane_stress_lambda
from plane_elements import saint_venant_kirchhoff

MODULUS, RATIO, DENSITY, HEIGHT = 3000.0, 0.3, 1.0, 1.0
PATCH = HEIGHT / 4
# Elements along the beam and over its height, and their degree.
LEVELS = ((12, 6, 3), (16, 8, 4), (20, 10, 4), (24, 12, 6))


def lines_over_height(ends, rows):
    """Element boundaries, finer towards the corners and towards the ends of a patch."""
    if "patch" not in ends:
        return graded_to_both_ends(0, HEIGHT, rows, 1.4)
    parts = np.array([0, HEIGHT / 2 - PATCH / 2, HEIGHT / 2 + PATCH / 2, HEIGHT])
    count = rows // 4 * 2
    return np.unique(np.concatenate([graded_to_both_ends(a, b, count, 2.0) for a, b in zip(parts, parts[1:])]))


class Beam:
    """A beam on two ends. Displacements have the shape (nodes, 2), forces (unknowns,)."""

    def __init__(self, ends, length=8.0, level=LEVELS[2]):
        columns, rows, degree = level
        # Elements shrink towards the ends, where the stress is singular.
        self.mesh = Mesh(graded_to_both_ends(0, length, columns, 1.4), lines_over_height(ends, rows), degree)
        self.length = length
        self._motions = self._admissible(ends)

    @cached_property
    def _edge_weights(self):
        """Weights of the rows of nodes in the mean over a cross-section."""
        mesh = self.mesh
        points, weights = gauss_points(mesh.degree + 1)
        values, _ = lagrange(mesh.reference_nodes, points)
        mean = np.zeros(mesh.rows)
        for j, width in enumerate(np.diff(mesh.lines_y)):
            mean[j * mesh.degree : (j + 1) * mesh.degree + 1] += width / 2 * weights @ values
        return mean / HEIGHT

    def _admissible(self, ends):
        """The sparse matrix whose columns span the motions that the ends allow, (unknowns, free unknowns)."""
        mesh = self.mesh
        held = np.zeros((len(mesh.points), 2), bool)
        combination = sp.eye(mesh.unknowns, format="lil")
        if not {"clamped", "axial"} & set(ends):
            # Nothing resists a motion along the beam; bending does not move the mid-line's end.
            held[(mesh.points[:, 0] == 0) & (np.abs(mesh.points[:, 1] - HEIGHT / 2) < 1e-12), 0] = True
        for end, x in zip(ends, (0, self.length)):
            edge = np.flatnonzero(mesh.points[:, 0] == x)
            held[edge, 0] |= end in ("clamped", "axial")
            held[edge, 1] |= end in ("clamped", "hinged")
            if end == "patch":
                held[edge[np.abs(mesh.points[edge, 1] - HEIGHT / 2) <= PATCH / 2 + 1e-12], 1] = True
            if end in ("mean", "axial"):
                weights = self._edge_weights
                slave = weights.argmax()  # moves so that the mean stays
                held[edge[slave], 1] = True
                for row in np.delete(np.arange(mesh.rows), slave):
                    combination[2 * edge[slave] + 1, 2 * edge[row] + 1] = -weights[row] / weights[slave]
        return combination.tocsc()[:, mesh.free_unknowns(held)]

    @cached_property
    def _stiffness(self):
        law = saint_venant_kirchhoff(plane_stress_lambda(MODULUS, RATIO), lame(MODULUS, RATIO)[1])
        tangent = self.mesh.stiffness(np.zeros((len(self.mesh.points), 2)), law)
        return (self._motions.T @ tangent @ self._motions).tocsc()

    @cached_property
    def _mass(self):
        return (self._motions.T @ self.mesh.mass(DENSITY) @ self._motions).tocsc()

    def end_shear(self, load):
        """The nodal forces of a load across the right end, distributed as the parabola of beam theory."""
        return self.mesh.right_edge_load(lambda y: np.stack([0 * y, 6 * load / HEIGHT**3 * y * (HEIGHT - y)], -1))

    def top_load(self, load):
        """The nodal forces of a load per length on the upper edge, across the beam."""
        mesh = self.mesh
        points, weights = gauss_points(mesh.degree + 1)
        values, _ = lagrange(mesh.reference_nodes, points)
        force = np.zeros((mesh.rows, mesh.columns, 2))
        for i, width in enumerate(np.diff(mesh.lines_x)):
            force[-1, i * mesh.degree : (i + 1) * mesh.degree + 1, 1] += load * width / 2 * weights @ values
        return force.ravel()

    def body_load(self, load):
        """The nodal forces of a load per length, distributed over the cross-section, across the beam."""
        return self.mesh.body_load(DENSITY, (0, load / (DENSITY * HEIGHT)))

    def vibration(self, force, angular_frequency):
        """The displacement's amplitude under a force that varies as a sine."""
        system = self._stiffness - angular_frequency**2 * self._mass
        return (self._motions @ spl.spsolve(system.tocsc(), self._motions.T @ force)).reshape(-1, 2)

    def equilibrium(self, force):
        """The displacement under a force."""
        return self.vibration(force, 0)

    def modes(self, count, above):
        """Bending modes with angular frequencies above `above`, in order: angular frequencies (count,) and displacements
        (count, nodes, 2) of unit modal mass."""
        values, vectors = spl.eigsh(self._stiffness, k=count + 4, M=self._mass, sigma=above**2, which="LM")
        shapes = np.array([(self._motions @ vector).reshape(-1, 2) for vector in vectors.T])
        sections = np.abs([self.section_means(shape) for shape in shapes]).max(axis=1)
        # Bending moves cross-sections across, stretching along.
        bends = (values > above**2) & (sections[:, 1] > sections[:, 0])
        order = [mode for mode in np.argsort(values) if bends[mode]][:count]
        return np.sqrt(values[order]), shapes[order]

    def free_motion(self, velocity, times, count, above):
        """Mean displacements over the cross-sections after a start from rest's place with a velocity (nodes, 2), by `count`
        bending modes: (times, columns, 2)."""
        angular, shapes = self.modes(count, above)
        momentum = self.mesh.mass(DENSITY) @ velocity.ravel()
        amplitudes = shapes.reshape(len(shapes), -1) @ momentum / angular
        means = np.array([self.section_means(shape) for shape in shapes])
        return np.einsum("tm,mxi->txi", np.sin(np.outer(times, angular)) * amplitudes, means)

    def section_means(self, displacement):
        """The mean displacement over the cross-sections at mesh.axis_x, (columns, 2)."""
        field = displacement.reshape(self.mesh.rows, self.mesh.columns, 2)
        return np.einsum("y,yxi->xi", self._edge_weights, field)
