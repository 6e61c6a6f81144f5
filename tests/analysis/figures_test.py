"""Every figure script draws a campaign and explains itself on a folder without one.

figures_test.py WRITER ROOT: WRITER is the program analysis_sample_campaign, ROOT the source folder.
Exit 77 (skipped) where h5py or matplotlib is not installed.
"""

import contextlib
import csv
import io
import json
import math
import pathlib
import re
import runpy
import sqlite3
import subprocess
import sys
import tempfile
import traceback
import unittest
import warnings
from unittest import mock

import packages_or_skip

WRITER, ROOT = sys.argv[1], pathlib.Path(sys.argv[2])
sys.path.insert(0, str(ROOT / "analysis"))  # as if the scripts were started from there
ALL_SCRIPTS = sorted((ROOT / "analysis").glob("plot_*.py"))
# Those for closed boxes draw snapshots, which take a solver to make: end_to_end/test_closed_box.py draws them.
WAVES = ROOT / "analysis" / "plot_interface_waves.py"  # draws a campaign of its own
GROWTH = ROOT / "analysis" / "plot_growth_rates.py"
CORRELATIONS = ROOT / "analysis" / "plot_correlations.py"  # drawn along both directions
PLANES = ROOT / "analysis" / "plot_planes.py"
SPEEDS = ROOT / "analysis" / "plot_wave_speeds.py"  # linear theory takes its time: drawn of one case
SCRIPTS = [script for script in ALL_SCRIPTS
           if "from box_data import" not in script.read_text() and script not in (WAVES, GROWTH, CORRELATIONS, SPEEDS)]


def make_campaign(folder):
    """Real statistics files from WRITER, moments of an invented flow and a real store, made by the project's own SQL."""
    lines = subprocess.run([WRITER, folder], check=True, capture_output=True, text=True).stdout.splitlines()
    moments.write_moments(folder)
    store = sqlite3.connect(pathlib.Path(folder) / "results.db")
    store.executescript((ROOT / "schemas" / "results.sql").read_text())
    for case_id, line in enumerate(map(json.loads, lines)):
        solid = line["physics"].get("solid", {})
        store.execute(
            "INSERT INTO cases (case_id, label, directory, is_precursor, flow, G, viscosity_ratio, reynolds, grid, "
            "cells, end_time, ranks, physics, run, state_since, created) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, 2800, '', 1, 148, 1, '{}', '{}', '', '')",
            (str(case_id), line["directory"], line["directory"], not solid, line["physics"]["flow"],
             solid.get("G"), solid.get("viscosity_ratio")))
        for name, (value, ci95) in line["quantities"].items():
            store.execute("INSERT INTO quantities VALUES (?, ?, ?, ?, 100, 148, 24, ?, 1, '', '')",
                          (str(case_id), name, value, ci95, line["note"]))
    store.commit()
    store.close()


def make_waves(folder, frequency_error, decay_error):
    """Every wave of the reference with both formulations, on 32, 64 and 128 cells; errors are those on 32 cells and fall
    with second order."""
    import h5py
    import numpy as np

    lines = (ROOT / "analysis" / "data" / "interface_modes_linear.csv").read_text().splitlines()
    for number, row in enumerate(csv.DictReader(line for line in lines if not line.startswith("#"))):
        decay, frequency, nu = -float(row["re_s"]) / 2, float(row["im_s"]) / 2, float(row["nu_f"])
        for formulation in ("reference_map", "transported_B"):
            for cells in (32, 64, 128):
                directory = pathlib.Path(folder) / "cases" / f"{number}-{formulation}-{cells}"
                directory.mkdir(parents=True)
                physics = {
                    "flow": "interface_wave", "reynolds": 1 / (2 * nu), "grid": {"nx": cells},
                    "domain": {"length_x": 2, "layer_height": 1},
                    "solid": {"G": float(row["G_over_rho"]), "viscosity_ratio": float(row["nu_s"]) / nu,
                              "formulation": formulation},
                    "wave": {"decay": decay, "frequency": frequency, "displacement": 1e-4}}
                (directory / "case.json").write_text(json.dumps({"physics": physics}))
                finer = (32 / cells) ** 2
                rate = complex(-decay * (1 + decay_error * finer), frequency * (1 + frequency_error * finer))
                t = np.arange(0, 4.2 * math.pi / frequency, 0.02)
                with h5py.File(directory / "statistics.h5", "w") as file:
                    file["blocks/start"], file["blocks/end"], file["series/time"] = t, t + 1e-3, t
                    for phase, name in enumerate(("wave_v_fluid", "wave_v", "wave_v_solid", "wave_height")):
                        file[f"series/{name}"] = 1e-4 * np.exp(rate * t + 1j * phase).real


