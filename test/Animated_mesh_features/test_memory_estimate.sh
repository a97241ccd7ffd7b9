#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The memory that detect_features announces against what it takes at last: never less, and not more than about twice as
# much, for few and many vertices and frames, with both presets, and where a mesh has a part that is far denser than the
# rest. DETECT_FEATURES and MAKE_ANIMATION are the programs; without them the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation awk
[[ "$(uname)" == Linux ]] || skip "peaks of memory are known on Linux"
enter_empty_folder

announced() { sed -nE 's/^memory: about ([0-9]+)M.*/\1/p' err; }
peak() { sed -nE 's/^total .* ([0-9]+) MB$/\1/p' err; }

# check_memory <what> <arguments...>
check_memory() {
  local what="$1" a p
  shift
  expect 0 "memory: about" "$@" --threads 2 --verbose -o x.json
  a="$(announced)" p="$(peak)"
  echo "$what: announced $a MB, taken $p MB"
  [[ -n "$a" && -n "$p" ]] || { fail "$what: no memory is told: $(cat err)"; return; }
  ((p <= a)) || fail "$what: takes $p MB, but $a MB were announced"
  ((10 * a <= 24 * p)) || fail "$what: takes $p MB, far less than the announced $a MB"
}

# vertices, frames a second for 2 s
while read -r vertices fps; do
  "$generator" cylinder --vertices "$vertices" --fps "$fps" -o a >/dev/null || fail "make_animation"
  if [[ $vertices == 300 && $fps == 10 ]]; then
    expect 0 "" a.obj a.pc2 --verbose -o x.json
    (($(peak) < 40)) || skip "the program itself takes $(peak) MB, as with a sanitizer"
  fi
  check_memory "$vertices vertices, $((2 * fps)) frames" a.obj a.pc2 --fps "$fps"
  check_memory "$vertices vertices, $((2 * fps)) frames, published" a.obj a.pc2 --fps "$fps" --preset published \
    --space-counts 16
done <<END
300 10
300 150
300 480
300 1500
6000 15
6000 60
20000 5
END

# A small tube of 6,000 vertices beside a large one of 500, which becomes wider from frame to frame.
for frame in 1 2 3 4 5 6; do
  awk -v frame=$frame '
    function tube(around, rings, h, z, i, j, radius, angle) {
      radius = h * around / 6.283185307 * (1 + 0.05 * frame)
      for (i = 0; i < rings; ++i)
        for (j = 0; j < around; ++j) {
          angle = j * 6.283185307 / around
          print "v", radius * cos(angle), radius * sin(angle), z + 0.9 * h * i
        }
      for (i = 0; i + 1 < rings; ++i)
        for (j = 0; j < around; ++j) {
          p = first + i * around + j; q = first + i * around + (j + 1) % around
          print "f", p, q, q + around; print "f", p, q + around, p + around
        }
      first += around * rings
    }
    BEGIN { first = 1; tube(25, 20, 200, 0); tube(60, 100, 1, 6000) }' >"f$frame.obj"
done
check_memory "a part that is far denser" f*.obj --fps 10
grep -q "balls: radius .*1,500 vertices" err || fail "no note of a ball radius that is bounded: $(cat err)"

[[ $failed -eq 0 ]] && echo "$checks runs passed"
exit "$failed"
