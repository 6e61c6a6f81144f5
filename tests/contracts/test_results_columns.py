"""The columns of the results table that README.md explains are those of the view `results`."""

import re
import sqlite3
import unittest

from repository import section, text_of


def columns_of_view():
    store = sqlite3.connect(":memory:")
    store.executescript(text_of("schemas/results.sql"))
    return [row[1] for row in store.execute("PRAGMA table_info(results)")]


def columns_in_readme():
    table = section(text_of("README.md"), "The results table")
    first_cells = re.findall(r"^\| (.*?) \|", table, re.MULTILINE)
    return [name for cell in first_cells for name in re.findall(r"`(\w+)`", cell)]


class ResultsColumns(unittest.TestCase):
    def test_readme_names_only_columns_of_the_view(self):
        self.assertTrue(columns_in_readme())
        self.assertEqual([name for name in columns_in_readme() if name not in columns_of_view()], [])

    def test_readme_explains_every_column(self):
        intervals = {f"{name}_ci95" for name in columns_in_readme()}
        unexplained = set(columns_of_view()) - set(columns_in_readme()) - intervals
        self.assertEqual(sorted(unexplained), [])

    def test_every_measured_quantity_has_an_interval(self):
        columns = columns_of_view()
        for name in ("re_tau_w", "re_tau", "u_max", "y_max", "d", "k_plus_dk", "delta_u_plus", "delta_max", "delta_rms"):
            self.assertIn(name, columns)
            self.assertIn(f"{name}_ci95", columns)


if __name__ == "__main__":
    unittest.main()
