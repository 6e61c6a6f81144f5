#!/usr/bin/env bash
# Installs the Debian 12 packages that softwall needs, unless all of them are there already.
#   bash runs/install-packages.sh          to build and run softwall
#   bash runs/install-packages.sh tests    to build and run its tests as well
# As root, or as a user who may use sudo. Does nothing, and needs no network, when nothing is missing.
set -euo pipefail

build_packages=(
  g++ cmake ninja-build pkg-config git
  openmpi-bin libopenmpi-dev        # the solver's processes
  libhdf5-openmpi-dev               # checkpoints, statistics, fields
  libfftw3-dev                      # pressure
  libsqlite3-dev                    # the results store
  nlohmann-json3-dev libvalijson-dev  # campaign and case files, their schemas
  libcli11-dev                      # the command line
  libxxhash-dev                     # identities, checksums
)
test_packages=(
  libgtest-dev libbenchmark-dev
  python3                           # contract and end-to-end tests
  python3-h5py python3-matplotlib   # figures (analysis/)
  clang-format clang-tidy
  slurm-wlm munge                   # the launcher for clusters
)

packages=("${build_packages[@]}")
case "${1:-build}" in
  build) ;;
  tests) packages+=("${test_packages[@]}") ;;
  *) echo "usage: bash runs/install-packages.sh [build|tests]" >&2; exit 2 ;;
esac

is_installed() { [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]; }

if ! command -v apt-get >/dev/null; then
  echo "This is not a Debian system, so nothing was installed. softwall needs what Debian 12 calls:" >&2
  printf '  %s\n' "${packages[@]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "Packages: all ${#packages[@]} are installed."
  exit 0
fi

as_root=(env DEBIAN_FRONTEND=noninteractive)
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "Packages are missing, and installing them needs root or sudo: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo "${as_root[@]}")
fi

echo "Packages: installing ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
install_missing() {
  "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=600 update &&
    "${as_root[@]}" apt-get -o DPkg::Lock::Timeout=600 install --yes --no-install-recommends "${missing[@]}"
}
if ! install_missing >"$log" 2>&1 </dev/null; then
  tail -n 30 "$log" >&2
  echo "Installing failed (the end of its log is above). The command was: apt-get install ${missing[*]}" >&2
  exit 1
fi
echo "Packages: installed."
