#!/usr/bin/env bash
# From a fresh checkout to features: installs what is missing (Debian, Ubuntu), builds the two programs, generates an
# animation of a moving figure, detects its features, lists the strongest ones, and makes a page and a picture to look at.
# Everything is written to the folder demo_output of the checkout.
#
#   scripts/demo.sh          the figure
#   scripts/demo.sh --hand   a hand that makes a fist and opens again, from a GLB file (see scripts/fetch_hands.sh)

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

hand=false
case "${1:-}" in
  "") ;;
  --hand) hand=true ;;
  *) die "unknown option: $1" ;;
esac

bash "$root/scripts/install_dependencies.sh"
if $hand; then
  install_packages curl ca-certificates || echo "going on without curl"
fi

cd "$root"
trap 'give_back "$root/build" "$root/demo_output"' EXIT

say "Building; this takes a few minutes the first time"
configure build/demo -DCMAKE_BUILD_TYPE=Release \
  -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF
cmake --build build/demo --parallel "$(job_count)" --target detect_features make_animation
programs="$root/build/demo/examples/Animated_mesh_features/programs"

mkdir -p demo_output
cd demo_output

if $hand; then
  say "Fetching the hand"
  bash "$root/scripts/fetch_hands.sh" hand || die "without the hand there is nothing to show"
  input=(hand/rightHandHigh.glb --clip Fist --there-and-back)
else
  say "Generating an animation"
  "$programs/make_animation" figure -o animation
  input=(animation.obj animation.pc2 --rest average)
fi

say "Detecting features"
rm -f view.html
view=()
if [ -s "$root/build/demo/viewer/viewer.html" ]; then view=(--html view.html); fi
"$programs/detect_features" "${input[@]}" -o features.json -o features.csv -o features.ply --png features.png "${view[@]}"

say "The strongest features"
# columns by their names in the first line; the rows come strongest first
awk -F, '
  NR == 1 {
    for (i = 1; i <= NF; ++i) column[$i] = i
    split("time x y z sigma tau strength", needed, " ")
    for (i in needed)
      if (!(needed[i] in column)) { print "features.csv has no column " needed[i] > "/dev/stderr"; bad = 1; exit 1 }
    printf "%10s  %28s  %10s  %10s  %10s\n", "time", "place (x, y, z)", "sigma", "tau", "strength"
    next
  }
  NR <= 11 {
    place = sprintf("%.4g, %.4g, %.4g", $column["x"], $column["y"], $column["z"])
    printf "%8.4g s  %28s  %10.4g  %8.4g s  %10.4g\n", $column["time"], place, $column["sigma"], $column["tau"],
      $column["strength"]
  }
  END {
    if (bad) exit 1
    printf "\n%d features in all: when (s), where, how large (sigma, in units of the mesh), how long (tau, s)\n", NR - 1
  }' features.csv

say "Written to $root/demo_output"
ls -l
if [ ${#view[@]} -gt 0 ]; then
  say "Now open in a browser: file://$PWD/view.html"
else
  say "Now look at $PWD/features.png; there is no page for the browser, since Node.js could not be used, see above"
fi
