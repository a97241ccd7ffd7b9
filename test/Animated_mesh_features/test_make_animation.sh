#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The command line of make_animation: what it writes, and how it fails.
# MAKE_ANIMATION is the program; without it the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs make_animation
enter_empty_folder
program="$generator"

# tells <part of the standard output> <arguments...>
tells() {
  local message="$1"
  shift
  expect 0 "" "$@"
  grep -qF -- "$message" out || fail "$*: no \"$message\" but: $(head -c 300 out)"
}

# A 32-bit little-endian integer, or a float as its bits, from place $2 of file $1.
word() { od -An -v -t x1 -j "$2" -N 4 "$1" | awk '{ print $4 $3 $2 $1 }'; }

# check_files <base> <frames>
check_files() {
  local vertices size expected
  vertices="$(grep -c '^v ' "$1.obj")"
  [[ "$(head -c 11 "$1.pc2")" == POINTCACHE2 ]] || fail "$1.pc2: no signature"
  [[ "$(word "$1.pc2" 12)" == 00000001 ]] || fail "$1.pc2: version"
  [[ "$((16#$(word "$1.pc2" 16)))" -eq $vertices ]] || fail "$1.pc2: number of points"
  [[ "$(word "$1.pc2" 20)" == 00000000 ]] || fail "$1.pc2: first frame is not 0"
  [[ "$(word "$1.pc2" 24)" == 3f800000 ]] || fail "$1.pc2: sample rate is not 1"
  [[ "$((16#$(word "$1.pc2" 28)))" -eq $2 ]] || fail "$1.pc2: number of frames is not $2"
  size="$(wc -c <"$1.pc2")"
  expected=$((32 + 12 * vertices * $2))
  [[ $size -eq $expected ]] || fail "$1.pc2: $size bytes, not $expected"
}

tells "48 frames, 30 in a second" figure --vertices 2000 -o figure
check_files figure 48
tells "48 frames" figure --vertices 2000 -o again --events events.json
cmp -s figure.obj again.obj && cmp -s figure.pc2 again.pc2 || fail "a second run writes something else"

for word in '"animated-mesh-features-rig-events"' '"left shin"' '"frames":48' '"angle_deg"'; do
  grep -qF -- "$word" events.json || fail "--events: no $word"
done

tells "60 frames" cylinder -o cylinder
check_files cylinder 60
[[ "$(grep -c '^v ' cylinder.obj)" -eq 4394 ]] || fail "the cylinder has another default number of vertices"
# Twice the frames in the same time: every other one as before.
tells "120 frames, 60 in a second" cylinder --fps 60 -o faster
check_files faster 120
frame=$((12 * 4394))
cmp -s <(tail -c +33 cylinder.pc2 | tail -c +$((15 * frame + 1)) | head -c $frame) \
  <(tail -c +33 faster.pc2 | tail -c +$((30 * frame + 1)) | head -c $frame) || fail "another motion at 60 frames a second"
tells "7 frames" cylinder --frames 7 --vertices 500 --output short
check_files short 7
tells "Exit codes" --help

expect 2 "say what to make"
expect 2 "dog" dog -o x
expect 2 "-o BASE" figure
expect 2 "--events" cylinder -o x --events x.json
expect 2 "same file" figure -o x --vertices 1000 --events x.obj
expect 2 "--vertices" figure -o x --vertices -5
expect 2 "1000" figure -o x --vertices 999
expect 2 "--frames" cylinder -o x --frames 0
expect 2 "--fps" cylinder -o x --fps nan
expect 2 "--fps" cylinder -o x --fps -30
expect 2 "million" cylinder -o x --fps 1e9
expect 2 "--frame" cylinder -o x --frame 5
expect 2 "positional" cylinder figure -o x
[[ ! -e x.obj && ! -e x.pc2 ]] || fail "files after a bad command line"

expect 4 "cannot write" cylinder --vertices 500 -o nowhere/x
# The second file cannot be written: the first one is left as it was.
echo old >half.obj
mkdir half.pc2
expect 4 "half.pc2" cylinder --vertices 500 -o half
[[ "$(cat half.obj)" == old ]] || fail "half an animation was written"
[[ -z "$(find . -name '*.tmp')" ]] || fail "temporary files are left"
mkdir half.json
rm -r half.pc2
expect 4 "half.json" figure --vertices 1000 -o half --events half.json
[[ "$(cat half.obj)" == old && ! -e half.pc2 ]] || fail "an animation without its events was written"
ln -s same.obj same.pc2
expect 2 "same file" cylinder --vertices 500 -o same

[[ $failed -eq 0 ]] && echo "make_animation: all as expected"
exit $failed
