"""Peers on the same job, side by side: washout, CalculiX, Kratos, OpenSees on a thin cantilever plate in large rotation.

cargo build --release --example plates
python3 benches/peers.py                       all peers that are installed, 2k and 20k freedoms, 5 rounds
python3 benches/peers.py --mesh 2k --rounds 7 --peers calculix kratos --markdown

Every round runs every program once, one after the other, so that all see the same machine; figures are CPU seconds of the
whole process (start, input, solution, output) on one thread, and their median. Accuracy stands beside them. Plates: see
examples/plates.rs; `bend` has an exact answer (elastica), `twist` one on which three programs agree within 0.01 %.
Peers: Debian's calculix-ccx; pip install KratosMultiphysics KratosStructuralMechanicsApplication
KratosLinearSolversApplication openseespy, for the Python given with --python.
"""

import argparse
import json
import os
import re
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "docs"))
import second_opinion  # noqa: E402

# Cells along and across of four-node or twice as many three-node elements; of eight-node ones with as many nodes.
MESHES = {"2k": (30, 10), "20k": (108, 31)}
MESHES_8 = {"2k": (16, 6), "20k": (58, 18)}
# mm; deflection of the loaded corner (bend: of the edge), of the other corner
EXACT = {"bend": (46.89749, 46.89749), "twist": (20.3270, 19.1260)}
THREADS = ["OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "RAYON_NUM_THREADS", "MKL_NUM_THREADS"]
SECONDS = 1800


def washout(case, mesh, _):
    nx, ny = MESHES[mesh]
    said = run([ROOT / "target/release/examples/plates", case, nx, ny])
    found = json.loads(said)
    return found["first_mm"][2], found["second_mm"][2]


def calculix(case, mesh, _):
    deck, corners = second_opinion.plate(case, *MESHES_8[mesh])
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "plate.inp").write_text(deck)
        run(["ccx", "plate"], folder)
        steps = second_opinion.read_dat((Path(folder) / "plate.dat").read_text())
    return tuple(steps[1][corner][2] for corner in corners)


def by_python(peer):
    def job(case, mesh, python):
        said = run([python, __file__, "--job", peer, case, mesh])
        return tuple(json.loads(re.search(r"^tips (.*)$", said, re.MULTILINE).group(1)))

    return job


def run(command, folder=None):
    environment = dict(os.environ, **{name: "1" for name in THREADS})
    command = [str(word) for word in command]
    done = subprocess.run(
        command, cwd=folder, env=environment, capture_output=True, text=True, timeout=SECONDS, check=False
    )
    if done.returncode:
        raise RuntimeError(f"{command[0]}: {(done.stdout + done.stderr)[-300:]}")
    return done.stdout


def grid(case, mesh):
    """Nodes, four-node cells, held nodes, loads and the two corners."""
    nx, ny = MESHES[mesh]
    number = lambda i, j: 1 + i * (ny + 1) + j
    length, width = second_opinion.LENGTH, second_opinion.WIDTH
    nodes = {number(i, j): (length * i / nx, width * j / ny) for i in range(nx + 1) for j in range(ny + 1)}
    cells = [
        [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)] for i in range(nx) for j in range(ny)
    ]
    force = second_opinion.PLATES[case][1]
    loads = {number(nx, ny): force}
    if case == "bend":
        loads = {number(nx, j): force / ny * (0.5 if j in (0, ny) else 1.0) for j in range(ny + 1)}
    held = [number(0, j) for j in range(ny + 1)]
    return nodes, cells, held, loads, (number(nx, ny), number(nx, 0))


