"""Every example runs; those whose packages are missing are skipped by name."""

import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest
from conftest import data

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"


def run(name, *arguments, needs, cwd):
    for module in needs:
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is missing")
    words = [sys.executable, str(EXAMPLES / name), *map(str, arguments)]
    done = subprocess.run(words, capture_output=True, check=False, cwd=cwd, timeout=300)
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode()


def test_scikit_image(tmp_path):
    text = run("scikit_image.py", needs=["skimage"], cwd=tmp_path)
    assert "Betti(components=1, tunnels=3, cavities=0)" in text
    assert len(text.splitlines()) == 4


def test_nifti_table(tmp_path):
    path = data("formats/hippo.nii.gz")
    text = run("nifti_table.py", path, 0.5, "table.csv", needs=["nibabel"], cwd=tmp_path)
    rows = (tmp_path / "table.csv").read_text(encoding="utf-8").splitlines()
    assert text.startswith(f"{len(rows) - 1} tunnels")


def test_matplotlib_slice(tmp_path):
    run("matplotlib_slice.py", "slice.png", needs=["matplotlib"], cwd=tmp_path)
    assert (tmp_path / "slice.png").read_bytes().startswith(b"\x89PNG")


def test_vtk_surface(tmp_path):
    text = run("vtk_surface.py", needs=["vtkmodules"], cwd=tmp_path)
    assert text.endswith("6 curves\n")


def test_progress_bar(tmp_path):
    assert "verified" in run("progress_bar.py", needs=["tqdm"], cwd=tmp_path)


def test_the_notebook(tmp_path):
    for module in ("nbconvert", "ipykernel"):
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is missing")
    words = [sys.executable, "-m", "nbconvert", "--to", "html", "--execute", "--output-dir",
             str(tmp_path), str(EXAMPLES / "tour.ipynb")]
    environment = dict(os.environ, HOME=str(tmp_path))
    done = subprocess.run(words, capture_output=True, check=False, env=environment, timeout=300)
    assert done.returncode == 0, done.stderr.decode()
    text = (tmp_path / "tour.html").read_text(encoding="utf-8")
    assert "srcdoc" in text and "verified" in text
