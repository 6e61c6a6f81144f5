"""Linear theory of the layer under a mean flow, against published and independent results and against itself.

linear_stability_test.py ROOT: ROOT is the source folder. Exit 77 (skipped) where numpy is not installed.
"""

import csv
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import packages_or_skip

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "analysis"))
PROGRAM = ROOT / "analysis" / "linear_stability.py"
KNOWN_GROWTH = {  # laminar, Re 2800, thickness 0.5, ratio 1; from an independent program
    (0.25, 2): 0.07563 - 2.7323j, (0.25, 3): 0.03539 - 2.2402j, (0.25, 1): 0.01361 - 3.4759j,
    (0.5, 2): 0.01086 - 3.6096j, (1, 1): -0.01453 - 6.4427j, (0.125, 3): 0.16427 - 1.7334j}


class MeanProfiles(unittest.TestCase):
    y = [0.0, 0.1, 0.7, 1.0, 1.6, 2.0]

    def setUp(self):
        self.y = np.array(type(self).y)

    def test_laminar_flow_is_the_parabola(self):
        flow = mean_profiles.laminar(2800)
        np.testing.assert_allclose(flow.u(self.y, 0), 1.5 * self.y * (2 - self.y), atol=1e-14)
        np.testing.assert_allclose(flow.u(self.y, 1), 3 * (1 - self.y), atol=1e-14)
        np.testing.assert_allclose(flow.u(self.y, 2), -3, atol=1e-14)
        self.assertAlmostEqual(flow.gradient, 3 / 2800)

    def test_cess_has_the_flow_rate_and_balances_momentum(self):
        flow = mean_profiles.cess(2800)
        points, weights = np.polynomial.legendre.leggauss(200)
        self.assertAlmostEqual(flow.u(points + 1, 0) @ weights / 2, 1, delta=1e-8)
        stress = (1 / 2800 + flow.eddy_viscosity(self.y, 0)) * flow.u(self.y, 1)
        np.testing.assert_allclose(stress, flow.gradient * (1 - self.y), atol=1e-8)
        self.assertAlmostEqual(flow.re_tau, 178.5, delta=5)  # of Moser, Kim & Mansour at this Reynolds number
        for y in (self.y[1:-1], self.y[2:3]):
            slope = (flow.u(y + 1e-5, 1) - flow.u(y - 1e-5, 1)) / 2e-5
            np.testing.assert_allclose(flow.u(y, 2), slope, rtol=1e-5, atol=1e-5)

    def test_measured_profile_is_found_again(self):
        exact = mean_profiles.cess(2800)
        y = 1 + np.tanh(1.3 * (2 * (np.arange(96) + 0.5) / 96 - 1)) / np.tanh(1.3)
        flow = mean_profiles.measured(y, exact.u(y, 0), 2800, exact.gradient)
        np.testing.assert_allclose(flow.u(self.y, 0), exact.u(self.y, 0), atol=5e-3)
        np.testing.assert_allclose(flow.u(self.y, 1), exact.u(self.y, 1), atol=0.05 * 11.8)

    def test_a_table_says_how_it_is_driven(self):
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "mean.csv"
            table.write_text("# a parabola\ny,u\n" + "".join(f"{y},{1.5 * y * (2 - y)}\n" for y in np.linspace(0, 2, 33)))
            flow = mean_profiles.read_measured(table, 2800)
            self.assertAlmostEqual(flow.gradient, 3 / 2800, places=10)
            with self.assertRaisesRegex(ValueError, "Reynolds number"):
                mean_profiles.read_measured(table)


