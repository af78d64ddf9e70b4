#!/usr/bin/env bash
# Both commands of the README on Debian 13 (MRPT 2.14, gcc 14), in a chroot that this script makes. Needs root,
# debootstrap, 8 GB of disk and an hour.
#   debian13.sh FOLDER             makes FOLDER/trixie (kept for the next time), copies the tree, runs both commands
#   debian13.sh FOLDER COMMAND...  runs this command instead, in the copy of the tree:
#                                  debian13.sh /var/tmp 'bash apps/build.sh mrpt_ext_maps mrpt_ext_rawlog'
# MIRROR names another Debian mirror. The log stays in FOLDER/debian13.log.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/tests/portability/chroot.sh"
[ $# -ge 1 ] || { sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
folder=$1
shift
commands=("$@")
[ ${#commands[@]} -gt 0 ] || commands=("bash apps/quickstart.sh" "bash tests/run.sh")

need_chroot debian13.sh
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
chroot=$folder/trixie
log=$folder/debian13.log

make_chroot trixie "$chroot"
mount --bind /proc "$chroot/proc"
mount --bind /dev "$chroot/dev"
trap 'umount "$chroot/proc" "$chroot/dev"' EXIT
mkdir -p "$chroot/src"
tar -C "$root" --exclude=./build --exclude='./build-*' --exclude=./out -cf - . | tar -C "$chroot/src" -xf -

: >"$log"
for command in "${commands[@]}"; do
  echo "== $command" | tee -a "$log"
  start=$SECONDS
  status=0
  in_chroot "$chroot" "$command" >>"$log" 2>&1 || status=$?
  tail -n 3 "$log"
  echo "== $command: exit code $status after $((SECONDS - start)) s" | tee -a "$log"
  [ "$status" -eq 0 ] || exit "$status"
done
in_chroot "$chroot" 'dpkg-query --show --showformat="\${Package} \${Version}\n" libmrpt-obs-dev g++ cmake libopencv-core-dev' |
  tee -a "$log"
