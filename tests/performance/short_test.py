"""short_test.py COMMAND... : runs the short benchmark and holds its JSON to what no machine may miss."""

import json
import subprocess
import sys

# Far beyond what a slow and busy machine needs: only a blunder in the algorithm is slower.
MOST_NANOSECONDS = 500_000

done = subprocess.run(sys.argv[1:], stdout=subprocess.PIPE, text=True, check=True)
measured = json.loads(done.stdout.strip().splitlines()[-1])
assert measured["triad_gb_s"] > 0
names = [name for name in measured if name == "rigid" or name.startswith("elastic")]
assert names == ["elastic", "elastic_explicit", "elastic_transported_B", "rigid"], names
for name in names:
    sample = measured[name]
    assert 0 < sample["ns_min"] <= sample["ns"] <= sample["ns_max"] < MOST_NANOSECONDS, (name, sample)
    assert sample["allocations_per_step"] == 0, f"{name}: a step allocates {sample['allocations_per_step']} times"
    assert sample["bytes_per_cell"] > 0, name
    # The phases are all there is.
    steps = sum(phase["ns"] for phase in sample["phases"].values())
    assert steps > 0.5 * sample["ns"], (name, steps, sample["ns"])
    assert measured["ranks"] == 1 or sample["phases"]["transposition"]["messages"] > 0, name
print("the benchmark measures, a step allocates nothing")
