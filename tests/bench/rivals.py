#!/usr/bin/python3
"""Runs on one volume what a user might run instead of isoloop, and prints its CPU seconds.

    tests/bench/rivals.py gudhi|skimage|vtk VOLUME.npy ISO

Inside is VALUE >= ISO. CPU seconds are those of the library's own work: neither the interpreter's
start nor reading is counted. Needs python3-gudhi, python3-skimage or python3-vtk9."""

import sys
import time

import numpy


def gudhi_pairs(volume, iso):
    """All persistence pairs of the cubical complex, voxels as top cells."""
    import gudhi
    values = -volume.astype(numpy.float64)
    start = time.process_time()
    complex_ = gudhi.CubicalComplex(dimensions=list(values.shape),
                                    top_dimensional_cells=values.ravel(order="F"))
    complex_.compute_persistence(homology_coeff_field=2, min_persistence=-1.0)
    seconds = time.process_time() - start
    loops = complex_.persistence_intervals_in_dimension(1)
    alive = int(((loops[:, 0] <= -iso) & (loops[:, 1] > -iso)).sum()) if len(loops) else 0
    return seconds, f"{alive} loops alive"


def skimage_euler(volume, iso):
    """The Euler characteristic of the solid alone."""
    from skimage.measure import euler_number
    start = time.process_time()
    euler = euler_number(volume >= iso, connectivity=1)
    return time.process_time() - start, f"euler {euler}"


def vtk_surface(volume, iso):
    """The iso-surface alone, one thread."""
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk
    image = vtk.vtkImageData()
    image.SetDimensions(volume.shape)
    image.GetPointData().SetScalars(numpy_to_vtk(volume.ravel(order="F"), deep=True))
    vtk.vtkSMPTools.Initialize(1)
    surface = vtk.vtkFlyingEdges3D()
    surface.SetInputData(image)
    surface.SetValue(0, iso)
    surface.ComputeNormalsOff()
    start = time.process_time()
    surface.Update()
    return time.process_time() - start, f"{surface.GetOutput().GetNumberOfCells()} triangles"


RIVALS = {"gudhi": gudhi_pairs, "skimage": skimage_euler, "vtk": vtk_surface}


def main():
    if len(sys.argv) != 4 or sys.argv[1] not in RIVALS:
        sys.exit(__doc__)
    volume = numpy.load(sys.argv[2])  # indexed [x, y, z]
    seconds, result = RIVALS[sys.argv[1]](volume, float(sys.argv[3]))
    print(f"{seconds:.3f} {result}")


if __name__ == "__main__":
    main()
