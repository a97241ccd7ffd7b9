#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# detect_features --glb: the file shows what the other outputs say, and the Khronos validator of glTF finds nothing wrong.
# DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without python3, or if the validator cannot be had
# from npm (version and checksum: scene_files/package-lock.json), the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation python3
enter_empty_folder

"$generator" figure --vertices 1000 --fps 10 -o c >/dev/null &&
  "$program" c.obj c.pc2 --fps 10 --quiet -o features.json --glb scene.glb --write-field deformation:deformation.npy &&
  python3 "$tests/scene_files/check_glb.py" scene.glb c features.json deformation.npy || exit 1
# without features: the surface alone
"$program" c.obj c.pc2 --threshold 1e6 --quiet --glb nothing.glb || exit 1

# read again, it is the body alone, with the same features; a program without the reader says so
if "$program" scene.glb --fps 10 --rest first -v -o again.json 2>err >/dev/null; then
  python3 - <<'PYTHON' || exit 1
import json
there, again, said = json.load(open("features.json")), json.load(open("again.json")), open("err").read()
assert again["animation"]["vertices"] == there["animation"]["vertices"], again["animation"]
assert "%d spheres left out: features" % len(there["features"]) in said, said
PYTHON
else
  grep -qE "built without|cannot read" err || { cat err; exit 1; }
fi

command -v npm >/dev/null || skip "what is in the file was compared, but it was not validated, which needs npm"
mkdir npm && cp "$tests"/scene_files/package*.json npm/ || exit 1
npm ci --prefix npm --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log 2>&1 ||
  skip "what is in the file was compared, but it was not validated; npm says: $(head -c 300 npm.log)"
for file in scene.glb nothing.glb; do
  node "$tests/scene_files/validate_glb.js" npm/node_modules $file || exit 1
done
