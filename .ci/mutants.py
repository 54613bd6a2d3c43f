#!/usr/bin/env python3
"""How many mutants of the six rooms that compute do the tests catch?

    pip install tree-sitter tree-sitter-rust && cargo install cargo-mutants
    .ci/mutants.py --number 200 --seed 1

cargo-mutants lists the mutants. Building the tests for each would take days, so a random sample of them is put into one build,
each behind a switch that the environment turns on. Every test is run once to learn which mutants its code passes; then each
mutant runs the tests that pass it, the quickest first, until one fails or takes five times as long as it should. A mutant that
no test passes is missed. Those that do not compile are left out, as cargo-mutants leaves them out.

Everything happens in a copy under target/mutants; `results.json` there has a line for each mutant, and a run that is stopped
goes on where it was. Doc tests and Python take no part.
"""

import argparse
import json
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import tree_sitter_rust
from tree_sitter import Language, Parser

ROOMS = {
    **dict.fromkeys(["structure", "aero", "coupling", "observation"], "crates/washout-wing/src"),
    **dict.fromkeys(["compare", "diagnose"], "crates/washout-study/src"),
}
TOP = Path(__file__).resolve().parent.parent
RUST = Parser(Language(tree_sitter_rust.language()))
OPERATION = {"binary_expression", "compound_assignment_expr", "unary_expression"}

SWITCHES = """
//! Which mutant is on: the environment says so once.
use std::{env, fs, io::Write, sync::LazyLock, sync::atomic::{AtomicBool, Ordering}};

static ON: LazyLock<usize> = LazyLock::new(|| env::var("WASHOUT_MUTANT").ok().and_then(|id| id.parse().ok()).unwrap_or(usize::MAX));
static NOTE: LazyLock<Option<String>> = LazyLock::new(|| env::var("WASHOUT_REACHED").ok());
static REACHED: [AtomicBool; NUMBER] = [const { AtomicBool::new(false) }; NUMBER];

/// True if this mutant is on. Notes, if asked, that it was passed.
#[must_use]
pub fn is_on(id: usize) -> bool {
    if let Some(file) = NOTE.as_ref()
        && !REACHED[id].swap(true, Ordering::Relaxed)
        && let Ok(mut file) = fs::OpenOptions::new().append(true).create(true).open(file)
    {
        let _ = file.write_all(format!("{id}\\n").as_bytes());
    }
    *ON == id
}
"""


def offset(lines, place):
    """Bytes before a place of cargo-mutants: line and column count from 1, columns in characters."""
    head = sum(len(line) for line in lines[: place["line"] - 1])
    return head + len(lines[place["line"] - 1].decode()[: place["column"] - 1].encode())


def smallest(node, start, end, kinds):
    """The innermost node of one of these kinds around the bytes."""
    found = None
    while node is not None:
        if node.type in kinds:
            found = node
        node = next((child for child in node.children if child.start_byte <= start and end <= child.end_byte), None)
    return found


def changed(text, tree, mutant):
    """(start, end, pieces): where the source changes. The pieces hold texts of it and the mutant's own words; None if it cannot be switched."""
    lines = text.splitlines(keepends=True)
    start, end = offset(lines, mutant["span"]["start"]), offset(lines, mutant["span"]["end"])
    new = mutant["replacement"]
    on = f"crate::mutants::is_on({mutant['id']})"
    genre = mutant["genre"]
    if genre == "FnValue":
        block = smallest(tree.root_node, start, end, {"block"})
        if block is None:
            return None
        return [(block.start_byte + 1, f" if {on} {{ return {new.split('/*')[0]}; }} ")]
    if genre in ("BinaryOperator", "UnaryOperator"):
        node = smallest(tree.root_node, start, end, OPERATION)
        if node is None:
            return None
        whole = text[node.start_byte : node.end_byte]
        mutated = text[node.start_byte : start] + new.split("/*")[0].encode() + text[end : node.end_byte]
        opening = f"(if {on} {{ {mutated.decode()} }} else {{ "
        if node.type == "compound_assignment_expr":
            opening = opening[1:]
            return [(node.start_byte, opening), (node.end_byte, " }")]
        return [(node.start_byte, opening), (node.end_byte, " })")]
    if genre == "MatchArm":
        arm = smallest(tree.root_node, start, end, {"match_arm"})
        pattern = arm.child_by_field_name("pattern") if arm else None
        if pattern is None:
            return None
        guard = pattern.child_by_field_name("condition")
        if guard is None:
            return [(pattern.end_byte, f" if !{on}")]
        return [(guard.start_byte, f"!{on} && ("), (guard.end_byte, ")")]
    if genre == "MatchArmGuard":
        return [(start, f"if {on} {{ {new} }} else {{ "), (end, " }")]
    return None


def mutants(tree, number, seed):
    command = ["cargo", "mutants", "--list", "--json", "--no-config", "--workspace", "--dir", str(tree)]
    for room in ROOMS:
        command += ["-f", f"{ROOMS[room]}/{room}/**"]
    listed = json.loads(subprocess.run(command, check=True, capture_output=True, cwd=tree).stdout)
    print(f"{len(listed)} mutants in {', '.join(ROOMS)}")
    chosen = random.Random(seed).sample(listed, number)
    for id, mutant in enumerate(chosen):
        mutant["id"] = id
    return chosen


