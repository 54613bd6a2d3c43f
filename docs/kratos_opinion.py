"""A second opinion by Kratos Multiphysics: solves the model part of a run and compares displacement and twist.

washout export --to kratos output/twist-v2
python3 docs/kratos_opinion.py output/twist-v2                 one run
python3 docs/kratos_opinion.py output/a output/b --json        several, one JSON document
python3 docs/kratos_opinion.py PART.mdpa --nodes 41,21         a model part alone: displacements of these nodes

--film facets    the film as constant-strain membranes with plate bending, as washout has it (default)
--film shells    the film as shells whose membrane knows the rotations about the normal (ANDES)
--film wrinkles  membranes that wrinkle (Kratos's WrinklingLinear2DLaw), for a film that does
--start rest     from the unloaded shape in --steps steps of load (default 10)
--start washout  from washout's shape under the whole load: for films on which Newton's method fails from rest
--joint clamp    film and beams share displacement and rotation, as in washout (default)
--joint hinge    displacement alone: the film turns freely about rod and spars, as in the decks for CalculiX
--linear         one solve with the tangent at rest

Needs Python 3 and pip install KratosMultiphysics KratosStructuralMechanicsApplication KratosConstitutiveLawsApplication
KratosLinearSolversApplication. Ends with 1 where Kratos does not reach equilibrium under the full load.
"""

import argparse
import csv
import json
import os
import sys
import time
from pathlib import Path

import second_opinion

FREEDOMS = [f"{kind}_{axis}" for kind in ("DISPLACEMENT", "ROTATION") for axis in "XYZ"]
# A film's plate has this times its thickness and as much less stiffness: the same bending, next to no membrane.
THICKER = 100.0


def kratos():
    """The library, and what of it is needed, without its banner."""
    out = os.dup(1)
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    try:
        import KratosMultiphysics as core
        import KratosMultiphysics.LinearSolversApplication  # noqa: F401
        import KratosMultiphysics.StructuralMechanicsApplication as mechanics
    except ImportError:
        sys.exit(
            "kratos_opinion: no Kratos here; pip install KratosMultiphysics "
            "KratosStructuralMechanicsApplication KratosLinearSolversApplication"
        )
    finally:
        sys.stdout.flush()
        os.dup2(out, 1)
        os.close(null)
    core.Logger.GetDefaultOutput().SetSeverity(core.Logger.Severity.WARNING)
    return core, mechanics


def law(core, name):
    return core.KratosGlobals.GetConstitutiveLaw(name).Clone()


def model_part(path, film):
    """The model part of a file, with the laws that its elements need."""
    core, mechanics = kratos()
    model = core.Model()
    part = model.CreateModelPart("wing")
    part.SetBufferSize(2)
    part.ProcessInfo[core.DOMAIN_SIZE] = 3
    part.ProcessInfo[core.STEP] = 0
    variables = (core.DISPLACEMENT, core.ROTATION, core.REACTION, core.REACTION_MOMENT, core.VOLUME_ACCELERATION)
    for variable in variables + (mechanics.POINT_LOAD, mechanics.POINT_MOMENT):
        part.AddNodalSolutionStepVariable(variable)
    core.ModelPartIO(str(Path(path).with_suffix("")), core.IO.READ | core.IO.SKIP_TIMER).ReadModelPart(part)
    for kind, reaction in (("DISPLACEMENT", "REACTION"), ("ROTATION", "REACTION_MOMENT")):
        for axis in "XYZ":
            pair = [getattr(core, f"{name}_{axis}") for name in (kind, reaction)]
            core.VariableUtils().AddDof(*pair, part)
    sheets = [p for p in part.Properties if p.Has(core.THICKNESS)]
    for properties in part.Properties:
        if properties.Has(mechanics.CROSS_AREA):
            properties[core.CONSTITUTIVE_LAW] = law(core, "BeamConstitutiveLaw")
    for sheet in sheets:
        sheet[core.CONSTITUTIVE_LAW] = law(core, "LinearElasticPlaneStress2DLaw")
        if film != "shells":
            membranes(core, mechanics, part, sheet, film == "wrinkles")
        elif any(sheet[mechanics.PRESTRESS_VECTOR]):
            sys.exit("kratos_opinion: Kratos's shells have no pre-tension; --film facets")
    return core, mechanics, model, part


