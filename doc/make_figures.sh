#!/usr/bin/env bash
# Makes the figures of README.md and of the manual, in doc/Animated_mesh_features/fig, from nothing but the programs of this
# package: the built-in animations, their features, numbers and pictures. Needs what scripts/install_dependencies.sh
# installs, and Python. The same programs and libraries give the same bytes.

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../scripts/common.sh"

cd "$root"
configure build/demo -DCMAKE_BUILD_TYPE=Release \
  -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF
trap 'give_back "$root/build" "$root/doc/Animated_mesh_features/fig"' EXIT
cmake --build build/demo --parallel "$(job_count)" --target figures
ls -l doc/Animated_mesh_features/fig
