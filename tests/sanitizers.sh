#!/usr/bin/env bash
# Builds all tests with clang's sanitizers of addresses and undefined behaviour (build-asan) and runs them, then those in
# which threads meet with its thread sanitizer (build-tsan). Exit code 0: all passed, and no sanitizer had anything to say.
# Arguments go to the first ctest, e.g.  bash tests/sanitizers.sh -R RawlogDamage
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash apps/install_dependencies.sh --tests --sanitizers
status=0
# build_and_test PRESET TARGET... -- CTEST_ARGUMENT...
build_and_test() {
  local preset=$1 targets=()
  shift
  while [ "$1" != -- ]; do
    targets+=("$1")
    shift
  done
  shift
  cmake --preset "$preset" >/dev/null
  cmake --build --preset "$preset" --parallel "$(nproc)" --target "${targets[@]}"
  ctest --preset "$preset" --no-tests=error --parallel "$(nproc)" "$@" || status=$?
  echo "sanitizers.sh: $preset is done after $SECONDS s"
}

build_and_test asan all -- "$@"
rooms=(geometry files filter particle_filter experiment maps online)
build_and_test tsan "${rooms[@]/#/test_}" -- \
  -R 'WorkBudget|SlicedWork|DiskBacked|StagedFile|MotionModel|ParticleFilter\.|TrialPool|LandmarkMap2D|OnlineLocalizer'
exit "$status"
