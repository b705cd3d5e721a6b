"""Loops as they are found, and the page that shows them."""

from __future__ import annotations

import html
import os
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple, Optional, Union, overload

import numpy
from numpy.typing import NDArray

from . import _core
from ._errors import UsageError
from ._results import Counts, Floats, SurfaceCounts


class Feature(NamedTuple):
    """How far a handle or tunnel extends; docs/features.md says what each measure means."""

    label: int
    area: float
    depth: float
    thickness: float
    least_girth: float
    mean_girth: float
    axis: Floats
    vertices: NDArray[numpy.uint32]


class Loop:
    """A handle loop or a tunnel loop.

    Attributes
    ----------
    kind : str
        "handle", "tunnel", or "loop" with an open boundary.
    id : int
        1, 2, ... within its kind, by size.
    fix : str
        "cut" or "fill": what takes it away; "none" where neither is known to.
    length, found_length, size : float
        Of all curves; before loops were exchanged for shorter ones; about half the girth there, inf
        where it joins two components. Unit of the spacing.
    component : int
        Of the surface, its place in `parts`.
    center_index, center, center_world : Floats, shape (3,)
        In voxel indices of the array, times the spacing, and in the frame.
    curves, curves_index, curves_world : list of Floats, shape (n, 3)
        Closed curves: the last point joins the first. Index times spacing; voxel indices; the frame.
    certificate : dict
        "inside" and "outside": "trivial", "nontrivial" or "unknown".
    feature : Feature or None
        Where it was asked for.
    """

    def __init__(self, loops: Loops, row: int) -> None:
        columns = loops._columns
        self.kind: str = columns["kind"][row]
        self.fix: str = columns["fix"][row]
        self.id = int(columns["id"][row])
        self.length = float(columns["length"][row])
        self.found_length = float(columns["found_length"][row])
        self.size = float(columns["size"][row])
        self.component = int(columns["component"][row])
        self.center_index: Floats = columns["center_index"][row]
        self.center: Floats = self.center_index * loops.spacing
        self.center_world: Floats = loops.to_world(self.center_index)
        self.curves_index: list[Floats] = loops._curves_of(row)
        self.certificate = _certificate(self.kind, int(columns["certificate"][row]))
        self.feature = loops._feature_of(row)
        self._loops = loops

    @property
    def curves(self) -> list[Floats]:
        """Index times spacing."""
        return [curve * self._loops.spacing for curve in self.curves_index]

    @property
    def curves_world(self) -> list[Floats]:
        """In the frame."""
        return [self._loops.to_world(curve) for curve in self.curves_index]

    def __repr__(self) -> str:
        center = ", ".join(f"{x:.1f}" for x in self.center_index)
        return (
            f"<isoloop.Loop: {self.kind} {self.id}, {self.fix}, length {self.length:.2f}, "
            f"near voxel ({center})>"
        )


def _certificate(kind: str, bits: int) -> dict[str, str]:
    if kind == "loop":
        return {"inside": "unknown", "outside": "unknown"}
    words = ("nontrivial", "trivial")
    return {"inside": words[bits & 1], "outside": words[bits >> 1 & 1]}


