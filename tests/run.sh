#!/usr/bin/env bash
# Installs what is missing, builds everything (warnings are errors) and runs all tests. Exit code 0: all passed.
# Arguments go to ctest, e.g.  bash tests/run.sh -R KalmanUpdate
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

bash "$root/apps/build.sh" --tests
status=0
ctest --test-dir "$root/build" --output-on-failure --no-tests=error --parallel "$(nproc)" "$@" || status=$?

echo
if [ "$status" -eq 0 ]; then
  echo "tests/run.sh: all tests passed"
else
  echo "tests/run.sh: FAILED (ctest exit code $status); again with: ctest --test-dir build --rerun-failed" >&2
fi
exit "$status"
