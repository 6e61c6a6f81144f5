"""Who may include whom. The modules of the solver are ordered, and the manager includes only what is shared.

    case < run_directory < parallel < grid < {fluid, solid, pressure} < time < {statistics, output} < simulation < main

The modules of the manager are ordered, too:

    {core, system} < launch < observe < store < {tables, runner} < commands < main

Also: every header compiles alone. It is the first include of some source or test, so the compiler has seen it
with nothing before it; the few that are not are compiled here.
"""

import os
import re
import shutil
import subprocess
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from repository import ROOT, committed_files, text_of

LEVELS = [["case"], ["run_directory"], ["parallel"], ["grid"], ["fluid", "solid", "pressure"], ["time"], ["statistics", "output"],
          ["simulation"], ["main"]]
LEVEL = {room: level for level, rooms in enumerate(LEVELS) for room in rooms}
MANAGER_LEVELS = [["core", "system"], ["launch"], ["observe"], ["store"], ["tables", "runner"], ["commands"], ["main"]]
MANAGER_LEVEL = {room: level for level, rooms in enumerate(MANAGER_LEVELS) for room in rooms}
GENERATED = {"schemas/embedded.hpp", "campaign/tables/embedded_paper.hpp", "solver/run_directory/git_revision.hpp"}
SHARED = re.compile(r"^(solver/(case|run_directory)|analysis|schemas)/")
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
ANY_INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.MULTILINE)


def code(folder):
    """The sources and headers below a folder, as posix paths."""
    return [path for path in committed_files() if path.suffix in (".cpp", ".hpp") and path.parts[0] == folder]


def circle_in(arrows):
    """The names along one circle of arrows (name -> names), or nothing where there is none."""
    done, path = set(), []

    def visit(name):
        if name in path:
            return path[path.index(name):] + [name]
        if name in done:
            return []
        path.append(name)
        for other in sorted(arrows.get(name, ())):
            if found := visit(other):
                return found
        done.add(path.pop())
        return []

    for name in sorted(arrows):
        if found := visit(name):
            return found
    return []


def room_of(path):
    """The room of a file of solver/ or campaign/; other files that stand in solver/ itself are simulation."""
    parts = Path(path).parts
    if len(parts) > 2:
        return parts[1]
    return "main" if parts[1] == "main.cpp" else "simulation"


def flags():
    """Where the headers of the libraries are."""
    packages = [name for name in ("hdf5-openmpi", "ompi", "fftw3") if shutil.which("pkg-config") and subprocess.run(
        ["pkg-config", "--exists", name]).returncode == 0]
    listed = subprocess.run(["pkg-config", "--cflags", *packages], capture_output=True, text=True) if packages else None
    return (listed.stdout.split() if listed else []) + ["-DOMPI_SKIP_MPICXX", "-DMPICH_SKIP_MPICXX"]


def compile_alone(header):
    compiler = os.environ.get("CXX", "c++")
    return subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-x", "c++", f"-I{ROOT}", *flags(), "-"],
                          input=f'#include "{header}"\n', capture_output=True, text=True)


