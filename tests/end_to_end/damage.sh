#!/bin/bash
# Damages the newest checkpoint of a small elastic case at random, N times, and prints what softwall and its solver
# made of it as one JSON object, last:  bash tests/end_to_end/damage.sh --seed 1 --count 300
# SOFTWALL names the program; without it, the newest build of this checkout is taken.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/find_softwall.sh"
exec python3 "$here/damage.py" "$@"
