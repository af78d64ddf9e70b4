#!/usr/bin/env bash
# Full disks, little memory, read-only folders and closed streams: an app ends with exit code 1 and one line, what it has
# written is whole, and nothing temporary is left.
#   exhausted_resources.sh BIN_FOLDER SOURCE_FOLDER
set -euo pipefail
bin=$1 ini=$2/ini
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "$*"; cat "$work/err"; exit 1; }
without_rights=()
declare -A program=([localize]=landmark-localization [simulate]=landmark-simulator)
duration=$([ -n "${LANDMARK_SHORT_TESTS:-}" ] && echo 2 || echo 6)  # short under the sanitizers
localize() {
  "${without_rights[@]}" "$bin/landmark-localization" "$ini/landmark-localization/quickstart.ini" --duration $duration -q -o "$1" \
    --set LocalizationExperiment.methods=particle_filter --set LocalizationExperiment.particles_count=200
}
simulate() { "${without_rights[@]}" "$bin/landmark-simulator" "$ini/landmark-simulator/quickstart.ini" -o "$1/log.rawlog"; }

# Runs `app` with its results in $work/part under a limit of the shell: option and value of ulimit.
status=0
limited() {
  rm -rf "$work/part" && mkdir "$work/part"
  status=0
  (ulimit "$2" "$3" && "$1" "$work/part") 2>&1 >/dev/null | cat >"$work/err" || status=$?
}
# The files that are there are those of the undisturbed run; the report and the summary hold times of their own.
expect_whole() {
  local file name
  [ -z "$(find "$work/part" -name '.*' -type f)" ] || fail "$1: temporary files are left"
  while read -r file; do
    name=${file##*/}
    case "$name" in
      summary.json | report.html | log.txt) [ "$(tail -c 1 "$file" | xxd -p)" = 0a ] || fail "$1: $name is cut off" ;;
      *) cmp -s "$file" "$work/whole/$name" || fail "$1: $name differs from that of the whole run" ;;
    esac
  done < <(find "$work/part" -type f)
}
expect_line() {
  [ "$status" -eq 1 ] || fail "$1: exit code $status, expected 1"
  [ "$(wc -l <"$work/err")" -eq 1 ] || fail "$1: expected one line"
  ! grep -q 'exception\|bad_alloc' "$work/err" || fail "$1: words of the program's inside"
}

for app in localize simulate; do
  rm -rf "$work/whole" && mkdir "$work/whole"
  "$app" "$work/whole" >/dev/null
  largest=$(find "$work/whole" -type f -printf '%s\n' | sort -n | tail -n 1)
  for ((blocks = 0; blocks * 1024 < largest; blocks = blocks * 3 / 2 + 1)); do
    limited "$app" -f "$blocks"
    expect_line "$app, files of at most $blocks KiB"
    expect_whole "$app, files of at most $blocks KiB"
  done
  # The address sanitizer takes terabytes of addresses.
  [ -z "${LANDMARK_SHORT_TESTS:-}" ] || continue
  # From where the program comes into its own up to what suffices: with less, a library cannot be loaded or initialised.
  ended=0
  for ((kilobytes = 200000; kilobytes < 1500000; kilobytes += 5000)); do
    { (ulimit -c 0 -v "$kilobytes" && "$bin/${program[$app]}" --version); } >/dev/null 2>&1 || continue
    limited "$app" -v "$kilobytes"
    [ "$status" -ne 0 ] || break
    ended=$((ended + 1))
    expect_line "$app, memory of $kilobytes kB"
    expect_whole "$app, memory of $kilobytes kB"
  done
  [ "$status" -eq 0 ] || fail "$app: $kilobytes kB do not suffice"
  echo "$app: full disks up to $largest bytes, memory up to $kilobytes kB ($ended times too little of it): one line, no half file"
done

# Root may write everywhere, but for this.
[ "$(id -u)" -ne 0 ] || without_rights=(setpriv --bounding-set=-dac_override)
for app in localize simulate; do
  for place in "$work/part" "$work/part/new"; do
    rm -rf "$work/part" && mkdir "$work/part" && chmod 555 "$work/part"
    status=0
    "$app" "$place" >/dev/null 2>"$work/err" || status=$?
    expect_line "$app into a read-only folder"
    [ -z "$(ls -A "$work/part")" ] || fail "$app: something is in the read-only folder"
  done
done
without_rights=()

rm -rf "$work/part" && mkdir "$work/part"
status=0
localize "$work/part" >&- 2>"$work/err" || status=$?
expect_line "closed output"
{ status=0; localize "$work/part" 2>"$work/err" || status=$?; echo "$status" >"$work/status"; } | true
status=$(cat "$work/status")
expect_line "a reader that has gone"
