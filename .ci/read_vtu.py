"""Reads the files of a run with VTK's own readers and compares them with summary.json.

python .ci/read_vtu.py output/twist-v2            a run
python .ci/read_vtu.py --mesh output/mesh         what `washout mesh` wrote
python .ci/read_vtu.py --modes output/modes       what `washout modes` wrote
"""

import json
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy
from vtk import vtkXMLUnstructuredGridReader
from vtk.util.numpy_support import vtk_to_numpy

POINT_ARRAYS = {"displacement_mm": 3, "rotation_deg": 3, "twist_deg": 1, "pressure_pa": 1}
PART_ARRAYS = {"part": 1, "part_index": 1, "material": 1, "section": 1}
CELL_ARRAYS = PART_ARRAYS | {
    "membrane_force_n_per_m": 3,
    "principal_tension_n_per_m": 2,
    "beam_force_n": 3,
    "beam_moment_n_m": 3,
    "pressure_pa": 1,
}
VTK_LINE, VTK_TRIANGLE = 3, 5


def check(condition, text):
    if not condition:
        sys.exit(f"read_vtu: {text}")


def read(path):
    """Points (mm), types of the cells, point arrays and cell arrays of one file."""
    check(path.is_file(), f"{path} is missing")
    reader = vtkXMLUnstructuredGridReader()
    check(reader.CanReadFile(str(path)), f"{path}: VTK cannot read it")
    reader.SetFileName(str(path))
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(path))
    reader.Update()
    check(not errors, f"{path}: VTK complains")
    grid = reader.GetOutput()

    def arrays(data):
        names = [data.GetArrayName(index) for index in range(data.GetNumberOfArrays())]
        return {name: vtk_to_numpy(data.GetArray(name)) for name in names}

    points = vtk_to_numpy(grid.GetPoints().GetData())
    types = numpy.array([grid.GetCellType(index) for index in range(grid.GetNumberOfCells())])
    return points, types, arrays(grid.GetPointData()), arrays(grid.GetCellData())


def check_arrays(path, found, expected, entries):
    check(set(found) == set(expected), f"{path}: arrays {sorted(found)}, expected {sorted(expected)}")
    for name, components in expected.items():
        shape = (entries,) if components == 1 else (entries, components)
        check(found[name].shape == shape, f"{path}: {name} has shape {found[name].shape}, expected {shape}")
        check(numpy.isfinite(found[name]).all(), f"{path}: {name} holds values that are not finite")


def check_parts(path, points, types, cells, summary):
    mesh = summary["mesh"]
    counts = [len(points), (types == VTK_TRIANGLE).sum(), (types == VTK_LINE).sum()]
    expected = [mesh["nodes"], mesh["triangles"], mesh["beams"]]
    check(counts == expected, f"{path}: {counts} points, triangles, lines; expected {expected}")
    check(len(types) == sum(expected[1:]), f"{path}: cells of another type")
    part = cells["part"]
    check((part[types == VTK_TRIANGLE] == 0).all(), f"{path}: a triangle that is not film")
    check(numpy.isin(part[types == VTK_LINE], [1, 2]).all(), f"{path}: a line that is neither rod nor spar")
    design = summary["design"]
    for number, key in [(1, "rod"), (2, "spar")]:
        indices = set(cells["part_index"][part == number].tolist())
        check(indices == set(range(len(design[key]))), f"{path}: {key} pieces {indices}")
    check(cells["material"].max() < len(summary["legend"]["material"]), f"{path}: unknown material")
    check(cells["section"].max() < len(summary["legend"]["section"]), f"{path}: unknown section")


