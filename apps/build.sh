#!/usr/bin/env bash
# Installs what is missing, configures and builds into build/.
#   build.sh               all apps
#   build.sh TARGET...     these targets only, e.g. landmark-localization
#   build.sh --tests       everything, with the test programs
# An existing build/ keeps its generator and its other settings, and all forms share its object files.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

settings=() targets=()
if [ "${1:-}" = --tests ]; then
  bash "$root/apps/install_dependencies.sh" --tests
  # Debian's Python is the one that has the packages.
  settings+=(-DMRPT_EXT_BUILD_TESTS=ON -DMRPT_EXT_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3)
else
  bash "$root/apps/install_dependencies.sh"
  [ -f "$build/CMakeCache.txt" ] || settings+=(-DMRPT_EXT_BUILD_TESTS=OFF)
  [ $# -eq 0 ] || targets=(--target "$@")
fi
if [ ! -f "$build/CMakeCache.txt" ]; then
  # Several source files are compiled as one (a unity build): half the time from nothing.
  settings+=(-G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON)
fi
# Warnings are errors with the compiler we test with; another one may have new warnings, which are no reason to stop.
[ "$("${CXX:-g++}" -dumpversion | cut -d. -f1)" = 12 ] && settings+=(-DMRPT_EXT_WARNINGS_AS_ERRORS=ON)

cmake -S "$root" -B "$build" "${settings[@]}"
cmake --build "$build" --parallel "$(nproc)" "${targets[@]}"
