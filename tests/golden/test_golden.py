"""Files that an earlier version wrote are read by this one, hold what they held, and can be gone on from."""

import json
import unittest

from golden import Copy, sets, values_of


def differences(known, found, where=""):
    """Where something known is missing or another. What later versions add is no difference."""
    if isinstance(known, dict) and isinstance(found, dict):
        return [text for key, value in known.items()
                for text in (differences(value, found[key], f"{where}/{key}") if key in found
                             else [f"{where}/{key} is missing"])]
    if isinstance(known, list) and isinstance(found, list) and len(known) == len(found):
        return [text for n, value in enumerate(known) for text in differences(value, found[n], f"{where}/{n}")]
    return [] if known == found else [f"{where} is {found!r}, was {known!r}"]


class Golden(unittest.TestCase):
    def test_there_are_sets(self):
        self.assertTrue(sets())

    def test_every_file_holds_what_it_held(self):
        for folder in sets():
            with self.subTest(folder.name):
                known = json.loads((folder / "known.json").read_text(encoding="utf-8"))
                self.assertTrue(known["run directories"] and known["results"] and known["attempts"])
                self.assertEqual(differences(known, values_of(folder)), [])

    def test_verify_finds_nothing_wrong(self):
        for folder in sets():
            with self.subTest(folder.name):
                copy = Copy(folder)
                self.addCleanup(copy.remove)
                copy.softwall("verify")  # as an earlier program left it
                copy.softwall("rebuild")
                copy.softwall("verify")

    def test_a_campaign_goes_on_from_its_checkpoints(self):
        for folder in sets():
            with self.subTest(folder.name):
                copy = Copy(folder)
                self.addCleanup(copy.remove)
                file = copy.folder / "campaign.json"
                campaign = json.loads(file.read_text(encoding="utf-8"))
                campaign["run"]["end_time"] *= 1.2
                file.write_text(json.dumps(campaign), encoding="utf-8")
                copy.softwall("run")
                rows = json.loads(copy.softwall("query", "SELECT attempt, outcome, resumed_from FROM attempts "
                                                "WHERE attempt > 1", "--json"))
                self.assertEqual(len(rows), len(json.loads(copy.softwall("export", "--json"))) - 1)  # all but the precursor
                for row in rows:
                    self.assertEqual(row["outcome"], "finished")
                    self.assertIn("checkpoint-", row["resumed_from"])

    def test_a_difference_is_seen(self):
        self.assertEqual(differences({"a": [1, {"b": 2}]}, {"a": [1, {"b": 2, "c": 3}], "d": 4}), [])
        self.assertEqual(len(differences({"a": [1, {"b": 2}]}, {"a": [1, {"b": 2.5}]})), 1)
        self.assertEqual(len(differences({"a": [1, {"b": 2}]}, {"a": [1, {}]})), 1)
        self.assertEqual(len(differences({"a": [1, 2]}, {"a": [1]})), 1)


if __name__ == "__main__":
    unittest.main()
