"""A study as a file: written from readings, and an effect taken into its model."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path

from washout.errors import by_argument
from washout.readings import Readings, file_of
from washout.verb import Document, FilePath, Progress, names, run


@by_argument()
def init_study(
    name: str,
    design: FilePath,
    readings: Readings,
    *,
    sigma: float | str | None = None,
    hold_out: str | Sequence[str] = (),
    folder: FilePath = ".",
) -> Path:
    """Writes a study of a design and readings, with its measurement file, and gives its path; no file is written over.

    The study holds what `diagnose(design, readings)` uses. `hold_out` are conditions that no fit sees, such as "22 Hz". Effects can be
    added to it.
    """
    with file_of(readings) as table:
        arguments = [name, "--study", "--design", os.fspath(design), "--readings", os.fspath(table)]
        arguments += ["--output", os.fspath(folder)]
        if sigma is not None:
            arguments += ["--sigma", str(sigma)]
        for condition in names(hold_out):
            arguments += ["--hold-out", condition]
        document = run("init", *arguments)
    return Path(document["file"])


@by_argument()
def add(
    effect: str,
    study: FilePath,
    *,
    numbers: Mapping[str, float] | None = None,
    on: str | Sequence[str] = (),
    remove: bool = False,
    output: FilePath | None = None,
    ladder: FilePath | None = None,
    progress: Progress | None = None,
) -> Document:
    """Takes an effect into the model of a study, fitted, and writes the study; gives what `washout add --json` prints.

    `numbers` are others of the effect than its strength, `on` the wings that have it. `remove` takes it out instead. `output` is a
    study to write instead of changing this one, `ladder` the folder of the pictures. Among the keys: `strength` with its standard
    error, `ladder` with the error step by step, `notes`.
    """
    arguments: list[FilePath] = [effect, "--to", os.fspath(study)]
    for key, value in (numbers or {}).items():
        arguments += ["--number", f"{key}={value!r}"]
    for wing in names(on):
        arguments += ["--on", wing]
    if remove:
        arguments.append("--remove")
    for option, path in (("--output", output), ("--ladder", ladder)):
        if path is not None:
            arguments += [option, os.fspath(path)]
    document: Document = run("add", *arguments, progress=progress)
    return document
