"""The functions that look at a volume: count, loops, features, scan, view."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Optional, Union

import numpy
from numpy.typing import ArrayLike

from . import _arrays, _core
from ._arrays import Spacing
from ._errors import UsageError
from ._loops import Loops, Page
from ._options import (
    AnyVolume,
    Iso,
    Labels,
    Memory,
    input_of,
    level_of,
    limits_of,
    opened,
    tell_warnings,
    want,
)
from ._results import Scan, SurfaceCounts
from ._volume import Path, Progress


def count(
    volume: AnyVolume,
    iso: Iso = None,
    *,
    inside: Optional[str] = None,
    topology: Optional[str] = None,
    connectivity: Optional[int] = None,
    label: Labels = None,
    open_boundary: bool = False,
    spacing: Optional[Spacing] = None,
    affine: Optional[ArrayLike] = None,
    frame: Optional[str] = None,
    unit: str = "",
    nan_as: Optional[float] = None,
    threads: int = 0,
    max_memory: Memory = None,
    progress: Optional[Progress] = None,
) -> SurfaceCounts:
    """Counts components, tunnels and cavities of a solid, exactly; finds no loops, so fast.

    Parameters
    ----------
    volume : array of 3 axes, Volume, or path
        Of any integer type, float16 to float64, or bool (a mask). Its memory is read where it lies
        if its numbers are packed, in whatever order of axes; else it is copied, in its type.
    iso : float, (lower, upper), or "auto"
        The solid's voxels are those from this value on, or between the two; "auto" takes what scan()
        proposes, and `notes` say so. Booleans, masks of `label` and level sets of files need none.
    inside : {"above", "below"}
        "below": the solid's voxels are those up to `iso`.
    topology : {"trilinear", "simple"}
        How the surface runs within the cubes between voxels.
    connectivity : {6, 18, 26}
        Of a mask, in place of `topology`: across what its voxels are joined.
    label : int or sequence of ints
        Of a label map: these labels are the solid.
    open_boundary : bool
        Lets the surface end at the border of the array; its sides are not told apart then.
    spacing : float or 3 floats
        Length per voxel along each axis of the array.
    affine : (4, 4)
        In its place: leads from indices of the array to the world, as nibabel has it. Axes must be
        at right angles. `frame`: "ras", "lps" or "world", for reports.
    unit : str
        Of `spacing` or `affine`, for reports.
    nan_as : float
        Takes the place of NaN, which is refused else.
    threads : int
        At most; 0: one for each core. Results are the same for any number.
    max_memory : int or str
        Most bytes beside the array, such as "4G"; by default 80 % of what is free.
    progress : callable
        Called with a stage (str) and the share done (0 to 1); may raise, which ends the run.

    Returns
    -------
    SurfaceCounts
        betti, genus and so on, and the surface.

    Raises
    ------
    UsageError
        For arguments that make no sense for the array, such as none for `iso`.
    InvalidInput
        For NaN among the voxels, and an affine with sheared axes.
    LimitExceeded
        Before more memory is taken than allowed.

    Notes
    -----
    What is connected is decided without rounding (docs/topology.md). Homology after Dey, Li, Sun and
    Cohen-Steiner, Computing geometry-aware handle and tunnel loops in 3D models, SIGGRAPH 2008.

    Examples
    --------
    >>> import isoloop, numpy
    >>> ring = numpy.zeros((5, 9, 9), bool)
    >>> ring[1:4, 1:8, 1:8] = True
    >>> ring[:, 3:6, 3:6] = False
    >>> isoloop.count(ring)
    <isoloop.Counts: 1 components, 1 tunnels, 0 cavities>
    """
    volume = opened(volume, open_boundary)
    run = _core.count(
        input_of(volume, label, spacing, affine, frame, unit, nan_as),
        level_of(iso, inside, topology, connectivity, open_boundary, label),
        limits_of(threads, max_memory),
        progress,
    )
    tell_warnings(run, volume)
    return SurfaceCounts(run)


def _asked(
    level: _core.LevelFlags,
    geodesic: str,
    engine: str,
    refine: Optional[str],
    tighten: Optional[str],
    cells: tuple[str, Optional[int]],
    side: str,
    sizes: tuple[float, float],
) -> _core.LoopsInput:
    want("geodesic", geodesic, ("hierarchy", "exact"))
    want("engine", engine, ("dual", "pair"))
    want("refine", refine, ("none", "1", "2", "both"))
    want("tighten", tighten, ("none", "basis", "curve"))
    want("complex", cells[0], ("auto", "grid", "octree"))
    if cells[1] is not None and cells[1] not in (0, 1, 2):
        raise UsageError(f"grading= must be 0, 1 or 2, not {cells[1]!r}")
    if cells[1] is not None and cells[0] == "grid":
        raise UsageError('grading= does not go with complex="grid"')
    want("side", side, ("handle", "tunnel", "both"))
    if level.open_boundary and side != "both":
        raise UsageError("side= does not go with open_boundary=, which tells no sides apart")
    if not sizes[0] <= sizes[1]:
        raise UsageError("min_size= and max_size= leave nothing to report")
    asked = _core.LoopsInput()
    asked.level = level
    engine_flags = _core.EngineFlags()
    engine_flags.engine, engine_flags.refine = engine, refine or ""
    engine_flags.tighten = tighten or ""
    engine_flags.complex, engine_flags.grading = cells
    asked.engine = engine_flags
    asked.geodesic = geodesic
    filters = _core.LoopFilter()
    filters.min_size, filters.max_size = sizes
    filters.handles, filters.tunnels = side != "tunnel", side != "handle"
    asked.filter = filters
    return asked


def loops(
    volume: AnyVolume,
    iso: Iso = None,
    *,
    inside: Optional[str] = None,
    topology: Optional[str] = None,
    connectivity: Optional[int] = None,
    label: Labels = None,
    open_boundary: bool = False,
    geodesic: str = "hierarchy",
    tighten: Optional[str] = None,
    engine: str = "dual",
    refine: Optional[str] = None,
    complex: str = "auto",
    grading: Optional[int] = None,
    side: str = "both",
    min_size: float = 0.0,
    max_size: float = float("inf"),
    feature_ratio: Optional[float] = None,
    spacing: Optional[Spacing] = None,
    affine: Optional[ArrayLike] = None,
    frame: Optional[str] = None,
    unit: str = "",
    nan_as: Optional[float] = None,
    threads: int = 0,
    max_memory: Memory = None,
    progress: Optional[Progress] = None,
) -> Loops:
    """Finds, proves and measures every handle loop and tunnel loop of a solid.

    Parameters
    ----------
    volume, iso, inside, topology, connectivity, label, open_boundary
        As for count().
    geodesic : {"hierarchy", "exact"}
        How sizes are measured (docs/sizes.md).
    tighten : {"none", "basis", "curve"}
        Loops as found, exchanged for shorter ones, or also drawn across triangles. By default
        "basis"; with engine="pair" or an open boundary, which takes no other, "none".
    engine : {"dual", "pair"}
        "pair" is the paper's algorithm (docs/paper.md). `refine`, for it alone, says with which of
        its refinements: "none", "1", "2" or "both", the default.
    complex : {"auto", "grid", "octree"}
        The cells off the surface: one for each cube of voxels, or larger ones the farther they
        are from it (docs/octree.md). `grading`, of the octree: how many of its own widths a cell
        keeps from the surface, 0, 1 (the default) or 2.
    side : {"both", "handle", "tunnel"}
        Which kind to report; `min_size` and `max_size`: which sizes, in the unit of the spacing.
    feature_ratio : float
        Also says how far each handle and tunnel extends, as features() does.
    spacing, affine, frame, unit, nan_as, threads, max_memory, progress
        As for count().

    Returns
    -------
    Loops
        A sequence of Loop. For arrays whose memory runs in another order of axes, loops of equal
        length may be exchanged; their number and kinds never are.

    Raises
    ------
    UsageError, InvalidInput, LimitExceeded
        As count() does.
    SelfCheckFailed
        If any proof fails: no unproved loop is ever returned.

    Examples
    --------
    >>> import isoloop
    >>> found = isoloop.loops(isoloop.generate("torus", size=32))
    >>> [loop.kind for loop in found]
    ['handle', 'tunnel']
    """
    volume = opened(volume, open_boundary)
    level = level_of(iso, inside, topology, connectivity, open_boundary, label)
    cells = (complex, grading)
    asked = _asked(level, geodesic, engine, refine, tighten, cells, side, (min_size, max_size))
    if feature_ratio is not None:
        if open_boundary:
            raise UsageError("features do not go with open_boundary=")
        if not 1.0 <= feature_ratio < float("inf"):
            raise UsageError("feature_ratio= must be a number from 1 on")
        asked.set_feature_ratio(feature_ratio)
    run = _core.loops(
        input_of(volume, label, spacing, affine, frame, unit, nan_as),
        asked,
        limits_of(threads, max_memory),
        progress,
    )
    tell_warnings(run, volume)
    return Loops(run)


def features(volume: AnyVolume, iso: Iso = None, *, feature_ratio: float = 1.5, **given: Any) -> Loops:
    """Finds the loops, and how far each handle and tunnel extends.

    Parameters
    ----------
    volume, iso, **given
        As for loops().
    feature_ratio : float
        A feature ends where its girth exceeds this times its loop's length; 1.5 is half a radius
        beyond the mouth of a bore. At least 1.

    Returns
    -------
    Loops
        Each Loop has a `feature`; `labels` is an array of their voxels.

    Raises
    ------
    UsageError, InvalidInput, LimitExceeded, SelfCheckFailed
        As loops() does.
    """
    return loops(volume, iso, feature_ratio=feature_ratio, **given)


def scan(
    volume: AnyVolume,
    *,
    values: Optional[int] = None,
    from_: Optional[float] = None,
    to: Optional[float] = None,
    ignore_below: Union[None, int, str] = None,
    inside: Optional[str] = None,
    topology: Optional[str] = None,
    spacing: Optional[Spacing] = None,
    affine: Optional[ArrayLike] = None,
    frame: Optional[str] = None,
    unit: str = "",
    nan_as: Optional[float] = None,
    threads: int = 0,
    max_memory: Memory = None,
    progress: Optional[Progress] = None,
) -> Scan:
    """Counts components, tunnels and cavities at many iso values at once, and proposes one.

    Parameters
    ----------
    values : int
        How many iso values; by default 256, or all integers of a small range.
    from_, to : float
        The least and the largest of them; by default those of the voxels.
    ignore_below : int or str
        Parts of fewer voxels, or of less than a share of the largest ("0.1%"), do not break a
        plateau. None: 0, and where no plateau is stable then, the first of 64, 512 and 4096 with
        which one is, as long as that is at most a thousandth of the voxels; if none will do, 0.
    volume, inside, topology, spacing, affine, frame, unit, nan_as, threads, max_memory, progress
        As for count().

    Returns
    -------
    Scan
        In a notebook it shows its curves.

    Raises
    ------
    UsageError, InvalidInput, LimitExceeded
        As count() does.
    """
    volume = opened(volume)
    scan_range = _core.ScanRange()
    scan_range.values, scan_range.least, scan_range.most = values, from_, to
    run = _core.scan(
        input_of(volume, None, spacing, affine, frame, unit, nan_as),
        level_of(None, inside, topology, None, False, None),
        scan_range,
        "" if ignore_below is None else str(ignore_below),
        limits_of(threads, max_memory),
        progress,
    )
    tell_warnings(run, volume)
    return Scan(run)


def view(
    volume: AnyVolume,
    iso: Iso = None,
    output: Optional[Path] = None,
    *,
    triangles: int = 120_000,
    feature_ratio: float = 1.5,
    inside: Optional[str] = None,
    topology: Optional[str] = None,
    connectivity: Optional[int] = None,
    label: Labels = None,
    open_boundary: bool = False,
    geodesic: str = "hierarchy",
    side: str = "both",
    spacing: Optional[Spacing] = None,
    affine: Optional[ArrayLike] = None,
    frame: Optional[str] = None,
    unit: str = "",
    nan_as: Optional[float] = None,
    threads: int = 0,
    max_memory: Memory = None,
    progress: Optional[Progress] = None,
) -> Page:
    """Finds the loops and makes a page to look at them, which a notebook shows.

    Parameters
    ----------
    output : path
        Where to write the page; None: nowhere, it is text in memory.
    triangles : int
        Most triangles of the surface as it is drawn.
    volume, iso, ...
        As for loops().

    Returns
    -------
    Page

    Raises
    ------
    UsageError, InvalidInput, LimitExceeded, SelfCheckFailed
        As loops() does.
    """
    if triangles < 1:
        raise UsageError("triangles= must be at least 1")
    volume = opened(volume, open_boundary)
    level = level_of(iso, inside, topology, connectivity, open_boundary, label)
    cells = ("auto", None)
    asked = _asked(level, geodesic, "dual", None, None, cells, side, (0.0, float("inf")))
    asked.with_scan = asked.features_may_lack = True
    asked.set_feature_ratio(feature_ratio)
    made = input_of(volume, label, spacing, affine, frame, unit, nan_as)
    run = _core.loops(made, asked, limits_of(threads, max_memory), progress)
    tell_warnings(run, volume)
    drawn = _arrays.input_of(numpy.asfortranarray(made.voxels()))
    page = Page(_core.page(run, drawn, triangles), Loops(run))
    if output is not None:
        page.save(output)
    return page
