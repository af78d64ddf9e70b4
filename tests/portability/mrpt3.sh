#!/usr/bin/env bash
# Compiles every source file that sees MRPT against the headers of MRPT 3, without building anything of MRPT:
#   mrpt3.sh SOURCE_FOLDER [FOLDER...]     all files, or those below these folders: mrpt3.sh ~/mrpt observations maps
# SOURCE_FOLDER is a checkout of MRPT 3 (the folder with modules/). Needs what the project itself needs, the MRPT of this
# machine among it: it gives all other flags. Prints a line per folder, and the first errors of a file that does not compile.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
[ $# -ge 1 ] && [ -d "$1/modules/mrpt_obs" ] || { sed -n '2,6s/^# //p' "${BASH_SOURCE[0]}" >&2; exit 2; }
modules=$(cd "$1/modules" && pwd)
shift
work=$root/build/mrpt3
mkdir -p "$work/include/mrpt"

# What MRPT's own configuration would write: the templates with every option off.
version=$(sed -n 's/.*<version>\(.*\)<.*/\1/p' "$modules/mrpt_common/package.xml" | head -n 1)
IFS=. read -r major minor patch <<<"$version"
filled() {
  sed -e 's/\${CMAKE_MRPT_BUILD_SHARED_LIB}//' -e '/#cmakedefine/d' -e 's/\${EIGEN_MAX_[A-Z_]*}/16/' \
    -e 's/\${CMAKE_MRPT_WORD_SIZE}/64/' -e "s/\${CMAKE_MRPT_VERSION_CODE}/$(printf 0x%02x%02x%02x "$major" "$minor" "$patch")/" \
    -e 's/\${[A-Za-z_0-9]*}/0/' "$1"
}
filled "$modules/mrpt_core/version.h.in" >"$work/include/mrpt/version.h"
for template in "$modules"/*/config.h.in; do
  name=$(basename "$(dirname "$template")")
  mkdir -p "$work/include/mrpt/${name#mrpt_}"
  filled "$template" >"$work/include/mrpt/${name#mrpt_}/config.h"
done

cmake -S "$root" -B "$work" -DMRPT_EXT_BUILD_TESTS=ON -DCMAKE_UNITY_BUILD=OFF >/dev/null
echo "MRPT $version, $(c++ --version | head -n 1)"
python3 - "$root" "$work" "$modules" "$@" <<'END'
import collections, concurrent.futures, json, os, pathlib, re, subprocess, sys

root, work, modules = (pathlib.Path(argument) for argument in sys.argv[1:4])
wanted = sys.argv[4:]
system = "".join(f" -isystem {path}" for path in [work / "include", *sorted(modules.glob("*/include"))])


def folder_of(entry):
    return str(pathlib.Path(entry["file"]).parent.relative_to(root))


def compiled(entry):
    command = re.sub(r" -isystem /\S*/mrpt/\w+/include(?= )", "", entry["command"])
    command = re.sub(r" -o \S+ -c ", system.replace("\\", "\\\\") + " -Werror -fsyntax-only ", command)
    done = subprocess.run(command, shell=True, cwd=entry["directory"], capture_output=True, text=True)
    return entry, done.returncode == 0, [line for line in done.stderr.splitlines() if "error" in line][:3]


entries = [
    entry
    for entry in json.loads((work / "compile_commands.json").read_text())
    if "/mrpt/obs/include" in entry["command"] and pathlib.Path(entry["file"]).is_relative_to(root)
    and (not wanted or any(pathlib.Path(folder_of(entry)).is_relative_to(folder) for folder in wanted))
]
entries = list({entry["file"]: entry for entry in entries}.values())
failed, total = collections.Counter(), collections.Counter()
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for entry, good, errors in pool.map(compiled, entries):
        total[folder_of(entry)] += 1
        if not good:
            failed[folder_of(entry)] += 1
            print(f"{pathlib.Path(entry['file']).relative_to(root)} does not compile:", *errors, sep="\n  ")
for folder, count in sorted(total.items()):
    print(f"{folder}: {count - failed[folder]} of {count} files compile")
print(f"{sum(total.values()) - sum(failed.values())} of {sum(total.values())} files compile")
sys.exit(1 if failed or not total else 0)
END
