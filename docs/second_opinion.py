"""A second opinion: solves the deck of a run with CalculiX and compares displacement and twist along the span.

washout export --to calculix output/twist-v2
python3 docs/second_opinion.py output/twist-v2               one run
python3 docs/second_opinion.py output/a output/b --json      several, one JSON document
python3 docs/second_opinion.py DECK.inp                      a deck alone: displacements of its printed nodes
python3 docs/second_opinion.py --plates                      the plates `bend` and `twist` of examples/plates.rs with
                                                             eight-node shells (S8R) on meshes of CalculiX's own

Needs Python 3 and `ccx` (Debian: apt-get install calculix-ccx). Standard library only; works in a folder of its own, leaves
none of CalculiX's files behind. Ends with 1 where CalculiX does not reach the full load.
"""

import csv
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def solve(deck, seconds=3600):
    """Displacements of the printed nodes (mm) at the end of each step; the text of the deck as it is."""
    if shutil.which("ccx") is None:
        sys.exit("second_opinion: no ccx here; on Debian: apt-get install calculix-ccx")
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        (folder / "wing.inp").write_text(deck)
        try:
            said = subprocess.run(
                ["ccx", "wing"], cwd=folder, capture_output=True, text=True, timeout=seconds, check=False
            ).stdout
        except subprocess.TimeoutExpired:
            said = f"stopped after {seconds} s"
        result = folder / "wing.dat"
        steps = read_dat(result.read_text()) if result.is_file() else {}
    count = len(re.findall(r"^\*STEP", deck, re.MULTILINE))
    if set(steps) != set(range(1, count + 1)):
        return None, said[-400:]
    return [steps[step] for step in range(1, count + 1)], said


def read_dat(text):
    """Node → displacement by step; every step lasts one unit of time, and only its end counts."""
    steps, here = {}, None
    for line in text.splitlines():
        head = re.search(r"displacements .* and time\s+(\S+)", line)
        if head:
            time = float(head.group(1))
            here = {} if abs(time - round(time)) < 1e-6 else None
            if here is not None:
                steps[round(time)] = here
        elif here is not None and line.split():
            node, *u = line.split()
            here[int(node)] = [float(x) for x in u]
    return steps


def edges(path):
    """Leading and trailing edge from base to tip: node, place at rest, displacement by washout (mm)."""
    found = {"leading": [], "trailing": []}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            place = [float(row["r_mm"]), float(row["y_mm"]), 0.0]
            moved = [float(row[f"u{axis}_mm"]) for axis in "xyz"]
            found[row["edge"]].append((int(row["node"]), place, moved))
    return found["leading"], found["trailing"]


def interpolate(points, r):
    """Place and displacement on an edge at rest position r; none beyond its ends."""
    for (a, ua), (b, ub) in zip(points, points[1:]):
        if a[0] <= r <= b[0] and b[0] > a[0]:
            share = (r - a[0]) / (b[0] - a[0])
            mix = lambda p, q: [x + share * (y - x) for x, y in zip(p, q)]
            return mix(a, b), mix(ua, ub)
    return None


def profile(leading, trailing, smallest_chord):
    """r, displacement of the leading edge, displacement of the trailing edge, twist (deg) along the span."""
    rows = []
    for place, moved in leading:
        other = interpolate(trailing, place[0])
        if other is None or other[0][1] - place[1] < smallest_chord:
            continue
        chord = [b + v - a - u for a, u, b, v in zip(place, moved, *other)]
        rows.append((place[0], moved, other[1], math.degrees(math.atan2(chord[2], chord[1]))))
    return rows


def compare(folder):
    """What washout and CalculiX say of one run."""
    deck = folder / "calculix"
    leading, trailing = edges(deck / "edges.csv")
    steps, said = solve((deck / "wing.inp").read_text())
    if steps is None:
        return {"run": folder.name, "outcome": "CalculiX does not reach the full load", "said": said}
    rest = steps[0] if len(steps) > 1 else {}
    moved = lambda node: [a - b for a, b in zip(steps[-1][node], rest.get(node, [0.0] * 3))]
    return compared(folder.name, leading, trailing, moved)


def compared(name, leading, trailing, moved):
    """Both along the span; `moved` gives the displacement (mm) of a node by the other program."""
    chords = [b[1] - a[1] for (_, a, _), (_, b, _) in zip(leading, trailing)]
    smallest = 0.2 * sum(chords) / len(chords)
    ours = profile([p[1:] for p in leading], [p[1:] for p in trailing], smallest)
    theirs = profile(
        [(place, moved(node)) for node, place, _ in leading],
        [(place, moved(node)) for node, place, _ in trailing],
        smallest,
    )
    rows = []
    for (r, u, v, twist), (_, other_u, other_v, other_twist) in zip(ours, theirs):
        rows.append(
            {
                "r_mm": r,
                "twist_deg": [twist, other_twist],
                "leading_edge_mm": [u[2], other_u[2]],
                "trailing_edge_mm": [v[2], other_v[2]],
            }
        )
    result = {"run": name, "outcome": "solved", "rows": rows}
    for key in ["twist_deg", "leading_edge_mm", "trailing_edge_mm"]:
        largest = max(abs(row[key][0]) for row in rows)
        off = max(abs(row[key][0] - row[key][1]) for row in rows)
        result[key] = {"tip": rows[-1][key], "largest": largest, "largest_difference": off, "share": off / largest}
    return result


