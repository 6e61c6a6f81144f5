"""Which libraries a program needs: the manager's core stays free of databases, HDF5 and MPI."""

import os
import re
import shutil
import subprocess
import unittest

HEAVY = re.compile(r"lib(sqlite3|hdf5\w*|mpi\w*|open-rte|open-pal|fftw3\w*)\.so")


def libraries_of(program):
    """Every shared library that the program needs, those of its libraries included, as ldd lists them."""
    listed = subprocess.run(["ldd", program], capture_output=True, text=True, timeout=60)
    if listed.returncode != 0:
        raise AssertionError(f"ldd {program}: {listed.stderr}")
    return [line.split()[0] for line in listed.stdout.splitlines() if line.strip()]


@unittest.skipUnless(shutil.which("ldd"), "needs ldd")
class Libraries(unittest.TestCase):
    def test_the_core_of_the_manager_is_pure(self):
        # Its tests link the core's library and GoogleTest, nothing else of the manager.
        libraries = libraries_of(os.environ["CAMPAIGN_CORE_TESTS"])
        self.assertTrue(any(name.startswith("libc.so") for name in libraries), libraries)
        self.assertEqual([name for name in libraries if HEAVY.match(name)], [])

    @unittest.skipUnless(os.environ.get("HAS_SERIAL_HDF5") == "1", "HDF5 without MPI is not installed")
    def test_the_manager_starts_without_mpi(self):
        libraries = libraries_of(os.environ["SOFTWALL"])
        self.assertEqual([name for name in libraries if re.match(r"lib(mpi|open-rte|open-pal)", name)], [])

    def test_the_pattern_knows_the_libraries_it_looks_for(self):
        libraries = libraries_of(os.environ["SOFTWALL"])
        self.assertTrue(any(name.startswith("libsqlite3") for name in libraries if HEAVY.match(name)), libraries)


if __name__ == "__main__":
    unittest.main()
