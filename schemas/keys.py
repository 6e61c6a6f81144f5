#!/usr/bin/env python3
"""Writes KEYS.md, the page of every key of a campaign file, from the schemas: python3 schemas/keys.py > schemas/KEYS.md"""

import json
import pathlib
import sys

SCHEMAS = pathlib.Path(__file__).parent
HEAD = """# Every key of a campaign file

Made from `campaign.schema.json` and `case.schema.json` by `python3 schemas/keys.py > schemas/KEYS.md`; a test fails when it
no longer agrees with them. Lengths are in h (half the height of the rigid channel), velocities in U_b (bulk velocity), the
density is 1; the unit "-" is none. A key without a default has to be given, or is absent where its meaning says so.

Keys of `physics` are the parameters of every case, and each of them may be swept by its last name (`"G"`) or its full one
(`"solid.G"`). `"$schema": "/usr/local/share/softwall/schemas/campaign.schema.json"` (wherever the schemas were installed, or their
place in a copy of the sources) lets an editor complete and check the file.
"""


def resolved(node, home, documents):
    """The node that a reference means, and the file it stands in."""
    while "$ref" in node:
        file, _, pointer = node["$ref"].partition("#")
        home = file or home
        node = documents[home]
        for word in pointer.strip("/").split("/"):
            node = node[word]
    return node, home


def type_of(node):
    if "const" in node:
        return json.dumps(node["const"])
    if "enum" in node:
        return "one of " + ", ".join(f"`{word}`" for word in node["enum"])
    kind = node.get("type", "")
    return " or ".join(kind) if isinstance(kind, list) else kind


def number(value):
    """As a person writes it: every digit of a small whole number, powers of ten for the rest."""
    return str(int(value)) if value == int(value) and abs(value) < 1e10 else f"{value:g}"


def bounds_of(node):
    words = []
    if "exclusiveMinimum" in node:
        words.append(f"> {number(node['exclusiveMinimum'])}")
    if "minimum" in node:
        words.append(f">= {number(node['minimum'])}")
    if "maximum" in node:
        words.append(f"<= {number(node['maximum'])}")
    if node.get("minLength"):
        words.append(f"at least {node['minLength']} characters")
    if "maxLength" in node:
        words.append(f"at most {node['maxLength']} characters")
    if "maxItems" in node:
        words.append(f"at most {node['maxItems']} items")
    return ", ".join(words)


def default_of(node, needed, place):
    """`place`: the group of the key. A precursor takes what it is not given from its cases."""
    if place.startswith("precursor.") and not needed:
        return "its cases'"
    if "default" in node and "properties" not in node:
        return f"`{json.dumps(node['default'])}`"
    return "needed" if needed else ""


def rows(node, home, place, documents):
    """One row a key that holds a value; a group of keys has a row only where it says something."""
    for key, child in node.get("properties", {}).items():
        needed = key in node.get("required", [])
        child, file = resolved(child, home, documents)
        here = f"{place}.{key}" if place else key
        is_group = "properties" in child
        if not is_group or "description" in child:
            unit = child.get("unit", "")
            yield here, type_of(child), unit, bounds_of(child), default_of(child, needed, place), child.get("description", "")
        if is_group:
            yield from rows(child, file, here, documents)


def page():
    documents = {path.name: json.loads(path.read_text(encoding="utf-8")) for path in SCHEMAS.glob("c*.schema.json")}
    lines = [HEAD, "| key | type | unit | bounds | default | meaning |", "|---|---|---|---|---|---|"]
    for key, *cells in rows(documents["campaign.schema.json"], "campaign.schema.json", "", documents):
        lines.append("| " + " | ".join([f"`{key}`", *cells]).replace("  ", " ") + " |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.stdout.write(page())
