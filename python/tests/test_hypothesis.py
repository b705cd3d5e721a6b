"""Arrays of all kinds: a result that is right, or an exception that says what to do."""

import os

import hypothesis
import hypothesis.extra.numpy as arrays
import hypothesis.strategies as some
import numpy

import isoloop

hypothesis.settings.register_profile(
    "isoloop",
    max_examples=int(os.environ.get("ISOLOOP_EXAMPLES", "300")),  # 100000 in .ci/nightly
    deadline=None,
    database=None,
    derandomize=True,
    suppress_health_check=list(hypothesis.HealthCheck),
)
hypothesis.settings.load_profile("isoloop")

TYPES = "? u1 i1 u2 i2 u4 i4 u8 i8 f2 f4 f8 >u2 >i4 >f4 >f8 c8 S3 U2 M8[s] O".split()


@some.composite
def voxels(draw):
    """Arrays of any type and shape, of any order and steps, with NaN and infinities."""
    kind = numpy.dtype(draw(some.sampled_from(TYPES)))
    axes = draw(some.sampled_from([3, 3, 3, 3, 3, 3, 2, 1, 4, 0]))
    shape = draw(some.tuples(*[some.sampled_from([0, 1, 1, 2, 3, 4, 5])] * axes))
    few = some.integers(0, 2) if kind.kind in "uib" or kind.kind == "f" else None
    elements = few.map(kind.type) if few is not None and draw(some.booleans()) else None
    if kind.kind == "O":
        elements = some.none()
    array = draw(arrays.arrays(kind, shape, elements=elements))
    array = array.transpose(draw(some.permutations(range(axes))))
    steps = draw(some.tuples(*[some.sampled_from([1, 1, 1, 2, -1, -2])] * axes))
    return array[tuple(slice(None, None, step) for step in steps) or ...]


@hypothesis.given(
    voxels(),
    some.one_of(some.none(), some.floats(), some.tuples(some.floats(), some.floats()),
                some.sampled_from([0, 0.5, 1, (0.5, 1.5)])),
    some.sampled_from([None, "above", "below"]),
    some.sampled_from([None, None, 6, 18, 26]),
    some.booleans(),
    some.sampled_from([None, 1, 0]),
)
def test_no_array_breaks_anything(array, iso, inside, connectivity, is_open, label):
    given = {"inside": inside, "connectivity": connectivity, "open_boundary": is_open, "label": label}
    before = array.copy()
    try:
        counts = isoloop.count(array, iso, **given)
        found = isoloop.loops(array, iso, **given)
    except isoloop.Error as error:
        assert len(str(error)) > 15 and "--" not in str(error)
        assert error.exit_code in (2, 3, 4)
        return
    finally:
        assert array.tobytes() == before.tobytes() or array.dtype.kind == "O"
    assert counts.betti == found.betti
    betti = 2 * counts.genus if not is_open else counts.betti.tunnels
    assert len(found) == betti
    for loop in found:
        for curve in loop.curves_index:
            assert numpy.isfinite(curve).all()
            assert (curve >= -1).all() and (curve <= array.shape).all()


@hypothesis.given(arrays.arrays(bool, some.tuples(*[some.integers(1, 5)] * 3)),
                  some.permutations(range(3)), some.sampled_from([6, 18, 26]))
def test_counts_of_masks_do_not_depend_on_the_order_of_axes(mask, axes, connectivity):
    expected = isoloop.count(mask, connectivity=connectivity)
    turned = isoloop.count(mask.transpose(axes), connectivity=connectivity)
    assert turned.betti == expected.betti and turned.euler == expected.euler
