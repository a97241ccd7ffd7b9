#!/usr/bin/env bash
# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# The manual builds without warnings, none of its links is dead, every public entity is documented and in a group; and the
# checks that say so find what is wrong: each of them is given a copy with a fault. A browser draws its formulas, without a
# network.
# Skipped (77) without doxygen, python3 or MathJax (Debian: libjs-mathjax).

set -u
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
if ! command -v doxygen > /dev/null || ! command -v python3 > /dev/null; then
  echo "skipped: needs doxygen and python3"
  exit 77
fi
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
export PYTHONDONTWRITEBYTECODE=1
tools="$root/doc/manual"
failed=0
checks=0

# make <source> <output>: the manual of a checkout
make() { python3 "$tools/make_manual.py" --source "$1" --output "$2" --warnings-are-errors; }

# check <what> <expected exit code> <expected text> <command...>
check() {
  local what="$1" expected="$2" text="$3" result
  shift 3
  checks=$((checks + 1))
  "$@" > "$folder/log" 2>&1
  result=$?
  if [[ $result -ne $expected ]] || ! grep -qF -- "$text" "$folder/log"; then
    echo "FAILED: $what: exit code $result, expected $expected and the text: $text"
    tail -n 20 "$folder/log"
    failed=$((failed + 1))
  fi
}

if ! make "$root" "$folder/manual" > "$folder/log" 2>&1 && grep -q "MathJax 2 is not here" "$folder/log"; then
  echo "skipped: needs MathJax (Debian: libjs-mathjax)"
  exit 77
fi
check "the manual has warnings" 0 ": 0 warnings" make "$root" "$folder/manual"
check "links" 0 ", dead: 0;" python3 "$tools/check_links.py" "$folder/manual/html"
check "entities" 0 "public entities: " python3 "$tools/check_entities.py" --work "$folder/entities"
cat "$folder/log"

# ---------------------------------------------------------------------------------------------------------- in a browser

# rendered <page>: the page as a browser shows it, in $folder/page.html
rendered() {
  timeout 120 "$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$folder/browser" \
    --host-resolver-rules="MAP * ~NOTFOUND" --virtual-time-budget=20000 --dump-dom "file://$1" \
    > "$folder/page.html" 2> /dev/null
}

# count <pattern>: of what is in that page
count() { grep -oE -- "$1" "$folder/page.html" | wc -l; }

browser="$(command -v chromium || command -v chromium-browser || command -v google-chrome)"
if [[ -n "$browser" ]]; then
  for page in index.html group__PkgAnimatedMeshFeaturesCurvatureMeasures.html; do
    checks=$((checks + 1))
    rendered "$folder/manual/html/$page"
    # MathJax keeps the source of each formula in a script
    formulas=$(count '<script type="math/tex[^>]*>')
    if [[ $formulas -lt 5 || $(count 'class="MathJax_SVG"') -ne $formulas ||
          $(count 'class="(noError|merror|MathJax_Error)') -ne 0 || $(count 'id="amf-query"') -ne 1 ]]; then
      echo "FAILED: $page in a browser: of $formulas formulas $(count 'class="MathJax_SVG"') were drawn"
      failed=$((failed + 1))
    fi
  done
  # without what draws them
  checks=$((checks + 1))
  mv "$folder/manual/html/mathjax" "$folder/mathjax"
  rendered "$folder/manual/html/$page"
  if [[ $(count 'class="MathJax_SVG"') -ne 0 ]]; then
    echo "FAILED: formulas are drawn without MathJax"
    failed=$((failed + 1))
  fi
  mv "$folder/mathjax" "$folder/manual/html/mathjax"
else
  echo "left out: formulas in a browser, without Chromium"
fi

# ------------------------------------------------------------------------------------------------------ faults in links

