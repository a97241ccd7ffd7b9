#!/usr/bin/env bash
# Installs what is missing for building the package on Debian (12 or newer) or Ubuntu (24.04 or newer).
#
#   scripts/install_dependencies.sh           compiler, CMake, CGAL, Eigen, Boost, oneTBB, zlib, cairo with a font,
#                                             nlohmann-json; tinygltf and, for the page of --html, Node.js, if they can
#                                             be had
#   scripts/install_dependencies.sh --tests   also what only the tests need
#   scripts/install_dependencies.sh --doc     what the manual is made with, and nothing else

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

packages=(g++ make cmake libcgal-dev libeigen3-dev libboost-dev libboost-program-options-dev libtbb-dev
  zlib1g-dev nlohmann-json3-dev libcairo2-dev fonts-dejavu-core)
# Without this glTF is not read; it is small. What reads other formats (libassimp-dev, libhdf5-dev) brings along a lot, and
# is for whoever needs it.
optional=(libtinygltf-dev)
# For the viewer, while building; it may be there from elsewhere, and then Debian's would get in its way.
command -v npm > /dev/null || optional+=(nodejs npm)
# Without what is optional below a part of the tests is left out, too.
case "${1:-}" in
  "") ;;
  --doc)
    packages=(doxygen libjs-mathjax python3)
    optional=()
    ;;
  --tests)
    packages+=(ninja-build python3)
    optional+=(ccache libopenmesh-dev clang python3-vtk9 libassimp-dev libhdf5-dev assimp-testmodels curl doxygen
      libjs-mathjax python3-dev python3-numpy python3-scipy python3-pytest python3-mypy pybind11-dev
      python3-matplotlib python3-h5py python3-nbclient python3-ipykernel)
    command -v chromium > /dev/null || optional+=(chromium)
    ;;
  *) die "unknown option: $1" ;;
esac

install_packages "${packages[@]}" || die "the packages above could not be installed"
for package in "${optional[@]}"; do
  install_packages "$package" || echo "going on without $package"
done

# clang's runtime for sanitizers is a package named after the version of clang
if [ "${1:-}" = --tests ] && command -v clang++ > /dev/null; then
  version=$(clang++ -dumpversion | cut -d. -f1)
  install_packages "libclang-rt-$version-dev" || echo "going on without libclang-rt-$version-dev"
fi
