"""Loops over a slice: python3 matplotlib_slice.py [VOLUME ISO] PICTURE.png"""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy

import isoloop

if len(sys.argv) > 2:
    volume, given = isoloop.read(sys.argv[1]), {"iso": float(sys.argv[2])}
else:
    volume, given = isoloop.generate("engine_block", size=128), {}
found = isoloop.loops(volume, **given)
k = int(numpy.median([loop.center_index[2] for loop in found]))
pyplot.imshow(volume.array[:, :, k].T, origin="lower", cmap="gray")
for loop in found:
    colour = "tab:green" if loop.kind == "handle" else "tab:red"
    for curve in loop.curves_index:
        closed = numpy.vstack([curve, curve[:1]])
        pyplot.plot(closed[:, 0], closed[:, 1], colour, linewidth=1)
pyplot.title(f"{found.genus} handles (green) and tunnels (red), slice k = {k}")
pyplot.savefig(sys.argv[-1], dpi=110, bbox_inches="tight")