def make_growing_waves(folder, error):
    """The wave of linear theory under laminar flow with another one beside it, both formulations, on 24, 48 and 96 cells;
    `error` of the rate is that on 24 cells and falls with second order."""
    import h5py
    import numpy as np

    t = np.arange(0, 20, 0.05)
    for formulation in ("reference_map", "transported_B"):
        for cells in (24, 48, 96):
            directory = pathlib.Path(folder) / "cases" / f"{formulation}-{cells}"
            directory.mkdir(parents=True)
            physics = {
                "flow": "interface_wave", "reynolds": 2800, "grid": {"nx": cells},
                "domain": {"length_x": 2, "layer_height": 0.5}, "solid": {"G": 0.25, "formulation": formulation},
                "wave": {"decay": 0.037, "frequency": 2.15, "mean_flow": "laminar"}}
            (directory / "case.json").write_text(json.dumps({"physics": physics}))
            rate = 0.07562514 - 2.7323438j + error * (24 / cells) ** 2
            with h5py.File(directory / "statistics.h5", "w") as file:
                file["blocks/start"], file["blocks/end"], file["series/time"] = t, t + 1e-3, t
                for phase, name in enumerate(("wave_v_fluid", "wave_v", "wave_v_solid", "wave_height")):
                    wave = 1e-5 * (np.exp(rate * t + 1j * phase) + 0.3 * np.exp((-0.09 + 1.56j) * t))
                    file[f"series/{name}"], file[f"series/{name}_sin"] = wave.real, -wave.imag


class Drawn:
    """How a script ended that ran in this process, where numpy and matplotlib are loaded already."""

    def __init__(self, script, arguments):
        self.returncode, out, err = 0, io.StringIO(), io.StringIO()
        with (contextlib.redirect_stdout(out), contextlib.redirect_stderr(err), warnings.catch_warnings(),
              mock.patch.object(sys, "argv", [str(script), *map(str, arguments)])):
            warnings.simplefilter("error", UserWarning)
            try:
                runpy.run_path(str(script), run_name="__main__")
            except SystemExit as end:
                self.returncode = 0 if end.code is None else end.code if isinstance(end.code, int) else 1
                err.write(end.code + "\n" if isinstance(end.code, str) else "")
            except Exception:
                self.returncode = 1
                err.write(traceback.format_exc())
        self.stdout, self.stderr = out.getvalue(), err.getvalue()


