#!/usr/bin/env python3
"""Reference of the scene `spheres`: two equal elastic spheres collide head-on, slowly against the speed of sound.

Hertz's contact (Johnson 1985, Contact Mechanics, sections 4.2 and 11.4): the force k d^(3/2) at the approach
d of the centres with k = 4/3 E* sqrt(R*), 1/R* = 2/R, 1/E* = 2 (1 - nu^2) / E, quasi-static, hence without
loss. Prints the largest approach, how long the contact lasts, and the ratio of that to the time of a wave
across a sphere, which must be large for Hertz to hold.
"""

import json
import sys

import numpy as np
import scipy.integrate
import scipy.special

RADIUS, MODULUS, RATIO, DENSITY, SPEED = 0.4, 1000.0, 0.3, 1.0, 1.0  # SPEED of each


def contact():
    """Largest approach and duration in closed form."""
    mass = DENSITY * 4 / 3 * np.pi * RADIUS**3 / 2  # reduced
    stiffness = 4 / 3 * MODULUS / (2 * (1 - RATIO**2)) * np.sqrt(RADIUS / 2)
    closing = 2 * SPEED
    approach = (5 * mass * closing**2 / (4 * stiffness)) ** 0.4
    # 2 int_0^1 dx / sqrt(1 - x^(5/2)), a beta function: 2.9433.
    return approach, 0.8 * scipy.special.beta(0.4, 0.5) * approach / closing


def contact_by_integration():
    """The same from m d'' = -k d^(3/2)."""
    mass = DENSITY * 4 / 3 * np.pi * RADIUS**3 / 2
    stiffness = 4 / 3 * MODULUS / (2 * (1 - RATIO**2)) * np.sqrt(RADIUS / 2)
    slopes = lambda _, state: [state[1], -stiffness / mass * max(state[0], 0.0) ** 1.5]
    parted = lambda _, state: state[0] + 1e-15
    parted.terminal, parted.direction = True, -1
    solution = scipy.integrate.solve_ivp(
        slopes, (0, 10), [0, 2 * SPEED], rtol=1e-11, atol=1e-13, events=parted, dense_output=True
    )
    end = solution.t[-1]
    return solution.sol(end / 2)[0], end


def reference():
    approach, duration = contact()
    lam = MODULUS * RATIO / ((1 + RATIO) * (1 - 2 * RATIO))
    speed = np.sqrt((lam + MODULUS / (1 + RATIO)) / DENSITY)
    return {
        "largest_approach": approach,
        "duration": duration,
        "duration_over_wave_time": duration / (2 * RADIUS / speed),
        "mass": DENSITY * 4 / 3 * np.pi * RADIUS**3,
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