class Rates(unittest.TestCase):
    def test_rigid_channel_is_as_orszag_found_it(self):
        """J. Fluid Mech. 50 (1971): U = 1 - y^2, half height 1, alpha = 1, Re = 10^4."""
        s = linear_stability.rates(mean_profiles.laminar(1e4 / 1.5), None, 2 * math.pi, 1)[0]
        self.assertAlmostEqual(1j * s / 1.5, 0.23752649 + 0.00373967j, delta=2e-8)

    def test_waves_at_rest_have_the_rates_of_the_exact_solution(self):
        """Where fluid and layer are at rest the equations have solutions in closed form (data/interface_modes_linear.csv,
        for a fluid 1 deep: lengths and times here are twice those)."""
        lines = (ROOT / "analysis" / "data" / "interface_modes_linear.csv").read_text().splitlines()
        for row in csv.DictReader(line for line in lines if not line.startswith("#")):
            row = {name: float(value) for name, value in row.items() if name != "tag"}
            flow = mean_profiles.laminar(1 / (2 * row["nu_f"]), part=0)
            layer = linear_stability.Layer(row["G_over_rho"], row["nu_s"] / row["nu_f"], 2 * row["Hs"])
            exact = complex(row["re_s"], row["im_s"]) / 2
            problem = interface_operators.eigenvalue_problem(flow, layer, math.pi / row["lambda"])
            found = linear_stability.nearest_rate(problem, exact * 1.01)[0]
            self.assertAlmostEqual(found, exact, delta=1e-8 * abs(exact))

    def test_waves_under_laminar_flow_grow_as_known(self):
        for (G, wavelength), known in KNOWN_GROWTH.items():
            s = linear_stability.rates(mean_profiles.laminar(2800), linear_stability.Layer(G), wavelength, 1)[0]
            self.assertAlmostEqual(s.real, known.real, delta=1e-5)
            self.assertAlmostEqual(s.imag, known.imag, delta=1e-4)

    def test_the_wave_at_rest_becomes_the_one_that_grows(self):
        s = linear_stability.interface_rate(linear_stability.Layer(0.25), 2, 2800)
        self.assertAlmostEqual(s, KNOWN_GROWTH[0.25, 2], delta=1e-4)

    def test_rates_converge_spectrally(self):
        def rate(points, flow):
            problem = interface_operators.eigenvalue_problem(flow, linear_stability.Layer(0.25), math.pi, points)
            return linear_stability.nearest_rate(problem, 0.0756 - 2.73j)[0]
        flow = mean_profiles.laminar(2800)
        exact = rate((160, 80), flow)
        errors = [abs(rate(points, flow) - exact) for points in ((40, 20), (60, 30), (80, 40), (120, 60))]
        self.assertTrue(all(finer < coarser / 10 for coarser, finer in zip(errors[:3], errors[1:])), errors)
        self.assertLess(errors[-1], 1e-9)

    def test_pre_shear_and_curvature_count(self):
        """The terms of the deformed layer and of U'' at the interface: what the rate is without the mean stress."""
        flow = mean_profiles.laminar(2800)
        unloaded = mean_profiles.MeanFlow("", 2800, 0.0, flow.u, flow.eddy_viscosity)
        with_it, without = (linear_stability.rates(mean, linear_stability.Layer(0.25), 2, 1)[0]
                            for mean in (flow, unloaded))
        self.assertGreater(abs(with_it - without), 1e-4)

    def test_eigenvector_meets_walls_and_interface(self):
        points = (100, 48)
        flow, layer = mean_profiles.laminar(2800), linear_stability.Layer(0.25)
        A, M = interface_operators.eigenvalue_problem(flow, layer, math.pi, points)
        s, q = linear_stability.nearest_rate((A, M), 0.0756 - 2.73j)
        self.assertLess(np.linalg.norm(A @ q - s * (M @ q)), 1e-8 * np.linalg.norm(A) * np.linalg.norm(q))
        d = interface_operators.derivatives(points[0], 0, 2)[1]
        v = d[0] @ q[:points[0]]
        self.assertLess(abs(v[0]), 1e-9 * abs(v).max())

    def test_turbulent_mean_flow_lets_waves_grow_below_a_modulus(self):
        flow, layer = mean_profiles.cess(2800), linear_stability.Layer(1)
        G, wavelength = linear_stability.onset(flow, layer, (0.75, 1, 1.5))
        self.assertTrue(0.4 < G < 0.65)
        for part, sign in ((0.95, 1), (1.05, -1)):
            s = linear_stability.rates(flow, linear_stability.Layer(part * G), wavelength, 1)[0]
            self.assertGreater(sign * s.real, 0)
        self.assertIsNone(linear_stability.onset(flow, layer, (1,), low=1.5))

    def test_too_few_points_are_refused(self):
        with self.assertRaisesRegex(ValueError, "take more"):
            linear_stability.rates(mean_profiles.laminar(2800), linear_stability.Layer(0.25), 2, 50, (20, 12))


class CommandLine(unittest.TestCase):
    def run_program(self, *arguments):
        done = subprocess.run([sys.executable, PROGRAM, *arguments], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_rates_are_printed(self):
        text = self.run_program("--G", "0.25", "--wavelength", "2", "--modes", "1")
        self.assertRegex(text, r"2 +0\.075625 +-2\.732344 +0\.8697")

    def test_rigid_profile_is_named(self):
        self.assertIn("Re_tau 181", self.run_program("--profile", "cess", "--wavelength", "1", "--modes", "1"))


if __name__ == "__main__":
    packages_or_skip.needed("numpy")
    import numpy as np

    import interface_operators
    import linear_stability
    import mean_profiles
    unittest.main(argv=sys.argv[:1])
