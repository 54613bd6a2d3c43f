"""A table of readings that Python holds, and what a notebook shows of the answer."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

import washout
from washout.readings import Readings, file_of
from washout.verb import toml

HEADS = ("r (mm)", "22 Hz", "18 Hz")
COLUMNS = {
    HEADS[0]: [15.0, 28.0, 40.0, 51.0, 62.0],
    HEADS[1]: [4.92, 7.05, 9.71, 16.9, 19.3],
    HEADS[2]: [3.60, 5.18, 7.21, 13.1, 15.2],
}
DESIGN = "designs/twist-v2.toml"


def diagnosed(readings: Readings) -> washout.Diagnosis:
    """Two effects, on a coarse mesh."""
    effects = ["root-flexure", "coefficient-scale"]
    return washout.diagnose(DESIGN, readings, {"mesh.refine": 0.4}, effects=effects, sigma=0.3)


def test_columns_a_frame_and_a_file_give_the_same_diagnosis(tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame(COLUMNS)
    path = tmp_path / "readings.csv"
    frame.to_csv(path, index=False)
    by_columns = diagnosed(COLUMNS)
    for readings in (frame, frame.set_index(HEADS[0]), path):
        other = diagnosed(readings)
        assert other.sentence == by_columns.sentence
        assert other.hypotheses.rows == by_columns.hypotheses.rows
    assert list(by_columns.hypotheses.to_frame()["what"]) == by_columns.hypotheses["what"].tolist()
    assert any("Not in the table, so taken to be" in note for note in by_columns.notes)
    shown = by_columns._repr_html_()
    assert by_columns.sentence.split(":")[0] in shown and "<table>" in shown


def test_a_reading_that_is_none_is_an_empty_cell() -> None:
    with file_of({"r (mm)": [20.0, 40.0], "22 Hz": [5.1, float("nan")]}) as path:
        assert path.read_text().splitlines() == ["r (mm),22 Hz", "20.0,5.1", "40.0,"]


def test_columns_of_different_length_are_refused_with_their_lengths() -> None:
    with pytest.raises(ValueError, match="'r' 2, '22 Hz' 1"), file_of({"r": [1, 2], "22 Hz": [3]}):
        pass


def test_a_study_takes_no_table() -> None:
    with pytest.raises(washout.InputError, match="names its own readings"):
        washout.diagnose("studies/tang-dowell-gravity.toml", COLUMNS)


def test_a_table_becomes_a_study_an_effect_joins_it_and_the_calibrated_wing_can_be_solved(tmp_path: Path) -> None:
    sets = {"mesh.refine": 0.4}
    compared = washout.compare(DESIGN, COLUMNS, sets, sigma=0.3)
    assert isinstance(compared, washout.StudyComparison)
    for folder in ("designs", "measurements"):
        shutil.copytree(folder, tmp_path / folder)
    design = tmp_path / DESIGN
    assert "[mesh]" not in design.read_text()
    design.write_text(design.read_text() + "\n[mesh]\nrefine = 0.4\n")
    study = washout.init_study("mine", design, COLUMNS, sigma=0.3, folder=tmp_path)
    assert study == tmp_path / "mine.toml" and (tmp_path / "mine-measured.csv").exists()
    added = washout.add("coefficient-scale", study, ladder=tmp_path / "ladder")
    assert len(added["strength"]) == 2 and added["ladder"][0]["name"] == "raw"
    washout.compare(study, output=tmp_path / "compared")
    wing = washout.Wing.open(next((tmp_path / "compared").glob("calibrated-*.toml")))
    assert "coefficient-scale" in wing.design["effects"]
    assert wing.with_value("flapping.frequency_hz", 24).solve().tip_twist_deg is not None


def test_one_effect_may_be_given_by_its_name_alone() -> None:
    with pytest.raises(washout.InputError, match="there is no effect root-flexur;"):
        washout.diagnose(DESIGN, COLUMNS, effects="root-flexur")


def test_tables_and_lists_are_values_of_a_design() -> None:
    assert toml({"assumed": 4.0, "range": [3.0, 6.0], "why": "not measured"}) == (
        '{ assumed = 4.0, range = [3.0, 6.0], why = "not measured" }'
    )
    assert (toml("words"), toml(True), toml([1, 2.5])) == ("words", "true", "[1, 2.5]")


def test_a_fault_of_a_frame_names_its_row_and_no_file_that_is_gone() -> None:
    with pytest.raises(washout.InputError, match=r"readings:3 \(row 1 of the data, from 0\)") as caught:
        washout.diagnose(DESIGN, {"r (mm)": [20.0, 40.0], "22 Hz": [5.1, "much"]})
    assert "washout-" not in str(caught.value)
    with pytest.raises(TypeError, match="columns by their heads"):
        washout.diagnose(DESIGN, [[20.0, 5.1]])  # type: ignore[arg-type]
    with pytest.raises(washout.InputError, match="by its path"):
        washout.compare("format = 1\nname = 'x'\n", COLUMNS)
    with pytest.raises(washout.InputError, match="there is no effect") as refused:
        washout.diagnose(DESIGN, COLUMNS, effects=["nonsense"])
    assert refused.value.key == "effects" and "there is no effect" in refused.value.problem


def test_a_condition_that_is_held_out_is_predicted_and_never_fitted(tmp_path: Path) -> None:
    sets = {"mesh.refine": 0.4}
    whole = washout.compare(DESIGN, COLUMNS, sets, sigma=0.3)
    compared = washout.compare(DESIGN, COLUMNS, sets, sigma=0.3, hold_out="22 Hz")
    assert isinstance(whole, washout.StudyComparison) and isinstance(compared, washout.StudyComparison)
    held = {row["case"] for row in compared.rows.rows if row["is_held_out"]}
    assert held == {"22hz"} and not any(row["is_held_out"] for row in whole.rows.rows)
    diagnosis = washout.diagnose(DESIGN, COLUMNS, sets, sigma=0.3, hold_out=["22hz"], effects="coefficient-scale")
    assert set(diagnosis.predictions["condition"]) == {"22hz"}
    shown = str(diagnosis)
    assert shown.startswith(diagnosis.sentence) and "held out" in shown and "calibrated" in shown
    assert all(f"{meaning.split(':')[0]}: " in shown for meaning in diagnosis.meanings)
    study = washout.init_study("mine", DESIGN, COLUMNS, sigma=0.3, hold_out="22 Hz", folder=tmp_path)
    assert '\nheld_out = ["22hz"]\n' in study.read_text()
    with pytest.raises(washout.InputError, match=r"(?s)hold_out: 23 Hz is no condition of .*One of .*22hz") as refused:
        washout.diagnose(DESIGN, COLUMNS, hold_out="23 Hz")
    assert refused.value.problem
