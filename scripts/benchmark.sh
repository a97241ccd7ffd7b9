#!/usr/bin/env bash
# Builds the benchmarks with the flags that users get, runs them one after the other, and writes
# doc/Animated_mesh_features/Performance.txt. To be run on a machine that does nothing else; takes about half an
# hour on two cores, besides compiling.
#
#   scripts/benchmark.sh               on generated animations
#   scripts/benchmark.sh --data DIR    on a galloping horse where DIR has it: horse-gallop.obj, horse-gallop.pc2 and
#                                      horse-rest.obj
#   (in the table of views is the hand, too, once scripts/demo.sh --hand has fetched it)
#   scripts/benchmark.sh --quick       small sizes, a minute or two: shows that the programs work, and leaves the manual
#                                      alone
#
# The figures are in build/benchmark/*.json, what is printed in build/benchmark/*.log.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

options=()
page="$root/doc/Animated_mesh_features/Performance.txt"
while [ $# -gt 0 ]; do
  case "$1" in
    --quick)
      options+=(--quick)
      page="$root/build/benchmark/Performance.txt"
      ;;
    --data)
      if [ $# -lt 2 ] || [ ! -d "$2" ]; then die "--data needs a folder"; fi
      options+=(--data "$(cd "$2" && pwd -P)")
      shift
      ;;
    *) die "unknown option: $1" ;;
  esac
  shift
done

bash "$root/scripts/install_dependencies.sh"
install_packages python3 || die "the packages above could not be installed"
install_packages libsuitesparse-dev libopenblas-dev || echo "going on without the comparison with CHOLMOD"
cd "$root"
trap 'give_back "$root/build" "$page"' EXIT

say "Building"
folder="$root/build/benchmark"
configure "$folder" -DCMAKE_BUILD_TYPE=Release -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -DANIMATED_MESH_FEATURES_BUILD_BENCHMARKS=ON \
  -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF
build "$folder"

# benchmark NAME COMMAND...: runs a command, which prints tables and writes NAME.json.
benchmark()
{
  local name="$1" start=$SECONDS
  shift
  say "Benchmark: $name"
  rm -f "$folder/$name.json"
  "$@" "${options[@]}" --json "$folder/$name.json" | tee "$folder/$name.log"
  say "Benchmark: $name took $((SECONDS - start)) s"
}

programs="$folder/examples/Animated_mesh_features/programs"
hand="$root/demo_output/hand/rightHandHigh.glb"
if [ -s "$hand" ] && "$programs/simplify_animation" "$hand" --clip Fist --there-and-back --ratio 1 --quiet -o "$folder/hand"
then
  hand_options=(--hand "$folder/hand.obj")
else
  hand_options=()
fi
started=$SECONDS
for name in engine balls measures cholesky growth roofline viewpoints; do
  program="$folder/benchmark/Animated_mesh_features/benchmark_$name"
  if [ $name = cholesky ] && [ ! -x "$program" ]; then continue; fi # where there is no CHOLMOD
  if [ $name = viewpoints ]; then benchmark $name "$program" "${hand_options[@]}"; else benchmark $name "$program"; fi
done
benchmark program python3 "$root/benchmark/Animated_mesh_features/program.py" \
  "$programs/detect_features" "$programs/make_animation"

python3 "$root/benchmark/Animated_mesh_features/write_page.py" "$folder" "$page"
say "All benchmarks: $((SECONDS - started)) s"
