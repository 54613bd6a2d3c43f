"""What goes wrong is an exception with the message of the command line."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import CommandLine

import washout

DESIGN = "designs/twist-v2.toml"


def message(done: subprocess.CompletedProcess[str]) -> str:
    """What the program said on standard error, without its name."""
    return done.stderr.removeprefix("washout: ").strip()


def test_a_refused_key_is_named_with_its_place_and_cure(command_line: CommandLine, tmp_path: Path) -> None:
    design = tmp_path / "wing.toml"
    shutil.copy("designs/materials.toml", tmp_path)
    design.write_text(Path(DESIGN).read_text().replace("frequency_hz = 23.0", "frequency_hz = -3.0"))
    with pytest.raises(washout.InputError) as caught:
        washout.solve(design)
    error = caught.value
    assert str(error) == message(command_line("solve", design))
    assert (error.file, error.key, error.value) == (str(design), "flapping.frequency_hz", "-3.0")
    assert error.line is not None and "frequency_hz = -3.0" in design.read_text().splitlines()[error.line - 1]
    assert "must lie in" in error.problem and error.cure


def test_a_refused_text_says_so() -> None:
    with pytest.raises(washout.InputError, match="<text>:2"):
        washout.solve("format = 1\nname = \n")


@pytest.mark.parametrize("path", ["designs/nowhere.toml", "--nowhere"])
def test_a_missing_file_is_named(path: str) -> None:
    with pytest.raises(washout.InputError, match="nowhere") as caught:
        washout.solve(path)
    assert caught.value.file == path


def test_arguments_are_refused_as_the_options_of_the_command_line_by_their_own_names(command_line: CommandLine) -> None:
    with pytest.raises(washout.InputError) as caught:
        washout.solve(DESIGN, stroke=1)
    assert "stroke: " in str(caught.value)
    assert str(caught.value) == message(command_line("solve", "--stroke=1", "--", DESIGN)).replace("--stroke", "stroke")
    with pytest.raises(washout.InputError, match=r"^sets: .* must lie in 0.1 … 1000 Hz") as caught:
        washout.solve(DESIGN, {"flapping.frequency_hz": -3})
    with pytest.raises(washout.InputError, match=r"^sets: .* must lie in 0.1 … 1000 Hz") as caught:
        washout.Wing.open(DESIGN, {"flapping.frequency_hz": -3})
    with pytest.raises(washout.InputError, match="^--set: "):
        washout.run("solve", DESIGN, "--set", "flapping.frequency_hz=-3")
    with pytest.raises(washout.InputError, match="does not go together with"):
        washout.solve(DESIGN, stroke=4, stroke_quasi_static=4)
    with pytest.raises(washout.InputError, match="there is no verb fly"):
        washout.run("fly")


@pytest.mark.parametrize("phases", [-3, 0, 1, 721, 10**6])
def test_a_number_of_phases_is_refused_with_its_range(phases: int) -> None:
    with pytest.raises(washout.InputError, match=r"^stroke: .* 2 … 720"):
        washout.solve(DESIGN, stroke=phases)
    with pytest.raises(washout.InputError, match="^uncertainty"):
        washout.solve(DESIGN, uncertainty=min(phases, 15))


def test_options_of_a_diagnosis_are_refused() -> None:
    study = "studies/tang-dowell-gravity.toml"
    with pytest.raises(washout.InputError, match="^sigma: .*Leave it out"):
        washout.diagnose(study, sigma=0.3)
    with pytest.raises(washout.InputError, match="seed = -1: must lie in"):
        washout.diagnose(study, seed=-1)
    with pytest.raises(washout.InputError, match="there is no effect root-flexur"):
        washout.diagnose(study, effects=["root-flexur"])
    with pytest.raises(washout.InputError, match="^without: there is no effect root-flexur"):
        washout.diagnose(study, without="root-flexur")


def test_options_of_a_comparison_are_refused() -> None:
    with pytest.raises(washout.InputError, match="^readings: .*nowhere.csv: no such file"):
        washout.compare(DESIGN, "measurements/nowhere.csv")
    with pytest.raises(washout.InputError, match="^reference: belongs to a design"):
        washout.compare("studies/tang-dowell-gravity.toml", reference="designs/rigid.toml")


def test_what_does_not_converge_is_told_apart(command_line: CommandLine) -> None:
    sets = {"coupling.max_iterations": 1}
    with pytest.raises(washout.NotConverged) as caught:
        washout.solve(DESIGN, sets)
    done = command_line("solve", DESIGN, "--set", "coupling.max_iterations=1")
    assert done.returncode == 3
    assert str(caught.value) == message(done)
    assert caught.value.file == DESIGN


def test_a_folder_of_the_user_is_not_replaced(run: washout.Run, tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(washout.WashoutError, match="notes.txt") as caught:
        run.write(tmp_path)
    assert isinstance(caught.value, washout.InputError)
    assert [path.name for path in tmp_path.iterdir()] == ["notes.txt"]


def test_a_verb_without_a_document_says_so() -> None:
    with pytest.raises(washout.WashoutError, match="no JSON document"):
        washout.run("completions", "bash")
