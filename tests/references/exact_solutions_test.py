"""Solutions in closed form agree with what another way of computing them finds, and scenes state their numbers."""

import unittest

import numpy as np

import column_collapse
import hanging_bar
import hertz
import radial
import sliding_block
import sphere_collision
import taylor_bar
import wave_transmission
from scene_text import constant


class HangingBar(unittest.TestCase):
    def test_the_scenes_state_the_integral(self):
        # The scenes print eight digits.
        computed = hanging_bar.reference()
        for scene, key in (("hanging_bar", "end_displacement"), ("hanging_rod", "end_displacement_free_sides")):
            with self.subTest(scene=scene):
                self.assertAlmostEqual(constant(scene, "end_displacement"), computed[key], delta=5e-9)

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


class RadialSymmetry(unittest.TestCase):
    radii = np.linspace(1, 2, 5)

    def test_the_scenes_state_what_radial_equilibrium_gives(self):
        computed = radial.reference()
        stated = {
            ("thick_cylinder", "inner"): "cylinder_inner_displacement",
            ("thick_cylinder", "inner_slope"): "cylinder_inner_slope",
            ("thick_cylinder", "outer"): "cylinder_outer_displacement",
            ("thick_cylinder", "outer_slope"): "cylinder_outer_slope",
            ("compressed_cylinder", "lateral_stretch"): "compressed_lateral_stretch",
            ("compressed_cylinder", "axial_stress"): "compressed_axial_stress",
            ("hollow_sphere", "mean"): "sphere_mean_displacement",
            ("hollow_sphere_solid", "mean"): "sphere_mean_displacement",
        }
        for (scene, name), key in stated.items():
            # The last digit printed.
            with self.subTest(scene=scene, name=name):
                self.assertAlmostEqual(constant(scene, name) / computed[key], 1, delta=1e-5)

    def test_a_neo_hookean_shell_under_little_pressure_is_lame_s(self):
        # Strains of 1e-6: what linear elasticity leaves out is a few of them.
        for n, exact in ((1, radial.cylinder_displacement), (2, radial.sphere_displacement)):
            with self.subTest(n=n):
                shell = radial.NeoHookeanShell(n, 1, 2, 1000, 0.3, pressure=1e-3).solve()
                lame = exact(self.radii, 1, 2, 1e-3, 1000, 0.3)
                np.testing.assert_allclose(shell(self.radii)[0], lame, rtol=1e-5)

    def test_the_shell_of_finite_strain_is_in_equilibrium_as_a_whole(self):
        # A quarter of the cylinder: the hoop force in its two cuts balances the traction on its inner surface.
        shell = radial.NeoHookeanShell(1, 1, 2, 1000, 0.3, inner_traction=150)
        solution = shell.solve()
        points, weights = np.polynomial.legendre.leggauss(20)
        radius = 1.5 + points / 2
        displacement, nominal = solution(radius)
        hoop = 1 + displacement / radius
        _, around = shell.nominal(shell.radial_stretch(hoop, nominal), hoop)
        # The collocation's tolerance is 1e-11 for each interval.
        self.assertAlmostEqual(weights @ around / 2, 150 * 1, delta=1e-6)

    def test_the_rotating_disc_is_in_equilibrium_and_obeys_hooke_s_law(self):
        radius, step, modulus, ratio, force, outer = np.linspace(0.1, 0.9, 9), 1e-5, 1000.0, 0.3, 7.0, 1.0
        stress = lambda r: radial.disc_stress(r, outer, force, ratio)
        slope = lambda function: (function(radius + step) - function(radius - step)) / (2 * step)
        around_radius, hoop = stress(radius)
        # Differences: the error of the step squared, and rounding by the step.
        balance = slope(lambda r: stress(r)[0]) + (around_radius - hoop) / radius + force * radius
        np.testing.assert_allclose(balance, 0, atol=1e-8)
        displacement = lambda r: radial.disc_displacement(r, outer, force, modulus, ratio)
        np.testing.assert_allclose(displacement(radius) / radius * modulus, hoop - ratio * around_radius, rtol=1e-12)
        np.testing.assert_allclose(slope(displacement) * modulus, around_radius - ratio * hoop, rtol=0, atol=1e-7)

    def test_a_compressed_cylinder_has_no_stress_across(self):
        axial = 0.6
        a = radial.compressed_lateral_stretch(axial, 1000, 0.3)
        lam, mu = radial.lame(1000, 0.3)
        gradient = np.diag([a, a, axial])
        inverse = np.linalg.inv(gradient)
        nominal = mu * (gradient - inverse) + lam * np.log(np.linalg.det(gradient)) * inverse
        cauchy = nominal @ gradient / np.linalg.det(gradient)
        # Rounding in units of the modulus.
        along = radial.compressed_axial_stress(axial, 1000, 0.3)
        np.testing.assert_allclose(np.diag(cauchy), [0, 0, along], atol=1e-10)


class SlidingBlock(unittest.TestCase):
    def test_integrating_the_motion_with_smoothed_friction_finds_the_same(self):
        # The smoothed friction lets the block creep: 1e-4 of the speed for half a second.
        times = np.linspace(0, 1.5, 16)
        distance = sliding_block.distance_by_integration(times)
        np.testing.assert_allclose(sliding_block.distance(times), distance, rtol=0, atol=1e-4)


