"""Results are readable, and their parts agree with each other."""

import doctest
import importlib
import json

import numpy
import pytest
from conftest import plate

import isoloop


@pytest.fixture(scope="module")
def found():
    return isoloop.features(isoloop.generate("plate", size=48, holes=3))


def test_loops_are_a_sequence(found):
    assert len(found) == 6 == len(list(found)) == found.found
    assert [loop.kind for loop in found[:3]] == ["handle"] * 3
    assert found[-1].kind == "tunnel" and found[-1].fix == "fill"
    assert len(found.handle_loops) == len(found.tunnel_loops) == 3
    with pytest.raises(IndexError):
        found[6]
    assert "3 tunnels" in repr(found) and "tunnel 3" in repr(found[-1])
    assert "verified" in str(found)


def test_curves_are_closed_and_as_long_as_is_said(found):
    for loop in found:
        length = sum(
            numpy.linalg.norm(curve - numpy.roll(curve, 1, axis=0), axis=1).sum()
            for curve in loop.curves
        )
        assert length == pytest.approx(loop.length, rel=1e-5)
        assert all(numpy.allclose(a, b) for a, b in zip(loop.curves, loop.curves_world))
        assert loop.certificate[{"handle": "inside", "tunnel": "outside"}[loop.kind]] == "trivial"


def test_the_table_has_a_row_for_each_loop(found):
    table = found.to_numpy()
    assert table.dtype.names[:4] == ("kind", "id", "fix", "length")
    assert table["length"][2] == found[2].length and table["thickness"][3] == found[3].feature.thickness
    assert table["center"].shape == (6, 3)
    assert json.loads(found.to_json())["loops"][0]["length"] == found[0].length


def test_the_surface_has_the_characteristic_that_is_said(found):
    vertices, triangles = found.surface()
    edges = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    assert len(vertices) - len(numpy.unique(edges, axis=0)) + len(triangles) == found.euler
    assert sum(part.genus for part in found.parts) == found.genus == 3
    assert not found.surface()[1].flags.writeable


def test_labels_mark_the_features_in_the_axes_of_the_array():
    solid = plate(shape=(11, 13, 17))
    found = isoloop.features(solid)
    labels = found.labels
    assert labels.shape == solid.shape
    tunnel = found.tunnel_loops[0]
    beside = numpy.argwhere(labels == tunnel.feature.label)
    assert numpy.abs(beside[:, 1:].mean(axis=0) - (6, 12)).max() < 0.75
    assert abs(tunnel.feature.axis[0]) > 0.9
    with pytest.raises(isoloop.UsageError, match="features"):
        isoloop.loops(solid).labels


def test_files_are_written_whole(found, tmp_path):
    found.write(tmp_path / "a.json")
    assert json.loads((tmp_path / "a.json").read_text(encoding="utf-8")) == found.to_dict()
    found.write(tmp_path / "a.csv")
    found.write(tmp_path / "a.ply")
    found.write_surface(tmp_path / "a.stl")
    found.write_curves(tmp_path / "a.vtp")
    assert (tmp_path / "a.stl").stat().st_size == 84 + 50 * found.triangles
    with pytest.raises(isoloop.UsageError, match="ending|written|as"):
        found.write(tmp_path / "a.doc")
    with pytest.raises(isoloop.InvalidInput):
        found.write(tmp_path / "nowhere" / "a.json")


def test_a_repair_changes_a_copy_in_every_order_of_memory():
    for order in ("C", "F"):
        solid = numpy.array(plate(), order=order)
        before = solid.copy()
        repaired = isoloop.repair(solid, fill_tunnels=100)
        assert repaired.array.dtype == bool and numpy.array_equal(solid, before)
        assert numpy.array_equal(repaired.changed, repaired.array != solid)
        assert isoloop.count(repaired.array).tunnels == 0
        assert repaired.removals[0].action == "fill" and repaired.before.tunnels == 1
        assert numpy.abs(repaired.removals[0].center_index[1:] - (6, 12)).max() < 0.5
        assert "1 removed" in repr(repaired)


def test_scans_show_their_curves(found):
    scan = isoloop.scan(isoloop.generate("torus", size=24).array, values=20)
    assert "<svg" in scan._repr_html_() and len(scan.rows) == 20 == len(scan.to_numpy())
    assert {p.betti.tunnels for p in scan.plateaus} >= {0, 1}


def test_threads_change_nothing():
    volume = isoloop.generate("lattice", size=48, cells=2)
    one, two = (isoloop.loops(volume, threads=n) for n in (1, 2))
    assert one.to_dict()["loops"] == two.to_dict()["loops"]


@pytest.mark.parametrize("name", ["isoloop", "isoloop._runs", "isoloop._changes", "isoloop._volume", "isoloop._errors", "isoloop._napari"])
def test_examples_in_docstrings_are_true(name):
    failed, tried = doctest.testmod(importlib.import_module(name))
    assert failed == 0 and tried > 0
