"""Volumes of files and built-in solids."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterator, Sequence
from typing import Any, Optional, Union

import numpy
from numpy.typing import NDArray

from . import _core
from ._errors import IsoloopWarning, UsageError, in_keywords

Progress = Callable[[str, float], Any]
Path = Union[str, "os.PathLike[str]"]


class Volume:
    """Voxels with all that is known of where they lie; `array, affine = volume` takes both.

    Attributes
    ----------
    array : numpy.ndarray, shape (i, j, k)
        The voxels in their stored type, first axis fastest; not a copy.
    affine : numpy.ndarray, shape (4, 4)
        Leads from (i, j, k, 1) to the frame, in `unit`.
    spacing : tuple of 3 floats
        Length per voxel along each axis, in `unit`.
    unit : str
        "mm" and the like; empty where the file does not state it.
    frame : str
        "RAS", "LPS", "world" or, where the file says nothing of a place, "index".
    level_set, mask : bool
        A signed distance (`iso` defaults to 0, `inside` to "below"); 0 and 1 (to 0.5).
    betti : tuple of 3 ints, or None
        Of a built-in solid: components, tunnels and cavities as known by construction.
    file, name : str
        The path; of the grid or array within it, or empty.
    notes, warnings : list of str
        How it was read, and what to look at.
    """

    def __init__(self, held: _core.HeldVolume, betti: Optional[tuple[int, int, int]] = None) -> None:
        self._held = held
        self.betti = betti
        self.array: NDArray[Any] = held.array()
        self.affine: NDArray[numpy.float64] = numpy.array(held.affine())
        self.file: str = held.file
        self.name: str = held.name
        self.spacing: tuple[float, ...] = tuple(held.spacing)
        self.unit: str = held.unit
        self.frame: str = held.frame
        self.level_set: bool = held.level_set
        self.mask: bool = held.mask
        self.notes: list[str] = held.notes
        self.warnings: list[str] = held.warnings

    @property
    def shape(self) -> tuple[int, ...]:
        """Voxels along each axis."""
        return self.array.shape

    @property
    def dtype(self) -> numpy.dtype[Any]:
        """The stored type."""
        return self.array.dtype

    def __array__(self, dtype: Any = None) -> NDArray[Any]:
        return self.array if dtype is None else self.array.astype(dtype)

    def __iter__(self) -> Iterator[NDArray[Any]]:
        return iter((self.array, self.affine))

    def __repr__(self) -> str:
        size = " x ".join(str(n) for n in self.shape)
        return f"<isoloop.Volume {self.file or 'array'}: {size} {self.dtype}, frame {self.frame}>"


def warn(sentences: list[str]) -> None:
    """Each as a warning at the place where the user called."""
    for sentence in sentences:
        warnings.warn(in_keywords(sentence), IsoloopWarning, stacklevel=4)


def _words(values: Any) -> str:
    """Numbers as they are typed: "1" or "1 2 3"."""
    if isinstance(values, str):
        return values
    return " ".join(str(value) for value in numpy.atleast_1d(values).tolist())


def _crop_text(crop: Union[str, Sequence[slice]]) -> str:
    if isinstance(crop, str):
        return crop
    texts = []
    for part in crop:
        if not isinstance(part, slice) or part.step not in (None, 1):
            raise UsageError("crop= wants three slices without a step, or text such as '10:20,:,5:'")
        begin = "" if part.start is None else str(part.start)
        texts.append(begin + ":" + ("" if part.stop is None else str(part.stop)))
    return ",".join(texts)


def memory_text(max_memory: Union[None, int, str]) -> str:
    """As the command takes it: "4G", or bytes."""
    return "" if max_memory is None else str(max_memory)


def read(
    path: Path,
    *,
    dims: Union[None, str, Sequence[int]] = None,
    type: Optional[str] = None,
    endian: Optional[str] = None,
    skip: Optional[int] = None,
    spacing: Union[None, float, Sequence[float]] = None,
    grid: str = "",
    frame: Optional[int] = None,
    channel: Optional[int] = None,
    series: str = "",
    affine: str = "",
    label: Union[None, int, Sequence[int]] = None,
    world: str = "",
    nan_as: Optional[float] = None,
    crop: Union[None, str, Sequence[slice]] = None,
    voxel: Optional[float] = None,
    resolution: Union[None, int, str] = None,
    open_boundary: bool = False,
    max_memory: Union[None, int, str] = None,
    max_voxels: Optional[int] = None,
    progress: Optional[Progress] = None,
) -> Volume:
    """Reads a volume, or turns a mesh into one, as the command does.

    Formats: raw, OpenVDB, NIfTI, NRRD, MetaImage, NumPy, VTK image data, DICOM, TIFF, PNG and BMP
    slices; STL, PLY, OBJ and OFF meshes. docs/manual.md explains each keyword as the flag of its
    name.

    Parameters
    ----------
    path : str or path
        A file, or a folder of slices.
    dims, type, endian, skip
        Of a raw file whose name does not say them: voxels along each axis, "u8" to "f64", "little"
        or "big", bytes before the first voxel.
    spacing : float or 3 floats
        Length per voxel along each axis, in a unit of yours; replaces what the file says of its
        place, and its unit with it. For raw files 1 by default.
    grid, frame, channel, series
        Which of several in a file or folder.
    affine : {"sform", "qform"}
        Which of a NIfTI file's two maps.
    label : int or sequence of ints
        These labels become 1, all others 0.
    world : {"ras", "lps"}
        The frame to turn to.
    nan_as : float
        The value that takes the place of NaN.
    crop : three slices, or text
        The part to keep.
    voxel, resolution
        Of a mesh: the length of voxels, in its unit; or their number along its longest side, or
        "auto", which doubles it from 64 on until voxels and mesh have the same counts.
    open_boundary : bool
        Leaves the layer of background round an OpenVDB grid away, as runs with an open boundary ask.
    max_memory : int or str
        Most bytes of voxels, such as "4G"; by default 80 % of what is free. `max_voxels`: most
        voxels.
    progress : callable
        Called with a stage and the share done.

    Raises
    ------
    UsageError
        For keywords that do not fit the file.
    InvalidInput
        For a file that is missing, damaged, not supported, or that holds NaN.
    LimitExceeded
        For more voxels than allowed.
    """
    flags = _core.VolumeFlags()
    flags.file = os.fspath(path)
    _checked_word("endian", endian, ("little", "big"))
    _checked_word("affine", affine, ("sform", "qform"))
    _checked_word("world", world, ("ras", "lps"))
    texts = {
        "dims": _words(dims) if dims is not None else "",
        "type": type or "",
        "endian": endian or "",
        "spacing": _words(spacing) if spacing is not None else "",
        "grid": grid,
        "series": series,
        "affine": affine,
        "label": ",".join(_words(label).split()) if label is not None else "",
        "world": world,
        "crop": _crop_text(crop) if crop is not None else "",
        "max_memory": memory_text(max_memory),
    }
    for name, text in texts.items():
        setattr(flags, name, text)
    flags.skip, flags.frame, flags.channel, flags.nan_as = skip, frame, channel, nan_as
    flags.max_voxels = max_voxels or 0
    if voxel is not None:
        flags.set_voxel(voxel)
    if resolution == "auto":
        flags.set_automatic()
    elif resolution is not None:
        flags.set_resolution(int(resolution))
    volume = Volume(_core.read(flags, open_boundary, progress))
    warn(volume.warnings)
    return volume


def _checked_word(name: str, word: Optional[str], words: Sequence[str]) -> None:
    if word and word not in words:
        raise UsageError(f"{name}={word!r} is none of {', '.join(words)}")


def shapes() -> list[str]:
    """The names that generate() takes."""
    return _core.shape_names()


def generate(shape: str, *, size: int = 128, holes: int = 3, cells: int = 3) -> Volume:
    """A solid of known topology, as a signed distance in voxels (float32; the inside is below 0).

    Parameters
    ----------
    shape : str
        One of shapes().
    size : int
        Voxels along the longest axis.
    holes, cells : int
        Through a plate; of a lattice along each axis.

    Raises
    ------
    UsageError
        For an unknown name, and a size at which walls would be too thin.
    LimitExceeded
        For more voxels than there is memory.

    Examples
    --------
    >>> import isoloop
    >>> plate = isoloop.generate("plate", size=48, holes=3)
    >>> plate.betti  # components, tunnels, cavities
    (1, 3, 0)
    """
    held, betti = _core.generate(shape, size, holes, cells, 0)
    return Volume(held, betti)
