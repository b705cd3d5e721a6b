"""Arrays as the compiled module takes them: where they lie, and in which order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._errors import UsageError

Spacing = Union[float, Sequence[float]]

_KNOWN = frozenset("|u1 |i1 <u2 <i2 <u4 <i4 <f4 <f8 =u2 =i2 =u4 =i4 =f4 =f8".split())
_FRAMES = ("world", "ras", "lps")


def known_type(array: NDArray[Any]) -> NDArray[Any]:
    """The array in a type that isoloop knows and that holds the same values; most are as they are.

    Booleans become 0 and 1 where they lie, numbers in the other byte order, half precision and
    integers of 64 bits are copied. Raises UsageError where no type holds the values.
    """
    kind = array.dtype.kind
    if kind == "b":
        return array.view(numpy.uint8)
    if kind not in "iuf" or array.dtype.itemsize > 8:
        raise UsageError(
            f"voxels of type {array.dtype} are not read; pass array.astype(...) of a boolean, an "
            "integer or a floating-point type of 64 bits at most"
        )
    if array.dtype.itemsize == 8 and kind in "iu":
        return _narrowed(array)
    wanted = numpy.dtype("f4") if array.dtype.itemsize == 2 and kind == "f" else array.dtype
    return array.astype(wanted.newbyteorder("="), order="K", copy=False)


def _narrowed(array: NDArray[Any]) -> NDArray[Any]:
    least, most = int(array.min()), int(array.max())
    for narrow in (numpy.int32, numpy.uint32):
        if numpy.iinfo(narrow).min <= least and most <= numpy.iinfo(narrow).max:
            return array.astype(narrow, order="K")
    raise UsageError(
        f"voxels of type {array.dtype} are read where 32 bits hold them, but these run from {least} "
        f"to {most}; pass array.astype(float), which rounds beyond 2**53"
    )


def along_memory(array: NDArray[Any]) -> tuple[NDArray[Any], tuple[int, int, int]]:
    """The array with its axes turned so that the first is the fastest in memory, and which they are.

    A view if the array's numbers lie side by side in any order of the axes, else a copy.
    """
    if not array.flags.aligned:
        array = array.copy()
    if array.flags.f_contiguous:
        return array, (0, 1, 2)
    by_stride = sorted(range(3), key=lambda axis: abs(array.strides[axis]))
    for axes in ((2, 1, 0), (by_stride[0], by_stride[1], by_stride[2])):
        if array.transpose(axes).flags.f_contiguous:
            return array.transpose(axes), axes
    return numpy.ascontiguousarray(array).transpose((2, 1, 0)), (2, 1, 0)


def _lengths(spacing: Optional[Spacing]) -> tuple[float, float, float]:
    if spacing is None:
        return 1.0, 1.0, 1.0
    try:
        lengths = [float(length) for length in numpy.atleast_1d(numpy.asarray(spacing, float))]
    except (TypeError, ValueError) as error:
        raise UsageError(f"spacing={spacing!r} must be one length or three") from error
    if len(lengths) == 1:
        lengths *= 3
    if len(lengths) != 3:
        raise UsageError(f"spacing={spacing!r} must be one length, or one for each axis")
    return lengths[0], lengths[1], lengths[2]


def _columns(affine: ArrayLike) -> list[list[float]]:
    matrix = numpy.asarray(affine, float)
    if matrix.shape != (4, 4) or not numpy.array_equal(matrix[3], [0, 0, 0, 1]):
        raise UsageError("affine= must be a 4 x 4 matrix whose last row is 0 0 0 1")
    if not numpy.isfinite(matrix).all():
        raise UsageError("affine= must be finite")
    return [[float(x) for x in matrix[:3, column]] for column in range(4)]


def _without_nan(array: NDArray[Any], value: float) -> NDArray[Any]:
    if numpy.isnan(value):
        raise UsageError("nan_as= wants a number to stand in for NaN")
    if array.dtype.kind != "f":
        return array
    missing = numpy.isnan(array)
    if not missing.any():
        return array
    array = array.copy(order="K")
    array[missing] = value
    return array


def checked(array: ArrayLike) -> NDArray[Any]:
    """As an array of three axes with voxels. Raises UsageError where it is none."""
    voxels = numpy.asarray(array)
    if voxels.ndim != 3:
        raise UsageError(
            f"an array of {voxels.ndim} axes is no volume, which has three; "
            "array[None] makes one slice of a picture"
        )
    if voxels.size == 0:
        raise UsageError(f"an array of shape {voxels.shape} holds no voxel")
    return voxels


def input_of(
    array: ArrayLike,
    spacing: Optional[Spacing] = None,
    affine: Optional[ArrayLike] = None,
    frame: Optional[str] = None,
    unit: str = "",
    nan_as: Optional[float] = None,
) -> _core.Input:
    """The array for a run; its memory is not copied unless it must be, as the functions above say."""
    voxels = checked(array)
    is_mask = voxels.dtype.kind == "b"
    voxels = known_type(voxels)
    if nan_as is not None:
        voxels = _without_nan(voxels, float(nan_as))
    voxels, axes = along_memory(voxels)
    if frame is not None and (affine is None or frame not in _FRAMES):
        raise UsageError("frame= names what affine= leads to: 'world', 'ras' or 'lps'")
    if affine is not None and spacing is not None:
        raise UsageError("spacing= does not go with affine=, whose columns are as long as it says")
    columns = None if affine is None else _columns(affine)
    place = "index" if affine is None else frame or "world"
    return _core.input_of_array(
        voxels, axes, _lengths(spacing), columns, place, unit, nan_as, is_mask
    )
