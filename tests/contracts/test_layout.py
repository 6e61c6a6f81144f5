"""What lies where: the top level is fixed, every top folder has its README, nothing points out of the repository."""

import re
import unittest

from repository import ROOT, committed_files, text_of

TOP_LEVEL = {"CMakeLists.txt", "CMakePresets.json", "README.md", "LICENSE", "CONTRIBUTING.md", "CHANGELOG.md", "CITATION.cff",
             "solver", "campaign", "analysis", "schemas", "tests", "runs"}
ROOMS = ["solver", "campaign", "analysis", "schemas", "tests", "runs"]
# Absolute paths of somebody's machine, and folders beside the repository.
OUTSIDE = re.compile(r"(?<![\w.$}>)/-])/(?:home|root|work|Users)(?:/|\b)|\.\./(?:\.\./)*shared\b")
LINK = re.compile(r"\]\((?!https?:|mailto:|#)([^)#\s]+)")
MENTIONED_PATH = re.compile(r"`((?:solver|campaign|analysis|schemas|tests|runs)/[\w./-]+)`")
PRODUCED = re.compile(r"/(results\.db|cases|manager\.log)|^schemas/embedded\.hpp$")


def is_text(path):
    return b"\0" not in (ROOT / path).read_bytes()[:8192]


class Layout(unittest.TestCase):
    def test_top_level(self):
        entries = {path.parts[0] for path in committed_files()}
        self.assertEqual(sorted(name for name in entries - TOP_LEVEL if not name.startswith(".")), [])
        self.assertEqual(sorted(TOP_LEVEL - entries), [])

    def test_every_room_has_a_readme(self):
        self.assertEqual([room for room in ROOMS if not (ROOT / room / "README.md").is_file()], [])

    def test_nothing_points_outside(self):
        for path in filter(is_text, committed_files()):
            for number, line in enumerate(text_of(path).splitlines(), 1):
                self.assertIsNone(OUTSIDE.search(line), f"{path}:{number}: {line.strip()}")

    def test_links_and_paths_in_the_readmes_exist(self):
        for path in committed_files():
            if path.suffix != ".md":
                continue
            text = text_of(path)
            targets = [(ROOT / path).parent / link for link in LINK.findall(text)]
            targets += [ROOT / name for name in MENTIONED_PATH.findall(text) if not PRODUCED.search(name)]
            for target in targets:
                self.assertTrue(target.exists(), f"{path} mentions {target}")

    def test_no_file_is_too_long(self):
        for path in committed_files():
            if path.suffix in (".cpp", ".hpp"):
                self.assertLessEqual(len(text_of(path).splitlines()), 400, path)


if __name__ == "__main__":
    unittest.main()
