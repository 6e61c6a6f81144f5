"""The files and exit statuses that the two programs share are documented."""

import re
import unittest

from repository import text_of


class RunDirectory(unittest.TestCase):
    def test_every_run_file_is_documented(self):
        names = re.findall(r'directory / "([^"]+)"', text_of("solver/run_directory/run_files.hpp"))
        self.assertIn("case.json", names)
        readme = text_of("campaign/README.md")
        self.assertEqual([name for name in names if name not in readme], [])

    def test_every_exit_status_of_the_solver_is_documented(self):
        statuses = re.findall(r"^\s*k\w+ = (\d+),", text_of("solver/run_directory/exit_codes.hpp"), re.MULTILINE)
        self.assertIn("85", statuses)
        readme = text_of("solver/README.md")
        self.assertEqual([number for number in statuses if not re.search(rf"\| *`?{number}`? *\|", readme)], [])


    def test_the_manual_page_of_the_solver_lists_every_exit_status(self):
        statuses = re.findall(r"^\s*k\w+ = (\d+),", text_of("solver/run_directory/exit_codes.hpp"), re.MULTILINE)
        page = text_of("solver/softwall-dns.1").partition(".Sh EXIT STATUS")[2]
        self.assertEqual([number for number in statuses if not re.search(rf"\b{number} ", page)], [])


if __name__ == "__main__":
    unittest.main()
