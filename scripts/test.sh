#!/usr/bin/env bash
# Builds and runs the tests, installing what is missing for that (Debian, Ubuntu).
#
#   scripts/test.sh           all stages
#   scripts/test.sh --quick   the first stage only
#   scripts/test.sh --stage N the N-th stage only
#
# A stage that cannot run here is skipped, and says why. Returns non-zero if anything failed.
#
# CGAL6_DIR, if set, is the folder of a CGALConfig.cmake of CGAL 6; otherwise Debian's package is fetched for stage 4.

set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

stages="1 2 3 4 5 6"
case "${1:-}" in
  "") ;;
  --quick) stages=1 ;;
  --stage) stages="${2:?--stage needs a number}" ;;
  *) die "unknown option: $1" ;;
esac

bash "$root/scripts/install_dependencies.sh" --tests || exit 1
cd "$root" || exit 1
trap 'give_back "$root/build"' EXIT

# build_and_run FOLDER CTEST_OPTION...
build_and_run()
{
  local result=0 folder="$1"
  shift
  build "$folder" all || result=1
  ctest --test-dir "$folder" --output-on-failure --parallel "$(job_count)" --no-tests=error "$@" || result=1
  return $result
}

# ---------------------------------------------------------------------------------------------------------- the stages
# Each returns 0, or 77 after `why` was set, if it could not run here; anything else is a failure.

stage_gcc()
{
  configure build/gcc -DCMAKE_CXX_COMPILER=g++ -DANIMATED_MESH_FEATURES_WERROR=ON \
    -DANIMATED_MESH_FEATURES_BUILD_PYTHON=AUTO || return 1
  grep 'Python module' build/gcc/configure.log
  build_and_run build/gcc
}

# find_compiler SANITIZERS: sets `compiler` to one that has them. clang++ first, because it takes two thirds of g++'s time
# for the same checks.
find_compiler()
{
  for compiler in clang++ g++; do
    if echo 'int main() {}' | "$compiler" "-fsanitize=$1" -x c++ -o build/sanitizer_probe - 2> /dev/null &&
       build/sanitizer_probe; then
      echo "compiler: $compiler"
      return 0
    fi
  done
  why="neither clang++ nor g++ has the libraries of these sanitizers here"
  return 77
}

stage_sanitizers()
{
  local compiler
  find_compiler address,undefined || return
  # CGAL's headers give g++ false alarms when it instruments them, thus no errors from its warnings.
  # The viewer runs in a browser, where no sanitizer sees it; its page was made in the first stage, and the manual, too. The
  # short examples call what the tests call, and so do the programs that use features.
  configure build/sanitizers -DCMAKE_CXX_COMPILER=$compiler \
    "-DANIMATED_MESH_FEATURES_VIEWER_BUNDLE=$([ ! -f build/gcc/viewer/viewer.html ] || echo "$root/build/gcc/viewer/viewer.html")" \
    -DANIMATED_MESH_FEATURES_SANITIZE=address,undefined -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF \
    -DANIMATED_MESH_FEATURES_WERROR="$([ $compiler = clang++ ] && echo ON || echo OFF)" &&
    build_and_run build/sanitizers --exclude-regex '^consumer_|^test_viewer_|^test_manual_|^test_(compare_animations|evaluate_features|simplify_animation)_'
}

