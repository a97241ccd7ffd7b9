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
if ! command -v pvpython >/dev/null; then
  echo "SKIPPED: ParaView, since pvpython is not here (Debian: paraview, python3-paraview and xvfb)"
  exit 0
fi
show() { timeout 120 "$@" scene/show_in_paraview.py picture.png 0.5 >pvpython.log 2>&1; }
# Debian's ParaView needs a display, which may be slow to come.
if ! { show xvfb-run -a pvpython || show xvfb-run -a pvpython || show pvpython --force-offscreen-rendering; } 2>/dev/null; then
  cat pvpython.log
  exit 1
fi
# body, spheres and two keys on white paper; of each colour there are some
"$python" - <<'PYTHON' || { cat pvpython.log; exit 1; }
import sys
from vtkmodules.vtkIOImage import vtkPNGReader
reader = vtkPNGReader()
reader.SetFileName("picture.png")
reader.Update()
colours = reader.GetOutput().GetPointData().GetScalars()
pixels = [colours.GetTuple3(i) for i in range(0, colours.GetNumberOfTuples(), 7)]
white = sum(p == (255, 255, 255) for p in pixels) / len(pixels)
red = sum(r > 1.5 * g + 20 and r > b for r, g, b in pixels) / len(pixels)
body = sum(abs(r - g) < 40 and b < r - 5 and r > 60 for r, g, b in pixels) / len(pixels)
print("ParaView opens the scene: %.3f of its picture is paper, %.3f body, %.3f red" % (white, body, red))
sys.exit(not (0.3 < white < 0.97 and body > 0.01 and red > 0.001))
PYTHON
