"""The laws of the vibrating beams are those of plane_elements.py, which differentiates and iterates them elsewhere."""

import json
import pathlib
import unittest

import numpy as np

import nonlinear_vibration
from plane_elements import hencky, lame, plane_stress_lambda, saint_venant_kirchhoff
from scene_text import constants


class Laws(unittest.TestCase):
    def setUp(self):
        self.gradient = np.eye(2) + 0.05 * np.random.default_rng(1).standard_normal((7, 2, 2))
        self.constants = (
            plane_stress_lambda(nonlinear_vibration.MODULUS, nonlinear_vibration.RATIO),
            lame(nonlinear_vibration.MODULUS, nonlinear_vibration.RATIO)[1],
        )

    def stress(self, law):
        parts = law(*(self.gradient[:, i, j] for i, j in np.ndindex(2, 2)))
        return np.stack(parts, -1).reshape(-1, 2, 2)

    def test_green_is_saint_venant_and_kirchhoff_s(self):
        expected = saint_venant_kirchhoff(*self.constants)(self.gradient)
        np.testing.assert_allclose(self.stress(nonlinear_vibration.green), expected, rtol=1e-10, atol=1e-10)

    def test_logarithmic_is_hencky_s_with_the_cauchy_stress(self):
        # From the Kirchhoff stress to the Cauchy one by the volume ratio, the change of the thickness included.
        ratio = nonlinear_vibration.RATIO
        plane = np.linalg.det(self.gradient)
        volume = plane * np.exp(-ratio / (1 - ratio) * np.log(plane))
        expected = volume[:, None, None] * hencky(*self.constants)(self.gradient)
        np.testing.assert_allclose(self.stress(nonlinear_vibration.logarithmic), expected, rtol=1e-10, atol=1e-10)

    def test_logarithmic_bears_the_undeformed_body(self):
        np.testing.assert_array_equal(nonlinear_vibration.logarithmic(*map(np.array, (1.0, 0.0, 0.0, 1.0))), 0)


class Scene(unittest.TestCase):
    def test_the_scene_states_what_is_stored_of_the_hinged_beam(self):
        stored = json.loads(pathlib.Path(__file__).with_name("nonlinear_vibration.json").read_text(encoding="utf-8"))
        beam = stored["simply_supported 8"]
        row = next(row for row in beam["rows"] if row["amplitude"] == 1)
        self.assertLess(row["ratio_error"], 1e-4)
        stated = constants("nonlinear_beam")
        self.assertEqual(stated["v"], row["velocity"])
        self.assertEqual(stated["linear_frequency"], beam["linear_frequency"])
        self.assertEqual(stated["squared_ratio"], row["ratio"])


if __name__ == "__main__":
    unittest.main()