# Only those tests that run anything in parallel.
stage_threads()
{
  local compiler tests
  mapfile -t tests < <(cd test/Animated_mesh_features && grep -lE 'Parallel_(if_available_)?tag|CGAL_LINKED_WITH_TBB' test_*.cpp | sed 's/[.]cpp$//')
  if [ ${#tests[@]} -eq 0 ]; then
    echo "no test runs in parallel" >&2
    return 1
  fi
  find_compiler thread || return
  configure build/threads -DCMAKE_CXX_COMPILER=$compiler -DANIMATED_MESH_FEATURES_SANITIZE=thread || return 1
  if ! grep -q 'Animated_mesh_features .*, oneTBB' build/threads/configure.log; then
    why="oneTBB is not here"
    return 77
  fi
  cmake --build build/threads --parallel "$(job_count)" --target "${tests[@]}" &&
    ctest --test-dir build/threads --output-on-failure --no-tests=error \
      --tests-regex "^($(IFS='|' && echo "${tests[*]}"))\$"
}

# With NDEBUG, as a user's release build has it, and each header on its own. The tests, which never have NDEBUG, were
# compiled by clang++ for the sanitizers.
stage_clang()
{
  if ! command -v clang++ > /dev/null; then
    why="clang++ is not here"
    return 77
  fi
  configure build/clang -DCMAKE_CXX_COMPILER=clang++ -DANIMATED_MESH_FEATURES_WERROR=ON \
    -DANIMATED_MESH_FEATURES_PRECOMPILE=OFF \
    -DANIMATED_MESH_FEATURES_CHECK_HEADERS=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON &&
    python3 scripts/compile_only.py build/clang "$(job_count)" --without '/test/Animated_mesh_features/test_' -DNDEBUG
}

# The repository is the one that this machine's apt has for Debian; the checksum is Debian's own.
fetch_cgal6()
{
  local file=libcgal-dev_6.0.1-1_amd64.deb
  local sum=462110b9e0779ff7a214bb4c1048c0dee475c1522a0ba293d9fd6c7600ace777
  local package="$root/build/cgal6/$file"
  local uri
  mkdir -p "$root/build/cgal6"
  if ! echo "$sum  $package" | sha256sum --check --status 2> /dev/null; then
    for uri in $(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' 2> /dev/null |
                 sort -u); do
      /usr/lib/apt/apt-helper -qq download-file "${uri%/}/pool/main/c/cgal/$file" "$package" "SHA256:$sum" \
        > /dev/null 2>&1 && break
    done
  fi
  echo "$sum  $package" | sha256sum --check --status 2> /dev/null || return 1
  rm -rf "$root/build/cgal6/unpacked"
  dpkg-deb -x "$package" "$root/build/cgal6/unpacked" || return 1
  CGAL6_DIR="$root/build/cgal6/unpacked/usr/lib/x86_64-linux-gnu/cmake/CGAL"
  [ -f "$CGAL6_DIR/CGALConfig.cmake" ]
}

stage_cgal6()
{
  local compiler=g++
  if [ -z "${CGAL6_DIR:-}" ]; then
    if grep -q 'Animated_mesh_features .* with CGAL 6' build/gcc/configure.log; then
      why="the installed CGAL, with which the other stages ran, is a CGAL 6"
      return 77
    fi
    if ! fetch_cgal6; then
      why="Debian's package of CGAL 6 cannot be had from this machine's package sources"
      return 77
    fi
  fi
  if command -v clang++ > /dev/null; then compiler=clang++; fi
  configure build/cgal6/build -DCMAKE_CXX_COMPILER=$compiler "-DCGAL_DIR=$CGAL6_DIR" \
    -DANIMATED_MESH_FEATURES_PRECOMPILE=OFF \
    -DANIMATED_MESH_FEATURES_WERROR=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON || return 1
  if ! grep -q 'Animated_mesh_features .* with CGAL 6' build/cgal6/build/configure.log; then
    echo "CMake did not take the CGAL 6 in $CGAL6_DIR" >&2
    return 1
  fi
  # What draws and writes uses of CGAL no more than what the rest does. What CGAL 6 calls deprecated is what CGAL 5.5 has.
  python3 scripts/compile_only.py build/cgal6/build "$(job_count)" \
    --without '/programs/(drawing|options|output|page|pictures|plots|rendering|running|scenes)/|/test_(picture|plot|io_)' \
    -DCGAL_NO_DEPRECATION_WARNINGS &&
    ctest --test-dir build/cgal6/build --output-on-failure --tests-regex '^consumer_find_package$' --no-tests=error
}

stage_fuzzing()
{
  if ! echo 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
       clang++ -fsanitize=fuzzer -x c++ -o build/fuzzer_probe - 2> /dev/null; then
    why="clang++ with libFuzzer is not here"
    return 77
  fi
  scripts/fuzz.sh 1
}

# --------------------------------------------------------------------------------------------------------- running them

passed=0
failed=0
skipped=0
summary=""

# stage NUMBER TITLE FUNCTION
stage()
{
  local title="$1, $2" result start=$SECONDS
  [[ " $stages " == *" $1 "* ]] || return
  shift 2
  say "Stage $title"
  why=""
  "$@" < /dev/null
  result=$?
  local minutes
  minutes="$(((SECONDS - start) / 60)):$(printf '%02d' $(((SECONDS - start) % 60)))"
  if [ $result -eq 0 ]; then
    passed=$((passed + 1))
    result="passed"
  elif [ $result -eq 77 ] && [ -n "$why" ]; then
    skipped=$((skipped + 1))
    result="SKIPPED: $why"
  else
    failed=$((failed + 1))
    result="FAILED"
  fi
  say "Stage $title: $result ($minutes min)"
  summary+="  $title: $result ($minutes min)"$'\n'
}

mkdir -p build
stage 1 "g++: build and run" stage_gcc
stage 2 "address and undefined-behaviour sanitizers: build and run" stage_sanitizers
stage 3 "clang++, NDEBUG, every header alone: compile" stage_clang
stage 4 "CGAL 6: compile" stage_cgal6
stage 5 "thread sanitizer: build and run what is parallel" stage_threads
stage 6 "fuzz targets: build and run for a minute each" stage_fuzzing

say "Summary"
printf '%s\n' "$summary"
echo "stages: $passed passed, $failed failed, $skipped skipped"
[ $failed -eq 0 ]
