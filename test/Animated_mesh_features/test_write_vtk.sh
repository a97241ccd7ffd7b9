#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# detect_features --vtk: VTK's own readers find in the files what the other outputs say.
# DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without VTK's Python module, the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation
# A python3 that comes first in the path may not be the one that the system's packages are for.
for python in python3 /usr/bin/python3; do
  "$python" -c "import vtkmodules.vtkIOXML" 2>/dev/null && break
  python=""
done
[[ -n "$python" ]] || skip "needs Python and VTK's module for it (python3-vtk9)"
enter_empty_folder

"$generator" figure --vertices 1000 --fps 10 -o c >/dev/null &&
  "$program" c.obj c.pc2 --fps 10 --rest first --quiet -o features.json --vtk scene --write-field strain:strain.npy \
    --write-field curvature:curvature.npy --write-field deformation:deformation.npy &&
  "$python" "$tests/scene_files/check_vtk.py" scene c features.json || exit 1

# the script for ParaView, where that is
pvpython="$(command -v pvpython)"
if [[ -n "$pvpython" ]]; then
  if ! timeout 120 "$pvpython" --force-offscreen-rendering scene/show_in_paraview.py picture.png 0.5 >pvpython.log 2>&1 &&
     ! timeout 120 xvfb-run -a "$pvpython" scene/show_in_paraview.py picture.png 0.5 >pvpython.log 2>&1; then
    cat pvpython.log
    exit 1
  fi
  # an empty picture is a few thousand bytes
  [[ -s picture.png && "$(stat -c %s picture.png)" -gt 10000 ]] || { echo "failed: ParaView's picture is empty"; exit 1; }
  echo "ParaView opens the scene"
fi
