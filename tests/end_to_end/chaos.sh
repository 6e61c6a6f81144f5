#!/bin/bash
# Runs small campaigns under random faults until N of them have happened, and prints what became of the results as one
# JSON object, last:  bash tests/end_to_end/chaos.sh --seed 1 --faults 300
# SOFTWALL names the program; without it, the newest build of this checkout is taken.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if [[ -z "${SOFTWALL:-}" ]]; then
  SOFTWALL=$(ls -t "$here"/../../build*/bin/softwall 2>/dev/null | head -n 1 || true)
  if [[ -z "$SOFTWALL" ]]; then
    echo "chaos.sh: build softwall first, or name it: SOFTWALL=build/bin/softwall bash $0" >&2
    exit 2
  fi
  export SOFTWALL
fi
if [[ $(id -u) == 0 ]]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
PYTHONDONTWRITEBYTECODE=1 exec python3 "$here/chaos.py" "$@"
