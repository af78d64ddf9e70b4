#!/usr/bin/env bash
# One study in one piece, in parts with GNU parallel, killed and called again: the same bytes. A sweep: a table.
#   study_in_parts.sh BIN_FOLDER SOURCE_FOLDER
set -euo pipefail
if ! command -v parallel >/dev/null; then
  echo "SKIPPED: no GNU parallel"
  exit 77
fi
export PATH=$1:$PATH
apps=$2/apps/landmark-localization config=$2/ini/landmark-localization/quickstart.ini
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
trials=12 duration=6 particles=2000
[ -z "${LANDMARK_SHORT_TESTS:-}" ] || trials=6 duration=2 particles=200  # under the sanitizers
brief=(--duration $duration --set LocalizationExperiment.methods=particle_filter
  --set LocalizationExperiment.particles_count=200 --set LocalizationExperiment.initial_particles_count=$particles)

same() {
  local compared=0 file
  while IFS= read -r file; do
    cmp "whole/$file" parts/part_*/"$file"
    compared=$((compared + 1))
  done < <(cd whole && find trial_* -name '*.csv' -o -name '*.tum')
  [ "$compared" -eq $((3 * trials)) ] || { echo "$compared files compared, expected 3 for each of $trials trials"; exit 1; }
}

landmark-localization "$config" "${brief[@]}" --trials "0:$trials" -o whole -q >/dev/null
"$apps/study_parallel.sh" "$config" parts "$trials" 3 "${brief[@]}"
same
rm -r "$(find parts -name 'trial_*' | sort | tail -n 1)" parts/part_000000/summary.json parts/report.html
"$apps/study_parallel.sh" "$config" parts "$trials" 3 "${brief[@]}"
same
[ -s parts/report.html ]

# A folder and an option with blanks.
"$apps/study_parallel.sh" "$config" "two words" 2 2 "${brief[@]}" --set "LocalizationExperiment.objects=a ball"
[ "$(cd "two words" && echo part_*/trial_*)" = "part_000000/trial_000 part_000001/trial_001" ] || { ls -R .; exit 1; }
[ ! -e two ] || exit 1

"$apps/sweep.sh" "$config" sweep 2 LocalizationExperiment.particles_count=100,300 PF_options.BETA=0.3,0.6 -- "${brief[@]:0:4}" >/dev/null
head -1 sweep/sweep.csv | grep -q '^LocalizationExperiment.particles_count,PF_options.BETA,run,log,method,trials,'
[ "$(wc -l <sweep/sweep.csv)" -eq 5 ] || { cat sweep/sweep.csv; exit 1; }
grep -q '^300,0.6,quickstart 4,room,particle_filter,2,' sweep/sweep.csv
echo "all the same"