def draw(script, *arguments):
    return Drawn(script, arguments)


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.campaign = pathlib.Path(cls.scratch.name) / "campaign"
        cls.campaign.mkdir()
        make_campaign(cls.campaign)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_there_are_scripts(self):
        self.assertGreaterEqual(len(SCRIPTS), 5)

    def test_every_script_draws(self):
        for script in SCRIPTS:
            with self.subTest(script.name):
                output = pathlib.Path(self.scratch.name) / (script.stem + ".png")
                done = draw(script, self.campaign, "-o", output)
                self.assert_drawn(done, output)

    def test_letters_are_as_large_as_the_style_says(self):
        for script in ALL_SCRIPTS:
            self.assertNotRegex(script.read_text(), r"fontsize=\d", script.name)

    def test_the_example_for_ones_own_questions_runs(self):
        output = pathlib.Path(self.scratch.name) / "notebook.png"
        for pandas in (True, False):  # with it, where it is installed, and without it
            with self.subTest(pandas=pandas), mock.patch.dict(sys.modules, {} if pandas else {"pandas": None}):
                done = draw(ROOT / "analysis" / "notebook.py", self.campaign, "-o", output)
                self.assert_drawn(done, output)
                self.assertIn("re_tau", done.stdout)

    def test_correlations_are_drawn_along_both_directions(self):
        for axis in "xz":
            output = pathlib.Path(self.scratch.name) / f"correlations_{axis}.png"
            self.assert_drawn(draw(CORRELATIONS, self.campaign, "--axis", axis, "-o", output), output)

    def test_wave_speeds_are_drawn(self):
        with tempfile.TemporaryDirectory() as folder:
            make_campaign(folder)
            for file in pathlib.Path(folder).glob("cases/*/spectra.h5"):
                if file.parent.name != "G=1_mu=1":
                    file.unlink()
            output = pathlib.Path(folder) / "speeds.png"
            self.assert_drawn(draw(SPEEDS, folder, "-o", output), output)

    def test_correlations_are_drawn_from_moments_where_there_are_no_spectra(self):
        with tempfile.TemporaryDirectory() as folder:
            make_campaign(folder)
            for file in pathlib.Path(folder).glob("cases/*/spectra.h5"):
                file.unlink()
            for script in (CORRELATIONS, ROOT / "analysis" / "plot_rigid_channel.py"):
                output = pathlib.Path(folder) / "correlations.png"
                self.assert_drawn(draw(script, folder, "-o", output), output)

    def test_a_film_has_a_picture_of_every_moment(self):
        """Those of one case and from one time on; numbered files and one animated picture have the same."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            film = (PLANES, self.campaign, "--film", "--case", "G=1_mu=1", "--quantity", "w")
            done = draw(*film, "-o", folder / "film")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            pictures = sorted((folder / "film").iterdir())
            self.assertEqual([picture.name for picture in pictures], ["00000.png", "00001.png", "00002.png"])
            self.assertEqual(len({picture.read_bytes() for picture in pictures}), 3, "nothing moves")
            for other in ("cover.png", "00007.txt"):
                (folder / "film" / other).write_text("not of the film")
            for output in ("film", "film.gif"):
                done = draw(*film, "--from", "130", "-o", folder / output)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(sorted(file.name for file in (folder / "film").iterdir()),
                             ["00000.png", "00001.png", "00007.txt", "cover.png"], "a shorter film has taken its place")
            from PIL import Image

            with Image.open(folder / "film.gif") as picture:
                self.assertEqual((picture.format, picture.n_frames), ("GIF", 2))

    def test_frames_of_a_film_are_drawn_one_at_a_time(self):
        import film_data
        import plot_planes

        case = mock.Mock(directory=self.campaign / "cases" / "G=1_mu=1")
        case.name = "G=1"
        picture = plot_planes.Picture([(case, film_data.moments_of(case))], "u")
        drawn = []
        with mock.patch.object(picture, "draw", side_effect=lambda at, draw=picture.draw: drawn.append(1) or draw(at)):
            frames = plot_planes.frames_of(picture, [0.0, 130.0, 148.0])
            for number in (1, 2, 3):
                self.assertEqual(next(frames).mode, "RGBA")
                self.assertEqual((len(drawn), len(plot_planes.plt.get_fignums())), (number, 1))
            self.assertEqual((list(frames), plot_planes.plt.get_fignums()), ([], []))

    def test_planes_are_those_of_the_time_asked_for(self):
        import film_data
        import numpy as np

        case = mock.Mock(directory=self.campaign / "cases" / "G=1_mu=1")
        film = film_data.moments_of(case)
        self.assertEqual([moment.time for moment in film], [0.0, 130.0, 148.0])
        self.assertEqual([moment.time for moment in film_data.moments_of(case, start=130)], [130.0, 148.0])
        self.assertEqual([film_data.nearest_in_time(film, time).time for time in (None, 100, -1)], [148.0, 130.0, 0.0])
        last = film[-1]
        np.testing.assert_allclose(last.plane("interface", "height")[3], np.roll(moments.eta(), 2), atol=1e-6)
        self.assertEqual([last.plane(name, "u").shape for name in ("x_0", "y_0", "z_0")],
                         [tuple(len(faces) - 1 for faces in reversed(last.corners(name))) for name in ("x_0", "y_0", "z_0")])
        self.assertIsNone(last.plane("x_0", "height"))
        self.assertAlmostEqual(last.places["z_0"], 4.5 / moments.NZ * moments.LENGTH_Z)

    def test_flow_without_moments_is_explained(self):
        with tempfile.TemporaryDirectory() as folder:
            make_campaign(folder)
            for kind in ("fields/*", "checkpoints/*", "planes/*", "spectra.h5"):
                for file in pathlib.Path(folder).glob(f"cases/*/{kind}"):
                    file.unlink()
            for name in ("correlations", "velocity_planes", "wall_surface"):
                done = draw(ROOT / "analysis" / f"plot_{name}.py", folder)
                self.assertEqual(done.returncode, 1)
                self.assertRegex(done.stderr, "^no .* has (spectra, )?a snapshot or a checkpoint\n$")
            done = draw(PLANES, folder)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, "^no case has a film; run.plane_interval .*\n$")
            for name in ("spectra", "energy_budget", "interface_shape", "interface_pairs", "wave_speeds"):
                done = draw(ROOT / "analysis" / f"plot_{name}.py", folder)
                self.assertEqual(done.returncode, 1)
                self.assertRegex(done.stderr, "^no .* has .* in its averaging window\n$")

    def assert_drawn(self, done, picture):
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertGreater(picture.stat().st_size, 20000)

    def test_waves_are_drawn_and_their_rates_found(self):
        with tempfile.TemporaryDirectory() as folder:
            make_waves(folder, frequency_error=0.08, decay_error=-0.64)
            picture = pathlib.Path(folder) / "waves.png"
            done = draw(WAVES, folder, "-o", picture)
            self.assert_drawn(done, picture)
        for quantity, error, bar in (("frequency", 0.005, 0.01), ("decay", 0.04, 0.05)):
            found = [float(value) for value in re.findall(rf"^  {quantity}\D.*?(0\.\d+)   bar {bar}", done.stdout, re.M)]
            self.assertEqual(len(found), 20)
            for value in found:
                self.assertAlmostEqual(value, error, delta=2e-5)
        orders = [float(value) for value in re.findall(r"order of the rate +(\S+)", done.stdout)]
        self.assertEqual(len(orders), 20)
        self.assertTrue(all(abs(order - 2) < 0.01 for order in orders), orders)

    def test_growing_waves_are_drawn_and_their_rates_found(self):
        with tempfile.TemporaryDirectory() as folder:
            make_growing_waves(folder, error=0.016 + 0.032j)
            picture = pathlib.Path(folder) / "growth.png"
            done = draw(GROWTH, folder, "-o", picture)
            self.assert_drawn(done, picture)
        errors = [float(value) for value in re.findall(r" 96 cells .* growth (\S+),.*bars 0.0015, 0.2 % holds", done.stdout)]
        self.assertEqual(len(errors), 2, done.stdout)
        for error in errors:
            self.assertAlmostEqual(error, 0.001, delta=2e-5)
        orders = [float(value) for value in re.findall(r"errors fall, order between the finest two (\S+)", done.stdout)]
        self.assertEqual(len(orders), 2, done.stdout)
        self.assertTrue(all(abs(order - 2) < 0.01 for order in orders), orders)

    def test_means_are_those_of_the_averaging_window(self):
        with tempfile.TemporaryDirectory() as folder:
            make_campaign(folder)
            with contextlib.closing(sqlite3.connect(pathlib.Path(folder) / "results.db")) as store:
                store.execute("UPDATE quantities SET window_start = 110")
                store.commit()
            program = ("import sys, argparse; sys.path.insert(0, sys.argv[1]); from campaign_data import read_campaign\n"
                       "start = float(sys.argv[3]) if len(sys.argv) > 3 else None\n"
                       "cases = read_campaign(argparse.Namespace(campaign=sys.argv[2], start=start))\n"
                       "print(*(c.start[0] for c in cases if not c.elastic), *{c.start[0] for c in cases if c.elastic})")
            for given, starts in (((), "110.0 110.0\n"), (("120.5",), "110.0 122.0\n")):
                done = subprocess.run([sys.executable, "-c", program, ROOT / "analysis", folder, *given],
                                      capture_output=True, text=True)
                self.assertEqual(done.stdout, starts, done.stderr)

    def test_missing_packages_are_named_in_one_line(self):
        """Also for --help; by an interpreter that finds no package at all (-S: no site-packages)."""
        others = [ROOT / "analysis" / name for name in ("linear_stability.py", "figures.py", "report.py")]
        for script in [*ALL_SCRIPTS, *others]:
            with self.subTest(script.name):
                done = subprocess.run([sys.executable, "-S", script, "--help"], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stdout), (1, ""))
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
                self.assertRegex(done.stderr, r"has no .*numpy.*: sudo apt install .*python3-numpy .*pip install")

    def test_colours_go_by_the_value_and_lines_are_the_papers(self):
        program = ("import sys; sys.path.insert(0, sys.argv[1]); from case_style import colour_of, line_of\n"
                   "print(colour_of(4), colour_of(2), colour_of(1), colour_of(0.5), line_of(0.1), line_of(1), line_of(10))\n"
                   "print(colour_of(0.7) == colour_of(0.7), len({colour_of(g) for g in (0.3, 0.6, 0.7, 1.5, 3)}))")
        done = subprocess.run([sys.executable, "-c", program, ROOT / "analysis"], capture_output=True, text=True)
        self.assertEqual(done.stdout, "blue magenta red green : - --\nTrue 5\n", done.stderr)

    def test_whatever_a_sweep_varies_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            make_campaign(folder)
            for number, name in enumerate(("G=4_mu=1", "G=2_mu=1", "G=1_mu=1")):
                case = pathlib.Path(folder) / "cases" / name / "case.json"
                definition = json.loads(case.read_text())
                definition["physics"]["solid"] = {"G": 0.7, "viscosity_ratio": 1}
                definition["physics"]["grid"]["nx"] = 48 * (number + 1)
                case.write_text(json.dumps(definition))
            program = ("import sys, argparse; sys.path.insert(0, sys.argv[1]); from campaign_data import read_campaign\n"
                       "cases = read_campaign(argparse.Namespace(campaign=sys.argv[2], start=None))\n"
                       "print([case.name for case in cases if case.G == 0.7], len({c.style for c in cases if c.G == 0.7}))")
            done = subprocess.run([sys.executable, "-c", program, ROOT / "analysis", folder], capture_output=True, text=True)
            for words in ("on 48x", "on 96x", "on 144x"):
                self.assertIn(words, done.stdout, done.stderr)
            self.assertTrue(done.stdout.endswith("] 3\n"), done.stdout)

    def test_a_script_that_fails_costs_no_other_figure(self):
        program = ("import sys, argparse, pathlib; sys.path.insert(0, sys.argv[1]); import figures\n"
                   "folder = pathlib.Path(sys.argv[3])\n"
                   "(folder / 'bad.py').write_text('raise ValueError(1)')\n"
                   "figures.FIGURES = {'bad': (folder / 'bad.py',), 'friction': figures.FIGURES['friction']}\n"
                   "options = argparse.Namespace(campaign=sys.argv[2], output=folder, format='png', start=None, no_caption=False,\n"
                   "                             style='screen')\n"
                   "drawn, reasons = figures.draw_all(options)\n"
                   "print(list(drawn), reasons)")
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-c", program, ROOT / "analysis", self.campaign, folder],
                                  capture_output=True, text=True)
            self.assertIn("['friction'] {'bad': 'ValueError: 1'}", done.stdout, done.stderr)

    def test_log_law_of_a_very_soft_wall_is_drawn_without_plateau(self):
        """d+ = -30: points at or below the log law's origin are left out, its fit is drawn."""
        program = ("import sys, argparse, numpy as np; sys.path.insert(0, sys.argv[1]); import plot_log_law as p\n"
                   "case = next(c for c in p.read_campaign(argparse.Namespace(campaign=sys.argv[2], start=None)) if c.G == 0.5)\n"
                   "case.results.update(d=-30 / (case.u_tau * case.reynolds), log_range_low_plus=37)\n"
                   "figure, axes = p.plt.subplots(); p.plot_profiles(axes, [case])\n"
                   "x = [line.get_xdata() for line in axes.lines]\n"
                   "print(len(x), all((one > 0).all() and np.isfinite(one).all() for one in x), x[1][0] < 15)")
        done = subprocess.run([sys.executable, "-c", program, ROOT / "analysis", self.campaign], capture_output=True, text=True)
        self.assertEqual(done.stdout, "2 True True\n", done.stderr)

    def test_damaged_case_is_left_out_by_name(self):
        with tempfile.TemporaryDirectory() as folder:
            make_campaign(folder)
            victim = pathlib.Path(folder) / "cases" / "G=1_mu=1" / "statistics.h5"
            victim.write_bytes(b"damaged")
            done = draw(SCRIPTS[0], folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("left out", done.stderr)
            self.assertIn("G=1_mu=1", done.stderr)

    def test_empty_folder_is_explained(self):
        with tempfile.TemporaryDirectory() as folder:
            for script in ALL_SCRIPTS:
                with self.subTest(script.name):
                    done = draw(script, folder)
                    self.assertEqual(done.returncode, 1)
                    self.assertRegex(done.stderr, "has (statistics|left snapshots) yet")
                    self.assertNotIn("Traceback", done.stderr)

    def test_log_law_refuses_an_unknown_case(self):
        script = ROOT / "analysis" / "plot_log_law.py"
        done = draw(script, self.campaign, "--case", "nonsense")
        self.assertEqual(done.returncode, 1)
        self.assertIn("G=1_mu=10", done.stderr)


if __name__ == "__main__":
    packages_or_skip.needed("h5py", "matplotlib")
    import moments
    unittest.main(argv=sys.argv[:1])
