#!/usr/bin/env bash
# From a fresh clone to a localized robot: installs what is missing, builds the apps, and runs them on the shipped
# data set "room". Needs no display and no key press; leaves its results in out/quickstart.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
log=$root/build/quickstart.log

mkdir -p "$root/build"
echo "Building (the first time takes a few minutes; details in build/quickstart.log) ..."
if ! bash "$root/apps/build.sh" >"$log" 2>&1; then
  grep -E 'install_dependencies.sh:|error|Error|FAILED' "$log" | tail -n 20 >&2
  echo "quickstart.sh: the build failed, see $log" >&2
  exit 1
fi

cd "$root"
status=0
build/bin/landmark-localization ini/landmark-localization/quickstart.ini -o out/quickstart || status=$?
[ "$status" -eq 0 ] && echo && echo "Report: $root/out/quickstart/report.html"
exit "$status"
