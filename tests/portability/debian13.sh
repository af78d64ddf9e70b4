#!/usr/bin/env bash
# Both commands of the README on Debian 13 (MRPT 2.14, gcc 14), in a chroot that this script makes. Needs root,
# debootstrap, 8 GB of disk and an hour.
#   debian13.sh FOLDER             makes FOLDER/trixie (kept for the next time), copies the tree, runs both commands
#   debian13.sh FOLDER COMMAND...  runs this command instead, in the copy of the tree:
#                                  debian13.sh /var/tmp 'bash apps/build.sh mrpt_ext_maps mrpt_ext_rawlog'
# MIRROR names another Debian mirror. The log stays in FOLDER/debian13.log.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ $# -ge 1 ] || { sed -n '2,8s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
folder=$1
shift
commands=("$@")
[ ${#commands[@]} -gt 0 ] || commands=("bash apps/quickstart.sh" "bash tests/run.sh")

[ "$(id -u)" -eq 0 ] || { echo "debian13.sh: a chroot needs root" >&2; exit 1; }
command -v debootstrap >/dev/null || { echo "debian13.sh: no debootstrap: apt-get install debootstrap" >&2; exit 1; }
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
chroot=$folder/trixie
log=$folder/debian13.log

if [ ! -f "$chroot/etc/debian_version" ]; then
  debootstrap --variant=minbase trixie "$chroot" "${MIRROR:-http://deb.debian.org/debian}" | tail -n 1
fi
# The settings that apt needs on this machine hold there too: proxies, mirrors of this network.
cp /etc/resolv.conf "$chroot/etc/" 2>/dev/null || true
for setting in /etc/apt/apt.conf.d/*proxy*; do
  [ ! -e "$setting" ] || cp "$setting" "$chroot/etc/apt/apt.conf.d/"
done

mount --bind /proc "$chroot/proc"
mount --bind /dev "$chroot/dev"
trap 'umount "$chroot/proc" "$chroot/dev"' EXIT
mkdir -p "$chroot/src"
tar -C "$root" --exclude=./build --exclude='./build-*' --exclude=./out -cf - . | tar -C "$chroot/src" -xf -

inside() {
  chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy=$http_proxy} ${https_proxy:+https_proxy=$https_proxy} bash -c "cd /src && $1"
}
: >"$log"
for command in "${commands[@]}"; do
  echo "== $command" | tee -a "$log"
  start=$SECONDS
  status=0
  inside "$command" >>"$log" 2>&1 || status=$?
  tail -n 3 "$log"
  echo "== $command: exit code $status after $((SECONDS - start)) s" | tee -a "$log"
  [ "$status" -eq 0 ] || exit "$status"
done
inside 'dpkg-query --show --showformat="\${Package} \${Version}\n" libmrpt-obs-dev g++ cmake libopencv-core-dev' |
  tee -a "$log"
