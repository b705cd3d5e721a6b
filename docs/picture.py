"""Draws what `isoloop loops VOLUME --ply SURFACE.ply --json LOOPS.json` wrote.

usage: picture.py SURFACE.ply LOOPS.json OUT.png AZIMUTH ELEVATION

The camera stands AZIMUTH degrees from the x axis towards y, ELEVATION degrees above; z is up.
Needs Debian's python3-vtk9 and an X display.
"""

import json
import math
import sys

import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the renderer)
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersHybrid import vtkDepthSortPolyData
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkFiltersExtraction import vtkExtractCells
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

WIDTH, HEIGHT = 840, 640  # pixels
TUBE_RADIUS = 0.0065  # share of the surface's extent
ZOOM = 1.34
SHIFT = (-0.02, -0.12)  # of the picture, in shares of half its extent
SURFACE_COLOUR = (0.45, 0.47, 0.5)
SURFACE_OPACITY = 0.16
COLOURS = {"handle": (0.0, 0.55, 0.15), "tunnel": (0.86, 0.08, 0.08)}


def actor_of(source, colour, opacity):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def surface_of(ply, triangles):
    """The iso-surface: the first triangles of the mesh, those after it are the loops' tubes."""
    reader = vtkPLYReader()
    reader.SetFileName(ply)
    cells = vtkExtractCells()
    cells.SetInputConnection(reader.GetOutputPort())
    cells.AddCellRange(0, triangles - 1)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(cells.GetOutputPort())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(surface.GetOutputPort())
    normals.SplittingOff()
    return normals


def tubes_of(loops, kind, radius):
    points, lines = vtkPoints(), vtkCellArray()
    for loop in loops:
        if loop["kind"] != kind:
            continue
        for curve in loop["curves"]:
            ids = [points.InsertNextPoint(*point) for point in curve]
            lines.InsertNextCell(len(ids) + 1)
            for point_id in ids + ids[:1]:
                lines.InsertCellPoint(point_id)
    polylines = vtkPolyData()
    polylines.SetPoints(points)
    polylines.SetLines(lines)
    tubes = vtkTubeFilter()
    tubes.SetInputData(polylines)
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(12)
    return tubes


def main():
    ply, loops_file, out, azimuth, elevation = sys.argv[1:]
    with open(loops_file, encoding="utf-8") as file:
        report = json.load(file)
    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    surface = surface_of(ply, report["surface"]["triangles"])
    surface.Update()
    bounds = surface.GetOutput().GetBounds()
    extent = max(bounds[2 * axis + 1] - bounds[2 * axis] for axis in range(3))
    for kind, colour in COLOURS.items():
        renderer.AddActor(actor_of(tubes_of(report["loops"], kind, TUBE_RADIUS * extent), colour, 1))

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(2 * WIDTH, 2 * HEIGHT)  # shrunk below: smooth edges
    window.AddRenderer(renderer)

    around, above = math.radians(float(azimuth)), math.radians(float(elevation))
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(
        math.cos(above) * math.cos(around), math.cos(above) * math.sin(around), math.sin(above)
    )
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(12)
    renderer.ResetCamera(bounds)
    camera.Zoom(ZOOM)
    camera.SetWindowCenter(*SHIFT)
    back_to_front = vtkDepthSortPolyData()
    back_to_front.SetInputConnection(surface.GetOutputPort())
    back_to_front.SetCamera(camera)
    renderer.AddActor(actor_of(back_to_front, SURFACE_COLOUR, SURFACE_OPACITY))
    renderer.ResetCameraClippingRange()
    window.Render()

    image = vtkWindowToImageFilter()
    image.SetInput(window)
    shrunk = vtkImageShrink3D()
    shrunk.SetInputConnection(image.GetOutputPort())
    shrunk.SetShrinkFactors(2, 2, 1)
    writer = vtkPNGWriter()
    writer.SetFileName(out)
    writer.SetCompressionLevel(9)
    writer.SetInputConnection(shrunk.GetOutputPort())
    writer.Write()


main()
