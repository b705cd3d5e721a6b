"""The functions that make volumes of volumes: repair, write."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any, Optional, Union

import numpy
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Spacing
from ._options import (
    AnyVolume,
    Iso,
    Labels,
    Memory,
    input_of,
    labels_of,
    level_of,
    limits_of,
    opened,
    tell_warnings,
    want,
)
from ._repair import Repair
from ._volume import Path, Progress, Volume, warn


def repair(
    volume: AnyVolume,
    iso: Iso = None,
    *,
    fill_tunnels: Optional[float] = None,
    cut_handles: Optional[float] = None,
    auto: Optional[float] = None,
    ids: Union[str, Sequence[str]] = "",
    side: str = "",
    genus: Optional[int] = None,
    keep_going: bool = False,
    inside: Optional[str] = None,
    topology: Optional[str] = None,
    connectivity: Optional[int] = None,
    label: Labels = None,
    spacing: Optional[Spacing] = None,
    affine: Optional[ArrayLike] = None,
    frame: Optional[str] = None,
    unit: str = "",
    nan_as: Optional[float] = None,
    threads: int = 0,
    max_memory: Memory = None,
    progress: Optional[Progress] = None,
) -> Repair:
    """Removes handles and tunnels by changing few voxels, and nothing else; returns a copy.

    Parameters
    ----------
    fill_tunnels, cut_handles, auto : float
        Tunnels to fill, handles to cut, or either, whose loops are shorter than this, in the unit of
        the spacing.
    ids : str, or sequence of str
        Loops of loops(), such as "h3,t7"; numbers alone with `side`, "handle" or "tunnel".
    genus : int
        Removes the shortest until the surface has this genus or less.
    keep_going : bool
        Lists what cannot be removed, as `kept`, and removes the rest.
    volume, iso, inside, topology, connectivity, label, spacing, affine, frame, unit, nan_as, threads,
    max_memory, progress
        As for count().

    Returns
    -------
    Repair
        Its `array` is of the array's type. With `label` the other labels stay: a voxel gets the label
        that most of its 26 neighbours on its new side have, of several the least.

    Raises
    ------
    UsageError, InvalidInput, LimitExceeded
        As count() does; UsageError also for an id that does not exist.
    SelfCheckFailed
        If a loop cannot be removed so, naming it; not with `keep_going`.

    Examples
    --------
    >>> import isoloop, numpy
    >>> ring = numpy.zeros((5, 9, 9), bool)
    >>> ring[1:4, 1:8, 1:8] = True
    >>> ring[:, 3:6, 3:6] = False
    >>> isoloop.count(isoloop.repair(ring, genus=0).array).tunnels
    0
    """
    volume = opened(volume)
    want("side", side or None, ("handle", "tunnel"))
    asked = _core.RepairFlags()
    lengths = ("" if one is None else repr(float(one)) for one in (fill_tunnels, cut_handles, auto))
    asked.fill_tunnels, asked.cut_handles, asked.either = lengths
    asked.genus, asked.side, asked.keep_going = genus, side, keep_going
    asked.ids = ids if isinstance(ids, str) else ",".join(ids)
    made = input_of(volume, label, spacing, affine, frame, unit, nan_as)
    run = _core.repair(
        made,
        level_of(iso, inside, topology, connectivity, False, label),
        asked,
        limits_of(threads, max_memory),
        progress,
    )
    tell_warnings(run, volume)
    if label is None:
        array, changed = _changed(made, *run.changes())
    else:
        all_labels = input_of(volume, None, spacing, affine, frame, unit, nan_as)
        voxels, values, overwritten = run.changes_of_labels(all_labels, labels_of(label))
        array, changed = _changed(all_labels, voxels, values)
        if overwritten > 0:
            warn([f"voxels filled that had another label than 0: {overwritten}"])
    if label is None and numpy.asarray(volume).dtype == bool:
        array = array.view(bool)
    return Repair(run, array, changed)


def _changed(
    made: _core.Input, voxels: NDArray[Any], values: NDArray[Any]
) -> tuple[NDArray[Any], NDArray[numpy.bool_]]:
    """A copy of the voxels with these changes, and where they are."""
    array: NDArray[Any] = made.voxels().copy(order="K")
    changed = numpy.zeros(array.shape, bool)
    along_memory = numpy.unravel_index(voxels, array.transpose(made.axes).shape, order="F")
    array.transpose(made.axes)[along_memory] = values
    changed.transpose(made.axes)[along_memory] = True
    return array, changed


def write(
    volume: AnyVolume,
    path: Path,
    *,
    spacing: Optional[Spacing] = None,
    affine: Optional[ArrayLike] = None,
    frame: Optional[str] = None,
    unit: str = "",
) -> None:
    """Writes a volume to .nrrd, .nii, .nii.gz, .mha, .vti, .npy, .raw or .vdb, whole or not at all.

    The array's first axis is the file's x. Warns of what the format cannot say of the place, of the
    unit and of level sets.

    Parameters
    ----------
    volume : Volume, array or path
        Of read(), generate() or the user; a file is read.
    path : path
        Its extension says the format.
    spacing, affine, frame, unit
        As for count().

    Raises
    ------
    UsageError
        For another extension, and where the format would round the voxels.
    InvalidInput
        If the file cannot be written.

    Examples
    --------
    >>> import isoloop, os, tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     ball = os.path.join(folder, "ball.vdb")
    ...     isoloop.write(isoloop.generate("ball", size=16), ball)
    ...     isoloop.read(ball).level_set
    True
    """
    volume = opened(volume)
    if not isinstance(volume, Volume):
        volume = numpy.asfortranarray(volume)
    made = input_of(volume, None, spacing, affine, frame, unit, None)
    warn(_core.write(made, os.fspath(path)))
