"""Draws the wing of a run: unloaded as an outline, loaded in colours of twist.

    python docs/picture.py output/twist-v2 docs/twist-v2.png

Needs the PyPI package `vtk` (pip install vtk); draws without a screen.
"""

import json
import sys
from pathlib import Path

from vtk import (
    vtkActor,
    vtkColorTransferFunction,
    vtkDataSetMapper,
    vtkFeatureEdges,
    vtkGeometryFilter,
    vtkPNGWriter,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkScalarBarActor,
    vtkTextActor,
    vtkThreshold,
    vtkTubeFilter,
    vtkWindowToImageFilter,
    vtkXMLUnstructuredGridReader,
    vtkDataObject,
)


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def parts(grid, low, high):
    """The cells whose `part` lies between low and high: film 0, rod 1, spar 2."""
    cut = vtkThreshold()
    cut.SetInputData(grid)
    cut.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_CELLS, "part")
    cut.SetLowerThreshold(low)
    cut.SetUpperThreshold(high)
    surface = vtkGeometryFilter()
    surface.SetInputConnection(cut.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def tubes(lines, radius_mm, colour):
    tube = vtkTubeFilter()
    tube.SetInputData(lines)
    tube.SetRadius(radius_mm)
    tube.SetNumberOfSides(12)
    tube.Update()
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(tube.GetOutput())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*colour)
    return actor


def outline(surface):
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ColoringOff()
    edges.Update()
    return edges.GetOutput()


def colours(low, high):
    """Blue over white-yellow to red, readable in grey as well."""
    scale = vtkColorTransferFunction()
    stops = [(0.0, 0.19, 0.29, 0.60), (0.35, 0.45, 0.72, 0.82), (0.65, 0.99, 0.88, 0.56), (1.0, 0.80, 0.20, 0.15)]
    for share, red, green, blue in stops:
        scale.AddRGBPoint(low + share * (high - low), red, green, blue)
    return scale


def main(folder, target):
    summary = json.loads((folder / "summary.json").read_text())
    loaded, rest = read(folder / "wing.vtu"), read(folder / "wing-rest.vtu")
    low, high = loaded.GetPointData().GetArray("twist_deg").GetRange()
    low = min(low, 0.0)

    film = vtkDataSetMapper()
    film.SetInputData(parts(loaded, 0, 0))
    film.SetScalarModeToUsePointFieldData()
    film.SelectColorArray("twist_deg")
    film.SetLookupTable(colours(low, high))
    film.SetScalarRange(low, high)
    sheet = vtkActor()
    sheet.SetMapper(film)
    sheet.GetProperty().SetAmbient(0.72)
    sheet.GetProperty().SetDiffuse(0.32)

    bar = vtkScalarBarActor()
    bar.SetLookupTable(film.GetLookupTable())
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("{:.0f}")
    bar.SetOrientationToHorizontal()
    bar.SetPosition(0.64, 0.06)
    bar.SetPosition2(0.33, 0.12)
    bar.UnconstrainedFontSizeOn()
    text = bar.GetLabelTextProperty()
    text.SetColor(0.1, 0.1, 0.1)
    text.SetFontSize(22)
    text.ItalicOff()
    text.BoldOff()
    text.ShadowOff()

    title = vtkTextActor()
    twist = summary["tip"]["twist_deg"]
    place = summary["tip"]["r_mm"]
    title.SetInput(f"{summary['name']}: {twist:.1f} deg at {place:.1f} mm\ncolour: twist, deg; grey: unloaded")
    title.SetPosition(30, 30)
    title.GetTextProperty().SetFontSize(24)
    title.GetTextProperty().SetColor(0.1, 0.1, 0.1)

    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(tubes(outline(parts(rest, 0, 0)), 0.12, (0.65, 0.65, 0.65)))
    renderer.AddActor(sheet)
    renderer.AddActor(tubes(parts(loaded, 1, 1), 0.5, (0.15, 0.15, 0.15)))
    renderer.AddActor(tubes(parts(loaded, 2, 2), 0.25, (0.25, 0.25, 0.25)))
    renderer.AddViewProp(bar)
    renderer.AddViewProp(title)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(150.0, 120.0, 90.0)
    camera.SetFocalPoint(36.0, 10.0, 0.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(24.0)
    renderer.ResetCamera()
    camera.Zoom(1.62)
    camera.SetWindowCenter(0.0, -0.12)

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(1200, 640)
    window.AddRenderer(renderer)
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(target))
    writer.SetCompressionLevel(9)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
