#!/usr/bin/env python3
"""Free vibration of beams with finite amplitudes: references of the dissertation's tables 10 to 12.

A beam of length L and height h, plane stress, Saint Venant-Kirchhoff's law, E 3000, rho 1, nu 0.3. Both ends are
immovable: clamped, or hinged in the mean of the edge, which may turn and warp. The frequency rises with the amplitude
since the mid-line is stretched. The beam starts straight with the velocity v W(x) across and -v (y - h/2) W'(x)
along, W being the first bending mode of Euler and Bernoulli's beam with the value 1 at mid-length, and
v = a omega sqrt(1 + alpha (a/r)^2 / 2) what Duffing's equation w'' + omega^2 (1 + alpha (w/r)^2) w = 0 asks for the
amplitude a. Shear and other modes change the amplitude that is reached: the results state it.

Spectral finite elements (mass lumped at the Gauss-Lobatto points) in explicit steps, all amplitudes of a beam at
once; Duffing's frequency, exact for the hinged beam without shear and inertia along itself (Woinowsky-Krieger 1950),
one-term Ritz otherwise; and its first two terms, 1 + 3/4 alpha (a/r)^2, in which form Evensen (1968) gives it.

With --write FILE computes all beams by two discretisations and writes nonlinear_vibration.json.
"""

import argparse
import json
import sys

import numpy as np
import scipy.special

from plane_elements import Mesh, gauss_points, lagrange, lame, plane_stress_lambda

MODULUS, RATIO, DENSITY, HEIGHT = 3000.0, 0.3, 1.0, 1.0
RADIUS = HEIGHT / np.sqrt(12)  # of gyration
LENGTHS = (4.0, 8.0)  # L/r 13.856 and 27.713
AMPLITUDES = (0.1, 0.2, 0.4, 0.6, 0.8, 1.0, 1.5)  # over the radius of gyration
LINEAR = 1e-3  # an amplitude over the radius of gyration that changes the frequency by less than 1e-6
PERIODS = 8
ENDS = {
    "simply_supported": ("mean", "mean"),
    "fixed_fixed": ("clamped", "clamped"),
    "fixed_hinged": ("clamped", "mean"),
}
# beta L of the first mode.
ROOTS = {"simply_supported": np.pi, "fixed_fixed": 4.730040744862704, "fixed_hinged": 3.926602312047919}


def mode(kind, length):
    """W(x) with the value 1 at mid-length, and W'(x), as functions of arrays."""
    root = ROOTS[kind]
    beta = root / length
    if kind == "simply_supported":
        return lambda x: np.sin(beta * x), lambda x: beta * np.cos(beta * x)
    sigma = (np.cosh(root) - np.cos(root)) / (np.sinh(root) - np.sin(root))
    shape = lambda x: np.cosh(beta * x) - np.cos(beta * x) - sigma * (np.sinh(beta * x) - np.sin(beta * x))
    slope = lambda x: beta * (np.sinh(beta * x) + np.sin(beta * x) - sigma * (np.cosh(beta * x) - np.cos(beta * x)))
    middle = shape(length / 2)
    return lambda x: shape(x) / middle, lambda x: slope(x) / middle


def euler_bernoulli(kind, length):
    """The angular frequency of the first mode."""
    return (ROOTS[kind] / length) ** 2 * RADIUS * np.sqrt(MODULUS / DENSITY)


def stretching(kind):
    """alpha = (1/2) (int W'^2)^2 / int W''^2 with W = 1 at mid-length: 1/4 for hinged ends."""
    x = np.linspace(0, 1, 200001)
    _, slope = mode(kind, 1.0)
    square = lambda f: np.trapz(f**2, x)
    return 0.5 * square(slope(x)) ** 2 / square(np.gradient(slope(x), x, edge_order=2))


def duffing(kind, amplitude):
    """(omega_NL / omega_L)^2 of Duffing's equation at an amplitude over the radius of gyration."""
    epsilon = stretching(kind) * amplitude**2
    quarter = scipy.special.ellipk(epsilon / (2 * (1 + epsilon))) / np.sqrt(1 + epsilon)
    return (np.pi / 2 / quarter) ** 2


def first_order(kind, amplitude):
    """Its first two terms."""
    return 1 + 0.75 * stretching(kind) * amplitude**2


def velocity(kind, omega, amplitude):
    """v, for an amplitude over the radius of gyration and the linear angular frequency."""
    return amplitude * RADIUS * omega * np.sqrt(1 + 0.5 * stretching(kind) * amplitude**2)


