#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The add-on for Blender: what it reads, with Blender's modules stood in for; and, where Blender is, in Blender, in the
# background. DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without NumPy, the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation
# A python3 that comes first in the path may not be the one that the system's packages are for.
for python in python3 /usr/bin/python3; do
  "$python" -c "import numpy" 2>/dev/null && break
  python=""
done
[[ -n "$python" ]] || skip "needs Python and NumPy"
addon="$(cd "$tests/../../python/blender" && pwd)/import_animated_mesh_features.py"
enter_empty_folder
export PYTHONDONTWRITEBYTECODE=1

"$generator" figure --vertices 1000 --fps 10 -o c >/dev/null &&
  "$program" c.obj c.pc2 --fps 10 --quiet -o features.json --write-field deformation:deformation.npy || exit 1
"$python" "$tests/blender_files/check_files.py" "$addon" features.json deformation.npy || exit 1

if command -v blender >/dev/null; then
  if ! timeout 120 blender --background --factory-startup --python-exit-code 1 --python "$tests/blender_files/check_in_blender.py" -- \
       "$addon" c features.json deformation.npy >blender.log 2>&1; then
    cat blender.log
    exit 1
  fi
  grep '^Blender .* checks' blender.log
fi
