#!/usr/bin/env bash
# completion.sh BIN_FOLDER SOURCE_FOLDER: what bash offers after the words that one has typed.
set -euo pipefail
bin=$1
source "$2/libmrpt-ext/packages/completion.bash"
compopt() { :; } # bash has it only while it completes

# offers EXPECTED WORD...: the last word is being typed
offers() {
  local expected=$1
  shift
  COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _mrpt_ext "$bin/$1" "${*: -1}" "${*: -2:1}"
  [ "${COMPREPLY[*]}" = "$expected" ] || { echo "$*: offers '${COMPREPLY[*]}', expected '$expected'" >&2; exit 1; }
}
offers --version landmark-localization --vers
offers "--ground-truth --gui --gui-speed" landmark-localization room.ini --g
offers "" landmark-localization --map ""
offers LocalizationExperiment.random_seed landmark-localization --explain LocalizationExperiment.random
offers LocalizationExperiment.random_seed= landmark-localization room.ini --set LocalizationExperiment.random
offers "mrclam mrclam-snapshots" dataset2rawlog mrc
offers "known category anonymous" dataset2rawlog mrclam --identity ""
