"""The finite elements that give beams' frequencies meet exact waves where there are any, and beam theory where it holds."""

import unittest

import numpy as np

import beam_frequencies


class Frequencies(unittest.TestCase):
    def test_two_hinged_ends_carry_the_exact_waves(self):
        modes, error = beam_frequencies.beam_reference("simply_supported", levels=beam_frequencies.COARSE)
        exact = [beam_frequencies.rayleigh_lamb(mode) for mode in (1, 2, 3)]
        # The finer level is far nearer than the two are to each other.
        np.testing.assert_allclose(modes.frequencies, exact, rtol=0.01 * error)

    def test_hinges_that_hold_less_vibrate_more_slowly(self):
        whole, mean, patch = (
            beam_frequencies.finite_elements(beam, 8.0, beam_frequencies.COARSE[0]).frequencies
            for beam in ("simply_supported", "mean_mean", "patch_patch")
        )
        self.assertTrue((patch < mean).all())
        self.assertTrue((mean < whole).all())

    def test_slender_beams_approach_beam_theory(self):
        # At L/h = 64 shear and rotary inertia lower the first frequency by about (pi h / L)^2 / 24 (1 + E / kG), that
        # is 4e-4 on two hinges; with clamped ends up to four times as much.
        for beam in ("cantilever", "simply_supported", "fixed_hinged"):
            with self.subTest(beam=beam):
                modes = beam_frequencies.finite_elements(beam, 64.0, (24, 4, 5))
                below = 1 - modes.frequencies[0] / beam_frequencies.euler_bernoulli(beam, 64.0)[0]
                self.assertGreater(below, 0)
                self.assertLess(below, 2e-3)

    def test_shapes_meet_their_ends(self):
        shapes = beam_frequencies.finite_elements("fixed_hinged", 8.0, beam_frequencies.COARSE[0]).shapes
        np.testing.assert_allclose(shapes[:, [0, -1]], 0, atol=1e-12)
        np.testing.assert_allclose(np.abs(shapes).max(axis=1), 1)


if __name__ == "__main__":
    unittest.main()