def green(xx, xy, yx, yy):
    """The first Piola-Kirchhoff stress of Saint Venant and Kirchhoff's law, row by row, from the deformation gradient's."""
    mu, lam = lame(MODULUS, RATIO)[1], plane_stress_lambda(MODULUS, RATIO)
    strain_x, strain_y = 0.5 * (xx**2 + yx**2 - 1), 0.5 * (xy**2 + yy**2 - 1)
    shear = mu * (xx * xy + yx * yy)
    trace = lam * (strain_x + strain_y)
    sx, sy = trace + 2 * mu * strain_x, trace + 2 * mu * strain_y
    return xx * sx + xy * shear, xx * shear + xy * sy, yx * sx + yy * shear, yx * shear + yy * sy


def logarithmic(xx, xy, yx, yy):
    """The same of Hooke's law between the Cauchy stress and the logarithmic strain: what linear strain increments sum up
    to where the principal directions turn with the material, as in bending."""
    mu, lam = lame(MODULUS, RATIO)[1], plane_stress_lambda(MODULUS, RATIO)
    bxx, bxy, byy = xx**2 + xy**2, xx * yx + xy * yy, yx**2 + yy**2
    mean, half = 0.5 * (bxx + byy), np.hypot(0.5 * (bxx - byy), bxy)
    # ln b = c 1 + s (b - mean 1), from its eigenvalues mean +- half.
    safe = np.where(half > 1e-9, half, 1e-9)
    s = np.arctanh(safe / mean) / safe
    c = 0.5 * np.log(mean**2 - half**2)
    ex, ey, exy = 0.5 * (c + s * (bxx - mean)), 0.5 * (c + s * (byy - mean)), 0.5 * s * bxy
    # The thickness follows from the vanishing stress across it.
    thickness = np.exp(-RATIO / (1 - RATIO) * (ex + ey))
    tx, ty, txy = (thickness * t for t in (lam * (ex + ey) + 2 * mu * ex, lam * (ex + ey) + 2 * mu * ey, 2 * mu * exy))
    return tx * yy - txy * xy, txy * xx - tx * yx, txy * yy - ty * xy, ty * xx - txy * yx


class Vibration:
    """The plane body in explicit steps."""

    def __init__(self, kind, length, columns, rows, degree, law=green):
        self.length, self.kind, self.law = length, kind, law
        self.mesh = Mesh(np.linspace(0, length, columns + 1), np.linspace(0, HEIGHT, rows + 1), degree)
        self.mass = self._lumped_mass()
        self._hold()
        gap = min(np.diff(self.mesh.axis_y).min(), np.diff(self.mesh.axis_x).min())
        self.step = 0.5 * gap / np.sqrt(MODULUS / (1 - RATIO**2) / DENSITY)
        self.middle = self._weights_of_the_middle()

    def _lumped_mass(self):
        nodes = self.mesh.reference_nodes
        p = self.mesh.degree
        weights = 2 / (p * (p + 1) * np.polynomial.legendre.Legendre.basis(p)(nodes) ** 2)

        def along(lines):
            result = np.zeros(p * (len(lines) - 1) + 1)
            for e, size in enumerate(np.diff(lines)):
                result[e * p : e * p + p + 1] += size / 2 * weights
            return result

        return DENSITY * np.outer(along(self.mesh.lines_y), along(self.mesh.lines_x)).ravel()

    def _hold(self):
        """Which nodes are clamped, and the weights of the means that are held, (means, nodes)."""
        x = self.mesh.points[:, 0]
        self.clamped = np.zeros(len(x), bool)
        means = []
        for end, place in zip(ENDS[self.kind], (0, self.length)):
            if end == "clamped":
                self.clamped |= x == place
            else:
                means.append(np.where(x == place, self.mass, 0))
        self.means = np.array(means).reshape(len(means), len(x))
        # Accelerations that the means do not allow, by Gauss's principle of least constraint.
        if means:
            compliance = self.means / self.mass
            self.release = compliance.T @ np.linalg.inv(self.means @ compliance.T)

    def _weights_of_the_middle(self):
        """Weights of the nodes for the transverse displacement at mid-length, averaged over the height."""
        mesh, x = self.mesh, self.length / 2
        i = min(np.searchsorted(mesh.lines_x, x, side="right") - 1, len(mesh.lines_x) - 2)
        a, b = mesh.lines_x[i], mesh.lines_x[i + 1]
        along, _ = lagrange(mesh.reference_nodes, np.array([2 * (x - a) / (b - a) - 1]))
        points, weights = gauss_points(mesh.degree + 1)
        across, _ = lagrange(mesh.reference_nodes, points)
        result = np.zeros((mesh.rows, mesh.columns))
        for j, height in enumerate(np.diff(mesh.lines_y)):
            rows = slice(j * mesh.degree, (j + 1) * mesh.degree + 1)
            columns = slice(i * mesh.degree, (i + 1) * mesh.degree + 1)
            result[rows, columns] += np.outer(height / 2 * weights @ across, along[0])
        return result.ravel() / HEIGHT

    def _constrain(self, vectors):
        """Takes from velocities or accelerations (amplitudes, nodes, 2) what the supports do not allow."""
        vectors[:, self.clamped] = 0
        if len(self.means):
            vectors -= self.release @ (self.means @ vectors)
        return vectors

    def _force(self, u):
        """Minus the internal forces of displacements (amplitudes, nodes, 2)."""
        mesh = self.mesh
        gradients = mesh._gradient_matrix
        count, nodes = len(u), u.shape[1]
        h = np.swapaxes(u[:, mesh.elements], -1, -2) @ gradients
        h = h.reshape(h.shape[:3] + (-1, 2))
        xx, xy, yx, yy = 1 + h[..., 0, :, 0], h[..., 0, :, 1], h[..., 1, :, 0], 1 + h[..., 1, :, 1]
        stress = np.empty_like(h)
        parts = self.law(xx, xy, yx, yy)
        for (i, j), part in zip(np.ndindex(2, 2), parts):
            stress[..., i, :, j] = part * mesh.weights
        nodal = gradients @ np.swapaxes(stress.reshape(h.shape[:3] + (-1,)), -1, -2)
        first = 2 * nodes * np.arange(count)[:, None, None]
        places = first + mesh.element_unknowns
        return -np.bincount(places.ravel(), nodal.ravel(), 2 * nodes * count).reshape(u.shape)

    def run(self, velocities, duration):
        """Times and the transverse displacement at mid-length for each of the velocities at mid-length."""
        shape, slope = mode(self.kind, self.length)
        x, y = self.mesh.points.T
        start = np.column_stack([-(y - HEIGHT / 2) * slope(x), shape(x)])
        v = self._constrain(np.multiply.outer(np.asarray(velocities, float), start))
        u = np.zeros_like(v)
        steps = int(np.ceil(duration / self.step))
        histories = np.zeros((len(velocities), steps + 1))
        v_held = self.mass[:, None]
        for step in range(1, steps + 1):
            u += self.step * v
            v += self.step * self._constrain(self._force(u) / v_held)
            histories[:, step] = u[..., 1] @ self.middle
        return self.step * np.arange(steps + 1), histories


