#!/usr/bin/env bash
# Measures the speed of a time step on this machine, optimised for its processor, and prints one JSON object last.
#   bash tests/performance/bench.sh [--record FILE] [--against OTHER_BUILD_FOLDER]
# The samples: a rigid channel of 128 x 96 x 128 cells, and the same with an elastic layer of 24 rows more.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

bash runs/install-packages.sh tests >&2
echo "Building for this processor (build-native)"
cmake --preset native -DSOFTWALL_TESTS=ON >/dev/null
cmake --build --preset native --target step_benchmark step_benchmark_single >&2
echo "Load of the machine before: $(cut -d' ' -f1-3 /proc/loadavg)"
exec python3 tests/performance/bench.py --build build-native "$@"
