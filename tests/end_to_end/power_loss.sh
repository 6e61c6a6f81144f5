#!/bin/bash
# Takes N images of the disk under running campaigns at random moments, as a power loss would leave it, and goes on
# from each:  bash tests/end_to_end/power_loss.sh --seed 1 --images 15     Prints one JSON object, last.
# Needs root and loop devices. SOFTWALL names the program; without it, the newest build of this checkout is taken.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/find_softwall.sh"
exec python3 "$here/power_loss.py" "$@"
