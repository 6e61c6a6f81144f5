"""case_defaults_test.py ROOT: what figures take from a case's file that leaves things out. ROOT is the source folder."""

import pathlib
import sys
import types
import unittest

ROOT = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(ROOT / "analysis"))
import case_defaults  # noqa: E402
import solid_words  # noqa: E402


def case_with(solid):
    physics = {"flow": "elastic_wall", "grid": {"nx": 8, "ny_fluid": 8, "ny_solid": 4, "nz": 8}, "solid": {"G": 1, **solid}}
    return types.SimpleNamespace(physics=case_defaults.with_defaults(physics))


class CaseDefaults(unittest.TestCase):
    def test_what_a_file_leaves_out_is_that_of_the_schema(self):
        physics = case_with({}).physics
        self.assertEqual((physics["reynolds"], physics["domain"]["layer_height"], physics["domain"]["length_x"]), (2800, 0.5, 6))
        self.assertEqual((physics["solid"]["interface"], physics["solid"]["threshold"]), ("height", 0.9))
        self.assertEqual((physics["solid"]["G"], physics["grid"]["nx"]), (1, 8))

    def test_what_it_gives_stays_and_no_choice_is_made_for_it(self):
        given = {"flow": "rigid_channel", "reynolds": 1000, "domain": {"length_x": 2}}
        physics = case_defaults.with_defaults(given)
        self.assertEqual((physics["reynolds"], physics["domain"]["length_x"], physics["domain"]["length_z"]), (1000, 2, 3))
        self.assertNotIn("solid", physics)
        self.assertNotIn("fixed_dt", physics["time_step"])
        self.assertEqual(given, {"flow": "rigid_channel", "reynolds": 1000, "domain": {"length_x": 2}})

    def test_one_case_does_not_change_the_defaults_of_another(self):
        case_with({}).physics["domain"]["length_x"] = 99
        self.assertEqual(case_with({}).physics["domain"]["length_x"], 6)


class SolidWords(unittest.TestCase):
    def test_each_way_to_carry_the_solid_has_its_words(self):
        transported = {"formulation": "transported_B"}
        for solid, words in (
                ({}, "reference map"), (transported, "height, threshold 0.75"),
                ({**transported, "threshold": 0.5}, "height, threshold 0.5"),
                ({**transported, "interface": "mthinc"}, "MTHINC, threshold 0.9"),
                ({**transported, "interface": "weno"}, "WENO-Z, threshold 0.9"),
                ({**transported, "interface": "weno", "weno": "js", "threshold": 0.1}, "WENO-JS, threshold 0.1")):
            self.assertEqual(solid_words.option_of(case_with(solid)), words)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