def kratos_job(case, mesh):
    """Thin corotational triangles, ten steps of load, sparse LU: the fastest of its shells that is accurate here."""
    import KratosMultiphysics as core
    import KratosMultiphysics.LinearSolversApplication  # noqa: F401
    import KratosMultiphysics.StructuralMechanicsApplication as mechanics
    from KratosMultiphysics import python_linear_solver_factory

    core.Logger.GetDefaultOutput().SetSeverity(core.Logger.Severity.WARNING)
    nodes, cells, held, loads, corners = grid(case, mesh)
    model = core.Model()
    part = model.CreateModelPart("plate")
    part.SetBufferSize(2)
    part.ProcessInfo[core.DOMAIN_SIZE] = 3
    variables = (core.DISPLACEMENT, core.ROTATION, core.REACTION, core.REACTION_MOMENT, core.VOLUME_ACCELERATION)
    for variable in (*variables, mechanics.POINT_LOAD):
        part.AddNodalSolutionStepVariable(variable)
    sheet = part.CreateNewProperties(1)
    sheet[core.YOUNG_MODULUS], sheet[core.POISSON_RATIO] = second_opinion.E, second_opinion.PLATES[case][0]
    sheet[core.THICKNESS], sheet[core.DENSITY] = second_opinion.THICKNESS, 1e-9
    sheet[core.CONSTITUTIVE_LAW] = core.KratosGlobals.GetConstitutiveLaw("LinearElasticPlaneStress2DLaw").Clone()
    for node, (x, y) in nodes.items():
        part.CreateNewNode(node, x, y, 0.0)
    number = 0
    for a, b, c, d in cells:
        for corner in ([a, b, c], [a, c, d]):
            number += 1
            part.CreateNewElement("ShellThinElementCorotational3D3N", number, corner, sheet)
    for axis in "XYZ":
        for kind, reaction in (("DISPLACEMENT", "REACTION"), ("ROTATION", "REACTION_MOMENT")):
            variable = getattr(core, f"{kind}_{axis}")
            core.VariableUtils().AddDof(variable, getattr(core, f"{reaction}_{axis}"), part)
            for node in held:
                part.GetNode(node).Fix(variable)
    for number, node in enumerate(loads):
        part.CreateNewCondition("PointLoadCondition3D1N", number + 1, [node], sheet)
    settings = core.Parameters('{"solver_type": "LinearSolversApplication.sparse_lu"}')
    strategy = core.ResidualBasedNewtonRaphsonStrategy(
        part,
        core.ResidualBasedIncrementalUpdateStaticScheme(),
        core.ResidualCriteria(1e-6, 1e-9),
        core.ResidualBasedBlockBuilderAndSolver(python_linear_solver_factory.ConstructSolver(settings)),
        60,
        False,
        False,
        True,
    )
    strategy.SetEchoLevel(0)
    strategy.Initialize()
    for step in range(1, 11):
        part.CloneTimeStep(float(step))
        part.ProcessInfo[core.STEP] = step
        for node, force in loads.items():
            part.GetNode(node).SetSolutionStepValue(mechanics.POINT_LOAD_Z, force * step / 10)
        strategy.InitializeSolutionStep()
        strategy.Predict()
        if not strategy.SolveSolutionStep():
            sys.exit(f"no equilibrium at step {step}")
        strategy.FinalizeSolutionStep()
    return [part.GetNode(node).GetSolutionStepValue(core.DISPLACEMENT)[2] for node in corners]


def opensees_job(case, mesh):
    """ASDShellQ4, corotational, ten steps of load, UmfPack."""
    import openseespy.opensees as ops

    nodes, cells, held, loads, corners = grid(case, mesh)
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    for node, (x, y) in nodes.items():
        ops.node(node, x, y, 0.0)
    ops.section(
        "ElasticMembranePlateSection", 1, second_opinion.E, second_opinion.PLATES[case][0], second_opinion.THICKNESS, 0.0
    )
    for number, cell in enumerate(cells):
        ops.element("ASDShellQ4", number + 1, *cell, 1, "-corotational")
    for node in held:
        ops.fix(node, 1, 1, 1, 1, 1, 1)
    ops.timeSeries("Linear", 1)
    ops.pattern("Plain", 1, 1)
    for node, force in loads.items():
        ops.load(node, 0.0, 0.0, force, 0.0, 0.0, 0.0)
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system("UmfPack")
    ops.test("NormUnbalance", 1e-4 * sum(loads.values()), 100, 0)
    ops.algorithm("Newton")
    ops.integrator("LoadControl", 0.1)
    ops.analysis("Static")
    if ops.analyze(10):
        sys.exit("no equilibrium")
    return [ops.nodeDisp(node, 3) for node in corners]


