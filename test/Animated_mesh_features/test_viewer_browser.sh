#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The viewer in a browser, see test/viewer/browser_test.mjs. DETECT_FEATURES, MAKE_ANIMATION and, if it
# is there, COMPARE_ANIMATIONS are the programs. Skipped (77)
# without them, without Chromium, Node.js and npm, without a network, or if the program has no viewer.

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
source_folder="$(cd "$tests/../viewer" && pwd)"
node="$(command -v node || command -v nodejs)"
browser="$(command -v chromium || command -v chromium-browser || command -v google-chrome)"
[[ -n "$node" ]] || skip "needs Node.js"
needs detect_features make_animation npm
[[ -n "$browser" ]] || skip "needs Chromium"

cp "$source_folder"/*.json "$source_folder"/*.*js .
if ! npm ci --prefer-offline --ignore-scripts --no-audit --no-fund --fetch-retries=1 >npm.log 2>&1; then
  grep -qE 'ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ETIMEDOUT|ENETUNREACH' npm.log && skip "npm finds no network"
  cat npm.log
  exit 1
fi

# a small animation to look at closely, and one of the size that has a limit
"$generator" figure --vertices 1500 --fps 15 -o small >/dev/null || exit 1
options=()
"$program" --help | grep -q -- '--glb' && options=(--glb small.glb)
if ! "$program" small.obj small.pc2 --fps 15 -q -o small.json -o small.csv --html small.html "${options[@]}" \
       --write-field strain:strain.npy 2>err; then
  cat err
  grep -q "built without the viewer" err && skip "the program has no viewer"
  exit 1
fi
"$program" small.obj small.pc2 --fps 15 -q --cyclic --html cyclic.html || exit 1
"$generator" figure --vertices 9500 --frames 48 -o large >/dev/null || exit 1
"$program" large.obj large.pc2 -q --html large.html || exit 1
if [[ -n "$comparer" ]]; then
  "$generator" figure --vertices 1200 --frames 40 -o other >/dev/null || exit 1
  "$comparer" small.pc2 other.pc2 -q -o pair.json --html pair.html || exit 1
  "$comparer" small.pc2 other.pc2 -q --cyclic -o loops.json --html loops.html || exit 1
fi

"$node" browser_test.mjs "$browser" small large pair cyclic loops
