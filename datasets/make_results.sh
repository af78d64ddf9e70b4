#!/usr/bin/env bash
# Writes datasets/RESULTS.md: all methods over all recordings that are there, from an unknown start.
#   make_results.sh FOLDER_OF_RECORDINGS OUT [TRIALS]
# FOLDER_OF_RECORDINGS holds mrclam/, plaza/, labyrinth_uwb/, cuhksz_uwb_planar/, lost_in_the_woods/, carpark/ and
# roh_angulation/, what is not there is left out; MRPT's UWB demo comes with mrpt-common. TRIALS (20): random seeds per
# recording, run on all cores. Goes on where it stopped when it is called again.
set -euo pipefail
if [ $# -lt 2 ]; then
  sed -n '2,8s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
recordings=$(realpath "$1") trials=${3:-20}
mkdir -p "$2"
out=$(realpath "$2")
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export PATH=$PATH:$root/build/bin
folders=()

# run NAME INI TRIALS [arguments]: a study into $out/NAME.
run() {
  local folder=$out/$1 config=$root/ini/landmark-localization/$2.ini count=$3 status=0
  shift 3
  landmark-localization "$config" "$@" --repeat "$count" --jobs "$(nproc)" -o "$folder" --resume -q >/dev/null || status=$?
  [ "$status" -eq 0 ] || [ "$status" -eq 3 ] || exit "$status"
  folders+=("$folder")
}
# run_log NAME INI TRIALS: the same over the log of this name.
run_log() {
  local log=$out/logs/$1
  run "$@" "$log.rawlog" --map "${log}_map.csv" --ground-truth "${log}_ground_truth.tum"
}
# study NAME INI TRIALS FORMAT INPUT [options]: the same over an imported recording, when it is there.
study() {
  local name=$1 ini=$2 count=$3 format=$4 input=$5 log=$out/logs/$1
  shift 5
  [ -e "$input" ] || return 0
  mkdir -p "$out/logs"
  [ -e "$log.rawlog" ] || dataset2rawlog "$format" "$input" "$@" -q -o "$log.rawlog" 2>"$log.warnings"
  run_log "$name" "$ini" "$count"
}

# images NAME INI OF_IMAGES TRIALS: the same over a shipped drive, from its images.
images() {
  local name=$1 ini=$2 log=$out/logs/$1
  mkdir -p "$out/logs"
  [ -e "$log.rawlog" ] || images2rawlog "$root/ini/images2rawlog/$3.ini" -i "$root/datasets/$name" -q -o "$log.rawlog" \
    2>"$log.warnings"
  run_log "$name" "$ini" "$4"
}
# variants NAME INI FORMAT INPUT [options]: with names, without, bearings, bearings without names.
variants() {
  local name=$1 ini=$2 format=$3 input=$4
  shift 4
  study "$name" "$ini" "$trials" "$format" "$input" "$@"
  study "$name-anonymous" "$ini" "$trials" "$format" "$input" "$@" --identity anonymous
  study "$name-bearings" "$ini" "$trials" "$format" "$input" "$@" --measurements bearing
  study "$name-anonymous-bearings" "$ini" "$trials" "$format" "$input" "$@" --identity anonymous --measurements bearing
}

for name in room half-field goal-corners; do
  run "$name" "$name" "$trials"
done
images conic-mirror conic-mirror conic-mirror 1
images movis-field movis movis "$trials"
images stereo-goal stereo-goal stereo "$trials"
images tags tags tags "$trials"
demo=/usr/share/mrpt/datasets/uwb_ro-localization_demo.rawlog
[ ! -e "$demo" ] || run mrpt-uwb-demo mrpt-uwb-demo "$trials"
study plaza1 plaza "$trials" plaza "$recordings/plaza"
study labyrinth labyrinth "$trials" labyrinth "$recordings/labyrinth_uwb"
study cuhksz-fast cuhksz "$trials" cuhksz "$recordings/cuhksz_uwb_planar"
for robot in 1 2 3 4 5; do
  variants "mrclam6-robot$robot" mrclam mrclam "$recordings/mrclam/MRCLAM_Dataset6" --robot "$robot"
done
variants lost-in-the-woods csv csv "$recordings/lost_in_the_woods"
study carpark csv "$trials" csv "$recordings/carpark"
# Independent frames use no random numbers: one trial is enough.
for set in 1 2 3 5 6; do
  study "mrclam$set-snapshots" mrclam-snapshots 1 mrclam-snapshots "$recordings/mrclam/MRCLAM_Dataset$set"
done
study roh roh 1 roh "$recordings/roh_angulation"

localization-report "${folders[@]}" -o "$out/report.html" --table "$out/table.md"
{
  echo "# Results on recordings"
  echo
  echo "Made by \`datasets/make_results.sh\`: unknown start, the shipped configurations, up to $trials random seeds per"
  echo "recording; every figure is the median over the trials. Position errors count from the convergence of the filter on"
  echo "(\`converged_within_m\` of the configuration); independent frames count all. \`successes\` are trials that"
  echo "converged in time and stayed converged. \`successes\`, \`lost\` and the time to converge refer to the particle filter, in"
  echo "the rows of other methods too. Closed forms give a pose for some frames only; an oracle uses the ground truth to choose"
  echo "among its candidates. \`ok\` is the share of the time with this verdict; the last column, the share of these estimates"
  echo "whose truth lies in the stated 95 % region. State $(git -C "$root" rev-parse --short HEAD)."
  echo
  cat "$out/table.md"
} >"$root/datasets/RESULTS.md"
