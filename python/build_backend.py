# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What pip calls to make a wheel or a source package (PEP 517): runs CMake and packs what it makes.

Not scikit-build-core, which Debian 12 does not have: with what is here, and nothing to be fetched for the build, ``pip
install .`` works where there is no network. Needed are CMake, a C++ compiler, and the development packages of the project and of pybind11, see
scripts/python.sh.

Settings (``pip install . --config-settings=NAME=VALUE``):
  build-dir     a folder that is kept, so that the next build is a short one
  jobs          compilers beside each other, by default one for each 2.5 GB of free memory, at most one for each core
  cmake.define.VARIABLE   for CMake, for instance cmake.define.ANIMATED_MESH_FEATURES_WITH_VIEWER=ON
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

NAME = "animated_mesh_features"
HERE = pathlib.Path(__file__).resolve().parent
# In a source package the project lies beside this file, else above it.
PROJECT = HERE / "project" if (HERE / "project").is_dir() else HERE.parent
# What it takes to build the module.
PARTS = ["CMakeLists.txt", "LICENSE", "README.md", "cmake", "include", "src", "examples", "python", "viewer",
         "doc/figures", "doc/manual"]


def version():
    text = (PROJECT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"\bVERSION (\d+\.\d+\.\d+)", text)[1]


def metadata():
    return f"""Metadata-Version: 2.1
Name: animated-mesh-features
Version: {version()}
Summary: Spatio-temporal feature points of animated meshes
License: GPL-3.0-or-later
Classifier: License :: OSI Approved :: GNU General Public License v3 or later (GPLv3+)
Classifier: Programming Language :: C++
Classifier: Topic :: Scientific/Engineering
Requires-Python: >=3.8
Requires-Dist: numpy>=1.20
Provides-Extra: test
Requires-Dist: pytest; extra == "test"
Provides-Extra: gallery
Requires-Dist: matplotlib; extra == "gallery"
Requires-Dist: scipy; extra == "gallery"
Requires-Dist: h5py; extra == "gallery"
Description-Content-Type: text/markdown

{(HERE / "README.md").read_text(encoding="utf-8")}"""


def jobs():
    cores, memory = os.cpu_count() or 1, 0
    try:
        memory = int(re.search(r"MemAvailable: *(\d+)", pathlib.Path("/proc/meminfo").read_text())[1])
    except (OSError, TypeError):
        return cores
    return max(1, min(cores, memory // 2500000))


def run(*command):
    print("+", *command, flush=True)
    subprocess.run([str(c) for c in command], check=True)


def build(folder, settings):
    """The folder of the package, complete."""
    defines = {"CMAKE_BUILD_TYPE": "Release", "ANIMATED_MESH_FEATURES_BUILD_PYTHON": "ON",
               "ANIMATED_MESH_FEATURES_PYTHON": sys.executable, "ANIMATED_MESH_FEATURES_BUILD_TESTS": "OFF",
               "ANIMATED_MESH_FEATURES_BUILD_EXAMPLES": "OFF",
               # its page is made with packages that are fetched
               "ANIMATED_MESH_FEATURES_WITH_VIEWER": "OFF"}
    for name, value in settings.items():
        if name.startswith("cmake.define."):
            defines[name[len("cmake.define."):]] = value
    run("cmake", "-S", PROJECT, "-B", folder, *(f"-D{k}={v}" for k, v in defines.items()))
    run("cmake", "--build", folder, "--parallel", settings.get("jobs", jobs()), "--target", f"{NAME}_python")
    return pathlib.Path(folder) / "python" / NAME


def get_requires_for_build_wheel(config_settings=None):
    return []


def get_requires_for_build_sdist(config_settings=None):
    return []


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = dict(config_settings or {})
    with tempfile.TemporaryDirectory() as temporary:
        package = build(settings.get("build-dir", temporary), settings)
        python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
        platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
        tag = f"{python}-{python}-{platform}"
        name = f"{NAME}-{version()}-{tag}.whl"
        info = f"{NAME}-{version()}.dist-info"
        suffix = sysconfig.get_config_var("EXT_SUFFIX")
        files = {f"{NAME}/{p.name}": p.read_bytes() for p in sorted(package.iterdir())
                 if p.is_file() and (p.suffix in (".py", ".pyi", ".typed") or p.name in ("_core" + suffix, "py.typed"))}
        files[f"{info}/METADATA"] = metadata().encode()
        files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
        files[f"{info}/LICENSE"] = (PROJECT / "LICENSE").read_bytes()
        record = []
        with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
            for path, content in files.items():
                wheel.writestr(path, content)
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                record.append(f"{path},sha256={digest},{len(content)}\n")
            record.append(f"{info}/RECORD,,\n")
            wheel.writestr(f"{info}/RECORD", "".join(record))
    return name


def build_sdist(sdist_directory, config_settings=None):
    base = f"{NAME}-{version()}"

    def wanted(entry):
        name = pathlib.PurePosixPath(entry.name).name
        is_made = name in ("__pycache__", "node_modules", "dist", ".git") or name.startswith("build") and entry.isdir()
        return None if is_made else entry

    with tempfile.TemporaryDirectory() as temporary:
        information = pathlib.Path(temporary) / "PKG-INFO"
        information.write_text(metadata(), encoding="utf-8")
        path = pathlib.Path(sdist_directory) / f"{base}.tar.gz"
        with tarfile.open(path, "w:gz", format=tarfile.PAX_FORMAT) as archive:
            archive.add(information, f"{base}/PKG-INFO")
            for name in ("pyproject.toml", "build_backend.py", "README.md"):
                archive.add(HERE / name, f"{base}/{name}")
            for part in PARTS:
                archive.add(PROJECT / part, f"{base}/project/{part}", filter=wanted)
    return f"{base}.tar.gz"
