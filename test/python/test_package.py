# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What is installed, and what pip is told of it. That a wheel is made of it is tested by wheel.sh."""

import importlib.metadata
import os
import pathlib
import re
import subprocess
import sys

import pytest

import animated_mesh_features as amf
from conftest import ROOT

SOURCES = ROOT / "python" / "animated_mesh_features"
PACKAGE = pathlib.Path(amf.__file__).parent


@pytest.fixture(scope="module")
def project():
    tomllib = pytest.importorskip("tomllib", reason="Python 3.11 and newer read TOML")
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def files_of_package():
    """their names: Python's files, and the one extension module"""
    extensions = [p.name for p in PACKAGE.glob("_core.*") if p.suffix in (".so", ".pyd")]
    assert len(extensions) == 1
    return {p.name for p in SOURCES.iterdir() if p.suffix in (".py", ".pyi") or p.name == "py.typed"} | set(extensions)


def test_metadata(project):
    about, build = project["project"], project["tool"]["scikit-build"]
    assert project["build-system"]["build-backend"] == "scikit_build_core.build"
    assert {r.split(">=")[0] for r in project["build-system"]["requires"]} == {"scikit-build-core", "pybind11"}
    assert about["dynamic"] == ["version"] and (ROOT / about["readme"]).is_file()
    assert "GPL-3.0-or-later" in about["license"]["text"] and about["dependencies"] == ["numpy>=1.20"]
    version = build["metadata"]["version"]
    found = re.findall(version["regex"], (ROOT / version["input"]).read_text(encoding="utf-8"), re.MULTILINE)
    assert found == [amf.__version__]
    # what CMake is told is known to it
    known = "".join(p.read_text(encoding="utf-8") for p in
                    [ROOT / "CMakeLists.txt", ROOT / "python" / "CMakeLists.txt", *(ROOT / "cmake").glob("*.cmake")])
    for name in build["cmake"]["define"]:
        assert re.search(rf"(option\(|set\(|DEFINED ){name}\b", known), name
    for target in build["build"]["targets"]:
        assert re.search(rf"add_library\({target} MODULE\b", known)
    for component in build["install"]["components"]:
        assert f"COMPONENT {component})" in known
    # what a source package leaves out is no part of a build, but there
    for path in build["sdist"]["exclude"]:
        assert path.startswith("/") and ((ROOT / path[1:]).exists() or "INSTALLED" in os.environ), path


def test_files():
    """what is imported are the sources of today"""
    for source in SOURCES.glob("*.py*"):
        assert (PACKAGE / source.name).read_bytes() == source.read_bytes(), source.name


def test_installation_by_cmake(tmp_path):
    """the component "python", of which a wheel is made, is the package and nothing else, and works where it is"""
    build = os.environ.get("BUILD_FOLDER")
    if not build or not os.path.exists(os.path.join(build, "CMakeCache.txt")):
        pytest.skip("BUILD_FOLDER does not name the folder in which the module was built")
    subprocess.run([os.environ.get("CMAKE", "cmake"), "--install", build, "--component", "python", "--prefix",
                    str(tmp_path)], check=True, capture_output=True)
    files = [p for p in tmp_path.rglob("*") if p.is_file()]
    folders = {p.parent for p in files}
    assert len(folders) == 1 and {p.name for p in files} == files_of_package()
    folder = folders.pop()
    assert folder.name == "animated_mesh_features"
    done = subprocess.run([sys.executable, "-c", "import animated_mesh_features as amf; print(amf.__file__)"], check=True,
                          capture_output=True, text=True, env=dict(os.environ, PYTHONPATH=str(folder.parent)))
    assert done.stdout.strip() == str(folder / "__init__.py")


def test_wheel(project):
    """of the module that was installed by pip"""
    if "INSTALLED" not in os.environ:
        pytest.skip("the module was not installed by pip: see wheel.sh")
    assert pathlib.Path(os.environ["INSTALLED"]) in PACKAGE.parents
    about = importlib.metadata.metadata(project["project"]["name"])
    assert about["Version"] == amf.__version__ and about["Summary"] == project["project"]["description"]
    assert about["License"] == "GPL-3.0-or-later" and "amf.detect" in about.get_payload()
    files = {str(f) for f in importlib.metadata.files(project["project"]["name"])}
    inside = {f.split("/", 1)[1] for f in files if f.startswith("animated_mesh_features/") and "__pycache__" not in f}
    assert inside == files_of_package()
    outside = {f.split("/")[0] for f in files} - {"animated_mesh_features"}
    assert len(outside) == 1 and outside.pop().endswith(".dist-info")
    assert any(f.endswith("LICENSE") for f in files)