class Loops(SurfaceCounts, Sequence[Loop]):
    """A sequence of Loop: handles first, then tunnels, each by size; with the counts and the surface.

    `found` says how many there are before a filter.
    """

    def __init__(self, run: _core.LoopsRun) -> None:
        super().__init__(run)
        self._loops_run = run
        self.found: int = run.found
        self._columns = run.columns()
        self._points, points_of_curve, curves_of_loop = run.curves()
        self._curve_ends = numpy.concatenate([[0], numpy.cumsum(points_of_curve)])
        self._loop_ends = numpy.concatenate([[0], numpy.cumsum(curves_of_loop)])
        self._features = run.feature_columns()

    def __len__(self) -> int:
        return len(self._columns["id"])

    @overload
    def __getitem__(self, row: int) -> Loop: ...

    @overload
    def __getitem__(self, row: slice) -> list[Loop]: ...

    def __getitem__(self, row: Union[int, slice]) -> Union[Loop, list[Loop]]:
        if isinstance(row, slice):
            return [Loop(self, i) for i in range(*row.indices(len(self)))]
        if not -len(self) <= row < len(self):
            raise IndexError(f"there are {len(self)} loops")
        return Loop(self, row % len(self))

    def __iter__(self) -> Iterator[Loop]:
        return (Loop(self, row) for row in range(len(self)))

    def of_kind(self, kind: str) -> list[Loop]:
        """The "handle" loops, the "tunnel" loops, or those of an open boundary ("loop")."""
        return [self[row] for row, its in enumerate(self._columns["kind"]) if its == kind]

    @property
    def handle_loops(self) -> list[Loop]:
        """Those round the material beside a tunnel: cut there, and the handle is gone."""
        return self.of_kind("handle")

    @property
    def tunnel_loops(self) -> list[Loop]:
        """Those round an opening: fill there, and the tunnel is gone."""
        return self.of_kind("tunnel")

    def _curves_of(self, row: int) -> list[Floats]:
        first, last = self._loop_ends[row], self._loop_ends[row + 1]
        ends = self._curve_ends
        return [self._points[ends[c] : ends[c + 1]] for c in range(first, last)]

    def _feature_of(self, row: int) -> Optional[Feature]:
        if len(self._features["label"]) == 0:
            return None
        values: dict[str, Any] = {name: column[row] for name, column in self._features.items()}
        for name in ("area", "depth", "thickness", "least_girth", "mean_girth"):
            values[name] = float(values[name])
        values["label"] = int(values["label"])
        return Feature(**values)

    def to_numpy(self) -> NDArray[Any]:
        """One row for each loop, of the attributes that are numbers or words.

        A structured array: kind, id, fix, length, found_length, size, component, curves (their
        number), center_index, center and center_world, and, where features were asked for, label,
        area, depth, thickness, least_girth, mean_girth and axis.
        """
        names = ["length", "found_length", "size"]
        fields: list[tuple[Any, ...]] = [("kind", "U6"), ("id", "i8"), ("fix", "U4")]
        fields += [(name, "f8") for name in names]
        fields += [("component", "i8"), ("curves", "i8")]
        fields += [(name, "f8", (3,)) for name in ("center_index", "center", "center_world")]
        columns = dict(self._columns, curves=numpy.diff(self._loop_ends))
        columns["center"] = columns["center_index"] * self.spacing
        columns["center_world"] = self.to_world(columns["center_index"])
        if len(self._features["label"]) > 0:
            measures = ["area", "depth", "thickness", "least_girth", "mean_girth"]
            fields += [("label", "i8"), *((name, "f8") for name in measures), ("axis", "f8", (3,))]
            columns.update(self._features)
        table = numpy.empty(len(self), dtype=fields)
        for field in fields:
            table[field[0]] = columns[field[0]]
        return table

    @property
    def labels(self) -> NDArray[Any]:
        """The array's shape: voxels beside a loop's feature have its label, all others 0."""
        if len(self._features["label"]) == 0 and len(self) > 0:
            raise UsageError("labels are those of features; ask for them by isoloop.features()")
        return self._loops_run.labels()

    def table(self, top: int = 0) -> str:
        """What the command prints for people; of the loops the `top` largest, or all of them."""
        return self._loops_run.table(top)

    def to_csv(self) -> str:
        """The text that the command writes for --csv."""
        return self._loops_run.csv()

    def write(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes .json, .csv, or .ply (the surface, and a tube round each loop).

        Raises UsageError for another ending, InvalidInput where it cannot be written.
        """
        name = os.fspath(path)
        if not name.endswith((".json", ".csv", ".ply")) or name.endswith(".mrk.json"):
            raise UsageError(f"{name}: results are written as .json, .csv or .ply")
        self._loops_run.write(name)

    def write_surface(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the surface alone: .ply, .obj, .stl or .vtp, in the frame."""
        self._loops_run.write_surface(os.fspath(path))

    def write_curves(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the loops alone: .vtp, .obj or .mrk.json (3D Slicer), in the frame."""
        self._loops_run.write_curves(os.fspath(path))

    def __repr__(self) -> str:
        shown = f"{len(self)} loops" if len(self) == self.found else f"{len(self)} of {self.found} loops"
        return f"<isoloop.Loops: {shown}, {Counts.__repr__(self)[17:]}"


class Page:
    """A page to look at: one file of HTML, which a notebook shows and save() writes.

    Attributes
    ----------
    html : str
        The page.
    loops : Loops
        What it shows.
    """

    def __init__(self, text: str, loops: Loops) -> None:
        self.html = text
        self.loops = loops

    def save(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the page, which any browser opens without a network."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.html)

    def _repr_html_(self) -> str:
        return (
            '<iframe style="width: 100%; height: 640px; border: 0" '
            f'srcdoc="{html.escape(self.html)}"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<isoloop.Page of {len(self.html.encode()) / 1e6:.1f} MB: {self.loops!r}>"
