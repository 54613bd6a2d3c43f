"""Kills every verb that writes at every system call that creates, renames, links, removes or syncs, and looks at what is left.

    python3 .ci/kills.py [WASHOUT] [--every N] [--at-once N] [--only VERB]

Needs strace (Linux). For each verb an earlier result stands under its name. The verb runs again with other inputs and is killed as it enters the
call. Then the name must hold the earlier result whole, or the new one whole, and the verb must do its work when it is run once more, with the same
bytes as if nothing had happened and nothing left over. `--every 7` takes each seventh call only. Then two of the verb run at once, so many times:
both do their work, or one is refused; nothing is lost or mixed.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile

CALLS = "rename,renameat,renameat2,link,linkat,unlink,unlinkat,rmdir,mkdir,mkdirat,fsync,fdatasync,openat,ftruncate,write"
# of these only the ones that create or change something are worth a kill
CHANGES = re.compile(r"^\d+ +(\w+)\((.*)")

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("washout", nargs="?", default="target/release/washout")
parser.add_argument("--every", type=int, default=1, metavar="N")
parser.add_argument("--at-once", type=int, default=20, metavar="N")
parser.add_argument("--only", metavar="VERB")
given = parser.parse_args()
washout = os.path.abspath(given.washout)
root = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
environment = dict(os.environ, WASHOUT_CACHE="", RAYON_NUM_THREADS="1")
COARSE = ["--set", "mesh.refine=0.2"]


class Case:
    """A verb: the run that makes the earlier result, the run that is killed, and the names that hold results."""

    def __init__(self, verb, before, killed, names, timed=False):
        self.verb, self.before, self.killed, self.names = verb, before, killed, names
        # whether its files say how long it took: that differs from run to run
        self.timed = timed


def solve(*more):
    return ["solve", "rigid.toml", *COARSE, *more, "--output", "run"]


FEW = ["--no-gain", "--population", "10", "--generations", "3"]


def design(*more):
    return ["design", "twist-v2.toml", "--stock", "few.csv", "--like", "twist-v2.toml", "--pieces", "1", "--set", "mesh.refine=0.4", *more, "--output", "out"]


def blind(seed):
    return ["blind", "1", "--study", "study.toml", "--effect", "root-flexure", "--kind", "single", "--seed", seed, "--output", "out"]


CASES = [
    Case("solve", [solve()], solve("--set", "flapping.frequency_hz=21"), ["run"]),
    Case(
        "compare",
        [["compare", "twist-v2.toml", *COARSE, "--output", "out"]],
        ["compare", "twist-v2.toml", *COARSE, "--set", "flapping.frequency_hz=21", "--output", "out"],
        ["out"],
    ),
    Case(
        "lift",
        [["lift", "rigid.toml", *COARSE, "--output", "out"]],
        ["lift", "rigid.toml", *COARSE, "--set", "flapping.frequency_hz=21", "--output", "out"],
        ["out"],
    ),
    Case(
        "sweep",
        [],
        ["sweep", "rigid.toml", *COARSE, "--vary", "flapping.frequency_hz=20,22", "--output", "out"],
        ["out"],
    ),
    Case(
        "mesh",
        [["mesh", "rigid.toml", *COARSE, "--output", "out"]],
        ["mesh", "twist-v1.toml", *COARSE, "--output", "out"],
        ["out"],
    ),
    Case(
        "modes",
        [["modes", "rigid.toml", *COARSE, "--output", "out"]],
        ["modes", "twist-v1.toml", *COARSE, "--output", "out"],
        ["out"],
    ),
    Case("report", [solve(), ["report", "run"]], ["report", "run"], ["run"]),
    Case(
        "plot",
        [solve(), ["plot", "run", "--output", "out"]],
        ["plot", "run", "--only", "twist", "--output", "out"],
        ["out"],
    ),
    Case(
        "export",
        [solve(), ["export", "--to", "calculix", "run", "--output", "out"]],
        ["export", "--to", "kratos", "run", "--output", "out"],
        ["out"],
    ),
    Case(
        "synthesize",
        [["synthesize", "study.toml", "--seed", "1", "--output", "made"]],
        ["synthesize", "study.toml", "--seed", "2", "--output", "made"],
        ["made"],
    ),
    Case(
        "diagnose",
        [["synthesize", "study.toml", "--seed", "1", "--output", "made"], ["diagnose", "made/study.toml", "--seed", "5", "--output", "out"]],
        ["diagnose", "made/study.toml", "--seed", "5", "--effect", "root-flexure", "--output", "out"],
        ["out"],
    ),
    Case(
        "add",
        [["synthesize", "study.toml", "--seed", "1", "--output", "made"]],
        ["add", "root-flexure", "--to", "made/study.toml", "--output", "more.toml"],
        ["more.toml", "output/bench-ladder"],
    ),
    Case(
        "measure",
        [["measure", "video.toml", "--output", "read.csv"]],
        ["measure", "video.toml", "--force", "--output", "read.csv"],
        ["read.csv"],
    ),
    Case("init", [], ["init", "fresh"], ["fresh.toml", "materials.toml"]),
    Case(
        "pareto",
        [["pareto", "rigid.toml", *FEW, "--output", "out"]],
        ["pareto", "rigid.toml", *FEW, "--seed", "2", "--output", "out"],
        ["out"],
    ),
    Case(
        "design",
        [design()],
        design("--set", "flapping.frequency_hz=21"),
        ["out"],
    ),
    Case(
        "explain",
        [["synthesize", "study.toml", "--seed", "1", "--output", "made"], ["explain", "made/study.toml", "--output", "out"]],
        ["explain", "made/study.toml", "--effect", "root-flexure", "--output", "out"],
        ["out"],
    ),
    Case("blind", [blind("1")], blind("2"), ["out"], timed=True),
    Case(
        "verify",
        [["verify", "cook-membrane", "--short", "--output", "out"]],
        ["verify", "elastica", "--short", "--output", "out"],
        ["out"],
        timed=True,
    ),
]

ROD = """format = 1
name = 'rod'
[planform]
length_mm = 100.0
outline = [[0.0, 20.0], [100.0, 20.0]]
tip_cut = 1.0
[ribs]
bays = 10
[[rod]]
from_mm = 0.0
to_mm = 100.0
material = 'steel'
section = { shape = 'round', diameter_mm = 1.0 }
[material.steel]
e_gpa = 200.0
g_gpa = 80.0
poisson = 0.25
density_kg_m3 = 8000.0
[[load]]
at_mm = 100.0
moment_n_m = [0.001, 0.0, 0.0]
"""
STUDY = """format = 1
name = 'bench'
candidates = ['rod-shear-modulus', 'root-flexure']
[[case]]
design = 'rod.toml'
set = ['load[0].moment_n_m=[{moment*0.001}, 0, 0]']
measurement = 'm.csv'
measured = 'm-{moment}'
"""


STOCK = """name,shape,diameter_mm,material,tolerance_mm
round-1.0,round,1.0,carbon-rod,0.03
round-0.8,round,0.8,carbon-rod,0.03
"""


def inputs(folder):
    for name in ["rigid.toml", "twist-v1.toml", "twist-v2.toml", "materials.toml"]:
        shutil.copy(os.path.join(root, "designs", name), folder)
        path = os.path.join(folder, name)
        with open(path, encoding="utf-8") as file:
            text = file.read().replace("../measurements/", "")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    for name in os.listdir(os.path.join(root, "measurements")):
        if name.endswith(".csv"):
            shutil.copy(os.path.join(root, "measurements", name), folder)
    for name in ["video.toml", "video-marks.csv"]:
        shutil.copy(os.path.join(root, "examples", name), folder)
    with open(os.path.join(folder, "rod.toml"), "w", encoding="utf-8") as file:
        file.write(ROD)
    with open(os.path.join(folder, "study.toml"), "w", encoding="utf-8") as file:
        file.write(STUDY)
    with open(os.path.join(folder, "few.csv"), "w", encoding="utf-8") as file:
        file.write(STOCK)
    rows = ["case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound"]
    for moment in [1, 2, 3]:
        rows += [f"m-{moment},twist,chord_rotation,deg,washout,,{r},,,0.01,stated,none" for r in range(10, 101, 10)]
    with open(os.path.join(folder, "m.csv"), "w", encoding="utf-8") as file:
        file.write("\n".join(rows) + "\n")


def run(folder, arguments, before=()):
    return subprocess.run([*before, washout, *arguments], cwd=folder, env=environment, capture_output=True, text=True)


def done(folder, arguments):
    said = run(folder, arguments)
    if said.returncode != 0:
        sys.exit(f"washout {' '.join(arguments)} ends with {said.returncode}: {said.stderr}")


def held(folder, name):
    """What stands under a name: bytes of a file, or of each file of a folder."""
    path = os.path.join(folder, name)
    if os.path.isfile(path):
        with open(path, "rb") as file:
            return file.read()
    if not os.path.isdir(path):
        return None
    found = {}
    for below, _, files in os.walk(path):
        for file in files:
            whole = os.path.join(below, file)
            with open(whole, "rb") as opened:
                found[os.path.relpath(whole, path)] = opened.read()
    return found


def without_left_overs(found):
    if not isinstance(found, dict):
        return found
    is_own = lambda name: not any(part.startswith(".") and part != ".washout.json" for part in name.split(os.sep))
    return {name: text for name, text in found.items() if is_own(name)}


def calls(folder, arguments):
    """How often the first thread enters each call that changes something, by call."""
    log = os.path.join(folder, "calls.log")
    run(folder, arguments, ["strace", "-f", "-e", "trace=" + CALLS, "-o", log])
    with open(log, encoding="utf-8", errors="replace") as file:
        lines = file.read().splitlines()
    os.remove(log)
    first = lines[0].split()[0]
    numbers, worth = {}, []
    for line in lines:
        match = CHANGES.match(line)
        if not match or line.split()[0] != first:
            continue
        call, rest = match.groups()
        numbers[call] = numbers.get(call, 0) + 1
        # what goes to the terminal changes nothing
        if (call != "openat" or "O_CREAT" in rest) and not (call == "write" and rest.startswith(("1,", "2,"))):
            worth.append((call, numbers[call]))
    return worth


def differing(found, wanted):
    if not isinstance(found, dict) or not isinstance(wanted, dict):
        return "all"
    names = sorted(found.keys() | wanted.keys())
    return ", ".join(name for name in names if found.get(name) != wanted.get(name))


# what a file says of the time that something took, and the sums of such files
TIMES = [
    (re.compile(rb'"(time_s|median_seconds|seconds)": [0-9.e-]+'), rb'"time": 0'),
    (re.compile(rb"(,|\| )[0-9.e-]+(,| \| )(pass|fail)"), rb",0,pass"),
    (re.compile(rb'"(verify|scoreboard)[.a-z]*": "[0-9a-f]{64}"'), rb'"sum": 0'),
]


def found_in(case, folder, name):
    """What stands under a name, without the times."""
    found = held(folder, name)
    if not case.timed or not isinstance(found, dict):
        return found
    for file, text in found.items():
        for pattern, instead in TIMES:
            text = pattern.sub(instead, text)
        found[file] = text
    return found


def kept_names(case, folder):
    return {name: without_left_overs(found_in(case, folder, name)) for name in case.names}


def tried(case):
    with tempfile.TemporaryDirectory() as place:
        # results may hold the path of their inputs, so all runs are made in one folder
        start, folder = (os.path.join(place, name) for name in ["start", "here"])
        os.mkdir(folder)
        inputs(folder)
        for arguments in case.before:
            done(folder, arguments)
        shutil.move(folder, start)
        earlier = kept_names(case, start)
        shutil.copytree(start, folder)
        done(folder, case.killed)
        new = {name: found_in(case, folder, name) for name in case.names}
        shutil.rmtree(folder)
        shutil.copytree(start, folder)
        worth = calls(folder, case.killed)[:: given.every]
        kills = faults = 0
        for call, number in worth:
            shutil.rmtree(folder)
            shutil.copytree(start, folder)
            inject = f"inject={call}:signal=SIGKILL:when={number}"
            said = run(folder, case.killed, ["strace", "-f", "-e", "trace=" + call, "-e", inject, "-o", "/dev/null"])
            if said.returncode == 0:
                continue
            kills += 1
            for name, found in kept_names(case, folder).items():
                if found not in (earlier[name], without_left_overs(new[name])):
                    faults += 1
                    differ = differing(found, without_left_overs(new[name]))
                    print(f"{case.verb}: killed at {call} {number}: {name} is neither the earlier nor the new one ({differ} differs)")
            if all(found_in(case, folder, name) == new[name] for name in case.names):
                continue
            said = run(folder, case.killed)
            if said.returncode != 0:
                faults += 1
                print(f"{case.verb}: killed at {call} {number}, then run again: {said.stderr}")
                continue
            for name in case.names:
                if found_in(case, folder, name) != new[name]:
                    faults += 1
                    print(f"{case.verb}: killed at {call} {number}, then run again: {differing(found_in(case, folder, name), new[name])} differs")
        for _ in range(given.at_once):
            shutil.rmtree(folder)
            shutil.copytree(start, folder)
            command = [washout, *case.killed]
            pipes = dict(cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            both = [subprocess.Popen(command, **pipes) for _ in range(2)]
            said = [process.communicate()[1] for process in both]
            codes = [process.returncode for process in both]
            wrong = [name for name in case.names if found_in(case, folder, name) != new[name]]
            if 0 not in codes or not set(codes) <= {0, 1, 2} or wrong:
                faults += 1
                print(f"{case.verb}: two at once end with {codes}; {wrong} differ: {''.join(said)}")
        print(f"{case.verb}: {kills} kills, {given.at_once} times two at once, {faults} faults", flush=True)
        return kills, faults


chosen = [case for case in CASES if given.only in (None, case.verb)]
totals = [tried(case) for case in chosen]
kills, faults = (sum(part) for part in zip(*totals))
print(f"{kills} kills in all, {faults} faults")
sys.exit(1 if faults or not kills else 0)
