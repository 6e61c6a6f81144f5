#!/usr/bin/env bash
# From a bare Debian 12 to a table of results: installs the packages, builds, runs runs/quickstart/campaign.json.
#   bash runs/quickstart.sh
# Stop it at any time with Ctrl-C and start it again: it goes on where it was. When all is done, it prints the table again.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

step() { printf '\n== %s\n' "$1"; }
took() { printf '   (%d min %02d s)\n' $((($SECONDS - begun) / 60)) $((($SECONDS - begun) % 60)); }

# Shows what a command printed only when it fails.
quietly() {
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 || status=$?
  ((status == 0)) || tail -n 60 "$log" >&2
  rm -f "$log"
  return "$status"
}

echo "This takes some eight minutes on two cores: two to build, six to run; more where packages are missing."
step "1/3 Packages"
begun=$SECONDS
bash runs/install-packages.sh
took

step "2/3 Build, optimised for this processor, in build-native/"
begun=$SECONDS
quietly cmake --preset native -DSOFTWALL_TESTS=OFF
quietly cmake --build --preset native --parallel "$(nproc)" --target softwall softwall-dns softwall-dns-single
took

softwall=build-native/bin/softwall
step "3/3 Campaign: one rigid channel, then five elastic walls that start from its turbulence"
begun=$SECONDS
status=0
"$softwall" run runs/quickstart/campaign.json || status=$?
took
if ((status == 4)); then
  echo "Stopped before the end. To go on: bash runs/quickstart.sh" >&2
fi
((status == 0)) || exit "$status"

step "The paper's tables 1 and 2 beside these values"
"$softwall" table runs/quickstart
cat <<'END'

A coarse grid and a short average: trust the intervals, not the digits (runs/quickstart/README.md says why).
Everything is in runs/quickstart/: results.db (SQLite), cases/ (a folder a case). To go on from here:
  export PATH="$PWD/build-native/bin:$PATH"
  softwall query runs/quickstart "SELECT label, re_tau, re_tau_ci95 FROM results"
  softwall export runs/quickstart --csv -o results.csv
  softwall table runs/quickstart --from 60         # averages over another window; nothing is computed
  softwall plan runs/rosti-brandt-2017/coarse      # what the paper's cases would cost here
Figures, and one page of it all (Debian's python3-numpy python3-h5py python3-matplotlib):
  softwall figures runs/quickstart                 # runs/quickstart/example.png shows one of them
  softwall report runs/quickstart
Change runs/quickstart/campaign.json, run it again: only what is new is computed.
END
