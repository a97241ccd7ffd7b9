# shellcheck shell=bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# Shared by the tests of the programs, which are given to them as DETECT_FEATURES, MAKE_ANIMATION, EVALUATE_FEATURES and
# SIMPLIFY_ANIMATION, COMPARE_ANIMATIONS; to be sourced. Sets `tests`, this folder, `program`, `generator`, `evaluator`,
# `simplifier` and `comparer`, the
# programs or nothing, and `failed`, the exit code to end with.

set -u
tests="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
program="${DETECT_FEATURES:-}"
generator="${MAKE_ANIMATION:-}"
evaluator="${EVALUATE_FEATURES:-}"
simplifier="${SIMPLIFY_ANIMATION:-}"
comparer="${COMPARE_ANIMATIONS:-}"
failed=0
checks=0
export PYTHONDONTWRITEBYTECODE=1

skip() {
  echo "skipped: $*"
  exit 77
}

fail() {
  echo "failed: $*"
  failed=1
}

# needs <what>...: skips the test without. The programs have their own names, all else are
# commands.
needs() {
  local what missing=""
  for what in "$@"; do
    case "$what" in
      detect_features) [[ -n "$program" ]] || missing+=" DETECT_FEATURES" ;;
      evaluate_features) [[ -n "$evaluator" ]] || missing+=" EVALUATE_FEATURES" ;;
      simplify_animation) [[ -n "$simplifier" ]] || missing+=" SIMPLIFY_ANIMATION" ;;
      compare_animations) [[ -n "$comparer" ]] || missing+=" COMPARE_ANIMATIONS" ;;
      make_animation) [[ -n "$generator" ]] || missing+=" MAKE_ANIMATION" ;;
      *) command -v "$what" >/dev/null || missing+=" $what" ;;
    esac
  done
  [[ -z "$missing" ]] || skip "needs$missing"
}

# Goes to an empty folder, which is there as long as the test runs. Sets `folder`.
enter_empty_folder() {
  folder="$(mktemp -d)"
  trap 'rm -rf "$folder"' EXIT
  cd "$folder" || exit 1
}

# expect <exit code> <part of the messages> <arguments...>: runs `program`, leaves the two outputs in the files out and err.
expect() {
  local code="$1" message="$2"
  shift 2
  checks=$((checks + 1))
  "$program" "$@" >out 2>err </dev/null
  local got=$?
  [[ $got -eq $code ]] || fail "$*: exit code $got, not $code: $(head -c 300 err)"
  [[ -z "$message" ]] || grep -qF -- "$message" err || fail "$*: no message \"$message\" but: $(head -c 300 err)"
}
