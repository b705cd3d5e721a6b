"""What the functions take, as the runs take it: checked, and in words that name the keyword."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Optional, Union

import numpy
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._arrays import Spacing
from ._errors import UsageError
from ._volume import Volume, read, warn

AnyVolume = Union[Volume, ArrayLike, "os.PathLike[str]"]
Iso = Union[None, float, str, Sequence[float]]
Labels = Union[None, int, Sequence[int]]
Memory = Union[None, int, str]


def level_of(
    iso: Iso,
    inside: Optional[str],
    topology: Optional[str],
    connectivity: Optional[int],
    open_boundary: bool,
    label: Labels,
) -> _core.LevelFlags:
    flags = _core.LevelFlags()
    if isinstance(iso, str):
        want("iso", iso, ("auto",))
        flags.iso = iso
    elif iso is not None:
        flags.iso = " ".join(repr(float(value)) for value in numpy.atleast_1d(iso))
    want("inside", inside, ("above", "below"))
    want("topology", topology, ("trilinear", "simple"))
    want("connectivity", connectivity, (6, 18, 26))
    if topology is not None and connectivity is not None:
        raise UsageError("topology= does not go with connectivity=, which takes its place")
    if label is not None and (iso is not None or inside is not None):
        raise UsageError("iso= and inside= do not go with label=, which says what is inside")
    flags.inside = inside or ""
    flags.topology = topology or "trilinear"
    flags.connectivity = "" if connectivity is None else str(connectivity)
    flags.open_boundary = open_boundary
    return flags


def want(name: str, value: Any, known: Sequence[Any]) -> None:
    if value is not None and value not in known:
        raise UsageError(f"{name}={value!r} is none of {', '.join(map(repr, known))}")


def limits_of(threads: int, max_memory: Memory) -> _core.Limits:
    if threads < 0 or threads > 1 << 16:
        raise UsageError(f"threads={threads} must be 0 (one for each core) to 65536")
    return _core.Limits(threads, _core.bytes_of(str(max_memory)) if max_memory is not None else 0)


def opened(volume: AnyVolume, open_boundary: bool = False) -> Any:
    """A path is read."""
    if isinstance(volume, (str, os.PathLike)):
        return read(volume, open_boundary=open_boundary)
    return volume


def input_of(
    volume: Any,
    label: Labels,
    spacing: Optional[Spacing],
    affine: Optional[ArrayLike],
    frame: Optional[str],
    unit: str,
    nan_as: Optional[float],
) -> _core.Input:
    if isinstance(volume, Volume):
        given = {
            "spacing": spacing,
            "affine": affine,
            "frame": frame,
            "unit": unit or None,
            "nan_as": nan_as,
        }
        for name, value in given.items():
            if value is not None:
                raise UsageError(f"{name}= goes with arrays; for a file, give it to isoloop.read()")
        made = _core.input_of_volume(volume._held)
    else:
        made = _arrays.input_of(volume, spacing, affine, frame, unit, nan_as)
    if label is None:
        return made
    return _core.input_of_labels(made, labels_of(label))


def labels_of(label: Union[int, Sequence[int]]) -> list[int]:
    """The labels, one or several."""
    return [int(one) for one in numpy.atleast_1d(label)]


def tell_warnings(run: _core.Run, volume: Any) -> None:
    """Warns of what the run found beside what reading the volume has told."""
    warn(run.warnings[len(volume.warnings) if isinstance(volume, Volume) else 0 :])
