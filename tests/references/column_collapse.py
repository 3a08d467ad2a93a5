#!/usr/bin/env python3
"""Reference of the scene `dam_break`: how the front of a collapsing column of water moves.

Of water without viscosity: potential flow in the plane, whose free surface is followed in time (Longuet-Higgins &
Cokelet 1976, Proc. R. Soc. Lond. A 350, 1-26) with sources a little outside of it (Cao, Schultz & Beck 1991, Int. J.
Numer. Meth. Fluids 12, 785-803) that are mirrored at wall and floor. It shares nothing with the solver. With 40, 56 and
80 nodes Z(4) = 5.751, 5.760, 5.770.

Measured by Martin & Moyce (1952, Phil. Trans. R. Soc. Lond. A 244, 312-324), rectangular section, height 2 a:
Z = z / a over T = t sqrt(2 g / a). The values are those of their figure 3 for a = 2.25 inches as digitised in
PySPH (pysph.examples.db_exp_data). The measured front is behind the one without viscosity from the beginning on: where
it is first seen, at Z = 1.22, by 0.27 in T, which the dam takes to go, and later by the friction of a front that
is some millimetres thin. Of that delay the speed of the front knows nothing.

Ritter's (1892) front of a dam of infinite length runs at 2 sqrt(g H) and bounds the speed: dZ/dT <= 2.
Prints fronts at the scene's times and the speeds between them.
"""

import json
import sys

import numpy as np
from scipy.interpolate import PchipInterpolator

# T, Z.
MEASURED = np.array(
    [
        (0.832, 1.217),
        (1.219, 1.474),
        (1.997, 2.292),
        (2.547, 2.995),
        (3.345, 4.134),
        (4.034, 4.944),
        (4.418, 5.881),
        (5.091, 6.980),
        (5.685, 7.945),
        (6.306, 8.966),
    ]
)
# The smaller column, a = 1.125 inches: how well experiments repeat.
MEASURED_SMALL = np.array(
    [
        (0.849, 1.245),
        (1.212, 1.443),
        (1.602, 1.884),
        (2.283, 2.689),
        (2.950, 3.728),
        (3.598, 4.528),
        (3.905, 4.999),
        (4.592, 5.841),
        (4.961, 6.271),
        (5.316, 6.717),
    ]
)


# How nodes lie on the free surface: as dense as the water is deep there, and this much.
LEAST_DEPTH = 0.05
MIRRORS = ((1, 1), (-1, 1), (1, -1), (-1, -1))


def mirrored(values, at_floor, at_wall, count):
    """Values along the surface and beyond its ends at floor and wall, where they are even (1) or odd (-1)."""
    return np.concatenate((at_floor * values[count:0:-1], values, at_wall * values[-2 : -2 - count : -1]))


def slopes(surface, potential):
    """Velocities of the nodes and rates of the potential there, in units of a and g."""
    x, y = (mirrored(surface[:, i], *signs, 1) for i, signs in enumerate(((1, -1), (-1, 1))))
    along = np.stack((x[2:] - x[:-2], y[2:] - y[:-2]), axis=1)
    # Two nodes' distance outside.
    sources = surface + np.stack((along[:, 1], -along[:, 0]), axis=1)
    matrix, gradient = np.zeros((len(surface),) * 2), np.zeros((2, len(surface), len(surface)))
    for mirror in MIRRORS:
        distance = surface[:, None] - sources * mirror
        square = (distance**2).sum(axis=2)
        matrix += np.log(square) / 2
        gradient += np.moveaxis(distance / square[:, :, None], 2, 0)
    velocity = (gradient @ np.linalg.solve(matrix, potential)).T
    velocity[0, 1] = velocity[-1, 0] = 0
    return velocity, (velocity**2).sum(axis=1) / 2 - surface[:, 1]


