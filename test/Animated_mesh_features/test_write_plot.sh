#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# detect_features --plot: what can be read off the plot is what the features are, in every format.
# DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without python3, the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation python3
enter_empty_folder

# what XML and PDF must quote
title='a <b> & "c" \d( '
"$generator" figure --vertices 1000 --fps 10 -o "$title" >/dev/null || exit 1
input=("$title.obj" "$title.pc2" --quiet)

"$program" "${input[@]}" --plot x.svg 2>err
if grep -q "built without pictures" err; then
  [[ ! -e x.svg ]] || fail "a plot in spite of an error"
  echo "skipped: the program was built without pictures"
  exit $((failed ? 1 : 77))
fi

# plots <thresholds...>: plot.svg, plot.pdf, plot.png and features.json
plots() {
  local format
  for format in svg pdf png; do
    "$program" "${input[@]}" "$@" -o features.json --write-field deformation:d.npy --plot "plot.$format" || exit 1
  done
}

plots --threshold 0
python3 "$tests/scene_files/check_plot.py" plot.svg plot.pdf features.json "$title" d.npy plot.png || exit 1
# the same files again; the standard output has no ending
for format in svg pdf png; do cp "plot.$format" "first.$format"; done
plots --threshold 0 --threads 1
for format in svg pdf png; do cmp "first.$format" "plot.$format" || fail "another $format of the same features"; done
"$program" "${input[@]}" --threshold 0 --plot - | cmp - plot.svg || fail "--plot - is not the plot"
"$program" "${input[@]}" --threshold 0 --plot again.SVG && cmp again.SVG plot.svg || fail "an ending in capitals"

# one, none
for thresholds in "--relative-threshold 1" "--threshold 1e6"; do
  # shellcheck disable=SC2086
  plots $thresholds
  python3 "$tests/scene_files/check_plot.py" plot.svg plot.pdf features.json "$title" d.npy || exit 1
done

# Endings that are none are noticed before anything is computed.
for file in plot plot.jpg plot.svg.gz; do
  expect 2 ".svg, .pdf, .png" "${input[@]}" --plot "$file"
  [[ ! -e "$file" ]] || fail "$file in spite of an error"
done

# A machine without fonts, and a name that is not UTF-8.
cat >fonts.conf <<'XML'
<?xml version="1.0"?>
<!DOCTYPE fontconfig SYSTEM "fonts.dtd">
<fontconfig><dir>nowhere</dir><cachedir>cache</cachedir></fontconfig>
XML
name=$'\xff\x01'
if cp "$title.obj" "$name.obj" 2>/dev/null; then
  for format in svg pdf png; do
    FONTCONFIG_FILE="$PWD/fonts.conf" expect 0 "" "$name.obj" "$title.pc2" --quiet --plot "bare.$format"
    [[ -s "bare.$format" ]] || fail "no $format without fonts"
  done
fi

exit $failed
