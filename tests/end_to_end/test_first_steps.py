"""What somebody meets before the first run: `softwall init`, help that opens with examples, completion in a shell."""

import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from harness import SOFTWALL


def softwall(*words, **options):
    return subprocess.run([SOFTWALL, *map(str, words)], capture_output=True, text=True, timeout=60, **options)


def completed(script, *words):
    """What bash offers for the last of these words."""
    program = (f'{script}\nCOMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _softwall; '
               'printf "%s\\n" "${COMPREPLY[@]}"')
    done = subprocess.run(["bash", "-c", program, "bash", "softwall", *words], capture_output=True, text=True, timeout=60)
    return done.stdout.split() if done.returncode == 0 else done.stderr


class FirstSteps(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.place = Path(scratch.name) / "it's new"

    def test_a_first_campaign_is_written_explained_and_sound(self):
        done = softwall("init", self.place)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        for words in ("physics.grid.nx", "Cells in x", "softwall plan '", "KEYS.md"):
            self.assertIn(words, done.stdout)
        written = json.loads((self.place / "campaign.json").read_text())
        self.assertEqual(written["name"], "it's new")
        plan = json.loads(softwall("plan", self.place, "--json").stdout)
        self.assertEqual([case["label"] for case in plan["cases"]], ["precursor", "G=2", "G=0.5", "G=0.25"])

    def test_a_campaign_that_is_there_stays(self):
        self.place.mkdir()
        (self.place / "campaign.json").write_text("mine")
        done = softwall("init", self.place)
        self.assertEqual(done.returncode, 2)
        self.assertIn("has a campaign.json already", done.stderr)
        self.assertEqual((self.place / "campaign.json").read_text(), "mine")

    def test_a_folder_without_a_name_of_its_own_has_one_all_the_same(self):
        self.place.mkdir()
        done = softwall("init", ".", cwd=self.place)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads((self.place / "campaign.json").read_text())["name"], "it's new")

    def test_a_folder_may_have_any_name(self):
        self.place.mkdir()
        for name in (b"x" * 200, b"caf\xe9", b"a\nb"):
            folder = os.path.join(os.fsencode(self.place), name)
            done = subprocess.run([SOFTWALL, "init", folder], capture_output=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (0, b""), name)
            plan = subprocess.run([SOFTWALL, "plan", folder, "--json"], capture_output=True, timeout=60)
            self.assertEqual(plan.returncode, 0, plan.stderr)
            case = os.path.join(folder, os.fsencode(json.loads(plan.stdout)["cases"][0]["directory"]))
            os.makedirs(case)
            os.symlink("checkpoints", os.path.join(case, b"checkpoints"))  # a loop: the reason names the folder
            status = subprocess.run([SOFTWALL, "status", folder, "--why", "--json"], capture_output=True, timeout=60)
            self.assertEqual((status.returncode, status.stderr), (0, b""))
            self.assertIn("cannot be read", json.loads(status.stdout)["cases"][0]["why"])

    def test_the_help_of_every_command_opens_with_examples(self):
        names = completed(softwall("completion", "bash").stdout, "")
        self.assertIn("run", names)
        for name in names:
            if name == "help":
                continue
            lines = softwall(name, "--help").stdout.splitlines()
            first = lines.index("Examples:")
            self.assertTrue(lines[first + 1].startswith(f"    softwall {name}"), lines[first + 1])
            self.assertLess(first, next(i for i, line in enumerate(lines) if line.startswith("Usage:")))

    def test_bash_completes_commands_options_and_files(self):
        script = softwall("completion", "bash").stdout
        self.assertEqual(completed(script, "ru"), ["run"])
        self.assertEqual(completed(script, "status", "--w"), ["--watch", "--why"])
        self.assertEqual(completed(script, "export", "--cs"), ["--csv"])
        self.assertEqual(completed(script, "help", "sta"), ["status"])
        self.assertEqual(completed(script, "run", ""), [])  # bash offers files then
        self.assertIn("-o default", script)

    def test_the_other_shells_take_their_scripts(self):
        for shell in ("zsh", "fish"):
            script = softwall("completion", shell).stdout
            for words in ("stall-minutes", "--watch" if shell == "zsh" else "-l watch", "rebuild"):
                self.assertIn(words, script)
            if shutil.which(shell):
                checked = subprocess.run([shell, "-n"], input=script, capture_output=True, text=True, timeout=60)
                self.assertEqual((checked.returncode, checked.stderr), (0, ""), shell)

    def test_an_unknown_shell_is_refused(self):
        done = softwall("completion", "tcsh")
        self.assertEqual(done.returncode, 2)
        self.assertIn("bash", done.stderr)


if __name__ == "__main__":
    unittest.main()