def redistributed(surface, potential, count):
    length = np.concatenate(([0], np.cumsum(np.hypot(*np.diff(surface, axis=0).T))))
    beyond = min(3, len(length) - 2)
    knots = np.concatenate((-length[beyond:0:-1], length, 2 * length[-1] - length[-2 : -2 - beyond : -1]))
    columns = ((surface[:, 0], 1, -1), (surface[:, 1], -1, 1), (potential, 1, 1))
    curve = PchipInterpolator(knots, np.stack([mirrored(*column, beyond) for column in columns], axis=1))
    fine = np.linspace(0, length[-1], 4000)
    density = 1 / np.clip(curve(fine)[:, 1] + LEAST_DEPTH, LEAST_DEPTH, 0.5)
    counted = np.concatenate(([0], np.cumsum((density[1:] + density[:-1]) / 2)))
    found = curve(np.interp(np.linspace(0, counted[-1], count + 1), counted, fine))
    found[-1, 0] = found[0, 1] = 0
    return found[:, :2], found[:, 2]


def smoothed(values, at_floor, at_wall):
    """Longuet-Higgins & Cokelet 1976, their filter against saw teeth."""
    v = mirrored(values, at_floor, at_wall, 2)
    return (-v[:-4] + 4 * v[1:-3] + 10 * v[2:-2] + 4 * v[3:-1] - v[4:]) / 16


def column(nodes):
    """Its surface at rest, 1 by 2, from the floor to the wall."""
    side, top = np.linspace(0, 2, 400), np.linspace(1, 0, 200)[1:]
    surface = np.concatenate((np.stack((np.ones(400), side), 1), np.stack((top, np.full(199, 2.0)), 1)))
    return redistributed(surface, np.zeros(len(surface)), nodes)[0]


def inviscid(end, nodes=80):
    """T, Z and the volume of the column without viscosity, until T = `end`."""
    surface, potential = column(nodes), np.zeros(nodes + 1)
    time, step, rows = 0.0, 0, [(0.0, 1.0, 2.0)]
    while time < end / np.sqrt(2) - 1e-12:
        first = slopes(surface, potential)
        speed = max(np.hypot(*first[0].T).max(), 0.3)
        h = min(0.5 * np.hypot(*np.diff(surface, axis=0).T).min() / speed, 0.02, end / np.sqrt(2) - time)
        # Runge and Kutta.
        second = slopes(surface + h / 2 * first[0], potential + h / 2 * first[1])
        third = slopes(surface + h / 2 * second[0], potential + h / 2 * second[1])
        fourth = slopes(surface + h * third[0], potential + h * third[1])
        surface = surface + h / 6 * (first[0] + 2 * second[0] + 2 * third[0] + fourth[0])
        potential = potential + h / 6 * (first[1] + 2 * second[1] + 2 * third[1] + fourth[1])
        time, step = time + h, step + 1
        if step % 2 == 0:
            surface, potential = redistributed(surface, potential, nodes)
            surface = np.stack((smoothed(surface[:, 0], 1, -1), smoothed(surface[:, 1], -1, 1)), axis=1)
            potential = smoothed(potential, 1, 1)
            surface[-1, 0] = surface[0, 1] = 0
        x, y = np.concatenate(([[0, 0]], surface)).T
        rows.append((time * np.sqrt(2), surface[0, 0], (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2))
    return np.array(rows)


def front(time, data=MEASURED):
    return np.interp(time, *data.T)


def speed(first, last, data=MEASURED):
    """The slope of the line that fits best, dZ/dT."""
    part = data[(data[:, 0] >= first) & (data[:, 0] <= last)]
    return np.polyfit(*part.T, 1)[0]


def reference(nodes=80):
    times, fronts, volumes = inviscid(4, nodes).T
    of_inviscid = np.stack((times, fronts), axis=1)
    return {
        **{f"inviscid_front_at_{time}": front(float(time), of_inviscid) for time in (1, 2, 3, 4)},
        "inviscid_speed": (front(4.0, of_inviscid) - front(2.0, of_inviscid)) / 2,
        "inviscid_volume": volumes[-1],
        "delay_at_first": MEASURED[0, 0] - np.interp(MEASURED[0, 1], fronts, times),
        "front_at_2": front(2.0),
        "front_at_3": front(3.0),
        "front_at_4": front(4.0),
        "speed": speed(1.9, 6.4),
        "speed_small": speed(1.5, 5.4, MEASURED_SMALL),
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
