#!/usr/bin/env bash
# Makes the figures of README.md and of the manual, in doc/Animated_mesh_features/fig, from nothing but the programs of this
# package: the built-in animations, their features, and the pictures. Needs what scripts/install_dependencies.sh installs.
# The same program and libraries give the same bytes.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

cd "$root"
configure build/demo -DCMAKE_BUILD_TYPE=Release \
  -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF
build build/demo
programs="$root/build/demo/examples/Animated_mesh_features"
figures="$root/doc/Animated_mesh_features/fig"

folder="$(mktemp -d)"
trap 'rm -rf "$folder"; give_back "$root/build" "$figures"' EXIT
mkdir -p "$figures"

say "Figure: features of a running figure"
"$programs/make_animation" figure --vertices 30000 -o "$folder/figure"
"$programs/detect_features" "$folder/figure.obj" "$folder/figure.pc2" \
  --png "$figures/running_figure.png" --frame 8 --frame 12 --frame 16 --frame 20 --png-size 1600x620

say "Figure: features of a bending cylinder"
"$programs/make_animation" cylinder -o "$folder/cylinder"
"$programs/detect_features" "$folder/cylinder.obj" "$folder/cylinder.pc2" \
  --png "$figures/bending_cylinder.png" --png-size 1600x620

say "Written to $figures"
ls -l "$figures"
