"""Verbs that write a folder, for those who want the document alone."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

from washout.verb import Document, FilePath, Progress, run


def in_folder(
    verb: str, options: list[str], path: FilePath, output: FilePath | None, progress: Progress | None
) -> Document:
    """The document of a verb that writes into `output`; without, its files are not kept, and none are named."""
    if output is not None:
        document: Document = run(verb, *options, "--output", output, "--", path, progress=progress)
        return document
    with TemporaryDirectory(prefix="washout-") as temporary:
        document = in_folder(verb, options, path, Path(temporary) / "output", progress)
    document["files"] = []
    return document
