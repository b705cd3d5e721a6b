"""The surface and its loops as VTK polydata, and a picture: python3 vtk_surface.py [PICTURE.png]"""

import sys

import numpy
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, draws
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

import isoloop


def polydata(points, cells, closed_lines=False):
    """Triangles (m, 3), or closed lines, on points (n, 3)."""
    data, vtk_points, vtk_cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    vtk_points.SetData(numpy_to_vtk(numpy.ascontiguousarray(points, float), deep=True))
    sizes = numpy.cumsum([0] + [len(cell) for cell in cells])
    vtk_cells.SetData(
        numpy_to_vtkIdTypeArray(sizes.astype("i8"), deep=True),
        numpy_to_vtkIdTypeArray(numpy.concatenate(cells).astype("i8"), deep=True),
    )
    data.SetPoints(vtk_points)
    data.SetLines(vtk_cells) if closed_lines else data.SetPolys(vtk_cells)
    return data


def lines_of(loops):
    curves = [curve for loop in loops for curve in loop.curves_world]
    starts = numpy.cumsum([0] + [len(curve) for curve in curves])
    cells = [numpy.r_[a:b, a] for a, b in zip(starts, starts[1:])]
    return polydata(numpy.concatenate(curves), cells, closed_lines=True)


found = isoloop.loops(isoloop.generate("plate", size=64, holes=3))
vertices, triangles = found.surface(world=True)
surface = polydata(vertices, triangles)
print(surface.GetNumberOfPolys(), "triangles,", lines_of(found).GetNumberOfLines(), "curves")

if len(sys.argv) > 1:
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for data, colour, opacity in [
        (surface, (0.6, 0.6, 0.65), 0.35),
        (lines_of(found.handle_loops), (0.1, 0.6, 0.2), 1),
        (lines_of(found.tunnel_loops), (0.8, 0.1, 0.1), 1),
    ]:
        mapper, actor = vtkPolyDataMapper(), vtkActor()
        mapper.SetInputData(data)
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(colour)
        actor.GetProperty().SetOpacity(opacity)
        actor.GetProperty().SetLineWidth(4)
        renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.AddRenderer(renderer)
    window.SetSize(800, 600)
    window.Render()
    grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grab.SetInput(window)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(sys.argv[1])
    writer.Write()
