#!/bin/bash
# Runs small campaigns under random faults until N of them have happened, and prints what became of the results as one
# JSON object, last:  bash tests/end_to_end/chaos.sh --seed 1 --faults 300
# With --slurm, attempts are jobs of a Slurm of one node that is begun for this and ended with it, and faults are those of a
# cluster as well:  bash tests/end_to_end/chaos.sh --slurm --seed 1 --faults 100
# SOFTWALL names the program; without it, the newest build of this checkout is taken.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/find_softwall.sh"
exec python3 "$here/chaos.py" "$@"
