"""spectra_test.py ROOT: what the figures make of spectra.h5. ROOT is the source folder.

Exit 77 (skipped) where h5py or matplotlib is not installed.
"""

import pathlib
import sys
import tempfile
import unittest
from unittest import mock

import packages_or_skip

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "analysis"))


class FakeCase:
    def __init__(self, directory, start):
        self.directory, self.start = pathlib.Path(directory), [start]


class Correlations(unittest.TestCase):
    def test_of_any_field_they_are_those_that_its_values_have(self):
        random = np.random.default_rng(1)
        for n in (11, 12):
            values = random.standard_normal((7, n))
            values -= values.mean()
            power = (abs(np.fft.rfft(values)) ** 2 / n**2).mean(axis=0)
            power[1:] *= 2
            if n % 2 == 0:
                power[-1] /= 2
            exact = np.array([(values * np.roll(values, -shift, axis=1)).mean() for shift in range(n // 2 + 1)])
            found = spectra_data.correlation_of(power[None], n)
            self.assertLess(abs(found[0] - exact / exact[0]).max(), 1e-14)
        self.assertTrue((spectra_data.correlation_of(np.zeros((2, 6)), 10) == 0).all())


class SpectraFile(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        self.y_face = np.concatenate([np.linspace(0, 2, 11), np.linspace(2.1, 2.5, 5)])
        moments.write_spectra(self.folder / "spectra.h5", self.y_face, [0.0, 10, 20, 30], elastic=True)

    def test_means_are_those_of_the_blocks_from_the_start_of_the_window_on(self):
        with h5py.File(self.folder / "spectra.h5", "r+") as data:
            data["spectra/x_u"][0] = 1e9
            data["spectra/x_u"][1] *= 2
            rows = data["spectra/x_u"][2].astype(float)
        spectra = spectra_data.read_spectra(FakeCase(self.folder, 10))
        self.assertEqual(list(spectra.flow.start), [10, 20])
        found = spectra.spectrum("x", "u") * 2 * np.pi / moments.LENGTH_X
        self.assertLess(abs(found - 1.5 * rows).max(), 1e-9)

    def test_integrals_of_spectra_are_mean_squares(self):
        spectra = spectra_data.read_spectra(FakeCase(self.folder, 0))
        for axis in "xz":
            k, E = spectra.wave_numbers(axis), spectra.spectrum(axis, "eta")
            self.assertAlmostEqual(E.sum() * k[1], moments.AMPLITUDE**2 / 2, delta=2e-5)
        self.assertAlmostEqual(spectra.wave_numbers("x")[moments.WAVES], 2 * np.pi * moments.WAVES / moments.LENGTH_X)

    def test_v_stands_on_the_faces(self):
        spectra = spectra_data.read_spectra(FakeCase(self.folder, 0))
        self.assertTrue((spectra.heights("v") == self.y_face[:-1]).all())
        self.assertEqual(spectra.correlation("z", "v").shape, (len(self.y_face) - 1, moments.NZ // 2 + 1))

    def test_a_rigid_channel_has_the_correlations_of_both_its_halves(self):
        with h5py.File(self.folder / "spectra.h5", "r+") as data:
            for axis in "xz":  # each row has other correlations
                data[f"spectra/{axis}_v"][:, 2] += 0.01 * np.arange(len(self.y_face) - 1, dtype="f4")
        case = FakeCase(self.folder, 0)
        spectra, source = spectra_data.read_spectra(case), correlations.source_of(case)
        found = plot_rigid_channel.Correlations(source, 100)  # y+ = 98 is y = 0.98 and 1.02
        for axis, n, length in (("x", moments.NX, moments.LENGTH_X), ("z", moments.NZ, moments.LENGTH_Z)):
            self.assertAlmostEqual(found.separation[axis][-1], length / 2)
            rows, row_of = spectra.correlation(axis, "v"), lambda y: np.argmin(abs(self.y_face - y))
            expected = (rows[row_of(0.2)] + rows[row_of(1.8)]) / 2
            at_low = plot_rigid_channel.Correlations(source, 50).along[axis]["v", 10]
            self.assertLess(abs(at_low - expected).max(), 1e-14)
            self.assertEqual(found.along[axis]["u", 98].shape, (n // 2 + 1,))

    def test_without_a_block_in_the_window_or_a_file_there_is_nothing(self):
        self.assertIsNone(spectra_data.read_spectra(FakeCase(self.folder, 25)))
        (self.folder / "spectra.h5").write_bytes(b"damaged")
        self.assertIsNone(spectra_data.read_spectra(FakeCase(self.folder, 0)))
        (self.folder / "spectra.h5").unlink()
        self.assertIsNone(spectra_data.read_spectra(FakeCase(self.folder, 0)))

    def test_the_density_of_the_height_has_area_one_and_the_moments_of_a_wave(self):
        spectra = spectra_data.read_spectra(FakeCase(self.folder, 0))
        edges, density = plot_interface_shape.density(spectra)
        middle, width = (edges[1:] + edges[:-1]) / 2, np.diff(edges)
        self.assertAlmostEqual((density * width).sum(), 1, places=6)
        self.assertAlmostEqual((density * middle**2 * width).sum(), 1, delta=0.02)
        skewness, flatness = plot_interface_shape.shape_of(spectra)
        self.assertAlmostEqual(skewness, 0)
        self.assertAlmostEqual(flatness, 1.5)

    def test_the_normal_density_is_that_of_the_bins(self):
        """Half of a normal distribution in a bin from 0 to 4 rms has a mean of an eighth there; in narrow bins it is the density."""
        self.assertAlmostEqual(plot_interface_shape.normal_density(np.array([-4.0, 0, 4]))[0], 0.125, delta=1e-5)
        narrow = plot_interface_shape.normal_density(np.array([0.999, 1.001]))[0]
        self.assertAlmostEqual(narrow, np.exp(-0.5) / np.sqrt(2 * np.pi), places=6)

    def test_walls_that_move_less_than_two_bins_have_no_density(self):
        bin_width = 1 / 256
        for rms, resolved in ((2.1 * bin_width, True), (1.9 * bin_width, False), (0.0, False)):
            with h5py.File(self.folder / "spectra.h5", "r+") as data:
                data["interface/eta2"][...] = rms**2
            spectra = spectra_data.read_spectra(FakeCase(self.folder, 0))
            self.assertEqual(plot_interface_shape.is_resolved(spectra), resolved)
            panel, case = matplotlib.figure.Figure().subplots(), mock.Mock()
            case.name = "wall"
            plot_interface_shape.draw_density(panel, [(case, spectra)])
            _, x, values = case.draw.call_args.args
            self.assertEqual((len(x) > 0, len(values) > 0), (resolved, resolved))
            self.assertEqual("wall" in plot_interface_shape.words_of_bins([(case, spectra)]), not resolved)

    def test_joint_densities_have_area_one_and_the_correlation_of_the_wave(self):
        spectra = spectra_data.read_spectra(FakeCase(self.folder, 0))
        for pair, exact in ((("v", "eta"), 0), (("p", "eta"), 0.5), (("v", "p"), 3**0.5 / 2)):
            self.assertAlmostEqual(plot_interface_pairs.correlation(spectra, pair), exact)
            first, second, density = plot_interface_pairs.density(spectra, pair)
            share = density * np.outer(np.diff(first), np.diff(second))
            self.assertAlmostEqual(share.sum(), 1)
            middle = [(edges[1:] + edges[:-1]) / 2 for edges in (first, second)]
            self.assertAlmostEqual((share * np.outer(*middle)).sum(), exact, delta=0.02)

    def test_joint_distributions_and_rms_are_of_one_time(self):
        """The joint distributions began in the middle of the first block of the interface, which moved twice as much then."""
        with h5py.File(self.folder / "spectra.h5", "r+") as data:
            data["interface_pairs/start"][0], data["interface_pairs/weight"][0] = 5, 5
            data["interface/vv"][0] *= 4
        spectra = plot_interface_pairs.of_one_time(spectra_data.read_spectra(FakeCase(self.folder, 0)))
        self.assertAlmostEqual(plot_interface_pairs.rms(spectra, "v"), 0.1 * np.sqrt((4 * 5 + 10 + 10) / 25))
        share = spectra.pairs.mean("share_v_p")
        self.assertAlmostEqual(share.sum(), 1)

    def test_what_lies_beyond_the_bins_is_not_shown_but_named(self):
        with h5py.File(self.folder / "spectra.h5", "r+") as data:
            data["interface_pairs/share_v_p"][:, 20, -1] += 0.01
        spectra = spectra_data.read_spectra(FakeCase(self.folder, 0))
        shades = plot_interface_pairs.draw(matplotlib.figure.Figure().subplots(), spectra, ("v", "p"))
        self.assertEqual(shades.get_array().size, 47 * 47)
        case = None
        self.assertRegex(plot_interface_pairs.words_of_bins([(case, spectra)]), r"0\.39 .* at most 1 % of the interface")

    def test_where_an_earlier_version_has_summed_no_joint_distribution_the_panel_says_so(self):
        with h5py.File(self.folder / "spectra.h5", "r+") as data:
            data.move("interface_pairs", "something_else")
        spectra = spectra_data.read_spectra(FakeCase(self.folder, 0))
        self.assertIsNone(spectra.pairs)
        panel = matplotlib.figure.Figure().subplots()
        self.assertIsNone(plot_interface_pairs.draw(panel, spectra, ("p", "eta")))
        self.assertEqual(panel.get_title(), "correlation 0.50")
        self.assertIn("no joint distribution", panel.texts[0].get_text())


class EnergyBudgets(unittest.TestCase):
    def setUp(self):
        self.y_face = np.concatenate([np.linspace(0, 2, 41), np.linspace(2.05, 2.5, 10)])
        with tempfile.TemporaryDirectory() as folder:
            moments.write_spectra(pathlib.Path(folder) / "spectra.h5", self.y_face, [0.0, 10, 20], elastic=True)
            self.spectra = spectra_data.read_spectra(FakeCase(folder, 0))
        self.budget = energy_budget.Budget(self.spectra.y, self.spectra.budget, 2800.0)
        self.arrays, self.production, self.handed_on = moments.budget_of_a_known_flow(self.y_face)

    def assert_equal_rows(self, found, exact):
        self.assertLess(abs(found - exact).max(), 1e-15)

    def test_the_mean_flow_is_taken_out_of_every_term(self):
        terms = self.budget.terms()
        self.assert_equal_rows(terms["production"], self.production)
        self.assert_equal_rows(terms["dissipation"], -0.9 * self.production)
        self.assert_equal_rows(terms["turbulent transport"], self.handed_on)
        self.assert_equal_rows(terms["rate of change"], -0.05 * self.production)
        for name in ("pressure transport", "viscous transport", "work on the wall", "elastic transport", "driving"):
            self.assert_equal_rows(terms[name], 0)
        self.assertGreater(self.budget.total(self.production), 1e-4)
        self.assertAlmostEqual(self.budget.total(terms["turbulent transport"]), 0)

    def test_what_is_missing_is_the_error_of_closure(self):
        missing = 0.05 * self.production + self.handed_on
        produced = self.budget.total(self.production)
        local, whole = self.budget.closure()
        self.assertAlmostEqual(local, self.budget.total(abs(missing)) / produced)
        self.assertAlmostEqual(whole, 0.05)

    def test_the_power_of_the_gradient_is_accounted_for(self):
        driving, spent, rest = self.budget.bulk()
        self.assertAlmostEqual(driving, 0.004 * 2, delta=2e-5)
        dissipated = self.budget.total(self.arrays["work_viscous"])
        self.assertAlmostEqual(spent["viscous"], dissipated)
        self.assertAlmostEqual(spent["gained speed"], self.budget.total(self.arrays["rate_kinetic"]))
        self.assertAlmostEqual(rest, driving - dissipated - spent["gained speed"])


    def test_terms_have_the_intervals_of_their_blocks(self):
        """Of a production that follows one series, as of the series itself."""
        factor = 1 + 0.1 * np.random.default_rng(7).standard_normal(12)
        with tempfile.TemporaryDirectory() as name:
            file = pathlib.Path(name) / "spectra.h5"
            moments.write_spectra(file, self.y_face, [10.0 * n for n in range(13)], elastic=True)
            with h5py.File(file, "r+") as data:
                data["budget/factor"] = factor[:, None]
                data["budget/uv"][...] = data["budget/uv"][:] * factor[:, None]
            spectra = spectra_data.read_spectra(FakeCase(name, 0))
        mean = lambda sums: sums.mean("factor")[0]
        relative = batches.half_width(spectra.budget, mean) / mean(spectra.budget)
        intervals = plot_energy_budget.intervals_of(spectra, 2800.0)
        self.assertGreater(relative, 0.01)
        production = energy_budget.Budget(spectra.y, spectra.budget, 2800.0).terms()["production"]
        self.assertLess(abs(intervals["production"] - relative * abs(production)).max(), 1e-12)
        self.assertLess(abs(intervals["dissipation"]).max(), 1e-12)
        self.assertNotIn("rate of change", intervals)
        self.assertEqual(plot_energy_budget.intervals_of(self.spectra, 2800.0), {})


class SpaceTimeSpectra(unittest.TestCase):
    def waves(self, noise=0.0):
        """One wave downstream and one upstream, at moments that lie as a solver's do."""
        random = np.random.default_rng(3)
        time = np.cumsum(0.04 + 0.02 * random.random(4000))
        amplitude = np.stack([0.3 * np.exp(-2.5j * time), 0.2 * np.exp(1.7j * time), 0 * time], axis=1)
        return time, amplitude + noise * random.standard_normal(amplitude.shape)

    def test_waves_stand_at_their_frequency_with_their_sign(self):
        time, amplitude = self.waves(noise=0.01)
        frequencies, E = wave_spectrum.space_time_spectrum(time, amplitude, 10, 20)
        bin_width = 2 * np.pi / 20
        for mode, exact in ((0, 2.5), (1, -1.7)):
            self.assertLess(abs(frequencies[np.argmax(E[:, mode])] - exact), bin_width)

    def test_the_integral_over_all_frequencies_is_the_mean_square(self):
        time, amplitude = self.waves()
        frequencies, E = wave_spectrum.space_time_spectrum(time, amplitude, 10, 20)
        integral = E.sum(axis=0) * (frequencies[1] - frequencies[0])
        self.assertLess(abs(integral / (0.3**2, 0.2**2, 1) - (1, 1, 0)).max(), 0.02)

    def test_segments_in_which_sampling_has_paused_are_left_out(self):
        time = np.concatenate([np.arange(0, 50, 0.05), np.arange(58, 100, 0.05)])
        parts = wave_spectrum.segments(time, 10, 20)
        self.assertEqual([round(float(time[part[0]])) for part in parts], [10, 20, 30, 60, 70])

    def test_segments_cover_the_window_and_nothing_before_it(self):
        time = np.arange(0, 100, 0.05)
        parts = wave_spectrum.segments(time, 30, 20)
        self.assertEqual([round(float(time[part[0]]), 2) for part in parts], [30, 40, 50, 60, 70])
        self.assertIsNone(wave_spectrum.space_time_spectrum(time, np.zeros((2000, 1)), 90, 20))


if __name__ == "__main__":
    packages_or_skip.needed("h5py", "matplotlib")
    import h5py
    import numpy as np

    import batches
    import correlations
    import energy_budget
    import matplotlib.figure
    import moments
    import plot_energy_budget
    import plot_interface_pairs
    import plot_interface_shape
    import plot_rigid_channel
    import spectra_data
    import wave_spectrum
    unittest.main(argv=sys.argv[:1])
