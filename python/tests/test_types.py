"""The types are those of the code, and stubs those of the compiled module."""

import importlib.util
import os
import pathlib
import subprocess
import sys

import pytest

import isoloop

PACKAGE = pathlib.Path(isoloop.__file__).parent

# What pybind11 makes of every class: a metaclass, and a constructor where there is none.
OF_PYBIND11 = r"""isoloop\._core\.[A-Z]\w+
isoloop\._core\.[A-Z]\w+\.__init__
"""


def mypy(*arguments, cwd):
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("mypy is missing")
    environment = dict(os.environ, MYPYPATH=str(PACKAGE.parent))
    done = subprocess.run([sys.executable, "-m", *arguments], capture_output=True, check=False,
                          cwd=cwd, env=environment)
    assert done.returncode == 0, done.stdout.decode() + done.stderr.decode()


def test_the_package_is_typed_strictly(tmp_path):
    assert (PACKAGE / "py.typed").exists()
    mypy("mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), str(PACKAGE), cwd=tmp_path)


def test_stubs_name_what_the_compiled_module_has(tmp_path):
    (tmp_path / "allowed.txt").write_text(OF_PYBIND11, encoding="utf-8")
    mypy("mypy.stubtest", "isoloop._core", "--allowlist", "allowed.txt", cwd=tmp_path)


def test_every_public_name_has_a_docstring():
    for name in isoloop.__all__:
        if name != "__version__":
            assert getattr(isoloop, name).__doc__, name
