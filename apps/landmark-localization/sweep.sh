#!/usr/bin/env bash
# Every combination of settings, with a table of what comes out:
#   sweep.sh CONFIG.ini OUT TRIALS Section.key=a,b,c [Section.key=d,e ...] [-- options of landmark-localization]
# Writes OUT/<combination>/ for each, OUT/report.html and OUT/sweep.csv (one row per combination and method), and goes on
# where it stopped when it is called again.
set -euo pipefail
if [ $# -lt 4 ]; then
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
config=$1 out=$2 trials=$3
shift 3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export PATH=$PATH:$here/../../build/bin

combinations=("")
while [ $# -gt 0 ] && [ "$1" != -- ]; do
  key=${1%%=*} longer=()
  IFS=, read -r -a values <<<"${1#*=}"
  for combination in "${combinations[@]}"; do
    for value in "${values[@]}"; do longer+=("$combination $key=$value"); done
  done
  combinations=("${longer[@]}")
  shift
done
[ "${1:-}" = -- ] && shift

folders=()
for combination in "${combinations[@]}"; do
  read -r -a settings <<<"$combination"
  folder="$out/$(tr ' /' '_-' <<<"${settings[*]}")"
  folders+=("$folder")
  status=0
  landmark-localization "$config" --repeat "$trials" -o "$folder" --resume -q "${settings[@]/#/--set=}" "$@" || status=$?
  # 3: finished, but lost in some trial, which the table tells.
  [ "$status" -eq 0 ] || [ "$status" -eq 3 ] || exit "$status"
done
localization-report "${folders[@]}" -o "$out/report.html" --table "$out/sweep.csv"
cat "$out/sweep.csv"
