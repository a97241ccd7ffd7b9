#!/usr/bin/env bash
# Fetches two animated hands, a right and a left one, from the npm package networked-aframe 0.14.3, where they are
# examples/assets/rightHandHigh.glb and leftHandHigh.glb:
#
#   scripts/fetch_hands.sh FOLDER
#
# FOLDER then has rightHandHigh.glb, leftHandHigh.glb and the package's LICENSE (MIT, (c) 2017 Hayden Lee). The files carry
# their own author's notice: "Copyright (c) Unboring SLU 2020. All rights reserved." They are used here, never passed on.
#
# Nothing is fetched if they are there already. Exit code 77: they cannot be had.

set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 1 ] || die "usage: fetch_hands.sh FOLDER"
name=networked-aframe
version=0.14.3
archive_sum=e2c5bb3be92556c10aa8951bbd536aac085e1c82dc760990cecfdc0bffd75605
mkdir -p "$1" && cd "$1" || exit 1

complete()
{
  sha256sum --check --status << 'END' 2> /dev/null
279aefb07d677d4a999c4ceb1e7a8a0fa3630ccd35e9bbe7f7e0937c9bf12856  rightHandHigh.glb
34fc636bb6525136ff37c1158ee28eb7af65a4cf376ee7fe670ae22b44d03990  leftHandHigh.glb
END
}

right_archive() { echo "$archive_sum  $1" | sha256sum --check --status 2> /dev/null; }

fetch()
{
  local url="https://registry.npmjs.org/$name/-/$name-$version.tgz"
  if command -v curl > /dev/null && curl -fsSL --connect-timeout 20 --max-time 300 -o "$1/hands.tgz" "$url" &&
     right_archive "$1/hands.tgz"; then
    return 0
  fi
  # where the registry is another one, npm knows
  command -v npm > /dev/null &&
    (cd "$1" && npm pack --silent --fetch-timeout=60000 --fetch-retries=1 "$name@$version" > /dev/null 2>&1) &&
    mv "$1/$name-$version.tgz" "$1/hands.tgz" && right_archive "$1/hands.tgz"
}

complete && exit 0
# several may fetch at the same time: what is complete is moved here at once
temporary="$(mktemp -d ./.fetch.XXXXXX)" || exit 1
trap 'rm -rf "$temporary"' EXIT
if ! fetch "$temporary" 2> /dev/null; then
  echo "$name $version cannot be had from the npm registry, neither by curl nor by npm"
  exit 77
fi
tar -xzf "$temporary/hands.tgz" -C "$temporary" package/LICENSE package/examples/assets/rightHandHigh.glb \
  package/examples/assets/leftHandHigh.glb &&
  mv -f "$temporary"/package/LICENSE "$temporary"/package/examples/assets/*.glb .
complete || die "the files in the package are not the expected ones"
