#!/usr/bin/env bash
# Installs the packages of `bash apps/package.sh` in a clean Debian of this machine's release, uses them as somebody who may
# write in no folder but the own, and removes them. Needs root, debootstrap, 4 GB of disk and some minutes.
#   packages.sh FOLDER [PACKAGES]    makes FOLDER/<release> (kept for the next time) and a copy of it for this run;
#                                    PACKAGES: the folder of the .deb files, default out/packages
# MIRROR names another Debian mirror. Every check is one line; the log stays in FOLDER/packages.log.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/tests/portability/chroot.sh"
[ $# -ge 1 ] || { sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
need_chroot packages.sh
mkdir -p "$1"
folder=$(cd "$1" && pwd) packages=$(cd "${2:-$root/out/packages}" && pwd)
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
log=$folder/packages.log clean=$folder/clean

# What is mounted goes first: what is removed after it is the copy alone.
leave() {
  ! mountpoint -q "$clean/proc" || umount "$clean/proc"
  rm -rf --one-file-system "$clean"
}
make_chroot "$release" "$folder/$release"
leave
trap leave EXIT
cp -a "$folder/$release" "$clean"
mkdir "$clean/packages"
cp "$packages"/*.deb "$clean/packages"
echo force-unsafe-io >"$clean/etc/dpkg/dpkg.cfg.d/unsafe-io" # nobody needs this copy after a power cut
mount -t proc proc "$clean/proc"
in_chroot "$clean" "useradd --create-home robot"

: >"$log"
# check WHAT COMMAND [USER]: ends with the log's last lines when the command fails.
check() {
  local start=$SECONDS
  printf '== %s\n' "$1" >>"$log"
  if ! in_chroot "$clean" "set -eo pipefail; $2" "${3:-}" >>"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "packages.sh: FAILED: $1, see $log" >&2
    exit 1
  fi
  echo "ok   $1 ($((SECONDS - start)) s)"
}
share=/usr/share/mrpt_ext

install() {
  local name files=
  for name in "$@"; do files+=" /packages/${name}_*.deb"; done
  check "$* installed" "apt-get -q update; apt-get -q -y install --no-install-recommends $files"
}

install libmrpt-ext0 python3-mrpt-ext
check "Python localizes" "python3 -c 'import mrpt_ext; print(mrpt_ext.__version__)'
  python3 /usr/share/doc/python3-mrpt-ext/examples/live.py | tee live.txt; tail -n 1 live.txt | grep -q ' ok '" robot

install mrpt-ext-apps
check "the room is localized" "landmark-localization $share/ini/landmark-localization/room.ini
  grep -q '\"verdict\": \"ok\"' out/room/summary.json; test -s out/room/report.html" robot
check "it runs without a configuration" "landmark-localization $share/datasets/room.rawlog --map $share/datasets/room_map.csv -q" robot
check "a scenario is simulated and localized" "landmark-simulator $share/ini/landmark-simulator/kidnap.ini -o out/sim/kidnap.rawlog
  landmark-localization $share/ini/landmark-localization/kidnap.ini out/sim/kidnap.rawlog --map out/sim/kidnap_map.csv \
    --ground-truth out/sim/kidnap_ground_truth.tum -q" robot
check "images are measured and localized" "images2rawlog $share/ini/images2rawlog/conic-mirror.ini -i $share/datasets/conic-mirror -o out/cone/cone.rawlog
  landmark-localization $share/ini/landmark-localization/conic-mirror.ini out/cone/cone.rawlog --map out/cone/cone_map.csv \
    --ground-truth out/cone/cone_ground_truth.tum -q" robot
check "runs are compared" "localization-report out/room out/kidnap -o out/report.html; test -s out/report.html" robot
check "the READMEs' commands run in a copy of the data" "cp -r $share copy; cd copy
  landmark-localization ini/landmark-localization/quickstart.ini -q" robot
check "Python runs a log" "python3 -c 'import mrpt_ext
run = mrpt_ext.run(\"$share/ini/landmark-localization/quickstart.ini\", \"out/python\", options=[\"--duration\", \"30\"])
assert run.summary[\"verdict\"] == \"ok\", run.summary[\"verdict\"]'" robot
check "man pages and completion" "for app in dataset2rawlog images2rawlog landmark-localization landmark-simulator localization-report; do
    zcat /usr/share/man/man1/\$app.1.gz | grep -q 'SH OPTIONS'
    source /usr/share/bash-completion/completions/\$app
    COMP_CWORD=1; _mrpt_ext \$app --vers \$app; test \"\${COMPREPLY[*]}\" = --version
  done" robot

install libmrpt-ext-dev
check "compiler installed" "apt-get -q -y install --no-install-recommends cmake g++ make"
check "a consumer is built and localizes" "cp -r /usr/share/doc/libmrpt-ext-dev/examples/consumer .
  cmake -S consumer -B consumer/build; cmake --build consumer/build; consumer/build/consumer >estimate.txt
  cat estimate.txt; grep -qE '^estimate: (1[.][89]|2[.][01])' estimate.txt" robot

check "MRPT's tools are installed" "apt-get -q -y install --no-install-recommends mrpt-apps"
check "rawlog-edit sees our classes" "rawlog-edit --info -i $share/datasets/room.rawlog -p libmrpt_ext_observations.so.0 >info.txt 2>&1
  cat info.txt; grep -q '451' info.txt; test \$(grep -c 'not registered' info.txt) = 0" robot
check "pf-localization uses our map" "cd copy
  LD_PRELOAD=libmrpt_ext_maps.so.0 pf-localization ini/pf-localization/room.ini datasets/room.rawlog </dev/null >pf.txt 2>&1
  tail -n 5 pf.txt; test \$(grep -c 'not registered' pf.txt) = 0; ls pf-localization*/*" robot

check "removed" "apt-get -q -y purge mrpt-ext-apps libmrpt-ext0 libmrpt-ext-dev python3-mrpt-ext"
check "nothing is left" "left=\$(find / -xdev \( -path /home -o -path /packages \) -prune -o -name '*mrpt[-_]ext*' -print -o -name 'lib*mrpt_ext*' -print -o -name 'landmark-localization*' -print)
  echo \"\$left\"; test -z \"\$left\""
echo "packages.sh: all checks passed"
