"""A solve from Python is the solve of the command line, to the bit."""

from __future__ import annotations

import csv
import threading
import time
from pathlib import Path

import numpy as np
import pytest
from conftest import REPOSITORY, CommandLine, Printed

import washout

DESIGN = "designs/twist-v2.toml"


def table(path: Path) -> dict[str, list[str]]:
    """The columns of a CSV file."""
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: [row[name] for row in rows] for name in rows[0]}


def files(folder: Path) -> dict[str, bytes]:
    """Every file of a folder."""
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def test_the_folder_is_that_of_the_command_line_byte_for_byte(
    run: washout.Run, command_line: CommandLine, tmp_path: Path
) -> None:
    done = command_line("solve", DESIGN, "--output", tmp_path / "shell", "--quiet")
    assert done.returncode == 0, done.stderr
    assert run.write(tmp_path / "python") == tmp_path / "python"
    assert files(tmp_path / "python") == files(tmp_path / "shell")


def test_arrays_are_the_numbers_of_the_tables_to_the_bit(run: washout.Run, tmp_path: Path) -> None:
    folder = run.write(tmp_path / "run")
    for name, values in table(folder / "strips.csv").items():
        assert [float(value) for value in values] == run.strips[name].tolist(), name
    profile = table(folder / "profile.csv")
    assert run.alpha_deg is not None
    for name in ["r_mm", "chord_mm", "twist_deg", "alpha_deg"]:
        assert [float(value) for value in profile[name]] == run.along_span[name].tolist(), name
    assert set(run.r_mm) <= set(run.along_span["r_mm"])


def test_scalars_are_those_of_the_summary(run: washout.Run) -> None:
    assert run.lift is not None and run.mean_lift is not None
    assert run.tip_twist_deg == run.summary["tip"]["twist_deg"] == run.twist_deg[-1]
    assert run.lift.lift_mn == run.summary["lift"]["solved"]["lift_mn"]
    assert run.mean_lift.power_mw == run.summary["lift"]["stroke_mean"]["power_mw"]
    assert run.counts["nodes"] == len(run.shape.rest_mm)
    assert run.counts["dof"] == run.summary["solve"]["dof"]
    assert run.convergence["outcome"] == "converged" and run.convergence["residual"] < 1e-6


def test_the_shape_belongs_to_the_summary_and_to_itself(run: washout.Run) -> None:
    shape, tip = run.shape, run.summary["tip"]
    moved = shape.deformed_mm - shape.rest_mm
    np.testing.assert_allclose(moved[tip["node"]], tip["displacement_mm"], atol=1e-12)
    assert shape.leading_edge[-1] == tip["node"]
    assert shape.triangles.shape == (run.counts["triangles"], 3)
    assert shape.beams.shape == (run.counts["beams"], 2)
    assert set(np.unique(shape.triangles)) <= set(range(run.counts["nodes"]))
    edge = shape.rest_mm[shape.triangles]
    area_mm2 = 0.5 * np.cross(edge[:, 1] - edge[:, 0], edge[:, 2] - edge[:, 0])[:, 2].sum()
    assert area_mm2 == pytest.approx(run.summary["wing"]["area_mm2"], rel=2e-3)


def test_the_air_force_on_the_nodes_is_that_of_the_strips(run: washout.Run) -> None:
    strips, force = run.strips, run.shape.air_force_mn.sum(axis=0)
    size = np.hypot(strips["normal_n_per_m"], strips["tangential_n_per_m"]) * strips["width_mm"]
    assert np.linalg.norm(force) == pytest.approx(size.sum(), rel=0.02)


def test_nothing_is_nan(run: washout.Run) -> None:
    arrays = [*run.strips.values(), *vars(run.shape).values(), run.r_mm, run.twist_deg]
    assert all(np.isfinite(array).all() for array in arrays)


def test_sets_change_the_design(printed: Printed, tmp_path: Path) -> None:
    sets = {"flapping.frequency_hz": np.float64(25.0), "mesh.refine": 0.5}
    run = washout.solve(Path(DESIGN), sets)
    assert run.summary["design"]["flapping"]["frequency_hz"] == 25.0
    options = ["--set", "flapping.frequency_hz=25.0", "--set", "mesh.refine=0.5", "--output", tmp_path / "run"]
    document = printed("solve", DESIGN, *options)
    assert {**document, "files": []} == run.summary


def test_a_text_is_solved_as_a_file_is(run: washout.Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(REPOSITORY / "designs")
    text = (REPOSITORY / DESIGN).read_text()
    of_text = washout.solve(text)
    assert of_text.twist_deg.tolist() == run.twist_deg.tolist()
    assert of_text.summary["design_file"] == "<text>"


def test_the_stroke_is_a_matrix_of_phases_and_stations() -> None:
    run = washout.solve(DESIGN, {"mesh.refine": 0.5}, stroke=6)
    assert run.stroke is not None and run.stroke.mean is not None
    stroke = run.stroke
    assert stroke.kind == "periodic" and stroke.phase_deg.tolist() == [0, 60, 120, 180, 240, 300]
    assert stroke.twist_deg.shape == (6, stroke.r_mm.size)
    assert stroke.twist_deg[:, -1].tolist() == stroke.phases["tip_twist_deg"].tolist()
    assert stroke.forces["lift_mn"].shape == (6,)


def test_other_threads_run_during_a_solve() -> None:
    beats, done = 0, threading.Event()

    def beat() -> None:
        nonlocal beats
        while not done.wait(0.005):
            beats += 1

    thread = threading.Thread(target=beat)
    thread.start()
    start = time.monotonic()
    washout.solve(DESIGN)
    lasted = time.monotonic() - start
    done.set()
    thread.join()
    assert beats > 0.2 * lasted / 0.005


def test_two_threads_solve_at_once(run: washout.Run) -> None:
    found: list[float | None] = []
    threads = [threading.Thread(target=lambda: found.append(washout.solve(DESIGN).tip_twist_deg)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [run.tip_twist_deg] * 2


def test_progress_is_heard() -> None:
    heard: list[str] = []
    washout.solve(DESIGN, progress=heard.append)
    assert heard[0] == "solving twist-v2" and len(heard) > 2
