#!/usr/bin/env bash
# Builds the tests in which threads meet with clang's thread sanitizer (build-tsan) and runs them, then all tests with those
# of addresses and undefined behaviour (build-asan). Exit code 0: all passed, and no sanitizer had anything to say.
# Addresses of locals are not followed beyond their function (-Wreturn-local-addr sees the common case): a third of the time.
# Arguments go to the second ctest, which knows the programs by their rooms, e.g.  bash tests/sanitizers.sh -R rawlog
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash apps/install_dependencies.sh --tests --sanitizers
export LANDMARK_DATA_DIR=none LANDMARK_SCENES_DIR=none  # recordings and shared images would take hours here
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

rooms=(geometry files filter particle_filter experiment maps online)
build_and_test tsan "${rooms[@]/#/test_}" -- \
  -R 'WorkBudget|SlicedWork|DiskBacked|StagedFile|MotionModel|ParticleFilter\.|TrialPool|LandmarkMap2D|OnlineLocalizer'
build_and_test asan all -- "$@"
exit "$status"
