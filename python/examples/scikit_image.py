"""Tunnels of a threshold that scikit-image chooses, as a table: python3 scikit_image.py"""

import numpy
from skimage.filters import threshold_otsu

import isoloop

volume = isoloop.generate("plate", size=64, holes=3)
picture = numpy.ascontiguousarray(-volume.array.transpose())  # (z, y, x), bright where solid
mask = picture > threshold_otsu(picture)
found = isoloop.loops(mask, connectivity=26, spacing=(2.0, 0.5, 0.5))  # mm along z, y, x
print(found.betti)
for tunnel in found.tunnel_loops:
    z, y, x = tunnel.center_index.round().astype(int)
    print(f"tunnel {tunnel.id}: {tunnel.length:.1f} mm round, near mask[{z}, {y}, {x}]")
