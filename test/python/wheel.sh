#!/usr/bin/env bash
# What pip does: makes a source package, of that a wheel, installs it into a virtual environment, all without a network, and
# runs the tests there; or tells why it cannot (exit code 77). Works in the current folder; takes as long as a build. For
# CTest and scripts/python.sh, which set PYTHON and what run.sh is told.
set -eu
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)"
here="$PWD"
if [ -z "${PYTHON:-}" ]; then
  echo "no Python module: ${WHY_NOT:-it was not built}"
  exit 77
fi
for module in scikit_build_core.build pybind11 venv pip pytest; do
  if ! "$PYTHON" -c "import $module" 2> /dev/null; then
    echo "no wheel is made: $PYTHON has no ${module%%.*}"
    exit 77
  fi
done
rm -rf "$here/dist" "$here/venv"
(cd "$root" && "$PYTHON" -c 'import sys, scikit_build_core.build as b; b.build_sdist(sys.argv[1])' "$here/dist")
"$PYTHON" -m pip wheel --quiet --no-build-isolation --no-deps --no-index --wheel-dir "$here/dist" "$here"/dist/*.tar.gz
"$PYTHON" -m venv --system-site-packages "$here/venv"
unset PYTHONPATH
"$here/venv/bin/python" -m pip install --quiet --no-deps --no-index "$here"/dist/*.whl
ls -l "$here/dist"
"$here/venv/bin/python" -c 'import animated_mesh_features as amf; print(amf.__version__, "in", amf.__file__)'
INSTALLED="$here/venv" PYTHON="$here/venv/bin/python" exec bash "$root/test/python/run.sh"
