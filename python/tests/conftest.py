"""What the tests share: solids with known places, the command, and real volumes."""

from __future__ import annotations

import os
import pathlib
import subprocess

import numpy
import pytest

DATA = pathlib.Path(__file__).resolve().parents[2].parent / "shared" / "data"


def plate(shape=(11, 13, 17), hole=(5, 6, 12), axis=0):
    """A plate across `axis` with one hole, which runs along it through the voxel `hole`."""
    solid = numpy.zeros(shape, bool)
    solid[1:-1, 1:-1, 1:-1] = True
    away = [abs(x - c) for x, c in zip(numpy.indices(shape), hole)]
    across = [away[other] for other in range(3) if other != axis]
    solid[numpy.maximum(*across) <= 1] = False
    return solid


@pytest.fixture
def ring():
    return plate()


@pytest.fixture(scope="session")
def command():
    """Runs the command that was built beside the module; returns what it prints as JSON."""
    program = os.environ.get("ISOLOOP")
    if not program:
        pytest.skip("ISOLOOP does not name the command")

    def run(*arguments):
        words = [program, *map(str, arguments), "--json", "-"]
        done = subprocess.run(words, capture_output=True, check=False)
        assert done.returncode == 0, done.stderr.decode()
        return done.stdout.decode("utf-8", "replace")

    run.program = program
    return run


def data(name):
    """A file of the shared data, or a skip by its name."""
    path = DATA / name
    if not path.exists():
        pytest.skip(f"{name} is missing")
    return str(path)


def without_cost(text):
    """The lines of a JSON report that are the same for every run."""
    return [
        line
        for line in text.splitlines()
        if not line.startswith(('  "seconds"', '  "peak_bytes"'))
    ]
