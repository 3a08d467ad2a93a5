#!/usr/bin/env python3
"""Reference of the scene `dam_break`: how the front of a collapsing column of water moves.

Measured by Martin & Moyce (1952, Phil. Trans. R. Soc. Lond. A 244, 312-324), rectangular section, height 2 a:
Z = z / a over T = t sqrt(2 g / a). The values are those of their figure 3 for a = 2.25 inches as digitised in
PySPH (pysph.examples.db_exp_data). The clock of the experiment has an uncertain start (the dam takes time to
go), so the scene compares the speed of the front where it is steady, too.

Ritter's (1892) front of a dam of infinite length runs at 2 sqrt(g H) and bounds the speed: dZ/dT <= 2.
Prints the measured front at the scene's times and the speed between them.
"""

import json
import sys

import numpy as np

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


def front(time, data=MEASURED):
    return np.interp(time, *data.T)


def speed(first, last, data=MEASURED):
    """The slope of the line that fits best, dZ/dT."""
    part = data[(data[:, 0] >= first) & (data[:, 0] <= last)]
    return np.polyfit(*part.T, 1)[0]


def reference():
    return {
        "front_at_2": front(2.0),
        "front_at_3": front(3.0),
        "front_at_4": front(4.0),
        "speed": speed(1.9, 6.4),
        "speed_small": speed(1.5, 5.4, MEASURED_SMALL),
    }


if __name__ == "__main__":
    json.dump(reference(), sys.stdout, indent=2)
    print()
