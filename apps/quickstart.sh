#!/usr/bin/env bash
# From a fresh clone to a localized robot: installs what is missing, builds the app landmark-localization, and runs it on
# the shipped data set "room". Needs no display and no key press; leaves its results in out/quickstart.
# The other apps are built by `bash apps/build.sh`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
log=$root/build/quickstart.log

# One line that counts the build steps on a terminal, a line for every quarter elsewhere. The full log goes to a file.
show_progress() {
  local line counter done_steps all quarter=-1
  while IFS= read -r line; do
    printf '%s\n' "$line"
    case $line in
      Installing*) echo "$line ..." >&2 ;;
      '['*/*']'*) ;;
      *) continue ;;
    esac
    counter=${line%%]*} counter=${counter#[}
    done_steps=${counter%/*} all=${counter#*/}
    [[ $done_steps =~ ^[0-9]+$ && $all =~ ^[0-9]+$ ]] || continue
    if [ -t 2 ]; then
      printf '\rBuilding: step %s of %s ' "$done_steps" "$all" >&2
      [ "$done_steps" -lt "$all" ] || echo >&2
    elif [ $((4 * done_steps / all)) -gt "$quarter" ]; then
      quarter=$((4 * done_steps / all))
      echo "Building: step $done_steps of $all" >&2
    fi
  done >"$log"
}

# The first error and the lines that explain it, not everything that has "error" in its name.
show_first_error() {
  echo >&2
  grep -m1 -A12 -E '(: (fatal )?error: |^CMake Error|^ninja: error|^install_dependencies.sh: |: undefined reference to |^ld: |^collect2: )' "$log" >&2 ||
    tail -n 12 "$log" >&2
  echo "quickstart.sh: the build failed, see $log" >&2
}

mkdir -p "$root/build"
echo "Building (the first time takes a few minutes; details in build/quickstart.log)"
if ! bash "$root/apps/build.sh" landmark-localization 2>&1 | show_progress; then
  show_first_error
  exit 1
fi

cd "$root"
status=0
build/bin/landmark-localization ini/landmark-localization/quickstart.ini -o out/quickstart || status=$?
[ "$status" -eq 0 ] && echo && echo "Report: $root/out/quickstart/report.html" &&
  echo "The other apps (import, simulate, look at images, compare runs) are built by: bash apps/build.sh"
exit "$status"
