# shellcheck shell=bash
# Shared by the scripts of this folder; to be sourced by bash, not run. Sets `root`, the checkout's top folder.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)"

say() { printf '\n== %s\n' "$*"; }

die()
{
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

as_root()
{
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo > /dev/null; then
    sudo "$@"
  else
    echo "neither root nor sudo: please install by hand: $missing" >&2
    return 1
  fi
}

# apt-get waits by itself for the lock of dpkg, but not for the one of the package lists.
apt_get_update()
{
  local tries=0
  until as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C apt-get -qq -o DPkg::Lock::Timeout=600 update; do
    tries=$((tries + 1))
    [ $tries -lt 12 ] || return 1
    sleep 10
  done
}

apt_get_install()
{
  # shellcheck disable=SC2086
  as_root env DEBIAN_FRONTEND=noninteractive LC_ALL=C \
    apt-get -qq -y -o DPkg::Lock::Timeout=600 -o Dpkg::Use-Pty=0 install --no-install-recommends $missing < /dev/null
}

installed() { dpkg-query -W -f '${db:Status-Status}\n' "$1" 2> /dev/null | grep -qx installed; }

# install_packages PACKAGE...: those of these Debian packages that are missing. Asks the package lists first, and brings
# them up to date only if what they name cannot be had. Elsewhere than on Debian and Ubuntu it does nothing: CMake will
# tell what it misses.
install_packages()
{
  local package
  missing=""
  if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
    return 0
  fi
  for package in "$@"; do
    installed "$package" || missing="$missing $package"
  done
  [ -n "$missing" ] || return 0
  say "Installing:$missing"
  apt_get_install > /dev/null 2>&1 && return 0
  apt_get_update && apt_get_install
}

# The number of compilers to run beside each other: one takes up to 2.5 GB for a program with CGAL's headers.
job_count()
{
  local cores memory
  cores=$(nproc 2> /dev/null || echo 1)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 2500000) }' /proc/meminfo 2> /dev/null)
  memory=${memory:-$cores}
  [ "$memory" -ge 1 ] || memory=1
  echo $((cores < memory ? cores : memory))
}

# configure FOLDER OPTION...: CMake, in a folder that may have been left there by an earlier run.
configure()
{
  local folder="$1"
  local generator=()
  shift
  # a checkout that was moved or copied together with its build folder
  if [ -f "$folder/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    rm -rf "$folder"
  fi
  if [ ! -f "$folder/CMakeCache.txt" ] && command -v ninja > /dev/null; then
    generator=(-G Ninja)
  fi
  mkdir -p "$folder"
  if ! cmake -S "$root" -B "$folder" "${generator[@]}" "$@" > "$folder/configure.log" 2>&1; then
    cat "$folder/configure.log" >&2
    return 1
  fi
}

# build FOLDER [all]: stops at the first error, or goes on with all that can be built nevertheless.
build()
{
  local options=()
  if [ "${2:-}" = all ]; then
    options=(-- -k)
    if [ -f "$1/build.ninja" ]; then options+=(0); fi
  fi
  cmake --build "$1" --parallel "$(job_count)" "${options[@]}"
}

# If the whole script was run by sudo: what it wrote belongs to the user, who is going to run it without next time.
give_back()
{
  if [ "$(id -u)" -eq 0 ] && [ -n "${SUDO_UID:-}" ] && [ -n "${SUDO_GID:-}" ]; then
    local path
    for path in "$@"; do
      if [ -e "$path" ]; then chown -R "$SUDO_UID:$SUDO_GID" "$path"; fi
    done
  fi
}
