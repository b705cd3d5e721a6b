"""What a repair did."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy
from numpy.typing import NDArray

from . import _core
from ._results import Counts, Floats, Placed


class Removal(NamedTuple):
    """One handle or tunnel that was removed.

    `kind` and `id` name the loop, in the `round` of analysis (1: of the array as it came); `along`
    the one that was cut along or filled. `length` in the unit of the spacing.
    """

    kind: str
    id: int
    round: int
    length: float
    action: str
    along: tuple[str, int]
    voxels: int
    center_index: Floats


class KeptLoop(NamedTuple):
    """A loop that was asked for and could not be removed; fields as those of Removal."""

    kind: str
    id: int
    round: int
    length: float
    center_index: Floats


class Repair(Placed):
    """Voxels that were changed so that handles and tunnels go, and nothing else does.

    Attributes
    ----------
    array : numpy.ndarray
        A copy of the array with the changes.
    changed : bool array
        Of its shape: where they are.
    removals : list of Removal
    kept : list of KeptLoop
        With `keep_going`: what could not be removed.
    before, after : Counts
    added_voxels, removed_voxels, shifted_voxels : int
        Now inside; now outside; of another value on the side that they were on, which is rare.
    """

    def __init__(
        self, run: _core.RepairRun, array: NDArray[Any], changed: NDArray[numpy.bool_]
    ) -> None:
        super().__init__(run)
        self._repair_run = run
        self.before = Counts(run.before)
        self.after = Counts(run.after)
        self.removals = [Removal(**removal) for removal in run.removals()]
        self.kept = [KeptLoop(**kept) for kept in run.kept()]
        self.added_voxels: int = run.added_voxels
        self.removed_voxels: int = run.removed_voxels
        self.shifted_voxels = int(changed.sum()) - run.added_voxels - run.removed_voxels
        self.array = array
        self.changed = changed

    def table(self, top: int = 0) -> str:
        """What the command prints for people; of the loops the `top` longest, or all of them."""
        return self._repair_run.table(top)

    def __repr__(self) -> str:
        return (
            f"<isoloop.Repair: {len(self.removals)} removed, {self.before.tunnels} tunnels before, "
            f"{self.after.tunnels} after, {int(self.changed.sum())} voxels changed>"
        )
