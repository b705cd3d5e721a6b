"""What runs find, but for loops and repairs: small classes with attributes, tables for NumPy, and
the command's JSON."""

from __future__ import annotations

import json
from typing import Any, NamedTuple, Optional, Union

import numpy
from numpy.typing import NDArray

from . import _core

Floats = NDArray[numpy.float64]


class Betti(NamedTuple):
    """Of the solid: separate pieces, ways through, and hollows closed off within."""

    components: int
    tunnels: int
    cavities: int


class Surface(NamedTuple):
    """A closed mesh (with an open boundary it may end at the border of the volume)."""

    vertices: NDArray[numpy.float32]
    """Shape (n, 3)."""
    triangles: NDArray[numpy.uint32]
    """Shape (m, 3): corners in `vertices`, counter-clockwise seen from outside."""


class SurfaceComponent(NamedTuple):
    """One connected part of the surface; `bounds` is "solid", "cavity" or "unknown"."""

    vertices: int
    triangles: int
    euler: int
    genus: int
    bounds: str
    borders: int


class Counts:
    """Counts of the solid and of its surface.

    Attributes
    ----------
    betti : Betti
        components, tunnels, cavities; also attributes of their own.
    vertices, triangles, euler, genus : int
        Of the surface, all its components together.
    parts : list of SurfaceComponent
        Of the surface.
    """

    def __init__(self, counts: dict[str, Any]) -> None:
        self.betti = Betti(*counts["betti"])
        self.vertices: int = counts["vertices"]
        self.triangles: int = counts["triangles"]
        self.euler: int = counts["euler"]
        self.genus: int = counts["genus"]
        self.parts = [SurfaceComponent(**part) for part in counts["components"]]

    @property
    def components(self) -> int:
        """Separate pieces of the solid."""
        return self.betti.components

    @property
    def tunnels(self) -> int:
        """Ways through the solid, as in a ring."""
        return self.betti.tunnels

    @property
    def cavities(self) -> int:
        """Hollows closed off inside the solid."""
        return self.betti.cavities

    def __repr__(self) -> str:
        return (
            f"<isoloop.Counts: {self.components} components, {self.tunnels} tunnels, "
            f"{self.cavities} cavities>"
        )


class Placed:
    """What all results have: the frame that they lie in, and the command's JSON.

    Attributes
    ----------
    spacing : Floats, shape (3,)
        Length per voxel along each axis of the array.
    affine : Floats, shape (4, 4)
        Leads from indices of the array to the frame.
    frame, unit, iso, inside, notes, warnings
        As in the JSON; `inside` such as "f >= 70".
    """

    def __init__(self, run: Union[_core.CountRun, _core.ScanRun, _core.RepairRun]) -> None:
        self._any_run = run
        self.spacing: Floats = numpy.array(run.spacing)
        self.affine: Floats = numpy.array(run.affine)
        self.frame: str = run.frame
        self.unit: str = run.unit
        self.iso: float = run.iso
        self.inside: str = run.inside
        self.notes: list[str] = run.notes
        self.warnings: list[str] = run.warnings

    def to_json(self) -> str:
        """The text that the command writes for --json."""
        return self._any_run.json()

    def to_dict(self) -> dict[str, Any]:
        """The same, read; docs/manual.md has the fields."""
        fields: dict[str, Any] = json.loads(self.to_json())
        return fields

    def to_world(self, indices: Any) -> Floats:
        """Points given in voxel indices of the array, shape (..., 3), in the frame."""
        world: Floats = numpy.asarray(indices, float) @ self.affine[:3, :3].T + self.affine[:3, 3]
        return world

    def table(self) -> str:
        """What the command prints for people."""
        return self._any_run.table()

    def summary(self) -> str:
        """One line of NAME=VALUE, as the command prints it for --summary."""
        return self._any_run.summary().rstrip("\n")

    def __str__(self) -> str:
        return self.table().rstrip("\n")


class SurfaceCounts(Counts, Placed):
    """What count() finds: the counts, and the surface that they are read off."""

    def __init__(self, run: _core.CountRun) -> None:
        Counts.__init__(self, run.counts)
        Placed.__init__(self, run)
        self._run = run

    def surface(self, world: bool = False) -> Surface:
        """The mesh: vertices in index times spacing, or in the frame."""
        points, triangles = self._run.points(), self._run.triangles()
        if not world:
            return Surface((points * self.spacing).astype(numpy.float32), triangles)
        if self._run.mirrors:
            triangles = triangles[:, [0, 2, 1]]
        return Surface(self.to_world(points).astype(numpy.float32), triangles)

    __str__ = Placed.__str__


class Plateau(NamedTuple):
    """Iso values from `least` to `most` between which all counts are the same.

    `betti` has these counts, without what the scan sets aside; `voxels` change sides between the
    two values.
    """

    least: float
    most: float
    width: float
    voxels: int
    meaningful: bool
    betti: Betti


class Scan(Placed):
    """The counts at many iso values.

    Attributes
    ----------
    rows : structured array
        One row for each iso value: iso, b0, b1, b2, euler, genus, inside_voxels, and large_b0,
        large_b1, large_b2 without what is set aside.
    plateaus : list of Plateau
        In the order of the rows.
    proposed : float or None
        The iso value to look at first.
    ignored_below : int
        Voxels: what is set aside, as components of less.
    """

    def __init__(self, run: _core.ScanRun) -> None:
        super().__init__(run)
        self._run = run
        columns = run.columns()
        self.rows = numpy.empty(
            len(columns["iso"]), dtype=[(name, column.dtype) for name, column in columns.items()]
        )
        for name, column in columns.items():
            self.rows[name] = column
        self.plateaus = [self._plateau(*plateau) for plateau in run.plateaus()]
        self.ignored_below: int = run.ignored_below
        self.proposed: Optional[float] = (
            None if run.proposed is None else float(self.rows["iso"][run.proposed])
        )

    def _plateau(
        self, first: int, last: int, width: float, voxels: int, meaningful: bool
    ) -> Plateau:
        row = self.rows[first]
        betti = Betti(int(row["large_b0"]), int(row["large_b1"]), int(row["large_b2"]))
        most = float(self.rows["iso"][last])
        return Plateau(float(row["iso"]), most, width, voxels, meaningful, betti)

    def to_numpy(self) -> NDArray[Any]:
        """The rows."""
        return self.rows

    def to_csv(self) -> str:
        """The text that the command writes for --csv."""
        return self._run.csv()

    def to_svg(self) -> str:
        """The counts as curves over the iso value."""
        return self._run.svg()

    def _repr_html_(self) -> str:
        return self.to_svg()

    def __repr__(self) -> str:
        return f"<isoloop.Scan: {len(self.rows)} iso values, proposed {self.proposed}>"
