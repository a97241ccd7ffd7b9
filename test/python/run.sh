#!/usr/bin/env bash
# Runs the tests of the Python module, or tells why they cannot run here (exit code 77). For CTest, which sets PYTHON,
# PYTHONPATH, the programs and, if there is no module, WHY_NOT.
set -u
if [ -z "${PYTHON:-}" ]; then
  echo "no Python module: ${WHY_NOT:-it was not built}"
  exit 77
fi
if ! "$PYTHON" -c 'import pytest' 2> /dev/null; then
  echo "pytest is not here (Debian: python3-pytest)"
  exit 77
fi
export MPLBACKEND=Agg PYTHONDONTWRITEBYTECODE=1
exec "$PYTHON" -m pytest -q -ra -p no:cacheprovider "$(dirname "${BASH_SOURCE[0]}")" "$@"
