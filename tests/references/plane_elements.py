"""High-order finite elements for plane elasticity on rectangles: the references' own discretisation.

It shares nothing with the solver under test: Lagrange polynomials of degree p on Gauss-Lobatto-Legendre
points, total Lagrangian, full Gauss quadrature, sparse direct solves. Displacements are arrays (nodes, 2)
and degrees of freedom are numbered 2 * node + component.
"""

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as spl


def lobatto_points(degree):
    """The degree + 1 Gauss-Lobatto-Legendre points on [-1, 1]."""
    inner = np.polynomial.legendre.Legendre.basis(degree).deriv().roots()
    return np.concatenate([[-1.0], np.sort(inner.real), [1.0]])


def lagrange(nodes, x):
    """Values and derivatives of the Lagrange polynomials of `nodes` at `x`: two arrays (x.size, nodes.size)."""
    vander = np.polynomial.legendre.legvander(nodes, nodes.size - 1)
    coefficients = np.linalg.inv(vander)
    derivative = np.polynomial.legendre.legder(np.eye(nodes.size))
    values = np.polynomial.legendre.legvander(x, nodes.size - 1) @ coefficients
    slopes = np.polynomial.legendre.legvander(x, nodes.size - 2) @ derivative @ coefficients
    return values, slopes


def gauss_points(count):
    """Points and weights of Gauss quadrature on [-1, 1]."""
    return np.polynomial.legendre.leggauss(count)


def graded(start, end, count, ratio):
    """`count` intervals of [start, end]; each is `ratio` times as long as the one before."""
    lengths = ratio ** np.arange(count)
    return start + (end - start) * np.concatenate([[0.0], np.cumsum(lengths)]) / lengths.sum()


