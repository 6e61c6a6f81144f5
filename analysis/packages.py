"""Says in one line what to install where a package is missing. Whoever needs one calls needed() before importing it, so
that also --help answers in words."""

import importlib.util
import sys

DEBIAN = {"numpy": "python3-numpy", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib"}


def needed(*names):
    """Ends the program where one of these cannot be imported by the interpreter that runs it."""
    missing = [name for name in names if importlib.util.find_spec(name) is None]
    if not missing:
        return
    packages = " ".join(DEBIAN[name] for name in missing)
    sys.exit(f"{sys.executable} has no {', '.join(missing)}: sudo apt install {packages} and run the script with "
             f"/usr/bin/python3, or {sys.executable} -m pip install {' '.join(missing)}")