class IncludeOrder(unittest.TestCase):
    def test_every_room_of_the_solver_has_its_place(self):
        self.assertEqual(sorted({room_of(path) for path in code("solver")} - set(LEVEL)), [])

    def test_rooms_include_only_lower_ones(self):
        wrong = []
        for path in code("solver"):
            own = room_of(path)
            for target in INCLUDE.findall(text_of(path)):
                if not target.startswith("solver/"):
                    continue
                other = room_of(target)
                if other != own and LEVEL[other] >= LEVEL[own]:
                    wrong.append(f"{path} ({own}) includes {target} ({other})")
        self.assertEqual(wrong, [])

    def test_every_room_of_the_manager_has_its_place(self):
        self.assertEqual(sorted({room_of(path) for path in code("campaign")} - set(MANAGER_LEVEL)), [])

    def test_rooms_of_the_manager_include_only_lower_ones(self):
        wrong = []
        for path in code("campaign"):
            own = room_of(path)
            for target in INCLUDE.findall(text_of(path)):
                if not target.startswith("campaign/"):
                    continue
                other = room_of(target)
                if other != own and MANAGER_LEVEL[other] >= MANAGER_LEVEL[own]:
                    wrong.append(f"{path} ({own}) includes {target} ({other})")
        self.assertEqual(wrong, [])

    def test_the_core_of_the_manager_is_pure(self):
        """It knows cases and schemas: no statistics file, no process, no database."""
        allowed = re.compile(r"^(campaign/core|solver/case|schemas)/|^solver/run_directory/status\.hpp$")
        for path in code("campaign"):
            if room_of(path) == "core":
                text = text_of(path)
                self.assertEqual([t for t in INCLUDE.findall(text) if not allowed.match(t)], [], path)
                self.assertIsNone(re.search(r"<(sqlite3|hdf5|mpi|unistd|signal|sys/\w+)\.h>", text), path)

    def test_files_do_not_include_each_other_in_circles(self):
        """No circle, through however many files: a header and its source count as one file."""
        arrows = {}
        for path in code("campaign") + code("analysis") + [p for p in code("solver") if room_of(p) == "run_directory"]:
            own = path.with_suffix("").as_posix()
            targets = {Path(target).with_suffix("").as_posix() for target in INCLUDE.findall(text_of(path))}
            arrows.setdefault(own, set()).update(targets - {own})
        self.assertEqual(circle_in(arrows), [])

    def test_the_solver_knows_neither_manager_nor_analysis(self):
        for path in code("solver"):
            outside = [t for t in INCLUDE.findall(text_of(path)) if not t.startswith("solver/")]
            self.assertEqual([t for t in outside if not t.startswith("schemas/")], [], path)

    def test_the_manager_uses_only_what_is_shared(self):
        for path in code("campaign"):
            targets = INCLUDE.findall(text_of(path))
            self.assertEqual([t for t in targets if not t.startswith("campaign/") and not SHARED.match(t)], [], path)

    def test_the_analysis_uses_only_itself_and_what_is_shared(self):
        for path in code("analysis"):
            targets = INCLUDE.findall(text_of(path))
            self.assertEqual([t for t in targets if not t.startswith("analysis/") and not SHARED.match(t)], [], path)

    def test_includes_are_written_from_the_root(self):
        for folder in ("solver", "campaign", "analysis"):
            for path in code(folder):
                for target in INCLUDE.findall(text_of(path)):
                    self.assertTrue((ROOT / target).is_file() or target in GENERATED, f"{path}: {target}")

    def test_the_order_is_the_one_that_is_enforced(self):
        self.assertGreater(len(code("solver")), 50)  # an empty listing would pass everything above
        self.assertEqual(room_of("solver/time/advance.cpp"), "time")
        self.assertEqual(room_of("solver/simulation.cpp"), "simulation")
        self.assertEqual(room_of("solver/main.cpp"), "main")
        self.assertEqual(room_of("campaign/core/plan.cpp"), "core")
        self.assertEqual(circle_in({"a": {"b"}, "b": {"c"}, "c": {"a"}}), ["a", "b", "c", "a"])


class Headers(unittest.TestCase):
    def headers(self):
        return [path for folder in ("solver", "campaign", "analysis") for path in code(folder) if path.suffix == ".hpp"]

    def test_headers_are_read_once(self):
        for path in self.headers():
            self.assertTrue(text_of(path).startswith("#pragma once\n"), path)

    def test_headers_stand_on_their_own(self):
        first = set()
        for folder in ("solver", "campaign", "analysis", "tests"):
            for path in code(folder):
                if path.suffix == ".cpp":
                    first.update(ANY_INCLUDE.findall(text_of(path))[:1])
        unseen = [path for path in self.headers() if path.as_posix() not in first]
        with ThreadPoolExecutor(max_workers=2) as pool:
            for path, result in zip(unseen, pool.map(compile_alone, unseen)):
                self.assertEqual(result.returncode, 0, f"{path}: {result.stderr}")


if __name__ == "__main__":
    unittest.main()