def membranes(core, mechanics, part, sheet, wrinkles):
    """Splits shells in two: a membrane of the film, and a plate that bends as the film but hardly stretches."""
    plates = [e for e in part.Elements if e.Properties.Id == sheet.Id]
    own = part.CreateNewProperties(max(p.Id for p in part.Properties) + 1)
    for variable in (core.YOUNG_MODULUS, core.POISSON_RATIO, core.THICKNESS, core.DENSITY):
        own[variable] = sheet[variable]
    own[mechanics.PRESTRESS_VECTOR] = sheet[mechanics.PRESTRESS_VECTOR]
    own[core.CONSTITUTIVE_LAW] = law(core, "LinearElasticPlaneStress2DLaw")
    if wrinkles:
        inner = part.CreateNewProperties(own.Id + 1)
        for variable in (core.YOUNG_MODULUS, core.POISSON_RATIO, core.THICKNESS, core.DENSITY):
            inner[variable] = sheet[variable]
        inner[core.CONSTITUTIVE_LAW] = law(core, "LinearElasticPlaneStress2DLaw")
        own[core.CONSTITUTIVE_LAW] = law(core, "WrinklingLinear2DLaw")
        own.AddSubProperties(inner)
    sheet[core.THICKNESS] *= THICKER
    sheet[core.YOUNG_MODULUS] /= THICKER**3
    last = max(e.Id for e in part.Elements)
    for index, plate in enumerate(plates):
        nodes = [node.Id for node in plate.GetNodes()]
        part.CreateNewElement("MembraneElement3D3N", last + 1 + index, nodes, own)


def hinge(core, part):
    """Gives beams nodes of their own, tied to those of the film by displacements: the film turns freely about them."""
    beams = [e for e in part.Elements if len(e.GetNodes()) == 2]
    film = {node.Id for e in part.Elements if len(e.GetNodes()) == 3 for node in e.GetNodes()}
    last = max(node.Id for node in part.Nodes)
    own, number = {}, 0
    for node in {node.Id: node for beam in beams for node in beam.GetNodes()}.values():
        if node.Id not in film:
            own[node.Id] = node.Id
            continue
        last += 1
        own[node.Id] = last
        twin = part.CreateNewNode(last, node.X0, node.Y0, node.Z0)
        for name in FREEDOMS:
            variable = getattr(core, name)
            reaction = name.replace("DISPLACEMENT", "REACTION").replace("ROTATION", "REACTION_MOMENT")
            twin.AddDof(variable, getattr(core, reaction))
            if node.IsFixed(variable):
                twin.Fix(variable)
                node.Free(variable)
            if name.startswith("DISPLACEMENT"):
                number += 1
                tie = (twin, variable, node, variable, 1.0, 0.0)
                part.CreateNewMasterSlaveConstraint("LinearMasterSlaveConstraint", number, *tie)
    for beam in beams:
        nodes = [own[node.Id] for node in beam.GetNodes()]
        side, properties, index = beam.GetValue(core.LOCAL_AXIS_2), beam.Properties, beam.Id
        part.RemoveElement(index)
        part.CreateNewElement("CrBeamElement3D2N", index, nodes, properties).SetValue(core.LOCAL_AXIS_2, side)


def solve(path, film="facets", steps=10, shape=None, linear=False, joint="clamp", iterations=100):
    """Displacement (mm) of every node under the full load, iterations, and whether Kratos found equilibrium."""
    core, mechanics, model, part = model_part(path, film)  # `model` owns the part
    if joint == "hinge":
        hinge(core, part)
    from KratosMultiphysics import python_linear_solver_factory

    settings = core.Parameters('{"solver_type": "LinearSolversApplication.sparse_lu"}')
    solver = python_linear_solver_factory.ConstructSolver(settings)
    builder = core.ResidualBasedBlockBuilderAndSolver(solver)
    scheme = core.ResidualBasedIncrementalUpdateStaticScheme()
    if linear:
        strategy = core.ResidualBasedLinearStrategy(part, scheme, builder, False, False, False, True)
    else:
        criterion = core.ResidualCriteria(1e-7, 1e-10)
        strategy = core.ResidualBasedNewtonRaphsonStrategy(
            part, scheme, criterion, builder, iterations, False, False, True
        )
    strategy.SetEchoLevel(0)
    loads = [getattr(mechanics, f"POINT_{kind}_{axis}") for kind in ("LOAD", "MOMENT") for axis in "XYZ"]
    full = [(node, [node.GetSolutionStepValue(load) for load in loads]) for node in part.Nodes]
    full = [(node, values) for node, values in full if any(values)]
    strategy.Initialize()
    if shape is not None:
        steps = 1
    done, used = True, 0
    for step in range(1, 2 if linear else steps + 1):
        part.CloneTimeStep(float(step))
        part.ProcessInfo[core.STEP] = step
        share = 1.0 if linear else step / steps
        for node, values in full:
            for load, value in zip(loads, values):
                node.SetSolutionStepValue(load, share * value)
        strategy.InitializeSolutionStep()
        if shape is not None:
            for node in part.Nodes:
                for freedom, value in zip(FREEDOMS, shape.get(node.Id, [0.0] * 6)):
                    node.SetSolutionStepValue(getattr(core, freedom), value)
                moved = node.GetSolutionStepValue(core.DISPLACEMENT)
                node.X, node.Y, node.Z = node.X0 + moved[0], node.Y0 + moved[1], node.Z0 + moved[2]
        strategy.Predict()
        done = strategy.SolveSolutionStep()
        strategy.FinalizeSolutionStep()
        used += 1 if linear else part.ProcessInfo[core.NL_ITERATION_NUMBER]
        if not (done or linear):
            break
    moved = {node.Id: list(node.GetSolutionStepValue(core.DISPLACEMENT)) for node in part.Nodes}
    return moved, {"iterations": used, "equilibrium": bool(done or linear), "share_of_load": share}


