# Copyright (c) 2026 The Animated_mesh_features authors.
#
# This file is part of the package Animated_mesh_features for CGAL.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The gallery runs: its scripts, and the code of its notebook as a plain script."""

import json
import os
import pathlib
import subprocess
import sys

import pytest

GALLERY = pathlib.Path(os.environ.get("GALLERY", pathlib.Path(__file__).resolve().parents[2] / "python" / "gallery"))


def run(code, folder):
    environment = dict(os.environ, MPLBACKEND="Agg", PYTHONPATH=os.pathsep.join([str(GALLERY), *sys.path]))
    done = subprocess.run([sys.executable, *code], cwd=folder, env=environment, capture_output=True, text=True,
                          timeout=120)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_plot_features(tmp_path):
    pytest.importorskip("matplotlib")
    assert "features, the strongest" in run([GALLERY / "plot_features.py", "out.png"], tmp_path)
    assert (tmp_path / "out.png").read_bytes()[1:4] == b"PNG"


def test_compare_corpus(tmp_path):
    rows = [[float(x) for x in line.split()[-5:]]
            for line in run([GALLERY / "compare_corpus.py"], tmp_path).splitlines()[-5:]]
    assert all(rows[i][i] == 0 for i in range(5)) and all(rows[i][j] == rows[j][i] for i in range(5) for j in range(5))
    # one bend and two bends, whatever the mesh and the frame rate
    same = rows[0][1:3] + rows[1][2:3] + rows[3][4:]
    assert max(same) < min(rows[i][j] for i in range(3) for j in (3, 4))


def test_simplify(tmp_path):
    lines = run([GALLERY / "simplify.py", "out.obj"], tmp_path).splitlines()
    assert lines[-1] == "positions: 40 x 144 x 3 written: out.obj"
    assert (tmp_path / "out.obj").read_text().count("v ") == 144


def test_read_hdf5(tmp_path):
    pytest.importorskip("h5py")
    time = float(run([GALLERY / "read_hdf5.py"], tmp_path).splitlines()[1].split()[1])
    assert abs(time - 0.5) < 0.1


def test_notebook(tmp_path):
    pytest.importorskip("matplotlib")
    notebook = json.loads((GALLERY / "tour.ipynb").read_text(encoding="utf-8"))
    cells = ["".join(c["source"]) for c in notebook["cells"] if c["cell_type"] == "code"]
    assert len(cells) > 5 and not any(c["outputs"] for c in notebook["cells"] if c["cell_type"] == "code")
    (tmp_path / "tour.py").write_text("\n\n".join(cells), encoding="utf-8")
    assert "strength" in run([tmp_path / "tour.py"], tmp_path)


def test_notebook_in_jupyter(tmp_path, monkeypatch):
    """where Jupyter is here, the notebook runs as one"""
    pytest.importorskip("matplotlib")
    why = "Jupyter is not here (Debian: python3-nbclient, python3-ipykernel); the notebook ran as a plain script"
    nbclient = pytest.importorskip("nbclient", reason=why)
    pytest.importorskip("ipykernel", reason=why)
    nbformat = pytest.importorskip("nbformat", reason=why)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(GALLERY), *sys.path]))
    monkeypatch.setenv("MPLBACKEND", "module://matplotlib_inline.backend_inline")
    monkeypatch.setenv("JUPYTER_DATA_DIR", str(tmp_path))  # of this Python, whatever kernels the user has
    kernel = tmp_path / "kernels" / "python3"
    kernel.mkdir(parents=True)
    (kernel / "kernel.json").write_text(json.dumps(
        {"argv": [sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"], "display_name": "Python",
         "language": "python"}))
    notebook = nbformat.read(GALLERY / "tour.ipynb", as_version=4)
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3",
                            resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [o for c in notebook.cells if c.cell_type == "code" for o in c.outputs]
    assert any("image/png" in o.get("data", {}) for o in outputs)
    assert any("Detection of" in o.get("data", {}).get("text/plain", "") for o in outputs)
