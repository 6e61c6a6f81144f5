"""cmake --install into an empty folder, and a campaign with the programs that came to be there."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = os.environ.get("BUILD", ROOT / "build")
CAMPAIGN = {
    "format": 1,
    "name": "tiny",
    "physics": {"flow": "rigid_channel", "domain": {"length_x": 2, "length_z": 1},
                "grid": {"nx": 8, "ny_fluid": 12, "nz": 8}, "time_step": {"fixed_dt": 0.01},
                "statistics": {"interval_steps": 2, "block_length": 0.05}},
    "sweep": {"list": [{"precision": "double"}, {"precision": "single"}]},
    "run": {"end_time": 0.2},
    "execution": {"ranks": 1, "cores": 1},
}


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.outer = Path(tempfile.mkdtemp(prefix="softwall-install-")).resolve()
        cls.prefix = cls.outer / "prefix"
        cls.installed = subprocess.run([os.environ.get("CMAKE", "cmake"), "--install", str(BUILD), "--prefix",
                                        str(cls.prefix)], capture_output=True, text=True, timeout=100)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.outer, ignore_errors=True)

    def softwall(self, *arguments):
        """The installed one, found by PATH from another folder."""
        environment = {name: value for name, value in os.environ.items() if not name.startswith("SOFTWALL")}
        environment["PATH"] = f"{self.prefix}/bin:{environment['PATH']}"
        return subprocess.run(["softwall", *map(str, arguments)], env=environment, cwd=self.outer,
                              capture_output=True, text=True, timeout=100)

    def copy_of_tiny(self, name):
        folder = self.outer / name
        folder.mkdir()
        (folder / "campaign.json").write_text(json.dumps(CAMPAIGN), encoding="utf-8")
        return folder

    def test_all_of_it_is_there(self):
        self.assertEqual(self.installed.returncode, 0, self.installed.stderr)
        files = {path.relative_to(self.prefix).as_posix() for path in self.prefix.rglob("*") if path.is_file()}
        schemas = {path.name for path in (ROOT / "schemas").iterdir() if path.suffix in (".json", ".sql")}
        self.assertTrue(schemas)
        wanted = ({f"bin/{name}" for name in ("softwall", "softwall-dns", "softwall-dns-single")}
                  | {f"share/softwall/schemas/{name}" for name in schemas}
                  | {f"share/man/man1/{name}.1" for name in ("softwall", "softwall-dns")}
                  | {f"share/{name}" for name in ("bash-completion/completions/softwall", "zsh/site-functions/_softwall",
                                                  "fish/vendor_completions.d/softwall.fish")}
                  | {f"share/doc/softwall/{name}" for name in ("README.md", "LICENSE", "CHANGELOG.md", "CITATION.cff")})
        self.assertEqual(wanted - files, set())
        self.assertEqual(sorted(path for path in files if path.startswith("bin/")),
                         sorted(path for path in wanted if path.startswith("bin/")), "programs of the tests, too")

    def test_it_says_its_version(self):
        said = self.softwall("--version")
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertIn(os.environ.get("VERSION", ""), said.stdout)

    def test_it_plans_the_quickstart(self):
        folder = self.outer / "quickstart"
        folder.mkdir()
        shutil.copy(ROOT / "runs/quickstart/campaign.json", folder)
        plan = self.softwall("plan", folder)
        self.assertEqual(plan.returncode, 0, plan.stderr)
        self.assertIn("quickstart: 6 cases", plan.stdout)

    def test_it_runs_a_campaign_in_both_precisions(self):
        folder = self.copy_of_tiny("tiny")
        run = self.softwall("run", folder)
        self.assertEqual(run.returncode, 0, run.stderr + run.stdout)
        self.assertIn("2 of 2 cases finished", run.stderr)
        self.assertEqual(self.softwall("verify", folder).returncode, 0)

    def test_its_solver_is_the_one_beside_it(self):
        """Without that one there is none: the programs of the build do not step in."""
        solver, aside = self.prefix / "bin/softwall-dns", self.prefix / "bin/aside"
        folder = self.copy_of_tiny("without")
        solver.rename(aside)
        try:
            run = self.softwall("run", folder)
        finally:
            aside.rename(solver)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("softwall-dns", run.stderr)


if __name__ == "__main__":
    unittest.main()
