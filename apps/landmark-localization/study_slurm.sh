#!/usr/bin/env bash
#SBATCH --job-name=landmark-study
#SBATCH --cpus-per-task=1
#SBATCH --requeue
# A study of many trials as a Slurm array, one element per part:
#   sbatch --array=0-49 study_slurm.sh CONFIG.ini OUT TRIALS [options of landmark-localization]
#   localization-report OUT/part_* -o OUT/report.html        (when all have ended)
# Element k of n runs trials k TRIALS/n up to (k+1) TRIALS/n. An element that was pre-empted and requeued goes on where it
# stopped. The programs must be on the PATH.
set -euo pipefail
if [ $# -lt 3 ] || [ -z "${SLURM_ARRAY_TASK_ID:-}" ]; then
  sed -n '5,9s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
config=$1 out=$2 trials=$3
shift 3
parts=$((SLURM_ARRAY_TASK_MAX - SLURM_ARRAY_TASK_MIN + 1)) part=$((SLURM_ARRAY_TASK_ID - SLURM_ARRAY_TASK_MIN))
first=$((trials * part / parts)) last=$((trials * (part + 1) / parts))
[ "$first" -lt "$last" ] || exit 0
exec landmark-localization "$config" --trials "$first:$last" -o "$(printf '%s/part_%06d' "$out" "$first")" --resume -q "$@"
