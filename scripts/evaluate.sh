#!/usr/bin/env bash
# Measures what the detector finds, on animations whose events are known and on the same motions sampled otherwise,
# beside the paper's recipe and detectors of static shapes, and brings the tables and curves of the manual's page Does It
# Find What It Should (doc/Animated_mesh_features/Evaluation.txt) up to date.
#
#   scripts/evaluate.sh                  on generated animations; with the evaluation data, too, where they are at hand:
#                                        in $ANIMATED_MESH_FEATURES_TEST_DATA, or in ../shared/data beside the checkout
#   scripts/evaluate.sh --data DIR       with the data in DIR
#   scripts/evaluate.sh --quick          a smaller figure and no data, some minutes: shows that everything works, and
#                                        leaves the manual alone
#   scripts/evaluate.sh --parts rig,...  some of the tables: rig, twins, noise, bodies, static; sheets: pictures
#   scripts/evaluate.sh --bodies child,woman_slim --motions walk,kick     some of the data's clips
#   scripts/evaluate.sh --time SECONDS   start nothing more after so many seconds
#   scripts/evaluate.sh --programs DIR   programs that are built already: detect_features, evaluate_features,
#                                        make_animation, and static_features for the table of static detectors
#   scripts/evaluate.sh --threads N      --run-with COMMAND     for each command, on a machine that others use, too
#
# On two cores that do nothing else, besides compiling: about a quarter of an hour without data, an hour and a half with
# all of its 60 clips of bodies. It may be interrupted at any time: what is in build/evaluation/work is not computed
# again by the same programs. Figures and tables are there, too, as JSON and Markdown. Without the data the page's rows
# about people are left out; a table that there was no time to complete leaves the page alone.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

data="${ANIMATED_MESH_FEATURES_TEST_DATA:-}"
if [ -z "$data" ] && [ -d "$root/../shared/data" ]; then data="$root/../shared/data"; fi
programs=""
options=()
kind=all
page=(--page "$root/doc/Animated_mesh_features/Evaluation.txt" --figures "$root/doc/Animated_mesh_features/fig")
while [ $# -gt 0 ]; do
  case "$1" in
    --quick)
      options+=(--quick)
      kind=quick
      page=()
      ;;
    --data | --programs | --parts | --bodies | --motions | --time | --threads | --run-with)
      if [ $# -lt 2 ]; then die "$1 needs a value"; fi
      case "$1" in
        --data)
          [ -d "$2" ] || die "--data needs a folder"
          data="$2"
          ;;
        --programs)
          [ -x "$2/detect_features" ] || die "$2: there is no detect_features in it"
          programs="$(cd "$2" && pwd -P)"
          ;;
        *) options+=("$1" "$2") ;;
      esac
      shift
      ;;
    *) die "unknown option: $1" ;;
  esac
  shift
done
if [ -n "$data" ]; then options+=(--data "$(cd "$data" && pwd -P)"); fi

# Those of others stay apart: by what they are, not by where.
work_of() { echo "$folder/work/$kind-$(cat "$@" | sha256sum | cut -c 1-12)"; }

folder="$root/build/evaluation"
if [ -z "$programs" ]; then
  bash "$root/scripts/install_dependencies.sh"
fi
install_packages python3 python3-numpy || die "the packages above could not be installed"
cd "$root"
trap 'give_back "$root/build" "$root/doc/Animated_mesh_features"' EXIT

if [ -z "$programs" ]; then
  say "Building"
  configure "$folder" -DCMAKE_BUILD_TYPE=Release -DANIMATED_MESH_FEATURES_BUILD_BENCHMARKS=ON \
    -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF
  cmake --build "$folder" --parallel "$(job_count)" \
    --target detect_features evaluate_features make_animation static_features test_static_detectors
  programs="$folder/examples/Animated_mesh_features/programs"
  static="$folder/benchmark/evaluation/static_features"
  "$folder/benchmark/evaluation/test_static_detectors"
else
  static="$programs/static_features"
fi
if [ -x "$static" ]; then
  options+=(--static "$static")
else
  echo "going on without detectors of static shapes: there is no $static"
fi

say "Evaluating"
exec_python="/usr/bin/python3" # the system's, which has the numpy of the packages
if [ ! -x "$exec_python" ]; then exec_python=python3; fi
"$exec_python" -B "$root/benchmark/evaluation/evaluate.py" --programs "$programs" "${page[@]}" "${options[@]}" \
  --work "$(work_of "$programs/detect_features" "$programs/make_animation")"
