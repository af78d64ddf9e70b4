#!/usr/bin/env bash
# Makes the Debian packages mrpt-ext-apps, libmrpt-ext0, libmrpt-ext-dev and python3-mrpt-ext, for the release of Debian
# that it runs on, and asks lintian. Builds in build-package/, installs what is missing.
#   package.sh [FOLDER]     where the packages go; default: out/packages
# The maintainer they name is DEBFULLNAME <DEBEMAIL>, or who made the last commit.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build-package
mkdir -p "${1:-$root/out/packages}"
folder=$(cd "${1:-$root/out/packages}" && pwd)

maintainer=${DEBEMAIL:+${DEBFULLNAME:-$DEBEMAIL} <$DEBEMAIL>}
if [ -z "$maintainer" ] && ! maintainer=$(git -C "$root" log -1 --format='%an <%ae>' 2>/dev/null); then
  echo "package.sh: no commit to take the maintainer from, expected DEBFULLNAME and DEBEMAIL" >&2
  exit 2
fi

bash "$root/apps/install_dependencies.sh" --packages
settings=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DCMAKE_SKIP_INSTALL_RPATH=ON -DMRPT_EXT_BUILD_TESTS=OFF
  -DMRPT_EXT_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3 -DMRPT_EXT_PYTHON_DIR=lib/python3/dist-packages
  -DMRPT_EXT_BUILD_PACKAGES=ON "-DMRPT_EXT_MAINTAINER=$maintainer" "-DCMAKE_EXE_LINKER_FLAGS=-Wl,-z,relro,-z,now"
  "-DCMAKE_SHARED_LINKER_FLAGS=-Wl,-z,relro,-z,now" "-DCMAKE_MODULE_LINKER_FLAGS=-Wl,-z,relro,-z,now")
[ -f "$build/CMakeCache.txt" ] || settings+=(-G Ninja -DCMAKE_UNITY_BUILD=ON)
cmake -S "$root" -B "$build" "${settings[@]}"
cmake --build "$build" --parallel "$(nproc)"

rm -f "$folder"/*.deb
(cd "$build" && cpack -B "$folder")
rm -rf "$folder/_CPack_Packages"
[ "$(id -u)" -ne 0 ] || as_root=--allow-root
lintian ${as_root:-} --fail-on error "$folder"/*.deb
ls "$folder"/*.deb
