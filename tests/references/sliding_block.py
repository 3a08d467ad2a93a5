#!/usr/bin/env python3
"""Reference of the scenes `sliding_block` and `blocks_on_incline`: blocks on a rough incline.

In the first one a block is pushed down, slows down and sticks.

Coulomb friction with coefficient mu > tan(theta): v' = g (sin(theta) - mu cos(theta)) < 0 until the block
stands still; from then on friction holds it. Prints the deceleration, and when and where it stops.
"""

import json
import sys

import numpy as np
import scipy.integrate

ANGLE, FRICTION, GRAVITY, SPEED = np.radians(20.0), 0.6, 10.0, 2.0


def deceleration():
    return GRAVITY * (FRICTION * np.cos(ANGLE) - np.sin(ANGLE))


def distance(t):
    t = np.minimum(t, SPEED / deceleration())
    return SPEED * t - deceleration() * t**2 / 2


def distance_by_integration(times):
    """Of the motion with a friction that grows smoothly with the speed, tanh(v / 1e-4) of its full value."""

    def slopes(_, state):
        friction = FRICTION * GRAVITY * np.cos(ANGLE) * np.tanh(state[1] / 1e-4)
        return [state[1], GRAVITY * np.sin(ANGLE) - friction]

    return scipy.integrate.solve_ivp(slopes, (0, times[-1]), [0, SPEED], "Radau", times, rtol=1e-9, atol=1e-11).y[0]


def ramped_distance(t, angle=np.radians(30.0), friction=0.3):
    """Of a block at rest under a gravity of 1 that grows as (1 - cos(pi t)) / 2 until t = 1."""
    acceleration = np.sin(angle) - friction * np.cos(angle)
    grown = lambda time: (1 - np.cos(np.pi * np.minimum(time, 1))) / 2
    times = np.linspace(0, t, 20001)
    speed = scipy.integrate.cumulative_trapezoid(grown(times), x=times, initial=0)
    return acceleration * scipy.integrate.simpson(speed, x=times)


def reference():
    return {
        "deceleration": deceleration(),
        "stop_time": SPEED / deceleration(),
        "stop_distance": SPEED**2 / (2 * deceleration()),
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
