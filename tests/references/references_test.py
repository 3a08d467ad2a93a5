"""The exact values that the gallery's scenes state are those that the references compute.

Each reference runs at a coarse discretisation, to be quick; the tolerance of each comparison is that
discretisation's own error (the difference to the fine one, which gave the printed digits) and half of the last
printed digit.
"""

import json
import pathlib
import unittest

import numpy as np

import cantilever
import column_buckling
import compliant_bar
import cook_membrane
import compliant_cube
import disc_impact
import elastica
import large_deflection
import nonlinear_vibration
import simply_supported_beam
import toggle_frame
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


class CookMembrane(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.computed = cook_membrane.reference(fine=False)

    def test_the_scenes_state_what_finite_elements_find(self):
        for scene, name in (("cook_membrane", "incompressible_finite"), ("cook_membrane_linear", "incompressible_linear")):
            tolerance = self.computed[f"{name}_error"]
            # A tenth of what the scenes allow.
            self.assertLess(tolerance, 0.003 * self.computed[name])
            self.assertAlmostEqual(constant(scene, "rise"), self.computed[name], delta=tolerance)
            # It moves the exact value by half of a length at most.
            self.assertAlmostEqual(constant(scene, "slope"), self.computed[f"{name}_slope"], delta=2 * tolerance)

    def test_they_find_what_has_been_published(self):
        # Cook's panel: tables give four digits. The corner at finite strain: within half a percent, where stresses are
        # singular.
        self.assertAlmostEqual(self.computed["cook"], 23.96, delta=0.03)
        self.assertAlmostEqual(self.computed["incompressible_finite_corner"], 6.9083, delta=0.005 * 6.9083)


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


class ToggleFrame(unittest.TestCase):
    def test_the_scene_states_the_limit_points_that_finite_elements_find(self):
        computed = toggle_frame.reference(fine=False)
        for name in ("maximum", "minimum"):
            # Half of the last printed digit, and the discretisation.
            tolerance = 5e-5 + computed[f"{name}_error"]
            self.assertLess(tolerance, 1.5e-3)
            self.assertAlmostEqual(constant("toggle_frame", name), computed[name], delta=tolerance)


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


class DiscImpact(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.smooth, cls.rough = disc_impact.collide(16, 0.0), disc_impact.collide(16, disc_impact.FRICTION)

    def test_the_scene_states_what_finite_elements_find(self):
        # Four thirds of the difference to twice as many elements: they are of second order.
        for kind, found in (("smooth", self.smooth), ("rough", self.rough)):
            for axis in "xy":
                with self.subTest(kind=kind, axis=axis):
                    self.assertAlmostEqual(constant("oblique_discs", f"{kind}_{axis}"), found[axis], delta=0.002)
        self.assertAlmostEqual(constant("oblique_discs", "spin"), self.rough["spin"], delta=0.0052)
        self.assertAlmostEqual(self.smooth["spin"], 0, delta=0.0052)

    def test_friction_gives_the_spin_that_its_lever_does(self):
        # Spin m R^2 / 2 = mu J R, and the change of momentum is J sqrt(1 + mu^2). The lever is shorter by the
        # indentation, which is up to 4 % of the radius.
        change = np.hypot(self.rough["x"] - disc_impact.TANGENTIAL, self.rough["y"] + disc_impact.NORMAL)
        impulse = change / np.hypot(1, disc_impact.FRICTION)
        rigid = disc_impact.rigid(impulse / disc_impact.NORMAL - 1, disc_impact.FRICTION)
        self.assertAlmostEqual(-self.rough["spin"] / rigid["spin"], 1, delta=0.04)


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


class CompliantCube(unittest.TestCase):
    def test_the_stored_history_is_the_one_that_finite_elements_give(self):
        _, stored = np.loadtxt(HERE / "compliant_cube_history.csv", delimiter=",", skiprows=1).T
        # The coarse mesh's own error: 0.5 % of the largest extension.
        self.assertLess(np.abs(stored - compliant_cube.extension_history(1, 2, 4)).max(), 0.005 * stored.max())


class LargeDeflection(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stored = np.loadtxt(HERE / "large_deflection.csv", delimiter=",", skiprows=1)

    def test_the_beam_without_stretch_and_shear_is_the_elastica(self):
        found = elastica.reference()
        ((deflection, shortening),) = large_deflection.beam([found["uniform_load"]], stretches=False)
        # The tolerance of the collocation is 1e-9 of the rates.
        self.assertAlmostEqual(deflection, elastica.DEFLECTION, delta=1e-7)
        self.assertAlmostEqual(1 - shortening, found["uniform_load_x"], delta=1e-7)

    def test_the_stored_table_is_the_one_that_the_programs_compute(self):
        loads = self.stored[[10, 20], 0]
        for stretches, columns in ((False, slice(1, 3)), (True, slice(3, 5))):
            # Half of the last digit.
            np.testing.assert_allclose(large_deflection.beam(loads, stretches), self.stored[[10, 20], columns], atol=6e-8)
        places = (large_deflection.LENGTH, large_deflection.PLACE)
        plane = large_deflection.plane_body(loads, places, columns=6, rows=2, degree=4).reshape(2, 4)
        # The coarse mesh's own error.
        np.testing.assert_allclose(plane, self.stored[[10, 20], 5:], atol=1e-4)


class NonlinearVibration(unittest.TestCase):
    def test_the_hinged_beam_s_frequency_is_woinowsky_krieger_s(self):
        # His equation's period by quadrature of the energy: w'^2 + w^2 + w^4 / 8 = 1 + 1 / 8 at w = sin(angle).
        angle = (np.arange(2000) + 0.5) * np.pi / 4000
        quarter = np.mean(1 / np.sqrt(1 + (1 + np.sin(angle) ** 2) / 8)) * np.pi / 2
        self.assertAlmostEqual(nonlinear_vibration.duffing("simply_supported", 1.0), (np.pi / 2 / quarter) ** 2, delta=1e-9)

    def test_the_stored_frequencies_are_those_that_finite_elements_find(self):
        stored = json.loads((HERE / "nonlinear_vibration.json").read_text())["fixed_hinged 4"]
        (row,) = (row for row in stored["rows"] if row["amplitude"] == 1.0)
        found = nonlinear_vibration.vibrations("fixed_hinged", 4.0, 4, amplitudes=(1.0,))
        # The stored errors are the differences to this degree.
        error = stored["linear_frequency_error"] * 1.001
        self.assertAlmostEqual(found["linear_frequency"], stored["linear_frequency"], delta=error)
        self.assertAlmostEqual(found["rows"][0]["ratio"], row["ratio"], delta=1.001 * row["ratio_error"])
        # The mean of extremes between time steps.
        self.assertAlmostEqual(found["rows"][0]["reached"], row["reached"], delta=2e-3)


if __name__ == "__main__":
    unittest.main()
