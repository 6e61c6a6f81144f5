#!/usr/bin/env bash
# Installs what the tests need, builds, and runs all of them: optimised, then with sanitizers; checks the layout.
#   bash tests/run.sh
# Exit status 0 only when everything passed. The last line counts the tests of both builds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

jobs=$(nproc)
passed=0 failed=0 skipped=0
step() { printf '\n== %s (%d min %02d s)\n' "$1" $((SECONDS / 60)) $((SECONDS % 60)); }

build() {  # preset
  cmake --preset "$1"
  cmake --build --preset "$1" --parallel "$jobs"
}

# Builds a preset behind what follows, with the time that nobody else wants: tests wait for most of theirs. Its process
# group is its own, so that it ends with this script.
build_log=$(mktemp)
start_building() {  # preset
  cmake --preset "$1" >"$build_log"
  set -m
  chrt --idle 0 cmake --build --preset "$1" --parallel "$jobs" >>"$build_log" 2>&1 &
  builder=$!
  set +m
}
stop_building() { [[ -z "${builder:-}" ]] || kill -- "-$builder" 2>/dev/null || true; rm -f "$build_log" "${tidy_errors:-}"; }
trap stop_building EXIT
finish_building() {
  local status=0
  wait "$builder" || status=$?
  builder=
  ((status == 0)) || cat "$build_log"
  return "$status"
}

# Runs the tests of a preset, one more at a time than there are cores, as some of them wait for most of their time,
# and adds up what ctest counted: "90% tests passed, 1 tests failed out of 10".
run_tests() {  # preset, options of ctest
  local preset=$1 log status=0 bad all not_run
  shift
  log=$(mktemp)
  ctest --preset "$preset" --parallel "$((jobs + 1))" --no-tests=error "$@" | tee "$log" || status=$?
  read -r bad all < <(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests failed out of \([0-9]*\)$/\1 \2/p' "$log") || true
  not_run=$(grep -c '^[[:space:]]*[0-9]* - .* (Skipped)$' "$log") || true
  rm -f "$log"
  if [[ -z "${all:-}" ]] || ((status != 0 && bad == 0)); then
    echo "ctest did not run the tests of the preset $preset (status $status)" >&2
    exit 1
  fi
  passed=$((passed + all - bad - not_run)) failed=$((failed + bad)) skipped=$((skipped + not_run))
}

step "Packages"
bash runs/install-packages.sh tests

step "Layout: clang-format"
git ls-files >/dev/null || { echo "the tests need a clone that git lets you read; its words are above" >&2; exit 1; }
if ! git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format --dry-run -Werror; then
  echo "not as .clang-format says; clang-format -i mends it" >&2
  exit 1
fi
echo "as .clang-format says"

step "Build, optimised, in build/"
build ci
step "Tests, and behind them a build with address and undefined-behaviour sanitizers, in build-sanitize/"
start_building sanitize
run_tests ci

step "clang-tidy on the sources that changed last"
# Each source by itself, as an editor sees it: compiled several at a time, one may live on what another includes.
cmake --preset ci -B build-tidy -DCMAKE_UNITY_BUILD=OFF -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
ln -sfn "$PWD/build/generated" build-tidy/generated
tidy_errors=$(mktemp)
# sed takes the first ten but reads on; head would close the pipe, which pipefail makes a failure.
complaints=$(git log -n 40 --format= --name-only --diff-filter=d -- '*.cpp' | awk '!seen[$0]++' |
  { grep -v '^tests/' || true; } | while read -r file; do [[ ! -f $file ]] || echo "$file"; done | sed -n 1,10p |
  xargs -r -n 5 -P "$jobs" clang-tidy -p build-tidy --quiet --extra-arg=-Wno-unknown-warning-option 2>"$tidy_errors") &&
  tidy=0 || tidy=1
((tidy == 1)) || echo "as .clang-tidy says"
# It counts its warnings there; what keeps it from its work, its absence say, stands nowhere else.
[[ $tidy == 0 || -n $complaints ]] || complaints=$(cat "$tidy_errors")
echo "$complaints"

step "The rest of the build with sanitizers"
finish_building
step "Tests with sanitizers"
# Open MPI keeps memory until the process ends; only our own leaks are of interest.
export LSAN_OPTIONS="suppressions='$PWD/tests/sanitizer/leaks.txt':print_suppressions=0"
export UBSAN_OPTIONS=print_stacktrace=1
# Without what takes minutes when instrumented (long, ranks) and what reads the same text as above (contracts).
run_tests sanitize --label-exclude '^(long|ranks|contracts)$'

step "Done"
((tidy == 0)) || printf 'clang-tidy has complaints:\n%s\n' "$complaints"
echo "$passed passed, $failed failed, $skipped skipped"
((failed == 0 && tidy == 0))
