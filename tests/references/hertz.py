#!/usr/bin/env python3
"""Reference of the scene `hertz`: a cylinder pressed onto a plane, both elastic and equal, in plane strain.

Hertz (1882): a force P per length makes a contact of the half-width a, a^2 = 4 P R / (pi E*), with the pressure
p0 sqrt(1 - x^2 / a^2), p0 = 2 P / (pi a); 1 / E* = 2 (1 - nu^2) / E. Below it McEwen (1949; Johnson, Contact Mechanics,
1985, eq. 4.49) has the stresses of the half-space. Prints those that the scene compares with, and by how much they change
if the half-width is off by `DOUBT`, under the same force: their tolerances.
"""

import json
import sys

import numpy as np

MODULUS, RATIO, RADIUS, HALF_WIDTH, CELL = 1000.0, 0.3, 40.0, 1.0, 0.2
CONTACT_MODULUS = MODULUS / (2 * (1 - RATIO**2))
FORCE = np.pi * CONTACT_MODULUS * HALF_WIDTH**2 / (4 * RADIUS)
# Gaps are means over what is within 0.75 cells beside a node, with the weights (1 - (t / 0.75)^2)^2, whose root of the
# mean square is 0.75 / sqrt(7) cells: surfaces are known that well along themselves.
DOUBT = 0.75 / np.sqrt(7) * CELL
# What is measured: means over boxes (x, then depth), and the particle nearest to this place on the axis.
BOXES = {"inner": (0, 0.5, 0, 0.4), "outer": (0.5, 1, 0, 0.4), "beside": (1, 1.5, 0, 0.4)}
AXIS = (0.05, 0.75)


def stresses(x, depth, half_width=HALF_WIDTH, force=FORCE):
    """xx, yy (along the depth), xy."""
    pressure = 2 * force / (np.pi * half_width)
    s = half_width**2 - x**2 + depth**2
    root = np.sqrt(s**2 + 4 * x**2 * depth**2)
    m, n = np.sqrt((root + s) / 2), np.sqrt(np.maximum(root - s, 0) / 2) * np.sign(x)
    share = (depth**2 + n**2) / (m**2 + n**2)
    xx = -pressure / half_width * (m * (1 + share) - 2 * depth)
    yy = -pressure / half_width * m * (1 - share)
    return xx, yy, -pressure / half_width * n * (m**2 - depth**2) / (m**2 + n**2)


def stresses_by_integration(x, depth, count=20000):
    """Flamant's line loads with Hertz's pressure: at a cos(angle), so that the ends are smooth."""
    angle = (np.arange(count) + 0.5) / count * np.pi
    load = 2 * FORCE / (np.pi * HALF_WIDTH) * np.sin(angle) * HALF_WIDTH * np.sin(angle) * np.pi / count
    away = x - HALF_WIDTH * np.cos(angle)
    factor = -2 * load * depth / (np.pi * (away**2 + depth**2) ** 2)
    return (factor * away**2).sum(), (factor * depth**2).sum(), (factor * away * depth).sum()


def mean(box, half_width=HALF_WIDTH, count=400):
    """Of yy over a box, by the midpoint rule."""
    middles = lambda lower, upper: lower + (np.arange(count) + 0.5) / count * (upper - lower)
    return stresses(middles(*box[:2]), middles(*box[2:])[:, None], half_width)[1].mean()


def reference(half_width=HALF_WIDTH):
    found = {name: mean(box, half_width) for name, box in BOXES.items()}
    found["lateral"], found["axial"], _ = stresses(*AXIS, half_width)
    return found


def tolerances():
    """Relative."""
    exact, narrow, wide = reference(), reference(HALF_WIDTH - DOUBT), reference(HALF_WIDTH + DOUBT)
    return {name: max(abs(narrow[name] / exact[name] - 1), abs(wide[name] / exact[name] - 1)) for name in exact}


if __name__ == "__main__":
    json.dump({"force": FORCE, "exact": reference(), "tolerances": tolerances()}, sys.stdout, indent=2)
    print()
