"""isoloop: every handle and every tunnel of a solid given as voxels, proved.

>>> import isoloop, numpy
>>> print(isoloop.count(numpy.ones((3, 3, 3), bool)).betti)
Betti(components=1, tunnels=0, cavities=0)

`count`, `loops`, `features`, `scan`, `repair` and `view` take arrays, volumes of `read` and
`generate`, or paths. Coordinates come back in the array's own order of axes: `center_index` in voxels,
`center` and `curves` in voxels times `spacing`, `center_world` and `curves_world` through `affine`.
docs/python.md is the manual.
"""

from ._core import version as __version__
from ._errors import (
    Error,
    InvalidInput,
    IsoloopWarning,
    LimitExceeded,
    SelfCheckFailed,
    UsageError,
)
from ._changes import repair, write
from ._loops import Feature, Loop, Loops, Page
from ._repair import KeptLoop, Removal, Repair
from ._results import (
    Betti,
    Counts,
    Plateau,
    Scan,
    Surface,
    SurfaceComponent,
    SurfaceCounts,
)
from ._runs import count, features, loops, scan, view
from ._volume import Volume, generate, read, shapes

__all__ = [
    "Betti",
    "Counts",
    "Error",
    "Feature",
    "InvalidInput",
    "IsoloopWarning",
    "LimitExceeded",
    "Loop",
    "Loops",
    "Page",
    "Plateau",
    "KeptLoop",
    "Removal",
    "Repair",
    "Scan",
    "SelfCheckFailed",
    "Surface",
    "SurfaceComponent",
    "SurfaceCounts",
    "UsageError",
    "Volume",
    "__version__",
    "count",
    "features",
    "generate",
    "loops",
    "read",
    "repair",
    "scan",
    "shapes",
    "view",
    "write",
]
