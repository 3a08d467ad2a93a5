"""The exact values that the gallery's scenes state are those that the references compute.

Each reference runs at a coarse discretisation, to be quick; the tolerance of each comparison is that
discretisation's own error (the difference to the fine one, which gave the printed digits) and half of the last
printed digit.
"""

import pathlib
import unittest

import numpy as np

import cantilever
import column_buckling
import compliant_bar
import elastica
import simply_supported_beam
from scene_text import constant

HERE = pathlib.Path(__file__).parent


class Cantilever(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.computed = cantilever.reference(fine=False)

    def test_the_scene_states_what_finite_elements_find(self):
        for kind in ("linear", "finite"):
            tolerance = self.computed[f"{kind}_error"]
            self.assertLess(tolerance, 2e-5)
            for scene_name, name in (("tip", "deflection"), ("slope", "slope")):
                with self.subTest(kind=kind, name=name):
                    stated = constant("cantilever", f"{scene_name}_{kind}")
                    self.assertAlmostEqual(stated, self.computed[f"{kind}_{name}"], delta=tolerance)
                    if kind == "finite":
                        self.assertEqual(constant("cantilever_static", f"{scene_name}_{kind}"), stated)

    def test_the_clamped_edge_lies_between_beam_theory_and_the_point_clamp(self):
        # A wholly clamped edge holds more than a point, and shear only adds to what bending gives.
        linear = self.computed["linear_deflection"]
        self.assertLess(self.computed["beam_theory_deflection"], linear)
        self.assertLess(linear, self.computed["timoshenko_goodier_deflection"])

    def test_the_strain_measure_does_not_matter_at_the_scene_s_tolerance(self):
        # A fiftieth of the 0.5 % that the scene allows.
        self.assertLess(self.computed["finite_difference_between_laws"], 1e-4)


class Elastica(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.computed = elastica.reference()

    def test_the_scenes_state_what_the_elastica_does(self):
        for name in ("end_load", "uniform_load"):
            stated = [constant(f"elastica_{name}", c) for c in ("load", "end_x", "end_angle")]
            computed = [self.computed[key] for key in (name, f"{name}_x", f"{name}_angle")]
            # The tolerance of the integration along the beam, 1e-11, and of the shooting, 1e-10.
            np.testing.assert_allclose(stated, computed, rtol=1e-9)

    def test_shooting_and_elliptic_integrals_agree(self):
        self.assertLess(self.computed["end_load_difference"], 1e-9)


class SimplySupportedBeam(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.computed = simply_supported_beam.reference(fine=False)

    def test_the_scene_states_the_rayleigh_lamb_frequency(self):
        # The scene prints seven digits.
        self.assertAlmostEqual(constant("ss_beam", "f1"), self.computed["rayleigh_lamb_frequency"], delta=5e-8)

    def test_the_scene_of_modes_states_three_of_them(self):
        for number, frequency in enumerate(self.computed["rayleigh_lamb_frequencies"], 1):
            self.assertAlmostEqual(constant("beam_modes", f"f{number}"), frequency, delta=5e-7)

    def test_finite_elements_find_the_same_three_frequencies(self):
        # Cubic elements one unit long; the third wave is three elements long from node to node.
        for error, most in zip(self.computed["finite_element_errors"], (1e-5, 3e-4, 3e-3)):
            self.assertLess(error, most)

    def test_finite_elements_find_the_same_frequency(self):
        # Cubic elements one unit long: (k h)^6 is about 4e-3, and the constant of the error is small.
        self.assertLess(self.computed["finite_element_error"], 1e-5)

    def test_timoshenko_s_beam_is_close_and_euler_s_is_not(self):
        exact = self.computed["rayleigh_lamb_frequency"]
        self.assertLess(abs(self.computed["timoshenko_frequency"] / exact - 1), 2e-5)
        self.assertGreater(self.computed["euler_bernoulli_frequency"] / exact - 1, 0.02)


class ColumnBuckling(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.computed = column_buckling.reference(fine=False)

    def test_the_scene_states_what_finite_elements_find(self):
        tolerance = self.computed["linearised_error"] + 5e-6
        self.assertLess(tolerance, 1e-3)
        self.assertAlmostEqual(constant("column_buckling", "critical"), self.computed["linearised"], delta=tolerance)

    def test_it_is_euler_s_but_for_shear_and_compression(self):
        # At the critical load the column is compressed by 8e-4; shear adds twice as much.
        self.assertLess(abs(self.computed["linearised"] / self.computed["euler"] - 1), 0.005)

    def test_the_true_path_loses_its_stability_there(self):
        # Laws differ by about six times the strain.
        for law in ("saint_venant_kirchhoff", "hencky"):
            self.assertLess(abs(self.computed[f"path_{law}"] / self.computed["linearised"] - 1), 0.006)


class CompliantBar(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.computed, cls.history = compliant_bar.reference(fine=False)

    def test_the_scene_states_what_finite_elements_find(self):
        for name, last_digit in (("first_extension", 5e-5), ("frequency", 5e-4)):
            with self.subTest(name=name):
                tolerance = self.computed[f"{name}_error"] + last_digit
                self.assertAlmostEqual(constant("compliant_bar", name), self.computed[name], delta=tolerance)

    def test_the_stored_history_is_the_one_that_finite_elements_give(self):
        stored = np.loadtxt(HERE / "compliant_bar_history.csv", delimiter=",", skiprows=1)
        self.assertEqual(len(stored), len(self.history))
        # 0.5 % of the largest extension, half of what the history is used to prove.
        self.assertLess(np.abs(stored[:, 1] - self.history).max(), 0.005 * stored[:, 1].max())


if __name__ == "__main__":
    unittest.main()
