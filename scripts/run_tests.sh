#!/bin/sh
# Installs what is missing, builds the programs and tests, and runs all tests.
# Usage: scripts/run_tests.sh [preset]    (tests or sanitizers; default: tests)
set -eu

root=$(cd "$(dirname "$0")/.." && pwd)
preset=${1:-tests}
jobs=${JOBS:-2}

"$root/scripts/install_packages.sh" clang-format python3-dev pybind11-dev python3-numpy python3-pytest parallel chromium
cd "$root"
if [ ! -d "build/$preset" ] && command -v ninja >/dev/null; then
  export CMAKE_GENERATOR=Ninja
fi
cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$jobs"
ctest --preset "$preset" --parallel "$jobs"
