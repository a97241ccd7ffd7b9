#!/usr/bin/env bash
# The Python module from a fresh checkout: installs what is missing (Debian, Ubuntu), builds it, runs its tests and an example.
#
#   scripts/python.sh             into build/python_module; for use from there: PYTHONPATH=build/python_module/python
#   scripts/python.sh --install   also installs it for all users, under /usr/local
#   scripts/python.sh --wheel     also makes a source package and a wheel, in build/python_module/dist, and tests the wheel in
#                                 a virtual environment, as pip install would; for this scikit-build-core must be here,
#                                 which Debian 12 does not have

set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

more="${1:-}"
case "$more" in
  "" | --install | --wheel) ;;
  *) die "unknown option: $1" ;;
esac

bash "$root/scripts/install_dependencies.sh"
install_packages python3-dev python3-numpy pybind11-dev python3-pytest || die "the packages above could not be installed"
for package in python3-matplotlib python3-scipy python3-h5py; do
  install_packages "$package" || echo "going on without $package: a part of the tests and of the gallery is left out"
done
if [ "$more" = --wheel ]; then
  install_packages python3-venv python3-pip python3-pybind11 || die "the packages above could not be installed"
fi

cd "$root"
trap 'give_back "$root/build"' EXIT
folder="$root/build/python_module"

say "Building; this takes a few minutes the first time"
started=$SECONDS
configure "$folder" -DCMAKE_BUILD_TYPE=Release -DANIMATED_MESH_FEATURES_BUILD_PYTHON=ON \
  -DANIMATED_MESH_FEATURES_BUILD_TESTS=OFF -DANIMATED_MESH_FEATURES_BUILD_EXAMPLES=OFF
grep 'the Python module' "$folder/configure.log"
build "$folder"
python=$(sed -n 's/.*the Python module is built for //p' "$folder/configure.log")
echo "built in $((SECONDS - started)) s"

say "Testing"
programs="$folder/examples/Animated_mesh_features/programs"
export PYTHON="$python" GALLERY="$root/python/gallery" BUILD_FOLDER="$folder" \
  DETECT_FEATURES="$programs/detect_features" MAKE_ANIMATION="$programs/make_animation" \
  COMPARE_ANIMATIONS="$programs/compare_animations" SIMPLIFY_ANIMATION="$programs/simplify_animation"
PYTHONPATH="$folder/python" bash "$root/test/python/run.sh"

say "An example: a figure that runs, as arrays"
"$programs/make_animation" figure -o "$folder/figure" > /dev/null
PYTHONPATH="$folder/python" "$python" - "$folder" << 'END'
import sys
import animated_mesh_features as amf

files = amf.read_animation(sys.argv[1] + "/figure.obj", sys.argv[1] + "/figure.pc2")
frames, faces = files.frames, files.faces                             # or arrays of your own

r = amf.detect(frames, faces, frame_duration=1/30, rest="average")    # F x N x 3, T x 3
print(r)
for f in r.features[:5]:
    print(f"{f['time']:.3f} s  vertex {f['vertex']:5}  sigma {f['sigma']:.3f}  tau {f['tau']:.3f} s  {f['strength']:.3f}")
print("deformation:", r.deformation.shape, r.deformation.dtype)
END

case "$more" in
  --install)
    say "Installing"
    missing="$folder, by cmake --install $folder --component python"
    as_root cmake --install "$folder" --component python
    ;;
  --wheel)
    say "Making a source package and a wheel, which takes as long as the first time"
    result=0
    (cd "$folder" && bash "$root/test/python/wheel.sh") || result=$?
    [ $result -ne 77 ] || die "no wheel is made without scikit-build-core: pip install 'scikit-build-core>=0.10'"
    [ $result -eq 0 ] || exit $result
    ;;
esac
say "Now try: PYTHONPATH=$folder/python $python"
