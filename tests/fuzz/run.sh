#!/usr/bin/env bash
# Fuzzes every reader of foreign input for MINUTES, with the address and undefined behaviour sanitizers:
#   run.sh MINUTES [TARGET ...]
# Builds into build-fuzz with clang. A fault is left in build-fuzz/faults and makes the exit code 1; put it into
# tests/fuzz/corpus/<target> together with its correction. Prints the executions of each target.
set -euo pipefail
if [ $# -lt 1 ]; then
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
minutes=$1
shift
targets=("$@")
[ ${#targets[@]} -gt 0 ] || targets=(rawlog ini scenario images_ini map tum csv live camera dictionary image summary mcap db3 cdr layout bundle)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
build=$root/build-fuzz

bash "$root/apps/install_dependencies.sh" --tests --sanitizers
CC=clang CXX=clang++ cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo -DMRPT_EXT_BUILD_TESTS=ON \
  -DMRPT_EXT_FUZZ=ON -DMRPT_EXT_SANITIZE=address,undefined -DCMAKE_UNITY_BUILD=ON \
  -DCMAKE_CXX_FLAGS=-fsanitize=fuzzer-no-link >/dev/null
cmake --build "$build" --target "${targets[@]/#/fuzz_}"

# Files that are written for every input stay in memory.
[ ! -w /dev/shm ] || export TMPDIR=/dev/shm
export ASAN_OPTIONS=verify_asan_link_order=0:quarantine_size_mb=64
mkdir -p "$build/faults"
status=0
for target in "${targets[@]}"; do
  mkdir -p "$build/corpus/$target"
  "$build/bin/fuzz_$target" -max_total_time=$((60 * minutes)) -timeout=5 -rss_limit_mb=1024 -malloc_limit_mb=1024 -max_len=65536 \
    -print_final_stats=1 -print_funcs=0 -artifact_prefix="$build/faults/$target-" "$build/corpus/$target" "$here/corpus/$target" \
    >"$build/$target.log" 2>&1 || status=1
  printf '%-8s %s executions\n' "$target" "$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/$target.log")"
done
exit $status
