"""The physics of a case with all that its file leaves out. Defaults stand in the schema alone, from where solver and manager
fill them in, too."""

import copy
import functools
import json
import pathlib

SCHEMA = pathlib.Path(__file__).parent.parent / "schemas" / "case.schema.json"


@functools.cache
def _of_physics():
    return json.loads(SCHEMA.read_text())["properties"]["physics"]


def _filled(value, schema):
    members = schema.get("properties")
    if not members or not isinstance(value, dict):
        return value
    absent = {name: copy.copy(member["default"]) for name, member in members.items() if name not in value and "default" in member}
    return {name: _filled(member, members.get(name, {})) for name, member in {**value, **absent}.items()}


def with_defaults(physics):
    return _filled(physics, _of_physics())
