"""A coupled wing, side by side: OpenAeroStruct and washout.

cargo build --release
python3 benches/coupled_peer.py --python PYTHON [--rounds 5]      PYTHON: one that has openaerostruct (pip)

No two programs pose the same coupled problem, so this compares what a user waits for, not one answer. washout solves
designs/twist-v2.toml: a shell and beams in large rotation, film that wrinkles, blade-element air of a flapping stroke.
OpenAeroStruct solves a wing of that size (70 x 20.5 mm, a tube of 1 mm along the leading edge) in a steady stream of 5 m/s at 5 deg:
a linear beam and a vortex lattice of 2 x 20 panels a side, iterated with Aitken's relaxation. The programs take turns, one thread
each. CPU seconds of the whole process, and, of OpenAeroStruct, of its solve without the imports and the set-up.
"""

import argparse
import contextlib
import io
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ONE_THREAD = {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "RAYON_NUM_THREADS")}
SPAN, CHORD, STATIONS = 0.070, 0.0205, 21
FLOW = {
    "v": (5.0, "m/s"),
    "alpha": (5.0, "deg"),
    "beta": (0.0, "deg"),
    "Mach_number": (0.0147, None),
    "re": (3.4e5, "1/m"),
    "rho": (1.2, "kg/m**3"),
    "CT": (1e-5, "1/s"),
    "R": (1e3, "m"),
    "W0": (1e-3, "kg"),
    "speed_of_sound": (340.0, "m/s"),
    "load_factor": (1.0, None),
}


def openaerostruct():
    """Solves its wing; prints the CPU seconds of the solve, and the tip's twist."""
    import numpy as np
    import openmdao.api as om
    from openaerostruct.integration.aerostruct_groups import AerostructGeometry, AerostructPoint
    from openaerostruct.meshing.mesh_generator import generate_mesh

    outline = {"num_y": 2 * STATIONS - 1, "num_x": 3, "wing_type": "rect", "symmetry": True}
    mesh = generate_mesh({**outline, "span": 2 * SPAN, "root_chord": CHORD})
    # a rod of 1 mm of carbon: the wall of the tube is nearly its radius; unidirectional carbon, as in the design
    rod = {"radius_cp": np.full(3, 0.5e-3), "thickness_cp": np.full(3, 0.49e-3), "fem_origin": 0.0, "E": 135e9, "G": 4e9}
    air = {"CL0": 0.0, "CD0": 0.02, "k_lam": 0.05, "t_over_c_cp": np.array([0.05]), "c_max_t": 0.3, "with_viscous": False}
    rest = {"yield": 1e9, "safety_factor": 1.0, "mrho": 1600.0, "wing_weight_ratio": 1.0, "exact_failure_constraint": False}
    relief = {"struct_weight_relief": False, "distributed_fuel_weight": False, "with_wave": False}
    kind = {"name": "wing", "symmetry": True, "S_ref_type": "wetted", "fem_model_type": "tube", "mesh": mesh}
    surface = {**kind, "twist_cp": np.zeros(2), **rod, **air, **rest, **relief}

    problem = om.Problem()
    given = om.IndepVarComp()
    for name, (value, unit) in FLOW.items():
        given.add_output(name, val=value, units=unit)
    given.add_output("empty_cg", val=np.zeros(3), units="m")
    model = problem.model
    model.add_subsystem("given", given, promotes=["*"])
    model.add_subsystem("wing", AerostructGeometry(surface=surface))
    model.add_subsystem("flight", AerostructPoint(surfaces=[surface]), promotes_inputs=[*FLOW, "empty_cg"])
    for name in ("local_stiff_transformed", "nodes", "mesh"):
        model.connect(f"wing.{name}", f"flight.coupled.wing.{name}")
    for name in ("nodes", "radius", "thickness", "t_over_c"):
        model.connect(f"wing.{name}", f"flight.wing_perf.{name}")
    for name in ("cg_location", "structural_mass"):
        model.connect(f"wing.{name}", f"flight.total_perf.wing_{name}")
    with contextlib.redirect_stdout(io.StringIO()) as said:
        problem.setup()
        start = time.process_time()
        problem.run_model()
        seconds = time.process_time() - start
    rounds = sum("NL: NLBGS" in line and line.strip()[-1:].isdigit() for line in said.getvalue().splitlines())
    tip = float(np.degrees(problem["flight.coupled.wing.disp"][0, 4]))
    print("solved", json.dumps({"solve_cpu_s": seconds, "rounds": rounds, "tip_twist_deg": tip}), flush=True)


def cpu_of(command):
    """CPU seconds of a whole process, and what it said."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        [str(word) for word in command], env={**os.environ, **ONE_THREAD}, capture_output=True, text=True, check=False
    )
    if done.returncode:
        sys.exit(done.stdout[-2000:] + done.stderr[-2000:])
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--python", default=sys.executable, help="Python that has openaerostruct")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--job", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.job:
        openaerostruct()
        return
    times = {"washout": [], "whole": [], "solve": []}
    with tempfile.TemporaryDirectory() as folder:
        design = ROOT / "designs/twist-v2.toml"
        solve = [ROOT / "target/release/washout", "solve", design, "--quiet", "--threads", 1, "--output", Path(folder) / "run"]
        for _ in range(options.rounds):
            times["washout"].append(cpu_of(solve)[0])
            whole, said = cpu_of([options.python, __file__, "--job"])
            answer = json.loads(said.split("solved ")[1])
            times["whole"].append(whole)
            times["solve"].append(answer["solve_cpu_s"])
    middle = {name: statistics.median(seconds) for name, seconds in times.items()}
    print("| program | CPU s of the process, median | of its coupled solve alone | × washout |")
    print("|---|---|---|---|")
    print(f"| washout, shell, twist-v2, with its files | {middle['washout']:.2f} | | 1 |")
    ratio = middle["whole"] / middle["washout"]
    print(f"| OpenAeroStruct, linear beam and vortex lattice | {middle['whole']:.2f} | {middle['solve']:.2f} | {ratio:.1f} |")
    print(f"\nload {os.getloadavg()[0]:.1f}, {options.rounds} rounds; OpenAeroStruct: {json.dumps(answer)}")


if __name__ == "__main__":
    main()
