"""Every key of every schema says what it means."""

import json
import subprocess
import sys
import unittest

from repository import ROOT

sys.path.insert(0, str(ROOT / "schemas"))
from keys import resolved  # noqa: E402

SCHEMAS = {path.name: json.loads(path.read_text(encoding="utf-8")) for path in sorted((ROOT / "schemas").glob("*.json"))}


def undescribed(name, schema, place):
    """A group of keys or a constant speaks for itself; any other key needs a description."""
    for key, value in schema.get("properties", {}).items():
        meant, home = resolved(value, name, SCHEMAS)
        here = f"{place}/{key}"
        if "properties" in meant:
            yield from undescribed(home, meant, here)
        elif "const" not in meant and not (value.get("description") or meant.get("description")):
            yield here


class Schemas(unittest.TestCase):
    def test_there_are_schemas(self):
        self.assertLessEqual({"case.schema.json", "campaign.schema.json", "status.schema.json", "summary.schema.json"},
                             set(SCHEMAS))

    def test_every_key_has_a_description(self):
        for name, schema in SCHEMAS.items():
            with self.subTest(name):
                self.assertEqual(list(undescribed(name, schema, "")), [])

    def test_every_number_of_an_input_has_a_unit(self):
        def without_unit(node, place):
            for key, child in node.get("properties", {}).items():
                if child.get("type") in ("number", "integer") and not child.get("unit"):
                    yield f"{place}/{key}"
                yield from without_unit(child, f"{place}/{key}")

        for name in ("case.schema.json", "campaign.schema.json"):
            self.assertEqual(list(without_unit(SCHEMAS[name], "")), [], name)

    def test_the_page_of_keys_is_that_of_the_schemas(self):
        made = subprocess.run([sys.executable, "-B", ROOT / "schemas" / "keys.py"], capture_output=True, text=True, check=True)
        self.assertEqual((ROOT / "schemas" / "KEYS.md").read_text(encoding="utf-8"), made.stdout,
                         "python3 schemas/keys.py > schemas/KEYS.md makes it again")
        for key in ("$schema", "physics.solid.G", "precursor.run.end_time", "sweep.exclude", "execution.walltime_seconds"):
            self.assertIn(f"\n| `{key}` |", made.stdout)

    def test_inputs_refuse_unknown_keys(self):
        for name in ("case.schema.json", "campaign.schema.json"):
            self.assertIs(SCHEMAS[name]["additionalProperties"], False)


if __name__ == "__main__":
    unittest.main()