def page(result, other="CalculiX"):
    if result["outcome"] != "solved":
        return f"{result['run']}: {result['outcome']}\n{result['said']}\n"
    columns = "".join(f"{what:>10} washout{other:>9}" for what in ["twist_deg", "le_mm", "te_mm"])
    lines = [result["run"], f"   r_mm{columns}"]
    every = max(1, len(result["rows"]) // 12)
    for row in result["rows"][::every] + [result["rows"][-1]]:
        pairs = [row[key] for key in ["twist_deg", "leading_edge_mm", "trailing_edge_mm"]]
        lines.append(f"{row['r_mm']:7.2f}" + "".join(f"{a:18.4f}{b:9.4f}" for a, b in pairs))
    for key in ["twist_deg", "leading_edge_mm", "trailing_edge_mm", "any_node_mm"]:
        if key not in result:
            continue
        lines.append(
            f"  {key}: largest difference {result[key]['largest_difference']:.4f}, "
            f"{100 * result[key]['share']:.2f} % of the largest value"
        )
    return "\n".join(lines) + "\n"


# The plates: 70 × 20 × 0.086 mm, E 70 GPa, one short edge clamped, dead load across the plate: over the free edge with
# F L²/(E I) = 4 and ν = 0 (`bend`), or a quarter of it at one free corner with ν = 0.3 (`twist`).
LENGTH, WIDTH, THICKNESS, E = 70.0, 20.0, 0.086, 70e3
FORCE = 4.0 * E * WIDTH * THICKNESS**3 / 12.0 / LENGTH**2
PLATES = {"bend": (0.0, FORCE), "twist": (0.3, 0.25 * FORCE)}


def plate(case, nx, ny):
    """Deck of eight-node shells (S8R); prints the loaded corner and the other."""
    poisson, force = PLATES[case]
    nodes = {}

    def node(i, j):
        return nodes.setdefault((i, j), len(nodes) + 1)

    elements = []
    for i in range(0, 2 * nx, 2):
        for j in range(0, 2 * ny, 2):
            corners = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
            elements.append([node(i + di, j + dj) for di, dj in corners])
    loads = {}
    if case == "twist":
        loads[node(2 * nx, 2 * ny)] = force
    else:
        for j in range(0, 2 * ny, 2):
            for step, share in enumerate([1 / 6, 4 / 6, 1 / 6]):
                at = node(2 * nx, j + step)
                loads[at] = loads.get(at, 0.0) + share * force / ny
    text = ["*NODE,NSET=NALL"]
    text += [f"{k},{LENGTH * i / (2 * nx):.10g},{WIDTH * j / (2 * ny):.10g},0." for (i, j), k in nodes.items()]
    text += ["*ELEMENT,TYPE=S8R,ELSET=ALL"]
    text += [",".join(map(str, [k + 1] + element)) for k, element in enumerate(elements)]
    text += [f"*MATERIAL,NAME=M\n*ELASTIC\n{E},{poisson}\n*SHELL SECTION,ELSET=ALL,MATERIAL=M\n{THICKNESS}"]
    text += ["*BOUNDARY"] + [f"{node(0, j)},1,6" for j in range(2 * ny + 1)]
    text += ["*STEP,NLGEOM,INC=1000\n*STATIC\n0.1,1.0,1e-6,0.25\n*CLOAD"]
    text += [f"{k},3,{value:.12g}" for k, value in loads.items()]
    corners = [node(2 * nx, 2 * ny), node(2 * nx, 0)]
    text += [f"*NSET,NSET=CORNERS\n{corners[0]},{corners[1]}"]
    text += ["*NODE PRINT,NSET=CORNERS,FREQUENCY=1000\nU\n*END STEP\n"]
    return "\n".join(text), corners


def plates():
    """Corner displacements of both plates on two meshes."""
    for case in PLATES:
        for nx, ny in [(16, 6), (32, 10)]:
            deck, (loaded, other) = plate(case, nx, ny)
            steps, said = solve(deck)
            if steps is None:
                sys.exit(f"second_opinion: {case}: {said}")
            at = lambda node: " ".join(f"{x:10.5f}" for x in steps[-1][node])
            print(f"{case:6} S8R {nx:3} x {ny:3}: loaded corner {at(loaded)}   other corner {at(other)}")


def alone(path):
    """Displacements (mm) of the printed nodes of a deck, from the end of its first step if it has two."""
    steps, said = solve(path.read_text())
    if steps is None:
        return {"run": path.stem, "outcome": "CalculiX does not reach the full load", "said": said}
    rest = steps[0] if len(steps) > 1 else {}
    moved = {node: [a - b for a, b in zip(u, rest.get(node, [0.0] * 3))] for node, u in steps[-1].items()}
    return {"part": path.stem, "outcome": "solved", "moved_mm": moved}


def main(arguments):
    as_json = "--json" in arguments
    arguments = [argument for argument in arguments if argument != "--json"]
    if arguments and arguments[0] == "--plates":
        plates()
        return 0
    if not arguments:
        sys.exit(__doc__)
    runs = map(Path, arguments)
    results = [alone(run) if run.suffix == ".inp" else compare(run) for run in runs]
    text = lambda result: json.dumps(result) + "\n" if "part" in result else page(result)
    print(json.dumps(results, indent=1) if as_json else "\n".join(map(text, results)), end="")
    return int(any(result["outcome"] != "solved" for result in results))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
