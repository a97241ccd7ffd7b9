#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# detect_features --plot: what can be read off the plot is what the features are.
# DETECT_FEATURES and MAKE_ANIMATION are the programs; without them, or without python3, the test is skipped (77).

source "$(dirname "${BASH_SOURCE[0]}")/shell_test.bash"
needs detect_features make_animation python3
enter_empty_folder

"$generator" figure --vertices 1000 --fps 10 -o 'a <b> & "c"' >/dev/null || exit 1
# all, one, none; and names that XML must quote
for threshold in 0 1 "0 --absolute-threshold 1e6"; do
  # shellcheck disable=SC2086
  "$program" 'a <b> & "c".obj' 'a <b> & "c".pc2' --quiet --threshold $threshold -o features.json --plot plot.svg &&
    python3 "$tests/scene_files/check_plot.py" plot.svg features.json || exit 1
done
