"""The body forces of the manufactured solutions, written in scenes by hand, are those that SymPy derives."""

import unittest

import numpy as np

import manufactured
from scene_text import constants, evaluate, vector_expression

CASES = {"axis_aligned": manufactured.AxisAligned, "generalized_vortex": manufactured.GeneralizedVortex}


def random_points(case, count=200):
    generator = np.random.default_rng(1)
    x, y = case.points(count, generator)
    return x, y, generator.uniform(0, case.period, count)


class ManufacturedSolutions(unittest.TestCase):
    def assert_expression(self, scene, field, function, x, y, t):
        values = constants(scene)
        for axis, (expression, exact) in enumerate(zip(vector_expression(scene, field), function(x, y, t))):
            with self.subTest(scene=scene, field=field, axis=axis):
                # The most that the schema allows.
                self.assertLessEqual(len(expression), 1024)
                found = evaluate(expression, **(values | {"x": x, "y": y, "t": t}))
                # Rounding, of differences of terms up to 100 times as large as their sum.
                np.testing.assert_allclose(found, exact, rtol=0, atol=1e-12 * np.abs(exact).max())

    def test_the_scenes_apply_the_body_force_of_their_motion(self):
        for scene, case in CASES.items():
            force = manufactured.body_force_function(case)
            self.assert_expression(scene, "field", force, *random_points(case))

    def test_the_scenes_start_with_the_velocity_of_their_motion(self):
        for scene, case in CASES.items():
            x, y, t = random_points(case)
            self.assert_expression(scene, "initial_velocity", manufactured.velocity_function(case), x, y, 0 * t)

    def test_momentum_balances_over_a_part_of_the_body(self):
        # The force on the edge of a small square and the body force within it accelerate its mass: an integral
        # form that does not differentiate the stress. Gauss points, 8 along each side.
        points, weights = np.polynomial.legendre.leggauss(8)
        half = 0.02
        for case, (x0, y0) in ((manufactured.AxisAligned, (0.3, 0.6)), (manufactured.GeneralizedVortex, (0.7, 0.6))):
            t = case.period / 8
            ends = []
            for axis, sign in ((0, 1), (0, -1), (1, 1), (1, -1)):
                x, y = (x0 + half * (sign if axis == 0 else points), y0 + half * (sign if axis == 1 else points))
                x, y = np.broadcast_arrays(x, y)
                ends.append(sign * half * weights @ manufactured.stress(case, x, y, t)[:, :, axis])
            x, y = (g.ravel() for g in np.meshgrid(x0 + half * points, y0 + half * points))
            area = half**2 * np.outer(weights, weights).ravel()
            force = np.array(manufactured.body_force_function(case)(x, y, t)) @ area * case.DENSITY
            acceleration = np.array(manufactured.acceleration_function(case)(x, y, t)) @ area * case.DENSITY
            # Rounding: the forces on opposite edges nearly cancel.
            np.testing.assert_allclose(sum(ends) + force, acceleration, rtol=0, atol=1e-11 * np.abs(ends).max() * 100)

    def test_the_vortex_leaves_its_edges_without_stress_and_in_place(self):
        turn = np.linspace(0, 2 * np.pi, 7)
        for radius in (0.75, 1.25):
            x, y = radius * np.cos(turn), radius * np.sin(turn)
            stress = manufactured.stress(manufactured.GeneralizedVortex, x, y, 0.4)
            # Rounding of F - F^-T, which depends on R with a slope of 200, in units of the modulus 1000.
            np.testing.assert_allclose(stress, 0, atol=1e-10)


if __name__ == "__main__":
    unittest.main()
