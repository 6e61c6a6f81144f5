#!/usr/bin/env bash
# Measures the speed of a time step on this machine, optimised for its processor: nanoseconds per cell and step.
#   bash tests/performance/bench.sh [RANKS] [options of Google Benchmark, e.g. --benchmark_out=speed.json]
# The samples: a rigid channel of 128 x 96 x 96 cells, and the same with an elastic layer, on 2 ranks by default.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

ranks=2
if [[ "${1:-}" =~ ^[0-9]+$ ]]; then ranks=$1 && shift; fi

bash runs/install-packages.sh tests
echo "Building for this processor (build-native)"
cmake --preset native -DSOFTWALL_TESTS=ON >/dev/null
cmake --build --preset native --target step_benchmark

echo "Measuring on $ranks ranks; the load of the machine now: $(cut -d' ' -f1-3 /proc/loadavg)"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
exec mpirun -n "$ranks" --use-hwthread-cpus build-native/bin/step_benchmark --benchmark_filter=-^short/ "$@"