def planted(tree, chosen):
    """Puts the switches into the copy; gives for each file the line numbers of each mutant."""
    for name in {mutant["file"] for mutant in chosen}:
        text = (TOP / name).read_bytes()
        parsed = RUST.parse(text)
        insertions = []
        taken = []
        for mutant in chosen:
            if mutant["file"] != name or "left_out" in mutant:
                continue
            places = changed(text, parsed, mutant)
            if places is None:
                mutant["left_out"] = f"{mutant['genre']} cannot be switched"
                continue
            span = (places[0][0], places[-1][0])
            # one expression inside another would mutate a copy that is not the one seen
            if any(span[0] < other[1] and other[0] < span[1] for other in taken):
                mutant["left_out"] = "inside another of the sample"
                continue
            taken.append(span)
            insertions += [(place, order, piece) for order, (place, piece) in enumerate(places)]
        # from the end, so that places stay
        for place, _, piece in sorted(insertions, reverse=True):
            text = text[:place] + piece.encode() + text[place:]
        (tree / name).write_bytes(text)


def copy(tree):
    tree.mkdir(parents=True, exist_ok=True)
    listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=TOP, check=True, capture_output=True).stdout.decode().split("\0")
    for name in filter(None, listed):
        (tree / name).parent.mkdir(parents=True, exist_ok=True)
        if not (TOP / name).is_symlink() and (TOP / name).exists():
            shutil.copy2(TOP / name, tree / name)
    # tables of a campaign hold what a mutant made: each has a folder of its own
    main = tree / "tests/cli/main.rs"
    was = 'command.env("WASHOUT_CACHE", concat!(env!("CARGO_TARGET_TMPDIR"), "/cache"));'
    assert was in main.read_text()
    own = 'command.env("WASHOUT_CACHE", std::env::var("WASHOUT_CACHE").unwrap_or_default());'
    main.write_text(main.read_text().replace(was, own))


def compiled(tree, chosen):
    """Leaves out, one round after the other, what does not compile."""
    # the switches are in the lowest crate, and the others see them there
    lowest = "crates/washout-design/src"
    (tree / lowest / "mutants.rs").write_text(SWITCHES.replace("NUMBER", str(len(chosen))))
    for crate in {lowest, *ROOMS.values()}:
        library = (TOP / crate / "lib.rs").read_text()
        module = "pub mod mutants;\n\n" if crate == lowest else "use washout_design::mutants;\n\n"
        head = library.index("\n\n") + 2
        (tree / crate / "lib.rs").write_text(library[:head] + module + library[head:])
    while True:
        planted(tree, chosen)
        run = subprocess.run(["cargo", "check", "--workspace", "--lib", "--message-format=json"], cwd=tree, capture_output=True, text=True)
        if run.returncode == 0:
            return
        wrong = set()
        for line in run.stdout.splitlines():
            message = json.loads(line).get("message") or {}
            if not isinstance(message, dict) or message.get("level") != "error":
                continue
            for span in message.get("spans", []):
                source = (tree / span["file_name"]).read_bytes().splitlines(keepends=True)
                before = b"".join(source[: span["line_end"]])
                ids = re.findall(rb"is_on\((\d+)\)", b"".join(source[span["line_start"] - 1 : span["line_end"]]))
                wrong |= {int(id) for id in ids} or {int(id) for id in re.findall(rb"is_on\((\d+)\)", before)[-1:]}
        wrong = {id for id in wrong if "left_out" not in chosen[id]}
        if not wrong:
            sys.exit(run.stderr + "\nno mutant can be blamed for this")
        print(f"{len(wrong)} do not compile")
        for id in wrong:
            chosen[id]["left_out"] = "does not compile"


def executables(tree):
    run = subprocess.run(
        ["cargo", "test", "--release", "--no-run", "--message-format=json"], cwd=tree, check=True, capture_output=True, text=True
    )
    found = {}
    for line in run.stdout.splitlines():
        message = json.loads(line)
        if message.get("executable") and message["profile"]["test"]:
            kind, name = message["target"]["kind"], message["target"]["name"]
            if kind in (["lib"], ["test"]):
                found[name] = message["executable"]
    return found


def once(tree, executable, test, limit, environment):
    """(passed, seconds, output) of one test, alone. Seconds are of the processor, so that other work on the machine changes nothing."""
    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(
            [executable, "--exact", test],
            cwd=tree,
            env={**os.environ, "RAYON_NUM_THREADS": "1", "RUST_BACKTRACE": "0", **environment},
            stdout=output,
            stderr=subprocess.STDOUT,
            start_new_session=True,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(limit) + 1,) * 2),
        )
        # a test that waits for ever uses no time of the processor
        late = threading.Timer(20 * limit, os.killpg, (process.pid, signal.SIGKILL))
        late.start()
        _, status, used = os.wait4(process.pid, 0)
        late.cancel()
        process.returncode = status
        # what the test has started ends with it
        try:
            os.killpg(process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        output.seek(0)
        said = output.read().decode(errors="replace")
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGKILL, signal.SIGXCPU):
        said = "took too long"
    return status == 0, used.ru_utime + used.ru_stime, said


