"""The finite elements that give beams' frequencies meet exact waves where there are any, and beam theory where it holds."""

import unittest

import numpy as np

import beam_elements
import beam_frequencies


class Frequencies(unittest.TestCase):
    def test_two_hinged_ends_carry_the_exact_waves(self):
        modes, error = beam_frequencies.beam_reference("simply_supported", levels=beam_frequencies.COARSE)
        exact = [beam_frequencies.rayleigh_lamb(mode) for mode in (1, 2, 3)]
        # The finer level is far nearer than the two are to each other.
        np.testing.assert_allclose(modes.frequencies, exact, rtol=0.01 * error)

    def test_the_wave_is_the_shape_of_the_first_mode(self):
        body = beam_elements.Beam(("hinged", "hinged"), 8.0, beam_elements.LEVELS[1])
        shape = body.modes(1, 1.0)[1][0].reshape(body.mesh.rows, body.mesh.columns, 2)
        wave = beam_frequencies.flexural_wave(1)
        middle = np.abs(body.mesh.axis_x - 4).argmin()
        amplitude = body.section_means(shape)[middle, 1]
        y = body.mesh.axis_y - 0.5
        # Eigenvectors are as near as the square root of the frequencies' error, which is 1e-10 here.
        np.testing.assert_allclose(shape[:, 0, 0] / amplitude, wave.axial(y), atol=1e-5)
        np.testing.assert_allclose(shape[:, middle, 1] / amplitude, wave.transverse(y), atol=1e-5)

    def test_sections_turn_as_timoshenko_s_nearly(self):
        wave = beam_frequencies.flexural_wave(1)
        # The slope of the cubic that sections become, at mid-height, against the straight section's.
        self.assertAlmostEqual(-wave.axial(0.5) / 0.5, beam_frequencies.timoshenko_rotation(1), delta=0.03 * wave.k)
        self.assertLess(beam_frequencies.timoshenko_rotation(1), wave.k)

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
