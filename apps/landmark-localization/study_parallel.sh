#!/usr/bin/env bash
# A study of many trials with GNU parallel, on this machine or on several that share its folders:
#   study_parallel.sh CONFIG.ini OUT TRIALS PARTS [options of landmark-localization]
#   SSHLOGIN=2/alice@one,4/two study_parallel.sh ...
# Runs PARTS jobs of TRIALS/PARTS trials each and merges them into OUT/report.html. Every trial has its own random
# stream, so the split does not change a byte of its results. Called again after a crash it goes on where it stopped.
set -euo pipefail
if [ $# -lt 4 ]; then
  sed -n '2,6s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
config=$(realpath "$1") trials=$3 parts=$4
mkdir -p "$2"
out=$(realpath "$2")
shift 4

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
export PATH=$PATH:$here/../../build/bin
program=$(command -v landmark-localization)

# One line "first:last name" per part; the name of its folder sorts like its trials.
for ((part = 0; part < parts; part++)); do
  first=$((trials * part / parts)) last=$((trials * (part + 1) / parts))
  [ "$first" -lt "$last" ] && printf '%d:%d part_%06d\n' "$first" "$last" "$first"
done | parallel ${SSHLOGIN:+--sshlogin "$SSHLOGIN"} --workdir "$PWD" --colsep ' ' --joblog "$out/jobs.log" --quote \
  "$program" "$config" --trials '{1}' -o "$out/{2}" --resume -q "$@" >"$out/log.txt"

localization-report "$out"/part_* -o "$out/report.html"