class BlocksOnIncline(unittest.TestCase):
    def test_integrating_the_growing_gravity_finds_what_the_scene_states(self):
        # At the end, t = 2; of the rule on 20000 intervals and its formula as printed.
        acceleration = constant("blocks_on_incline", "acceleration")
        stated = acceleration * (1 / 4 - 1 / np.pi**2 + 1 / 2 + 1 / 2)
        self.assertAlmostEqual(sliding_block.ramped_distance(2.0), stated, delta=1e-7)


class Hertz(unittest.TestCase):
    def test_stresses_are_those_of_the_pressure_by_integration(self):
        for place in ((0.05, 0.75), (0.7, 0.3), (1.4, 0.2)):
            with self.subTest(place=place):
                np.testing.assert_allclose(hertz.stresses(*place), hertz.stresses_by_integration(*place), rtol=1e-9)

    def test_the_largest_shear_stress_is_where_johnson_says(self):
        depth = np.linspace(0.5, 1.1, 601)
        xx, yy, _ = hertz.stresses(1e-9, depth)
        shear = (xx - yy) / 2
        self.assertAlmostEqual(depth[shear.argmax()], 0.786, delta=1e-3)
        self.assertAlmostEqual(shear.max() / (2 * hertz.FORCE / np.pi), 0.300, delta=5e-4)

    def test_the_scene_states_them(self):
        self.assertAlmostEqual(constant("hertz", "force"), hertz.FORCE, delta=1e-9)
        for name, stress in hertz.reference().items():
            with self.subTest(name=name):
                # Six digits.
                self.assertAlmostEqual(constant("hertz", name) / stress, 1, delta=2e-6)


class SphereCollision(unittest.TestCase):
    def test_integrating_hertz_s_contact_finds_the_same(self):
        # Relative tolerance of the integrator 1e-11 for each of about 100 steps.
        np.testing.assert_allclose(sphere_collision.contact(), sphere_collision.contact_by_integration(), rtol=1e-9)

    def test_waves_cross_the_spheres_several_times_during_the_contact(self):
        self.assertGreater(sphere_collision.reference()["duration_over_wave_time"], 5)


class TaylorBar(unittest.TestCase):
    def test_coarse_elements_come_as_near_to_the_scene_as_they_should(self):
        # Elements of a third of the radius: length and radius change by 0.1 % and 2.5 % when they are refined.
        coarse = taylor_bar.impact(3)
        self.assertAlmostEqual(coarse["length"] / constant("taylor_bar", "bar_length"), 1, delta=0.0015)
        self.assertAlmostEqual(coarse["particle_radius"] / constant("taylor_bar", "particle_radius"), 1, delta=0.03)

    def test_elements_have_the_bar_s_mass_and_pass_a_patch_test(self):
        # Rounding.
        bar = taylor_bar.Bar(3)
        mass = taylor_bar.DENSITY * taylor_bar.RADIUS**2 / 2 * taylor_bar.LENGTH
        self.assertAlmostEqual(bar.mass.sum() / mass, 1, delta=1e-12)
        # Half of the yield strain without lateral stress: uniaxial stress E times strain in all points.
        strain = taylor_bar.YIELD / taylor_bar.YOUNG / 2
        bar.v = bar.x * (taylor_bar.POISSON, -1) * strain
        bar.strain(1.0, *taylor_bar.geometry(bar.x, bar.elements))
        np.testing.assert_allclose(bar.deviator[..., 1] - bar.pressure[:, None], -taylor_bar.YIELD / 2, rtol=1e-12)
        np.testing.assert_allclose(bar.deviator[..., 0] - bar.pressure[:, None], 0, atol=1e-9)


class ColumnCollapse(unittest.TestCase):
    def test_the_front_accelerates_and_stays_below_ritter_s_speed(self):
        for data in (column_collapse.MEASURED, column_collapse.MEASURED_SMALL):
            steps = np.diff(data, axis=0)
            self.assertTrue((steps > 0).all())
            # A single difference carries two readings' errors of about 0.2.
            self.assertLess(column_collapse.speed(1.5, 6.4, data), 2)

    def test_the_scene_states_the_front_without_viscosity(self):
        # Half the nodes, which lose 0.5 % of the volume and of Z: 0.3 % less than twice as many.
        found = column_collapse.reference(nodes=40)
        self.assertAlmostEqual(found["inviscid_volume"], 2, delta=0.01)
        for name in ("front_at_2", "front_at_4", "speed"):
            self.assertAlmostEqual(found[f"inviscid_{name}"] / constant("dam_break", name), 1, delta=0.006)
        self.assertAlmostEqual(found["delay_at_first"], constant("dam_break", "delay"), delta=0.003)

    def test_the_column_begins_to_fall_as_fourier_says(self):
        # The pressure is harmonic, zero at side and top, and has the slopes 0 at the wall and -g at the floor.
        surface = column_collapse.column(40)
        acceleration, _ = column_collapse.slopes(surface, -surface[:, 1])
        k = (np.arange(30) + 0.5) * np.pi
        of_pressure = 2 * (-1.0) ** np.arange(30) / k**2 / np.cosh(2 * k)
        x, y = surface.T
        down = (of_pressure * k * np.cosh(k * (2 - y[-1]))).sum() - 1
        self.assertAlmostEqual(acceleration[-1, 1], down, delta=0.002)
        sideways = (of_pressure * k * np.sin(k) * np.sinh(k * (2 - y[:, None]))).sum(axis=1)
        # Not at the corners: slow near the upper one, and at the foot the acceleration has no bound.
        middle = (y > 0.3) & (y < 1.5)
        np.testing.assert_allclose(acceleration[middle, 0], sideways[middle], atol=0.01)


if __name__ == "__main__":
    unittest.main()
