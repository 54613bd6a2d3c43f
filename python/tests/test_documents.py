"""Comparisons, diagnoses and schemas are the documents that the command line prints."""

from __future__ import annotations

from pathlib import Path

import jsonschema
import numpy as np
import pytest
from conftest import Printed

import washout
from washout.verb import Document

DESIGN = "designs/twist-v1.toml"
SWEPT = "designs/twist-v2.toml"
STUDY = "studies/tang-dowell-gravity.toml"


def without_files(document: Document) -> Document:
    """A document whose files were not kept."""
    return {**document, "files": []}


@pytest.fixture(scope="module")
def comparison() -> washout.Comparison:
    compared = washout.compare(DESIGN)
    assert isinstance(compared, washout.Comparison)
    return compared


@pytest.fixture(scope="module")
def study() -> washout.StudyComparison:
    compared = washout.compare(STUDY)
    assert isinstance(compared, washout.StudyComparison)
    return compared


@pytest.fixture(scope="module")
def diagnosis() -> washout.Diagnosis:
    return washout.diagnose(STUDY)


def test_a_comparison_is_that_of_the_command_line(
    comparison: washout.Comparison, printed: Printed, tmp_path: Path
) -> None:
    document = printed("compare", DESIGN, "--output", tmp_path / "run")
    assert comparison.document == without_files(document)


def test_the_error_is_measured_minus_modelled(comparison: washout.Comparison) -> None:
    rows = comparison.rows
    np.testing.assert_allclose(rows["error"], rows["measured"] - rows["modelled"], atol=1e-12)
    (span,) = comparison.spans
    np.testing.assert_allclose(span.error_deg, span.measured_deg - span.modelled_deg, atol=1e-12)
    assert comparison.wing == "twist-v1" and "tip" in comparison.verdict


def test_a_study_is_that_of_the_command_line(
    study: washout.StudyComparison, printed: Printed, tmp_path: Path
) -> None:
    assert study.document == without_files(printed("compare", STUDY, "--output", tmp_path / "run"))
    assert study.residuals_before.shape == (len(study.rows.rows),)
    fitted = ~study.rows["is_held_out"]
    root_mean_square = np.sqrt(np.mean((study.residuals_after / study.rows["sigma"])[fitted] ** 2))
    assert root_mean_square < 1.0
    assert set(study.unknowns) >= {"name", "unit", "mean", "sigma", "value", "pull"}


def test_a_diagnosis_is_that_of_the_command_line(
    diagnosis: washout.Diagnosis, printed: Printed, tmp_path: Path
) -> None:
    assert diagnosis.document == without_files(printed("diagnose", STUDY, "--output", tmp_path / "run"))
    assert diagnosis.verdict == "nothing" and diagnosis.sentence.startswith("Nothing detectable is missing")
    assert diagnosis.hypotheses["what"][0] == "nothing" and diagnosis.check_first is None
    assert diagnosis.hypotheses["probability"][0] == diagnosis.p_nothing
    assert diagnosis.residuals.size == diagnosis.document["noise"]["numbers"]
    assert all(plot["residual"].tolist() == diagnosis.residuals.tolist() for plot in diagnosis.added_variables.values())
    assert set(diagnosis.unseen) <= set(diagnosis.effects["effect"])


def test_a_comparison_takes_another_measurement_and_a_reference(printed: Printed, tmp_path: Path) -> None:
    measurement, reference = Path("measurements/colmenares-as-restated.csv"), Path("designs/rigid.toml")
    coarse = {"mesh.refine": 0.5}
    compared = washout.compare(SWEPT, measurement, coarse, case="twist-v2", reference=reference)
    options = ["--set", "mesh.refine=0.5", "--with", measurement, "--case", "twist-v2", "--reference", reference]
    assert compared.document == without_files(printed("compare", SWEPT, *options, "--output", tmp_path / "run"))
    assert compared.document["ratios"]["reference"] == "rigid"


def test_without_an_output_no_file_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    design = Path(DESIGN).resolve()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    assert washout.compare(design, sets={"mesh.refine": 0.5}).document["files"] == []
    assert list(tmp_path.iterdir()) == []


def test_kept_files_are_those_that_the_document_names(tmp_path: Path) -> None:
    kept = washout.compare(DESIGN, output=tmp_path / "kept")
    written = {path.name for path in (tmp_path / "kept").iterdir()} - {".washout.json"}
    assert sorted(kept.document["files"]) == sorted(written)


def test_documents_follow_their_schemas(
    run: washout.Run,
    comparison: washout.Comparison,
    study: washout.StudyComparison,
    diagnosis: washout.Diagnosis,
    tmp_path: Path,
) -> None:
    documents = {
        "solve": run.summary,
        "compare": comparison.document,
        "study": study.document,
        "diagnose": diagnosis.document,
        "doctor": washout.run("doctor"),
        "sweep": washout.run("sweep", SWEPT, "--vary", "mesh.refine=0.4,0.5", "--output", tmp_path / "sweep"),
        "effects": washout.run("effects"),
    }
    for verb, document in documents.items():
        jsonschema.validate(document, washout.schema(verb))
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate({"no": "such field"}, washout.schema(verb))


def test_the_package_has_the_version_of_the_library(run: washout.Run) -> None:
    assert run.summary["made_of"]["washout_version"] == washout.__version__


def test_schemas_are_those_of_the_command_line(printed: Printed) -> None:
    assert washout.schema() == printed("schema")
    assert washout.schema("diagnose") == printed("schema", "--output", "diagnose")


def test_no_column_holds_nan(diagnosis: washout.Diagnosis, study: washout.StudyComparison) -> None:
    tables = [diagnosis.hypotheses, diagnosis.effects, diagnosis.ladder, study.rows, study.groups, study.unknowns]
    for table in tables:
        numbers = [column for column in table.values() if column.dtype.kind == "f"]
        assert numbers and all(np.isfinite(np.ma.getdata(column)).all() for column in numbers)


def test_numbers_that_some_rows_lack_are_masked() -> None:
    table = washout.Columns([{"a": 1.5, "b": None, "c": "x"}, {"a": None, "b": None, "c": "y", "d": [1]}])
    assert set(table) == {"a", "c"}
    assert table["a"].tolist() == [1.5, None]
    assert table["c"].tolist() == ["x", "y"]
    assert len(table.rows) == 2
