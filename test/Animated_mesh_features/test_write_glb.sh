#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# detect_features --glb: the file shows what the other outputs say, and the Khronos validator of glTF finds nothing wrong.
# DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without python3, or if the validator cannot be had
# from npm (version and checksum: scene_files/package-lock.json), the test is skipped (77).

set -u
program="${DETECT_FEATURES:-}"
generator="${MAKE_ANIMATION:-}"
here="$(cd "$(dirname "$0")" && pwd)/scene_files"
if [[ -z "$program" || -z "$generator" ]] || ! command -v python3 >/dev/null; then
  echo "skipped: needs DETECT_FEATURES, MAKE_ANIMATION and python3"
  exit 77
fi

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
export PYTHONDONTWRITEBYTECODE=1
"$generator" figure --vertices 1000 --fps 10 -o c >/dev/null &&
  "$program" c.obj c.pc2 --fps 10 --quiet -o features.json --glb scene.glb --write-field deformation:deformation.npy &&
  python3 "$here/check_glb.py" scene.glb c features.json deformation.npy || exit 1
# without features: the surface alone
"$program" c.obj c.pc2 --absolute-threshold 1e6 --quiet --glb nothing.glb || exit 1

if ! command -v npm >/dev/null; then
  echo "skipped: what is in the file was compared, but it was not validated, which needs npm"
  exit 77
fi
mkdir npm && cp "$here"/package*.json npm/ || exit 1
if ! npm ci --prefix npm --ignore-scripts --no-audit --no-fund --loglevel=error >npm.log 2>&1; then
  echo "skipped: what is in the file was compared, but it was not validated; npm says: $(head -c 300 npm.log)"
  exit 77
fi
for file in scene.glb nothing.glb; do
  node "$here/validate_glb.js" npm/node_modules $file || exit 1
done
