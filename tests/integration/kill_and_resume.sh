#!/usr/bin/env bash
# A study that is killed at random moments and gone on with by --resume leaves the bytes of one that was not; nothing
# half, no temporary files.
#   kill_and_resume.sh BIN_FOLDER SOURCE_FOLDER KILLS
set -euo pipefail
program=$1/landmark-localization config=$2/ini/landmark-localization/quickstart.ini kills=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
duration=6 particles=2000
[ -z "${LANDMARK_SHORT_TESTS:-}" ] || duration=2 particles=200  # under the sanitizers
study=("$program" "$config" --duration $duration --repeat 6 -q --set LocalizationExperiment.methods=particle_filter
  --set LocalizationExperiment.particles_count=200 --set LocalizationExperiment.initial_particles_count=$particles)

start=$(date +%s%N)
"${study[@]}" -o "$work/whole" >/dev/null
milliseconds=$((($(date +%s%N) - start) / 1000000))

results() { (cd "$1" && find . -type f \( -name '*.csv' -o -name '*.tum' \) -print0 | sort -z | xargs -0 sha256sum); }
wanted=$(results "$work/whole")
RANDOM=${SEED:-1}
interrupted=0
for ((k = 0; k < kills; k++)); do
  rm -rf "$work/study"
  "${study[@]}" -o "$work/study" --resume >/dev/null 2>&1 &
  pid=$!
  sleep "$(printf '0.%03d' $((RANDOM % (milliseconds < 1000 ? milliseconds : 1000))))"
  kill -KILL $pid 2>/dev/null && interrupted=$((interrupted + 1))
  wait $pid 2>/dev/null || true
  "${study[@]}" -o "$work/study" --resume >/dev/null
  [ "$(results "$work/study")" = "$wanted" ] || { echo "kill $k: other results"; exit 1; }
  left=$(find "$work/study" -name '.*' -type f)
  [ -z "$left" ] || { echo "kill $k: left over: $left"; exit 1; }
done
[ "$interrupted" -gt $((kills / 4)) ] || { echo "only $interrupted of $kills kills met a running program"; exit 1; }
echo "$kills of $kills went on to the same bytes, $interrupted of them killed while running"
