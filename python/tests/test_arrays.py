"""Arrays of every type and layout are read where they lie, or say what to do."""

import numpy
import pytest
from conftest import plate

import isoloop

KNOWN = ["u1", "i1", "u2", "i2", "u4", "i4", "f4", "f8"]


@pytest.mark.parametrize("kind", [*KNOWN, "u8", "i8", "f2", ">u2", ">i4", ">f8", "bool"])
def test_every_type_gives_the_same_counts(kind):
    solid = plate().astype(kind)
    assert isoloop.count(solid, iso=1).betti == (1, 1, 0)


@pytest.mark.parametrize("kind", KNOWN)
def test_known_types_are_not_copied(kind):
    solid = plate().astype(kind)
    assert numpy.shares_memory(isoloop._arrays.input_of(solid).voxels(), solid)


def test_masks_need_no_iso_and_are_not_copied(ring):
    assert isoloop.count(ring).betti == (1, 1, 0)
    assert numpy.shares_memory(isoloop._arrays.input_of(ring).voxels(), ring)


def test_memory_mapped_files_are_read_where_they_lie(tmp_path, ring):
    numpy.save(tmp_path / "a.npy", ring.astype("i2"))
    mapped = numpy.load(tmp_path / "a.npy", mmap_mode="r")
    assert numpy.shares_memory(isoloop._arrays.input_of(mapped).voxels(), mapped)
    assert isoloop.count(mapped, iso=1).tunnels == 1


@pytest.mark.parametrize(
    "part", [numpy.s_[::2, ::1, ::1], numpy.s_[::-1, :, :], numpy.s_[:, ::-1, ::-2], numpy.s_[1:9, 2:, :-1]]
)
def test_parts_and_steps_count_as_their_copies_do(ring, part):
    some = ring.astype("f4")[part]
    assert isoloop.count(some, iso=1).betti == isoloop.count(some.copy(), iso=1).betti


def test_unaligned_arrays_are_copied():
    packed = numpy.zeros(8 * 27 + 1, "u1")[1:].view("f8").reshape(3, 3, 3)
    packed[...] = 1
    assert isoloop.count(packed, iso=1).betti == (1, 0, 0)


def test_whole_numbers_of_64_bits_are_read_where_32_hold_them():
    solid = plate().astype("i8")
    assert isoloop.count(solid * 3_000_000_000, iso=1).betti == (1, 1, 0)
    assert isoloop.count(solid * -2_000_000_000, iso=-1, inside="below").betti == (1, 1, 0)
    with pytest.raises(isoloop.UsageError, match="astype"):
        isoloop.count(solid * 5_000_000_000, iso=1)


@pytest.mark.parametrize(
    "array, words",
    [
        (numpy.zeros((3, 3)), "array.None. makes"),
        (numpy.zeros((2, 3, 3, 3)), "no volume"),
        (numpy.zeros((0, 3, 3)), "no voxel"),
        (numpy.zeros((3, 3, 3), complex), "not read"),
        (numpy.zeros((3, 3, 3), "O"), "not read"),
        (numpy.zeros((3, 3, 3), "g"), "not read"),
        ([["a"]], "no volume"),
    ],
)
def test_what_is_no_volume_says_what_to_do(array, words):
    with pytest.raises(isoloop.UsageError, match=words):
        isoloop.count(array, iso=1)


@pytest.mark.parametrize(
    "given, words",
    [
        ({}, "iso= is required"),
        ({"iso": numpy.nan}, "iso="),
        ({"iso": (2, 1)}, "iso="),
        ({"iso": 1, "inside": "out"}, "'above', 'below'"),
        ({"iso": 1, "topology": "x"}, "trilinear"),
        ({"iso": 1, "connectivity": 4}, "6, 18, 26"),
        ({"iso": 1, "connectivity": 6, "topology": "simple"}, "takes its place"),
        ({"iso": 1, "label": 1}, "label="),
        ({"label": 7}, "label"),
        ({"iso": 1, "spacing": (1, 2)}, "one for each axis"),
        ({"iso": 1, "spacing": 0}, "spacing"),
        ({"iso": 1, "spacing": numpy.nan}, "spacing"),
        ({"iso": 1, "spacing": 1, "affine": numpy.eye(4)}, "does not go with"),
        ({"iso": 1, "affine": numpy.eye(3)}, "4 x 4"),
        ({"iso": 1, "affine": numpy.full((4, 4), numpy.nan)}, "0 0 0 1"),
        ({"iso": 1, "frame": "ras"}, "frame="),
        ({"iso": 1, "threads": -1}, "threads"),
        ({"iso": 1, "max_memory": "much"}, "is no size"),
        ({"iso": (1, 2), "inside": "above"}, "inside="),
    ],
)
def test_keywords_that_make_no_sense_are_named(ring, given, words):
    with pytest.raises(isoloop.UsageError, match=words) as caught:
        isoloop.count(ring.astype("u1"), **given)
    assert "--" not in str(caught.value)
    assert caught.value.exit_code == 2


def test_sheared_axes_are_refused(ring):
    sheared = numpy.eye(4)
    sheared[0, 1] = 0.2
    with pytest.raises(isoloop.InvalidInput, match="degrees"):
        isoloop.count(ring, affine=sheared)


def test_labels_of_a_map_are_the_solid(ring):
    labels = numpy.where(ring, 3, 0)
    labels[0, 0, 0] = 9
    assert isoloop.count(labels, label=3).betti == (1, 1, 0)
    assert isoloop.count(labels, label=[3, 9]).betti == (2, 1, 0)
    assert isoloop.count(labels.transpose(), label=9, connectivity=26).betti == (1, 0, 0)


def test_an_open_boundary_lets_the_surface_end():
    tube = numpy.zeros((5, 7, 7), bool)
    tube[:, 2:5, 2:5] = True
    counts = isoloop.count(tube, open_boundary=True)
    assert counts.parts[0].borders == 2
    assert [loop.kind for loop in isoloop.loops(tube, open_boundary=True)] == ["loop"]


def test_max_memory_is_asked_before_it_is_taken():
    solid = numpy.ones((120, 120, 120), bool)
    with pytest.raises(isoloop.LimitExceeded) as caught:
        isoloop.count(solid, max_memory="1M")
    error = caught.value
    assert isinstance(error, MemoryError)
    assert error.unit == "bytes" and error.needed > error.limit and error.stage
    assert "max_memory" in str(error)