# fault_in_page <what> <text that is added to a page> <expected text>
fault_in_page() {
  rm -rf "$folder/copy"
  cp -r "$folder/manual/html" "$folder/copy"
  echo "$2" >> "$folder/copy/citelist.html"
  check "$1" 1 "$3" python3 "$tools/check_links.py" "$folder/copy"
}

fault_in_page "a page that is not there" '<a href="no_page.html">x</a>' "no_page.html: there is no such file"
fault_in_page "an anchor that is not there" '<a href="index.html#no_anchor">x</a>' "index.html#no_anchor: there is no such anchor"
fault_in_page "an anchor of the page itself" '<a href="#no_anchor">x</a>' "#no_anchor: there is no such anchor"
fault_in_page "a picture that is not there" '<img src="no_picture.png"/>' "no_picture.png: there is no such file"
fault_in_page "a script from elsewhere" '<script src="https://example.org/a.js"></script>' \
  "loads https://example.org/a.js from elsewhere"
rm -rf "$folder/copy"
cp -r "$folder/manual/html" "$folder/copy"
rm "$folder/copy/classMeshAnimation.html"
check "a page that was deleted" 1 "classMeshAnimation.html: there is no such file" \
  python3 "$tools/check_links.py" "$folder/copy"
mkdir "$folder/empty"
check "no pages" 1 "there are no pages" python3 "$tools/check_links.py" "$folder/empty"

# --------------------------------------------------------------------------------------------- faults in documentation

# fault_in_sources <what> <text of a header> <check: make or entities> <expected text>
fault_in_sources() {
  rm -rf "$folder/checkout"
  mkdir "$folder/checkout"
  cp -r "$root/doc" "$root/include" "$root/examples" "$root/CMakeLists.txt" "$folder/checkout"
  printf 'namespace CGAL {\nnamespace Animated_mesh_features {\n%s\n}\n}\n' "$2" \
    > "$folder/checkout/include/CGAL/Animated_mesh_features/Faulty.h"
  if [[ $3 == make ]]; then
    check "$1" 1 "$4" make "$folder/checkout" "$folder/faulty"
  else
    check "$1" 1 "$4" python3 "$tools/check_entities.py" --source "$folder/checkout" --work "$folder/entities"
  fi
}

group='\ingroup PkgAnimatedMeshFeaturesRef'
fault_in_sources "a function that is not documented" 'void faulty(int x);' entities \
  "function CGAL::Animated_mesh_features::faulty(int x): not documented"
fault_in_sources "a member that is not documented" "/*! $group
A class. */
struct Faulty { int member; };" entities "variable CGAL::Animated_mesh_features::Faulty::member: not documented"
fault_in_sources "an enumerator that is not documented" "/*! $group
An enumeration. */
enum class Faulty { VALUE };" entities "enumerator CGAL::Animated_mesh_features::Faulty::VALUE: not documented"
fault_in_sources "a function with nothing but a parameter" "/*! $group
\\param x a number. */
void faulty(int x);" entities "function CGAL::Animated_mesh_features::faulty(int x): not documented"
fault_in_sources "a class in no group" '/// A class.
class Faulty {};' entities "class CGAL::Animated_mesh_features::Faulty: in no group"
fault_in_sources "a reference to nothing" "/*! $group
A class; see \\ref nothing_at_all. */
class Faulty {};" make "unable to resolve reference to 'nothing_at_all'"
fault_in_sources "a parameter that is not there" "/*! $group
does something.
\\param y a number. */
void faulty(int x);" make "argument 'y' of command @param is not found"

# What is internal need not be documented.
fault_in_sources "internal entities" "namespace internal { void faulty(int x); }
void also_faulty(int x);" entities "function CGAL::Animated_mesh_features::also_faulty(int x): not documented"
checks=$((checks + 1))
if grep -q "internal::faulty" "$folder/log"; then
  echo "FAILED: something internal is asked for"
  failed=$((failed + 1))
fi

echo "$checks checks, $failed failed"
[[ $checks -gt 15 && $failed -eq 0 ]]
