"""A wing read and meshed, and the same solved: the library's own types."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import pytest
from conftest import REPOSITORY, SOON_S, interrupted_after

import washout

DESIGN = "designs/twist-v2.toml"
COARSE: dict[str, float] = {"mesh.refine": 0.5}


@pytest.fixture(scope="module")
def wing() -> washout.Wing:
    return washout.Wing.open(DESIGN)


@pytest.fixture(scope="module")
def coarse() -> washout.Wing:
    return washout.Wing.open(DESIGN, COARSE)


@pytest.fixture(scope="module")
def solved(wing: washout.Wing) -> washout.SolvedWing:
    return wing.solve()


def test_a_wing_knows_its_design_its_outline_and_its_mesh(wing: washout.Wing, run: washout.Run) -> None:
    assert wing.name == "twist-v2"
    assert wing.design == run.summary["design"]
    outline = run.summary["wing"]
    assert (wing.length_mm, wing.mean_chord_mm, wing.area_mm2) == (
        outline["length_mm"],
        outline["mean_chord_mm"],
        outline["area_mm2"],
    )
    assert wing.counts == {name: run.counts[name] for name in ("nodes", "triangles", "beams")}
    for name in ("triangles", "beams", "leading_edge", "trailing_edge"):
        assert getattr(wing.mesh, name).tolist() == getattr(run.shape, name).tolist(), name
    np.testing.assert_allclose(wing.mesh.nodes_mm, run.shape.rest_mm, atol=1e-12)


def test_a_solved_wing_is_that_of_solve_to_the_bit(solved: washout.SolvedWing, run: washout.Run) -> None:
    assert solved.profile.rows == run.summary["profile"]
    assert solved.along_span.rows == run.summary["along_span"]
    assert solved.stages.rows == run.summary["stages"]["stages"]
    assert solved.tip_twist_deg == run.tip_twist_deg
    lift = solved.lift
    assert lift is not None and lift.solved == run.lift and lift.stroke_mean == run.mean_lift
    for name, values in run.strips.items():
        assert solved.strips[name].tolist() == values.tolist(), name
    for name, values in vars(run.shape).items():
        assert getattr(solved.shape, name).tolist() == values.tolist(), name


def test_the_run_holds_its_wing_and_its_solved_wing(run: washout.Run) -> None:
    assert run.wing.name == run.solved.name == run.name
    assert run.solved.wing is run.wing
    assert run.solved.tip_twist_deg == run.tip_twist_deg


def test_twist_is_read_at_a_place_or_at_many(solved: washout.SolvedWing) -> None:
    rows = solved.along_span
    np.testing.assert_allclose(solved.twist_at(rows["r_mm"]), rows["twist_deg"], atol=1e-9)
    twist_deg = solved.twist_at(rows["r_mm"][7])
    assert isinstance(twist_deg, float) and twist_deg == pytest.approx(rows["twist_deg"][7], abs=1e-9)
    assert solved.twist_at([20.0, 40.0]).tolist() == [solved.twist_at(20.0), solved.twist_at(40)]
    places_mm = np.array([[10, 20, 30], [40, 50, 60]])
    grid = solved.twist_at(places_mm)
    assert grid.shape == (2, 3) and not np.ma.isMaskedArray(grid)
    assert solved.twist_at(places_mm.T[::-1]).tolist() == grid.T[::-1].tolist()


def test_off_the_wing_there_is_no_twist(solved: washout.SolvedWing) -> None:
    assert solved.twist_at(-1.0) is None and solved.twist_at(500.0) is None and solved.twist_at(float("nan")) is None
    twist_deg = solved.twist_at([40.0, 500.0])
    assert isinstance(twist_deg, np.ma.MaskedArray)
    assert twist_deg.tolist() == [solved.twist_at(40.0), None]
    assert np.isfinite(np.ma.getdata(twist_deg)).all()


def test_a_value_gives_another_wing_and_leaves_the_first(coarse: washout.Wing) -> None:
    faster = coarse.with_value("flapping.frequency_hz", 25)
    assert faster.design["flapping"]["frequency_hz"] == 25.0
    assert coarse.design["flapping"]["frequency_hz"] == 23.0
    by_sets = washout.Wing.open(DESIGN, {**COARSE, "flapping.frequency_hz": 25})
    assert faster.solve().profile.rows == by_sets.solve().profile.rows
    finer = coarse.with_value("mesh.refine", np.float64(1))
    assert finer.counts["nodes"] > 2 * coarse.counts["nodes"]


def test_an_effect_changes_the_twist_and_strength_0_does_not(coarse: washout.Wing) -> None:
    plain = coarse.solve().profile["twist_deg"]
    none = coarse.with_effect("root-flexure", 0.0)
    assert none.solve().profile["twist_deg"].tolist() == plain.tolist()
    softer = coarse.with_effect("root-flexure", 0.3)
    assert softer.design["effects"]["root-flexure"]["strength"] == 0.3
    assert abs(softer.solve().profile["twist_deg"] - plain).max() > 0.1


def test_what_is_refused_is_named(coarse: washout.Wing) -> None:
    with pytest.raises(washout.InputError, match="must lie in") as caught:
        coarse.with_value("flapping.frequency_hz", -3.0)
    assert (caught.value.key, caught.value.value) == ("flapping.frequency_hz", "-3") and caught.value.cure
    with pytest.raises(washout.InputError, match="frequency_hz is expected"):
        coarse.with_value("flapping.frequency", 25.0)
    with pytest.raises(washout.InputError, match="did you mean root-flexure") as unknown:
        coarse.with_effect("root-flexur", 0.3)
    assert (unknown.value.file, unknown.value.key) == (DESIGN, "effects.root-flexur")
    with pytest.raises(washout.InputError, match="nowhere") as missing:
        washout.Wing.open("designs/nowhere.toml")
    assert missing.value.file == "designs/nowhere.toml"


def test_a_wing_without_a_solution_can_be_opened_and_changed_but_not_solved() -> None:
    wing = washout.Wing.open(DESIGN, {**COARSE, "coupling.max_iterations": 1}).with_value("flapping.frequency_hz", 22)
    with pytest.raises(washout.NotConverged) as caught:
        wing.solve()
    assert caught.value.file == DESIGN


def test_a_design_can_be_given_as_text(solved: washout.SolvedWing, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(REPOSITORY / "designs")
    wing = washout.Wing.open((REPOSITORY / DESIGN).read_text())
    assert wing.solve().tip_twist_deg == solved.tip_twist_deg


def test_files_are_those_of_a_run_without_the_error_of_the_mesh(
    solved: washout.SolvedWing, run: washout.Run, tmp_path: Path
) -> None:
    folder = solved.write(tmp_path / "wing")
    for path in run.write(tmp_path / "run").iterdir():
        if path.name not in ("summary.json", ".washout.json"):
            assert (folder / path.name).read_bytes() == path.read_bytes(), path.name
    checked = washout.run("check", folder)
    assert checked["kind"] == "check"
    assert "one mesh only" in (folder / "summary.json").read_text()


def test_a_folder_of_the_user_is_not_replaced(solved: washout.SolvedWing, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(washout.InputError, match="notes.txt"):
        solved.write(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


@pytest.mark.usefixtures("listening")
def test_ctrl_c_stops_the_solve_of_a_wing(wing: washout.Wing) -> None:
    fine = wing.with_value("mesh.refine", 4)
    assert interrupted_after(0.5, fine.solve) < SOON_S


def test_other_threads_run_while_a_wing_is_solved(wing: washout.Wing, solved: washout.SolvedWing) -> None:
    found: list[float | None] = []
    threads = [threading.Thread(target=lambda: found.append(wing.solve().tip_twist_deg)) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == [solved.tip_twist_deg] * 2


def test_progress_is_heard_and_stops_the_work(coarse: washout.Wing) -> None:
    heard: list[str] = []
    coarse.solve(progress=heard.append)
    assert heard[0] == "solving twist-v2"

    def give_up(line: str) -> None:
        raise LookupError(line)

    with pytest.raises(LookupError, match="solving twist-v2"):
        coarse.solve(progress=give_up)


def test_a_notebook_shows_the_wing_and_its_twist(wing: washout.Wing, solved: washout.SolvedWing) -> None:
    assert repr(wing).startswith("<washout.Wing twist-v2: ") and "<table>" in wing._repr_html_()
    assert f"tip twist {solved.tip_twist_deg:.2f} deg" in repr(solved)
    shown = solved._repr_html_()
    assert shown.count("<tr>") == 1 + len(solved.profile.rows)


def test_lift_is_as_the_flow_has_it() -> None:
    steady = washout.Wing.open("designs/pre-pazy.toml", COARSE).solve().lift
    assert steady is not None and steady.solved.name == "steady stream" and steady.stroke_mean is None
    still = washout.Wing.open("designs/minguet-1.toml", COARSE).solve()
    assert still.lift is None and "alpha_deg" not in still.profile