PEERS = {
    "washout": washout,
    "calculix": calculix,
    "kratos": by_python("kratos"),
    "opensees": by_python("opensees"),
}


def installed(peer, python):
    if peer == "washout":
        return True
    if peer == "calculix":
        return shutil.which("ccx") is not None
    module = {"kratos": "KratosMultiphysics", "opensees": "openseespy.opensees"}[peer]
    return subprocess.run([python, "-c", f"import {module}"], capture_output=True, check=False).returncode == 0


def measure(case, mesh, peers, rounds, python):
    """Rows of one plate on one mesh; the programs take turns."""
    seconds, tips, failed = {peer: [] for peer in peers}, {}, {}
    for turn in range(rounds):
        for peer in peers[turn % len(peers) :] + peers[: turn % len(peers)]:
            if peer in failed:
                continue
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            try:
                tips[peer] = PEERS[peer](case, mesh, python)
            except (RuntimeError, subprocess.TimeoutExpired) as error:
                failed[peer] = str(error).strip().splitlines()[-1][-120:]
                continue
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            seconds[peer].append(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    rows = []
    for peer in peers:
        row = {"case": case, "mesh": mesh, "program": peer, "load": round(os.getloadavg()[0], 1)}
        if peer in failed:
            rows.append({**row, "failed": failed[peer]})
            continue
        errors = [found / exact - 1 for found, exact in zip(tips[peer], EXACT[case])]
        middle = statistics.median(seconds[peer])
        ours = seconds["washout"]
        ratios = [other / own for other, own in zip(seconds[peer], ours)]
        rows.append(
            {
                **row,
                "cpu_s": round(middle, 3),
                "least_s": round(min(seconds[peer]), 3),
                "rounds": len(seconds[peer]),
                "times_washout": round(statistics.median(ratios), 1),
                "error": max(errors, key=abs),
            }
        )
    return rows


def page(rows):
    lines = ["| plate | mesh | program | CPU s, median | fastest | × washout | error |", "|---|---|---|---|---|---|---|"]
    for row in rows:
        head = f"| `{row['case']}` | {row['mesh']} | {row['program']} |"
        if "failed" in row:
            lines.append(f"{head} fails: {row['failed']} | | | |")
        else:
            lines.append(
                f"{head} {row['cpu_s']:.3g} | {row['least_s']:.3g} | {row['times_washout']:.3g} | {100 * row['error']:.3f} % |"
            )
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--mesh", nargs="+", choices=MESHES, default=list(MESHES))
    parser.add_argument("--case", nargs="+", choices=EXACT, default=list(EXACT))
    parser.add_argument("--peers", nargs="+", choices=[peer for peer in PEERS if peer != "washout"])
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--python", default=sys.executable, help="Python that has the peers")
    parser.add_argument("--markdown", action="store_true", help="a table instead of JSON lines")
    parser.add_argument("--job", nargs=3, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.job:
        peer, case, mesh = options.job
        tips = {"kratos": kratos_job, "opensees": opensees_job}[peer](case, mesh)
        print("tips", json.dumps(tips), flush=True)
        return
    peers = options.peers or [peer for peer in PEERS if peer != "washout" and installed(peer, options.python)]
    rows = []
    for mesh in options.mesh:
        for case in options.case:
            for row in measure(case, mesh, ["washout", *peers], options.rounds, options.python):
                rows.append(row)
                if not options.markdown:
                    print(json.dumps(row), flush=True)
    if options.markdown:
        print(page(rows))


if __name__ == "__main__":
    main()