def washout_shape(folder):
    """Displacement and rotation vector of each node where washout has it."""
    with open(folder / "shape.csv", newline="") as file:
        rows = csv.DictReader(file)
        names = ["ux_mm", "uy_mm", "uz_mm", "turn_x_rad", "turn_y_rad", "turn_z_rad"]
        return {int(row["node"]): [float(row[name]) for name in names] for row in rows}


def compare(run, options):
    """What washout and Kratos say of one run."""
    folder = run / "kratos"
    ours = washout_shape(folder)
    start = time.process_time()
    moved, report = solve(
        folder / "wing.mdpa",
        options.film,
        options.steps,
        ours if options.start == "washout" else None,
        options.linear,
        options.joint,
    )
    report["cpu_s"] = round(time.process_time() - start, 2)
    if not report["equilibrium"]:
        said = f"{100 * report['share_of_load']:.0f} % of the load after {report['iterations']} iterations"
        return {"run": run.name, "outcome": "Kratos finds no equilibrium", "said": said, **report}
    # from the flat film, as Kratos counts; edges.csv counts from the cured shape
    edges = second_opinion.edges(folder / "edges.csv")
    leading, trailing = [[(node, place, ours[node][:3]) for node, place, _ in edge] for edge in edges]
    result = second_opinion.compared(run.name, leading, trailing, lambda node: moved[node])
    nodes = [(ours[node][:3], moved[node]) for node in ours]
    largest = max(sum(x * x for x in u) ** 0.5 for u, _ in nodes)
    off = max(sum((x - y) ** 2 for x, y in zip(u, v)) ** 0.5 for u, v in nodes)
    result["any_node_mm"] = {"largest": largest, "largest_difference": off, "share": off / largest}
    return {**result, **report}


def alone(path, options):
    """Displacements of the nodes asked for of a model part; without any, of the node that moves most."""
    moved, report = solve(path, options.film, options.steps, None, options.linear, options.joint)
    most = max(moved, key=lambda node: sum(x * x for x in moved[node]))
    nodes = [int(node) for node in options.nodes.split(",")] if options.nodes else [most]
    return {"part": Path(path).stem, **report, "moved_mm": {node: moved[node] for node in nodes}}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", type=Path)
    parser.add_argument("--film", choices=["facets", "shells", "wrinkles"], default="facets")
    parser.add_argument("--start", choices=["rest", "washout"], default="rest")
    parser.add_argument("--joint", choices=["clamp", "hinge"], default="clamp")
    parser.add_argument("--steps", type=int, default=10)
    parser.add_argument("--nodes", help="of a model part alone: numbers, 41,21")
    parser.add_argument("--linear", action="store_true")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    results, failed = [], False
    for run in options.runs:
        if run.suffix == ".mdpa":
            results.append(alone(run, options))
            failed |= not results[-1]["equilibrium"]
        else:
            results.append(compare(run, options))
            failed |= results[-1]["outcome"] != "solved"
    if options.json:
        print(json.dumps(results, indent=1))
    else:
        for result in results:
            print(second_opinion.page(result, "Kratos") if "run" in result else json.dumps(result))
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
