"""Skips a test, in words, where the system's Python lacks a package: exit status 77."""

import importlib.util
import sys


def needed(*names):
    missing = [name for name in names if importlib.util.find_spec(name) is None]
    if missing:
        print("skipped: no", ", ".join(missing))
        sys.exit(77)
