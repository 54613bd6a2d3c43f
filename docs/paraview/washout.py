"""Opens a run of washout in ParaView as it should be seen: the film in colours of twist, rods and spars as tubes, the
unloaded wing as an outline.

As a macro: Tools > Macros > Add new macro, this file; then choose any .vtu or .pvd of a run with File > Open and press it.
From the shell, with or without a screen:

    paraview --script=docs/paraview/washout.py                 asks nothing: opens output/twist-v2
    WASHOUT_RUN=output/rigid paraview --script=docs/paraview/washout.py
    WASHOUT_RUN=output/rigid WASHOUT_PICTURE=wing.png pvpython --force-offscreen-rendering docs/paraview/washout.py

WASHOUT_COLOUR names the array to colour by, of points or of cells (default twist_deg).
Written for ParaView 5.11.
"""

import os
from pathlib import Path

from paraview import simple

# part of a cell, as the files of a run say
FILM, ROD, SPAR = 0, 1, 2
BLUE_TO_YELLOW = "Cividis"
SIZE = [1200, 800]


def chosen():
    """The folder of the run: of the file that is selected in ParaView, of WASHOUT_RUN, or output/twist-v2."""
    source = simple.GetActiveSource()
    names = getattr(source, "FileName", None) if source is not None else None
    if names:
        return Path(names if isinstance(names, str) else names[0]).parent
    return Path(os.environ.get("WASHOUT_RUN", "output/twist-v2"))


def part(source, low, high):
    """The cells whose `part` lies between low and high."""
    cut = simple.Threshold(registrationName=f"part {low}", Input=source)
    cut.Scalars = ["CELLS", "part"]
    cut.LowerThreshold = low
    cut.UpperThreshold = high
    cut.ThresholdMethod = "Between"
    return cut


def tubes(lines, view, colour):
    surface = simple.ExtractSurface(Input=lines)
    tube = simple.Tube(Input=surface, Radius=0.3, NumberofSides=12)
    shown = simple.Show(tube, view)
    shown.ColorArrayName = [None, ""]
    shown.DiffuseColor = colour


def array_of(source, name):
    """Where an array stands: POINTS or CELLS."""
    source.UpdatePipeline()
    for where, information in (("POINTS", source.PointData), ("CELLS", source.CellData)):
        if information.GetArray(name) is not None:
            return where
    known = [a.Name for information in (source.PointData, source.CellData) for a in information.values()]
    raise SystemExit(f"WASHOUT_COLOUR={name}: no such array; there are {', '.join(sorted(known))}")


def show(folder):
    view = simple.GetActiveViewOrCreate("RenderView")
    if "WASHOUT_PICTURE" in os.environ:
        view.ViewSize = SIZE
    loaded = simple.XMLUnstructuredGridReader(registrationName="loaded", FileName=[str(folder / "wing.vtu")])
    rest = simple.XMLUnstructuredGridReader(registrationName="unloaded", FileName=[str(folder / "wing-rest.vtu")])
    name = os.environ.get("WASHOUT_COLOUR", "twist_deg")
    film = part(loaded, FILM, FILM)
    shown = simple.Show(film, view)
    simple.ColorBy(shown, (array_of(film, name), name))
    colours = simple.GetColorTransferFunction(name)
    colours.ApplyPreset(BLUE_TO_YELLOW, True)
    shown.RescaleTransferFunctionToDataRange(False, True)
    shown.SetScalarBarVisibility(view, True)
    bar = simple.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = name, ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.88, 0.25], 0.5
    bar.TitleFontSize = bar.LabelFontSize = 14
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%.3g", "%.3g"
    tubes(part(loaded, ROD, ROD), view, [0.1, 0.1, 0.1])
    tubes(part(loaded, SPAR, SPAR), view, [0.3, 0.3, 0.3])
    ghost = simple.Show(simple.FeatureEdges(Input=simple.ExtractSurface(Input=rest)), view)
    ghost.ColorArrayName = [None, ""]
    ghost.AmbientColor = ghost.DiffuseColor = [0.6, 0.6, 0.6]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = [0.0, 0.0, 0.0]
    # from the leading edge of the tip, above: washout lifts the trailing edge
    view.CameraPosition = [160.0, -110.0, 90.0]
    view.CameraFocalPoint = [35.0, 10.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.ResetCamera()
    simple.GetActiveCamera().Zoom(1.5)
    simple.Render(view)
    return view


view = show(chosen())
if "WASHOUT_PICTURE" in os.environ:
    simple.SaveScreenshot(os.environ["WASHOUT_PICTURE"], view, ImageResolution=SIZE)
