#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The viewer's page: its sources give the one that viewer/viewer.sha256 tells, a ready-made one is taken only if it is that
# one, and whatever is missing, nothing breaks. Skipped (77) without cmake, Node.js and npm, or without a network.
# DETECT_FEATURES, if set, has that page in it.

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
viewer="$(cd "$tests/../../viewer" && pwd)"
script="$viewer/../cmake/make_viewer_page.cmake"
cmake="$(command -v cmake)"
node="$(command -v node || command -v nodejs)"
npm="$(command -v npm)"
[[ -n "$node" ]] || skip "needs Node.js"
needs cmake npm
enter_empty_folder

# make <work folder> <arguments...>: runs the script; it never fails
make() {
  local work="$folder/$1"
  shift
  "$cmake" "-DWORK_DIR=$work" "$@" -P "$script" >"$folder/out" 2>&1
  check "exit code of $*: $(cat "$folder/out")" [ $? -eq 0 ]
  check "a source file for $*" [ -s "$work/viewer_page.cpp" ]
}
check() {
  local what="$1"
  shift
  checks=$((checks + 1))
  "$@" || fail "$what"
}
sum() { sha256sum "$1" | cut -d' ' -f1; }
has_page() { [ -f "$folder/$1/viewer.html" ] && [ "$(sum "$folder/$1/viewer.html")" = "$recorded" ]; }
has_none() { [ ! -e "$folder/$1/viewer.html" ] && grep -q 'viewer_page_size = 0;' "$folder/$1/viewer_page.cpp"; }
says() { grep -qF -- "$2" "$folder/$1/viewer_page.cpp" || { sed -n '/missing = /p' "$folder/$1/viewer_page.cpp"; false; }; }

recorded=$(sed -n 's/  viewer.html$//p' "$viewer/viewer.sha256")

# ----------------------------------------------------------------------------------------------- made from the sources
make built "-DSOURCE_DIR=$viewer" "-DNODE=$node" "-DNPM=$npm"
if [[ ! -e "$folder/built/viewer.html" ]] && grep -qE 'ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ETIMEDOUT|ENETUNREACH' "$folder/built/log.txt"; then
  skip "npm finds no network"
fi
check "the sources give the page of viewer.sha256, $recorded, not $(sum "$folder/built/viewer.html"): build the target viewer_checksum" has_page built
page="$folder/built/viewer.html"
check "size" grep -q "viewer_page_size = $(stat -c %s "$page");" "$folder/built/viewer_page.cpp"
check "three.js is there, with its licence" grep -q 'three.js authors' "$page"
check "nothing is loaded from anywhere" bash -c "! grep -qE '(src|href)=\"?https?:' '$page'"

# nothing new, nothing done: not even npm is called
printf '#!/bin/sh\ntouch "%s/called"\nexit 1\n' "$folder" >"$folder/npm"
chmod +x "$folder/npm"
cp -r "$folder/built" "$folder/again"
make again "-DSOURCE_DIR=$viewer" "-DNODE=$node" "-DNPM=$npm"
check "nothing is done when nothing is new" [ "$folder/again/viewer_page.cpp" -ot "$folder/out" -a ! -e "$folder/called" ]
check "the page is still there" has_page again

# ------------------------------------------------------------------------------------------------------- taken as it is
make bundle "-DSOURCE_DIR=$viewer" "-DBUNDLE=$page"
check "a ready-made page is taken" has_page bundle
check "it is the same in the program" cmp -s "$folder/built/viewer_page.cpp" "$folder/bundle/viewer_page.cpp"
sed 's/Animated mesh/Another mesh/' "$page" >"$folder/other.html"
make other "-DSOURCE_DIR=$viewer" "-DBUNDLE=$folder/other.html"
check "another page is not taken" has_none other
check "it says so" says other "has not the checksum"
make nowhere "-DSOURCE_DIR=$viewer" "-DBUNDLE=$folder/nowhere.html"
check "a page that is not there" says nowhere "is not there"

# as in a source package
cp -r "$viewer" "$folder/packaged"
rm -rf "$folder/packaged/node_modules" "$folder/packaged/dist"
mkdir "$folder/packaged/dist"
cp "$page" "$folder/packaged/dist/viewer.html"
make dist "-DSOURCE_DIR=$folder/packaged"
check "the packaged page is taken" has_page dist
make fallback "-DSOURCE_DIR=$folder/packaged" "-DNODE=$node" "-DNPM=$folder/npm"
check "npm was called" [ -e "$folder/called" ]
check "the packaged page is taken if npm fails" has_page fallback
echo "/* changed */" >>"$folder/packaged/src/style.css"
make stale "-DSOURCE_DIR=$folder/packaged"
check "a packaged page of other sources is not taken" has_none stale
check "it says so" says stale "is not of these sources"

# ------------------------------------------------------------------------------------------------------ nothing to be had
make nothing "-DSOURCE_DIR=$viewer"
check "neither Node.js nor a page" has_none nothing
check "it says so" says nothing "neither Node.js with npm nor a ready-made page"
make offline "-DSOURCE_DIR=$viewer" "-DNODE=$node" "-DNPM=$folder/npm"
check "npm fails" has_none offline
check "it says so" says offline "npm ci failed"

# -------------------------------------------------------------------------------------------------------- in the program
if [[ -n "$program" && -n "$generator" ]] && command -v python3 >/dev/null; then
  "$generator" figure --vertices 1000 --frames 12 -o a >/dev/null
  if "$program" a.obj a.pc2 -q --html a.html 2>err; then
    python3 - "$recorded" <<'PYTHON'
import hashlib, re, sys
html = open("a.html", encoding="utf-8", newline="").read()
page = re.sub(r'<script type="application/json" id="scene">.*?</script>\n(<script type="text/plain" id="scene-[^>]*>[^<]*</script>\n)+',
              "<!--scene-->", html, flags=re.S)
sys.exit(0 if hashlib.sha256(page.encode()).hexdigest() == sys.argv[1] else 1)
PYTHON
    check "the program has the page of viewer.sha256" [ $? -eq 0 ]
    "$program" a.obj a.pc2 -q --html b.html --html-every 2
    check "every second frame is smaller" [ "$(stat -c %s b.html)" -lt "$(stat -c %s a.html)" ]
  else
    check "no page but for a reason: $(cat err)" grep -q "built without the viewer" err
  fi
fi

echo "$checks checks"
exit $failed
