"""Solutions in closed form agree with what another way of computing them finds, and scenes state their numbers."""

import unittest

import numpy as np

import hanging_bar
import wave_transmission
from references_test import constant


class HangingBar(unittest.TestCase):
    def test_the_scene_states_the_integral(self):
        # The scene prints eight digits.
        stated = constant("hanging_bar", "end_displacement")
        self.assertAlmostEqual(stated, hanging_bar.reference()["end_displacement"], delta=5e-9)

    def test_integrating_the_stretch_along_the_bar_finds_the_same(self):
        # Relative tolerance of the integrator 1e-10.
        for free in (False, True):
            for x in (0.3, 1.0):
                with self.subTest(free=free, x=x):
                    by_ode = hanging_bar.displacement_by_ode(x, free)
                    self.assertAlmostEqual(hanging_bar.displacement(x, free), by_ode, delta=1e-10)


class WaveTransmission(unittest.TestCase):
    def test_finite_differences_that_are_exact_in_a_bar_find_the_same(self):
        # Rounding of 960 steps.
        self.assertLess(wave_transmission.reference()["difference_to_finite_differences"], 1e-13)

    def test_energy_is_kept_where_the_pulse_splits(self):
        # The power of a wave is Z v^2.
        passed, returned = wave_transmission.factors()
        z1, z2 = np.multiply(wave_transmission.DENSITIES, wave_transmission.SPEEDS)
        self.assertAlmostEqual(z1, z1 * returned**2 + z2 * passed**2, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
