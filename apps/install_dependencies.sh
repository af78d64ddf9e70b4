#!/usr/bin/env bash
# Installs the Debian packages that are missing (Debian 12 and 13 have them); does nothing when nothing is missing.
#   install_dependencies.sh            what the build needs
#   install_dependencies.sh --tests    ... and what the tests need
#   install_dependencies.sh --lint     ... and the formatter and the static analyser, where there is their version 14
#   install_dependencies.sh --sanitizers ... and the compiler of the sanitizers and fuzzers
#   install_dependencies.sh --packages ... and what Debian packages are made with
#   install_dependencies.sh --list     installs nothing, prints the names
set -euo pipefail

build=(g++ cmake ninja-build libeigen3-dev zlib1g-dev libzstd-dev liblz4-dev libsqlite3-dev libjpeg-dev libtbb-dev libboost-dev libssl-dev
  libcli11-dev nlohmann-json3-dev libyaml-cpp-dev libjs-dygraphs libmrpt-obs-dev libmrpt-maps-dev libmrpt-opengl-dev libmrpt-slam-dev
  libmrpt-gui-dev libx11-dev libopencv-core-dev libopencv-imgproc-dev libopencv-imgcodecs-dev libapriltag-dev)
tests=(libgtest-dev librapidcheck-dev libbenchmark-dev mrpt-apps mrpt-common xvfb xauth libxml2-utils python3 parallel
  chromium python3-dev pybind11-dev python3-numpy python3-pytest)
packages=(dpkg-dev file help2man lintian python3-dev pybind11-dev python3-numpy)
sanitizers=(clang libclang-rt-dev)
lint=(node-typescript)
# Debian 13 has no version 14 of them.
case "$(. /etc/os-release 2>/dev/null && echo "${ID:-}-${VERSION_ID:-}")" in
  debian-13) ;;
  *) lint+=(clang-format-14 clang-tidy-14) ;;
esac

wanted=("${build[@]}") list=
for option in "$@"; do
  case "$option" in
    --tests) wanted+=("${tests[@]}") ;;
    --lint) wanted+=("${lint[@]}") ;;
    --sanitizers) wanted+=("${sanitizers[@]}") ;;
    --packages) wanted+=("${packages[@]}") ;;
    --list) list=1 ;;
    *)
      echo "install_dependencies.sh: unknown option '$option', expected --tests, --lint, --sanitizers, --packages or --list" >&2
      exit 2
      ;;
  esac
done
if [ -n "$list" ]; then
  echo "${wanted[*]}"
  exit 0
fi

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "install_dependencies.sh: no apt-get here; install what corresponds to: ${wanted[*]}" >&2
  exit 1
fi

installed() { dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null | grep -qx installed; }
missing=()
for package in "${wanted[@]}"; do
  installed "$package" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "install_dependencies.sh: neither root nor sudo; run as root: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt_get() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@" >"$log" 2>&1; }
echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
# A failing update is not yet an error: the lists on the machine may do.
apt_get update || true
if ! apt_get install --no-install-recommends "${missing[@]}"; then
  echo "install_dependencies.sh: apt-get could not install ${missing[*]}: $(grep -m1 '^E:' "$log" || tail -n 1 "$log")" >&2
  exit 1
fi
