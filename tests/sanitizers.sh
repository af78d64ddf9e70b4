#!/usr/bin/env bash
# Builds the tests with the address and undefined behaviour sanitizers (build-asan) and runs them, then those of threads
# with the thread sanitizer (build-tsan). Exit code 0: all passed, and no sanitizer had anything to say.
# Arguments go to the first ctest, e.g.  bash tests/sanitizers.sh -R RawlogDamage
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash apps/install_dependencies.sh --tests
cmake --preset asan >/dev/null
cmake --build --preset asan --parallel "$(nproc)"
status=0
ctest --preset asan --no-tests=error --parallel "$(nproc)" "$@" || status=$?

# Those in which several threads meet.
threaded=(geometry files online maps)
cmake --preset tsan >/dev/null
cmake --build --preset tsan --parallel "$(nproc)" --target "${threaded[@]/#/test_}"
ctest --preset tsan --no-tests=error --parallel "$(nproc)" -R 'WorkBudget|DiskBacked|OnlineLocalizer|LandmarkMap2D' || status=$?
exit "$status"
