#!/usr/bin/env python3
"""Makes a new set of golden files with the programs of a build.

    SOFTWALL=build/bin/softwall GOLDEN_VALUES=build/bin/golden_values python3 tests/golden/make.py NAME

runs the campaign below in tests/golden/set-NAME, keeps what a later version must be able to read, and writes what
the readers of this build find in it into known.json.
"""

import json
import shutil
import sys
import tempfile
from pathlib import Path

from golden import HERE, SOFTWALL, call, values_of

# The least that has every kind of file and both formulations of the solid in it.
CAMPAIGN = {
    "format": 1,
    "name": "golden",
    "physics": {
        "domain": {"length_x": 2, "length_z": 1},
        "grid": {"nx": 8, "ny_fluid": 16, "ny_solid": 4, "nz": 8},
        "precision": "single",
        "time_step": {"fixed_dt": 0.005},
        "statistics": {"interval_steps": 2, "block_length": 0.05},
    },
    "precursor": {"run": {"end_time": 0.5}},
    "sweep": {"list": [{"G": 1, "viscosity_ratio": 2}, {"G": 0.5, "formulation": "transported_B"}]},
    "run": {"end_time": 0.5},
    "execution": {"ranks": 1, "cores": 1},
}
KEPT = ("campaign.json", "results.db", "case.json", "run.json", "status.json", "summary.json", "statistics.h5",
        "spectra.h5")


def main(name):
    target = HERE / f"set-{name}"
    if target.exists():
        sys.exit(f"{target} exists; a set is never made again, since only its own version can write it")
    with tempfile.TemporaryDirectory(prefix="softwall-golden-") as outer:
        folder = Path(outer) / "golden"
        folder.mkdir()
        (folder / "campaign.json").write_text(json.dumps(CAMPAIGN, indent=2) + "\n", encoding="utf-8")
        call(SOFTWALL, "run", folder)
        for path in sorted(folder.rglob("*")):
            if path.is_file() and (path.name in KEPT or path.parent.name == "checkpoints"):
                kept = target / path.relative_to(folder)
                kept.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, kept)
    known = values_of(target)
    (target / "known.json").write_text(json.dumps(known, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    print(f"{target}: {sum(p.stat().st_size for p in target.rglob('*') if p.is_file()) // 1024} KiB")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
