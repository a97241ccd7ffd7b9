#!/usr/bin/env bash
# Builds the manual (user manual, reference manual, examples) as pages that need no network, and checks it: a warning of
# doxygen, a dead link or a public entity without documentation is an error. Installs what is missing for that (Debian,
# Ubuntu).
#
#   scripts/make_manual.sh [FOLDER]    writes FOLDER/html/index.html; default: build/manual

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case "${1:-}" in
  -*) die "unknown option: $1" ;;
esac
folder="${1:-$root/build/manual}"

bash "$root/scripts/install_dependencies.sh" --doc
trap 'give_back "$folder"' EXIT

result=0
python3 -B "$root/doc/manual/make_manual.py" --output "$folder" --warnings-are-errors || result=1
python3 -B "$root/doc/manual/check_links.py" "$folder/html" || result=1
python3 -B "$root/doc/manual/check_entities.py" --work "$folder/entities" || result=1
exit $result