def frequency_and_amplitude(time, value, periods=PERIODS):
    """Over the first `periods` periods, from one upward zero to another: their mean frequency, and the mean of half
    the distances of their extremes."""
    up = np.flatnonzero((value[:-1] <= 0) & (value[1:] > 0))[: periods + 1]
    assert len(up) == periods + 1, "the history is too short"
    zeros = time[up] - value[up] * (time[up + 1] - time[up]) / (value[up + 1] - value[up])
    parts = [value[a : b + 1] for a, b in zip(up[:-1], up[1:])]
    amplitude = np.mean([0.5 * (part.max() - part.min()) for part in parts])
    return periods / (zeros[-1] - zeros[0]), amplitude


def vibrations(kind, length, degree, amplitudes=AMPLITUDES, law=green):
    """The linear frequency (Hz), and for each amplitude: v, (omega_NL / omega_L)^2, the amplitude reached over r."""
    body = Vibration(kind, length, int(length), 1, degree, law)
    guess = euler_bernoulli(kind, length) / (2 * np.pi)
    # The frequencies of thick beams are up to 35 % below Euler and Bernoulli's.
    duration = (PERIODS + 0.1) / guess / 0.6
    time, history = body.run([LINEAR * RADIUS], duration)
    linear, _ = frequency_and_amplitude(time, history[0])
    speeds = [velocity(kind, 2 * np.pi * linear, a) for a in amplitudes]
    time, histories = body.run(speeds, (PERIODS + 0.1) / linear)
    rows = []
    for amplitude, speed, history in zip(amplitudes, speeds, histories):
        frequency, reached = frequency_and_amplitude(time, history)
        rows.append({"amplitude": amplitude, "velocity": speed, "ratio": (frequency / linear) ** 2})
        rows[-1]["reached"] = reached / RADIUS
    return {"linear_frequency": linear, "rows": rows}


def converged(kind, length, law=green):
    """Vibrations at degree 5; errors are the differences to degree 4."""
    fine, coarse = (vibrations(kind, length, degree, law=law) for degree in (5, 4))
    fine["linear_frequency_error"] = abs(fine["linear_frequency"] - coarse["linear_frequency"])
    for row, other in zip(fine["rows"], coarse["rows"]):
        row["ratio_error"] = abs(row["ratio"] - other["ratio"])
        row["duffing"] = duffing(kind, row["reached"])
        print(kind, length, row, file=sys.stderr)
    return fine


def reference():
    """All beams, and one of them by linear strain increments (table 14)."""
    result = {f"{kind} {length:g}": converged(kind, length) for kind in ENDS for length in LENGTHS}
    return result | {"simply_supported 8 logarithmic": converged("simply_supported", 8.0, logarithmic)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", metavar="FILE", required=True)
    arguments = parser.parse_args()
    with open(arguments.write, "w") as file:
        json.dump(reference(), file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main()