def baseline(tree, folder, tests, workers):
    """For each test: the seconds it takes and the mutants it passes."""
    kept = folder / "baseline.json"
    known = json.loads(kept.read_text()) if kept.exists() else {}

    def run(job):
        name, executable, test = job
        key = f"{name} {test}"
        if key in known:
            return
        note = folder / f"reached-{abs(hash(key))}"
        note.unlink(missing_ok=True)
        cache = folder / f"cache-{abs(hash(key))}"
        passed, seconds, output = once(
            tree, executable, test, 1800, {"WASHOUT_REACHED": str(note), "WASHOUT_CACHE": str(cache)}
        )
        reached = sorted({int(line) for line in note.read_text().split()}) if note.exists() else []
        note.unlink(missing_ok=True)
        shutil.rmtree(cache, ignore_errors=True)
        known[key] = {"seconds": seconds, "reached": reached, "passed": passed}
        if not passed:
            print(f"left out, for it fails without a mutant: {key}: {output[-300:]}")

    with ThreadPoolExecutor(workers) as pool:
        for done, _ in enumerate(pool.map(run, tests)):
            if done % 20 == 0:
                kept.write_text(json.dumps(known))
    kept.write_text(json.dumps(known))
    return known


def judged(tree, folder, chosen, found, known, workers, longest):
    results = folder / "results.json"
    done = {line["id"]: line for line in json.loads(results.read_text())} if results.exists() else {}

    def run(mutant):
        id = mutant["id"]
        if id in done and done[id].get("caught") is not False:
            return
        reaching = sorted(
            (entry["seconds"], key) for key, entry in known.items() if entry["passed"] and id in entry["reached"]
        )
        verdict = {**mutant, "caught": False, "reaching": len(reaching), "ran": 0}
        spent = 0.0
        for seconds, key in reaching:
            if spent > longest:
                break
            name, test = key.split(" ", 1)
            cache = folder / f"cache-{id}"
            passed, took, output = once(
                tree, found[name], test, 60 + 5 * seconds, {"WASHOUT_MUTANT": str(id), "WASHOUT_CACHE": str(cache)}
            )
            shutil.rmtree(cache, ignore_errors=True)
            spent += took
            verdict["ran"] += 1
            if not passed:
                verdict |= {"caught": True, "by": key, "how": "time" if output == "took too long" else "failed"}
                break
        verdict["seconds"] = spent
        done[id] = verdict
        results.write_text(json.dumps(sorted(done.values(), key=lambda line: line["id"]), indent=1))
        caught = sum(line["caught"] for line in done.values())
        print(f"{len(done)} done, {caught} caught; {'caught' if verdict['caught'] else 'MISSED'} {mutant['name']} ({spent:.0f} s)", flush=True)

    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(run, [mutant for mutant in chosen if "left_out" not in mutant]))
    return done


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--number", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--longest", type=float, default=900.0, help="seconds of tests for one mutant")
    parser.add_argument("--folder", type=Path, default=TOP / "target/mutants")
    parser.add_argument("--list", action="store_true", help="plant and build, and end there")
    asked = parser.parse_args()
    folder, tree = asked.folder, asked.folder / "tree"
    plan = folder / "chosen.json"
    if plan.exists():
        chosen = json.loads(plan.read_text())
    else:
        copy(tree)
        chosen = mutants(tree, asked.number, asked.seed)
        compiled(tree, chosen)
        plan.write_text(json.dumps(chosen, indent=1))
    tried = [mutant for mutant in chosen if "left_out" not in mutant]
    print(f"{len(tried)} of {len(chosen)} compile behind a switch")
    found = executables(tree)
    tests = []
    for name, executable in found.items():
        listed = subprocess.run([executable, "--list", "--format", "terse"], cwd=tree, capture_output=True, text=True).stdout
        tests += [(name, executable, line.removesuffix(": test")) for line in listed.splitlines() if line.endswith(": test")]
    ignored = set()
    for name, executable in found.items():
        listed = subprocess.run([executable, "--list", "--format", "terse", "--ignored"], cwd=tree, capture_output=True, text=True).stdout
        ignored |= {(name, line.removesuffix(": test")) for line in listed.splitlines() if line.endswith(": test")}
    tests = [job for job in tests if (job[0], job[2]) not in ignored]
    print(f"{len(tests)} tests")
    if asked.list:
        return
    known = baseline(tree, folder, tests, asked.workers)
    done = judged(tree, folder, chosen, found, known, asked.workers, asked.longest)
    caught = sum(line["caught"] for line in done.values())
    print(f"\ncaught {caught} of {len(done)}: {100 * caught / len(done):.0f} %")
    for line in done.values():
        if not line["caught"]:
            print(f"missed: {line['name']}; {line['reaching']} tests pass it")


if __name__ == "__main__":
    main()