def graded_to_both_ends(start, end, count, ratio):
    """`count` (even) intervals of [start, end], each `ratio` times as long as its neighbour nearer to an end."""
    middle = 0.5 * (start + end)
    half = graded(start, middle, count // 2, ratio)
    return np.concatenate([half, (start + end - half)[::-1][1:]])


class Mesh:
    """A rectangle cut along the given lines, with elements of one degree and unit thickness."""

    def __init__(self, lines_x, lines_y, degree):
        self.degree = degree
        self.reference_nodes = lobatto_points(degree)
        self.lines_x, self.lines_y = np.asarray(lines_x, float), np.asarray(lines_y, float)
        self.axis_x = self._axis(self.lines_x, self.reference_nodes)
        self.axis_y = self._axis(self.lines_y, self.reference_nodes)
        self.columns, self.rows = self.axis_x.size, self.axis_y.size
        grid_y, grid_x = np.meshgrid(self.axis_y, self.axis_x, indexing="ij")
        self.points = np.column_stack([grid_x.ravel(), grid_y.ravel()])
        self.unknowns = 2 * len(self.points)
        self._connect()
        self._quadrature()

    @staticmethod
    def _axis(lines, reference):
        parts = [lines[:1]]
        for a, b in zip(lines[:-1], lines[1:]):
            parts.append(a + (b - a) * (reference[1:] + 1) / 2)
        return np.concatenate(parts)

    def _connect(self):
        p = self.degree
        local = np.arange(p + 1)
        self.elements = np.array(
            [
                ((j * p + local)[:, None] * self.columns + (i * p + local)[None, :]).ravel()
                for j in range(len(self.lines_y) - 1)
                for i in range(len(self.lines_x) - 1)
            ]
        )
        dof = np.stack([2 * self.elements, 2 * self.elements + 1], axis=-1)
        self.element_unknowns = dof.reshape(len(self.elements), -1)

    def _quadrature(self):
        points, weights = gauss_points(self.degree + 1)
        values, slopes = lagrange(self.reference_nodes, points)
        n = self.degree + 1
        shape = lambda along_y, along_x: np.einsum("qb,ra->qrba", along_y, along_x).reshape(n * n, n * n)
        self.values = shape(values, values)
        by_xi, by_eta = shape(values, slopes), shape(slopes, values)
        width_x, width_y = np.diff(self.lines_x), np.diff(self.lines_y)
        size_y, size_x = (g.ravel() for g in np.meshgrid(width_y, width_x, indexing="ij"))
        # gradients: (elements, quadrature points, element nodes, 2); weights: (elements, quadrature points)
        self.gradients = np.stack(
            [by_xi[None] * (2 / size_x)[:, None, None], by_eta[None] * (2 / size_y)[:, None, None]], axis=-1
        )
        self.weights = np.outer(size_x * size_y / 4, np.outer(weights, weights).ravel())
        # The same gradients as one matrix for each element, (element nodes, quadrature points * 2).
        self._gradient_matrix = np.swapaxes(self.gradients, 1, 2).reshape(len(self.elements), n * n, -1)

    def assemble(self, blocks):
        """Sums element matrices (elements, m, m) into one sparse matrix."""
        m = self.element_unknowns.shape[1]
        rows = np.repeat(self.element_unknowns, m, axis=1).ravel()
        columns = np.tile(self.element_unknowns, (1, m)).ravel()
        return sp.csc_matrix((blocks.ravel(), (rows, columns)), shape=(self.unknowns, self.unknowns))

    def mass(self, density):
        """The consistent mass matrix."""
        scalar = density * np.einsum("eq,qa,qb->eab", self.weights, self.values, self.values)
        nodes = scalar.shape[1]
        blocks = np.einsum("eab,ij->eaibj", scalar, np.eye(2)).reshape(-1, 2 * nodes, 2 * nodes)
        return self.assemble(blocks)

    def body_load(self, density, acceleration):
        """The consistent nodal forces of a uniform force per mass."""
        nodal = density * np.einsum("eq,qa,i->eai", self.weights, self.values, np.asarray(acceleration, float))
        return self._sum(nodal)

    def right_edge_load(self, traction):
        """The nodal forces of a traction on the edge at the largest x; `traction(y)` gives (n, 2)."""
        points, weights = gauss_points(self.degree + 3)
        values, _ = lagrange(self.reference_nodes, points)
        force = np.zeros((len(self.points), 2))
        for j, (a, b) in enumerate(zip(self.lines_y[:-1], self.lines_y[1:])):
            t = traction(a + (b - a) * (points + 1) / 2)
            rows = j * self.degree + np.arange(self.degree + 1)
            force[rows * self.columns + self.columns - 1] += (b - a) / 2 * np.einsum("q,qa,qi->ai", weights, values, t)
        return force.ravel()

    def _sum(self, nodal):
        return np.bincount(self.element_unknowns.ravel(), nodal.ravel(), self.unknowns)

    def deformation_gradient(self, displacement):
        """F at the quadrature points: (elements, quadrature points, 2, 2)."""
        u = np.swapaxes(displacement[self.elements], 1, 2)
        gradient = (u @ self._gradient_matrix).reshape(len(u), 2, -1, 2)
        return np.eye(2) + np.swapaxes(gradient, 1, 2)

    def internal_force(self, displacement, law):
        """The nodal forces of the first Piola-Kirchhoff stress law(F)."""
        stress = law(self.deformation_gradient(displacement)) * self.weights[..., None, None]
        stress = np.swapaxes(stress, 1, 2).reshape(len(stress), 2, -1)
        return self._sum(self._gradient_matrix @ np.swapaxes(stress, 1, 2))

    def stiffness(self, displacement, law):
        """The tangent of the internal force."""
        return self.stiffness_of(tangent_of(law, self.deformation_gradient(displacement)))

    def stiffness_of(self, tangent):
        """The tangent of the internal force from those dP_ij / dF_kl at the quadrature points."""
        m = 2 * self.elements.shape[1]
        half = np.einsum("eq,eqijkl,eqbl->eqijbk", self.weights, tangent, self.gradients, optimize=True)
        return self.assemble(np.einsum("eqaj,eqijbk->eaibk", self.gradients, half, optimize=True).reshape(-1, m, m))

    def free_unknowns(self, held):
        """The unknowns that are not in the boolean array `held` of shape (nodes, 2)."""
        return np.flatnonzero(~np.asarray(held).ravel())

    def along_y(self, displacement, x):
        """Displacement at the mesh's heights on the vertical line at x: heights and (rows, 2)."""
        field = displacement.reshape(self.rows, self.columns, 2)
        i = min(np.searchsorted(self.lines_x, x, side="right") - 1, len(self.lines_x) - 2)
        a, b = self.lines_x[i], self.lines_x[i + 1]
        values, _ = lagrange(self.reference_nodes, np.array([2 * (x - a) / (b - a) - 1]))
        part = field[:, i * self.degree : (i + 1) * self.degree + 1]
        return self.axis_y, np.einsum("a,yai->yi", values[0], part)

    def mean_along_y(self, displacement, x):
        """The mean displacement over the vertical line at x."""
        _, line = self.along_y(displacement, x)
        points, weights = gauss_points(self.degree + 1)
        values, _ = lagrange(self.reference_nodes, points)
        mean = np.zeros(2)
        for j, (a, b) in enumerate(zip(self.lines_y[:-1], self.lines_y[1:])):
            part = line[j * self.degree : (j + 1) * self.degree + 1]
            mean += (b - a) / 2 * np.einsum("q,qa,ai->i", weights, values, part)
        return mean / (self.lines_y[-1] - self.lines_y[0])


class Quadrilateral(Mesh):
    """A mesh of the unit square, mapped to a quadrilateral with upright sides: from x = 0 to `width`, from `left` = (lower,
    upper) to `right`. `points` and lines stay those of the unit square."""

    def __init__(self, lines_s, lines_t, degree, width, left, right):
        self.width, self.left, self.right = width, np.asarray(left, float), np.asarray(right, float)
        super().__init__(lines_s, lines_t, degree)

    def _quadrature(self):
        super()._quadrature()
        place = np.einsum("qa,eai->eqi", self.values, self.points[self.elements])
        lower, upper = ((1 - place[..., 0]) * a + place[..., 0] * b for a, b in zip(self.left, self.right))
        slopes = self.right - self.left
        skew = (1 - place[..., 1]) * slopes[0] + place[..., 1] * slopes[1]
        height = upper - lower
        by_s, by_t = self.gradients[..., 0], self.gradients[..., 1]
        by_x = by_s / self.width - by_t * (skew / (self.width * height))[..., None]
        self.gradients = np.stack([by_x, by_t / height[..., None]], axis=-1)
        self.weights = self.weights * self.width * height
        self._gradient_matrix = np.swapaxes(self.gradients, 1, 2).reshape(len(self.elements), self.values.shape[1], -1)


def tangent_of(law, gradient, step=1e-6):
    """dP_ij / dF_kl of law P(F) by central differences (error about 1e-10 relative; Newton needs less)."""
    tangent = np.zeros(gradient.shape + (2, 2))
    for k in range(2):
        for l in range(2):
            shift = np.zeros((2, 2))
            shift[k, l] = step
            tangent[..., k, l] = (law(gradient + shift) - law(gradient - shift)) / (2 * step)
    return tangent


def solve_static(mesh, law, force, held, steps=4, tolerance=1e-11, start=None):
    """The equilibrium under dead nodal forces, reached in load steps by Newton's method, from rest or from `start`."""
    free = mesh.free_unknowns(held)
    u = np.zeros((len(mesh.points), 2)) if start is None else start.copy()
    for step in range(1, steps + 1):
        for _ in range(30):
            residual = (step / steps * force - mesh.internal_force(u, law))[free]
            correction = np.zeros(mesh.unknowns)
            correction[free] = spl.spsolve(mesh.stiffness(u, law)[free][:, free], residual)
            u += correction.reshape(-1, 2)
            if np.abs(correction).max() <= tolerance * np.abs(u).max():
                break
        else:
            raise RuntimeError("Newton's method did not converge")
    return u


def solve_neo_hookean(mesh, lam, mu, force, held, steps=4, tolerance=1e-9):
    """The equilibrium of a neo-Hookean body, nearly incompressible ones too: `solve_static` with the pressure
    lambda ln(J) of tangents for an unknown of its own at each quadrature point, for which Newton's method goes on to
    where it would be if J were linear, so that volume ratios of large steps on the way do not spoil tangents (mixed
    integration points: Magisano, Leonetti and Garcea 2017). The equilibria are the same."""
    free = mesh.free_unknowns(held)
    law = neo_hookean(lam, mu)
    u = np.zeros((len(mesh.points), 2))
    pressure = np.zeros(mesh.weights.shape)
    for step in range(1, steps + 1):
        for _ in range(40):
            gradient = mesh.deformation_gradient(u)
            det, g = invariants(gradient)
            tangent = mu * np.einsum("ik,jl->ijkl", np.eye(2), np.eye(2)) + lam * np.einsum("eqij,eqkl->eqijkl", g, g)
            tangent += np.einsum("eq,eqil,eqkj->eqijkl", mu - pressure, g, g)
            residual = (step / steps * force - mesh.internal_force(u, law))[free]
            correction = np.zeros(mesh.unknowns)
            correction[free] = spl.spsolve(mesh.stiffness_of(tangent)[free][:, free], residual)
            u += correction.reshape(-1, 2)
            change = mesh.deformation_gradient(u) - gradient
            pressure = lam * (np.log(det) + np.einsum("eqij,eqij->eq", g, change))
            if np.abs(correction).max() <= tolerance * np.abs(u).max():
                break
        else:
            raise RuntimeError("Newton's method did not converge")
    return u


def solve_linear(mesh, law, force, held):
    """The solution of the problem linearised at rest."""
    free = mesh.free_unknowns(held)
    u = np.zeros(mesh.unknowns)
    rest = np.zeros((len(mesh.points), 2))
    u[free] = spl.spsolve(mesh.stiffness(rest, law)[free][:, free], force[free])
    return u.reshape(-1, 2)


def lame(youngs_modulus, poissons_ratio):
    """Lame's constants lambda and mu."""
    shear = youngs_modulus / (2 * (1 + poissons_ratio))
    return 2 * shear * poissons_ratio / (1 - 2 * poissons_ratio), shear


def plane_stress_lambda(youngs_modulus, poissons_ratio):
    """The constant that takes lambda's place in Hooke's law for plane stress."""
    return youngs_modulus * poissons_ratio / (1 - poissons_ratio**2)


def invariants(gradient):
    """det F and F^-T of 2 by 2 matrices."""
    a, b, c, d = gradient[..., 0, 0], gradient[..., 0, 1], gradient[..., 1, 0], gradient[..., 1, 1]
    det = a * d - b * c
    inverse_transposed = np.stack([np.stack([d, -c], -1), np.stack([-b, a], -1)], -2) / det[..., None, None]
    return det, inverse_transposed


def neo_hookean(lam, mu):
    """P = mu (F - F^-T) + lambda ln(J) F^-T in plane strain (Belytschko et al. 2014, section 5.4)."""

    def law(gradient):
        det, inverse_transposed = invariants(gradient)
        return mu * (gradient - inverse_transposed) + lam * np.log(det)[..., None, None] * inverse_transposed

    return law


def saint_venant_kirchhoff(lam, mu):
    """P = F S with S = lambda tr(E) I + 2 mu E, E = (F^T F - I) / 2."""

    def law(gradient):
        strain = 0.5 * (np.swapaxes(gradient, -1, -2) @ gradient - np.eye(2))
        trace = np.trace(strain, axis1=-2, axis2=-1)[..., None, None]
        return gradient @ (lam * trace * np.eye(2) + 2 * mu * strain)

    return law


def hencky(lam, mu):
    """Hooke's law between the Kirchhoff stress and the logarithmic strain ln(F F^T) / 2."""

    def law(gradient):
        _, inverse_transposed = invariants(gradient)
        values, vectors = np.linalg.eigh(gradient @ np.swapaxes(gradient, -1, -2))
        logs = 0.5 * np.log(values)
        principal = lam * logs.sum(-1, keepdims=True) + 2 * mu * logs
        kirchhoff = np.einsum("...ik,...k,...jk->...ij", vectors, principal, vectors)
        return kirchhoff @ inverse_transposed

    return law
