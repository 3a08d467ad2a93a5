#!/usr/bin/env python3
"""Reference of the scene `wave_transmission`: a pulse crosses the joint of two elastic bars.

The end of bar 1 moves with the velocity v0 sin^2(pi t / T) for the time T. With the impedances Z = rho c, c =
sqrt(E / rho), a pulse of velocity v passes into bar 2 as 2 Z1 / (Z1 + Z2) v and returns as (Z1 - Z2) / (Z1 +
Z2) v (Graff 1975, Wave Motion in Elastic Solids, section 2.2.2). Until the returning pulse has met the end
again, d'Alembert's waves are all of the motion.

Prints the two factors and by how much a finite difference solution differs.
"""

import json
import sys

import numpy as np

LENGTH = 10.0  # of each bar
MODULI, DENSITIES = (100.0, 100.0), (1.0, 4.0)
SPEEDS = tuple(np.sqrt(e / rho) for e, rho in zip(MODULI, DENSITIES))
DURATION = 0.4
END_TIME = 2.4


def factors():
    """Of the velocity: transmitted, reflected."""
    z1, z2 = (rho * c for rho, c in zip(DENSITIES, SPEEDS))
    return 2 * z1 / (z1 + z2), (z1 - z2) / (z1 + z2)


def pulse(t):
    return np.where((t > 0) & (t < DURATION), np.sin(np.pi * t / DURATION) ** 2, 0.0)


def velocity(x, t):
    """At the place x at the times t, for v0 = 1."""
    transmitted, reflected = factors()
    if x > LENGTH:
        return transmitted * pulse(t - LENGTH / SPEEDS[0] - (x - LENGTH) / SPEEDS[1])
    return pulse(t - x / SPEEDS[0]) + reflected * pulse(t - (2 * LENGTH - x) / SPEEDS[0])


def velocity_by_differences(places, cells):
    """By leapfrog in velocity and stress on a staggered grid; each bar has as many cells as its waves need for the
    Courant number 1, at which the scheme is exact within a bar."""
    dt = LENGTH / SPEEDS[0] / cells
    widths = np.concatenate(
        [np.full(round(LENGTH / (c * dt)), c * dt) for c in SPEEDS]
    )
    first = round(LENGTH / (SPEEDS[0] * dt))
    modulus = np.where(np.arange(widths.size) < first, *MODULI)
    mass = np.where(np.arange(widths.size) < first, *DENSITIES) * widths
    node_mass = np.zeros(widths.size + 1)
    node_mass[:-1] += mass / 2
    node_mass[1:] += mass / 2
    x = np.concatenate([[0], np.cumsum(widths)])
    v, stress = np.zeros(x.size), np.zeros(widths.size)
    probes = [int(np.argmin(np.abs(x - place))) for place in places]
    times, history = [], []
    # Velocities live at t + dt / 2, stresses at t.
    for step in range(round(END_TIME / dt)):
        force = np.zeros(x.size)
        force[:-1] += stress
        force[1:] -= stress
        v += dt * force / node_mass
        v[0] = pulse((step + 0.5) * dt)
        stress += dt * modulus * np.diff(v) / widths
        times.append((step + 0.5) * dt)
        history.append(v[probes])
    return np.array(times), np.array(history).T


def reference():
    transmitted, reflected = factors()
    places = (5.0, 15.0)
    times, histories = velocity_by_differences(places, 400)
    exact = [velocity(x, times) for x in places]
    return {
        "transmitted": transmitted,
        "reflected": reflected,
        "difference_to_finite_differences": float(np.abs(histories - exact).max()),
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
