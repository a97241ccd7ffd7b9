#!/usr/bin/env bash
# Gives random bytes to what reads files and to the detector: builds the fuzz targets (test/fuzz/, clang's libFuzzer with the
# sanitizers for addresses and undefined behaviour) and runs them, as many at a time as there are cores.
#
#   scripts/fuzz.sh MINUTES [TARGET...]   all targets, or these, MINUTES each: meshes, caches, gltf, hdf5, features, detector
#
# Bytes that crash a target, take it more than 20 seconds or 2 GB are kept in build/fuzz/found/; run the target with such a
# file as argument to see it again. What reached new code is kept in build/fuzz/corpus/, for the next run to start from.
# Returns non-zero if anything was found.

set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[[ "${1:-}" =~ ^[0-9]+([.][0-9]+)?$ ]] || die "how many minutes?"
seconds=$(awk "BEGIN { print int(60 * $1) }")
shift
cd "$root" || exit 1
trap 'give_back "$root/build"; rm -rf "${scratch:-}"' EXIT

export folder=build/fuzz seconds scratch
configure $folder -DCMAKE_CXX_COMPILER=clang++ -DANIMATED_MESH_FEATURES_WERROR=ON -DANIMATED_MESH_FEATURES_BUILD_FUZZERS=ON \
  -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF || exit 1
[ -f $folder/test/fuzz/targets.txt ] || die "$(grep -A 1 libFuzzer $folder/configure.log)"
mapfile -t all < $folder/test/fuzz/targets.txt
targets=("${@/#/fuzz_}")
[ $# -gt 0 ] || targets=("${all[@]}")
cmake --build $folder --parallel "$(job_count)" --target "${targets[@]}" || exit 1

# Files of the readers are made anew for each input: in memory, if it can be had as a folder.
scratch=$(TMPDIR=$([ -w /dev/shm ] && echo /dev/shm || echo "${TMPDIR:-/tmp}") mktemp -d)
mkdir -p $folder/found $folder/logs

# run TARGET: a line of figures; non-zero if anything was found
run()
{
  local target="$1" name="${1#fuzz_}" dictionary=() result=0
  local log="$folder/logs/$name"
  mkdir -p "$folder/corpus/$name"
  if [ -f "test/fuzz/$name.dict" ]; then dictionary=("-dict=test/fuzz/$name.dict"); fi
  TMPDIR="$scratch" "$folder/test/fuzz/$target" -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=2048 \
    -malloc_limit_mb=512 -print_final_stats=1 "-artifact_prefix=$folder/found/$name-" "${dictionary[@]}" \
    "$folder/corpus/$name" "test/fuzz/corpus/$name" > "$log" 2>&1 || result=1
  printf '%-10s %12s executions %7s edges %s\n' "$name" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")" \
    "$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)" \
    "$([ $result = 0 ] && echo "nothing found" || grep -m 1 -E '^(fuzz target:|==[0-9]+== *ERROR)' "$log" ||
       echo "failed, see $log")"
  return $result
}
export -f run

say "Fuzzing, $seconds seconds a target"
printf '%s\n' "${targets[@]}" | xargs -P "$(nproc)" -I '{}' bash -c 'run {}'
