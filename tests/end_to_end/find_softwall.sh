# To be sourced: exports SOFTWALL, the program to try, and lets root run MPI. Without SOFTWALL in the environment, the
# newest build of this checkout is taken.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if [[ -z "${SOFTWALL:-}" ]]; then
  SOFTWALL=$(ls -t "$here"/../../build*/bin/softwall 2>/dev/null | head -n 1 || true)
  if [[ -z "$SOFTWALL" ]]; then
    echo "$0: build softwall first, or name it: SOFTWALL=build/bin/softwall bash $0" >&2
    exit 2
  fi
  export SOFTWALL
fi
if [[ $(id -u) == 0 ]]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
export PYTHONDONTWRITEBYTECODE=1