def check_run(folder):
    summary = json.loads((folder / "summary.json").read_text())
    here = {path.name for path in folder.iterdir()} - {".washout.json"}
    check(here == set(summary["files"]), f"{folder} holds {sorted(here)}, summary.json lists {summary['files']}")
    shapes = {}
    for name in ["wing-rest.vtu", "wing.vtu"]:
        path = folder / name
        points, types, at_points, at_cells = read(path)
        check_arrays(path, at_points, POINT_ARRAYS, len(points))
        check_arrays(path, at_cells, CELL_ARRAYS, len(types))
        check_parts(path, points, types, at_cells, summary)
        shapes[name] = (points, types, at_points, at_cells)

    points, types, at_points, at_cells = shapes["wing.vtu"]
    rest = shapes["wing-rest.vtu"][0]
    moved = rest + at_points["displacement_mm"]
    check(numpy.allclose(moved, points, rtol=0, atol=1e-9), "rest plus displacement is not the deformed shape")

    length = summary["wing"]["length_mm"]
    check(rest[:, 0].min() > -1e-9 and rest[:, 0].max() <= length + 1e-9, "points off the span")
    tip = summary["tip"]
    found = at_points["displacement_mm"][tip["node"]]
    check((found == tip["displacement_mm"]).all(), f"tip moves by {found}, summary.json says {tip['displacement_mm']}")

    check(numpy.abs(at_points["twist_deg"]).max() < 180.0, "twist beyond half a turn")
    # The base of the profile is the clamp; the film's root chord is free to turn, and the file shows that of the film.
    for row in summary["profile"]:
        if row["place"] == "base":
            continue
        column = numpy.isclose(rest[:, 0], row["r_mm"], rtol=0, atol=1e-6)
        for twist in at_points["twist_deg"][column]:
            check(abs(twist - row["twist_deg"]) < 1e-3, f"twist at {row['r_mm']} mm: {twist}, {row['twist_deg']}")

    principal = at_cells["principal_tension_n_per_m"]
    check((principal[:, 0] >= principal[:, 1]).all(), "principal tensions are not ordered")
    trace = at_cells["membrane_force_n_per_m"][:, :2].sum(axis=1)
    check(numpy.allclose(principal.sum(axis=1), trace), "principal tensions do not add up")
    line = types == VTK_LINE
    check((at_cells["membrane_force_n_per_m"][line] == 0).all(), "a beam with membrane force")
    check((at_cells["beam_force_n"][~line] == 0).all(), "a triangle with beam force")
    if summary["flow"] is not None:
        check(numpy.abs(at_cells["pressure_pa"][~line]).max() > 0, "no pressure in the flow")

    for path in folder.glob("*.pvd"):
        entries = list(ElementTree.parse(path).getroot().iter("DataSet"))
        check(entries, f"{path} names no file")
        steps = [float(entry.get("timestep")) for entry in entries]
        check(steps == sorted(set(steps)), f"{path}: steps {steps}")
        for entry in entries:
            read(folder / entry.get("file"))
    print(f"{folder}: {len(points)} points, {len(types)} cells, tip moves by {numpy.round(found, 3)} mm")


def check_mesh(folder):
    path = folder / "mesh.vtu"
    points, types, at_points, at_cells = read(path)
    check_arrays(path, at_points, {}, len(points))
    check_arrays(path, at_cells, PART_ARRAYS, len(types))
    check(numpy.isin(types, [VTK_TRIANGLE, VTK_LINE]).all(), f"{path}: cells of another type")
    print(f"{folder}: {len(points)} points, {len(types)} cells")


def check_modes(folder):
    summary = json.loads((folder / "summary.json").read_text())
    entries = list(ElementTree.parse(folder / "modes.pvd").getroot().iter("DataSet"))
    files = [mode["file"] for mode in summary["modes"]]
    check([entry.get("file") for entry in entries] == files, f"{folder}/modes.pvd does not list {files}")
    for name in files:
        path = folder / name
        points, types, at_points, at_cells = read(path)
        check_arrays(path, at_points, {"displacement_mm": 3, "rotation_deg": 3}, len(points))
        check_arrays(path, at_cells, PART_ARRAYS, len(types))
        largest = numpy.linalg.norm(at_points["displacement_mm"], axis=1).max()
        check(abs(largest - 1.0) < 1e-9, f"{path}: the largest displacement is {largest} mm")
    print(f"{folder}: {len(files)} modes")


if __name__ == "__main__":
    if sys.argv[1] == "--mesh":
        check_mesh(Path(sys.argv[2]))
    elif sys.argv[1] == "--modes":
        check_modes(Path(sys.argv[2]))
    else:
        check_run(Path(sys.argv[1]))
