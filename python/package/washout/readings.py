"""Readings that Python holds, as a table that washout reads."""

from __future__ import annotations

import csv
import math
import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Protocol, TypeAlias, runtime_checkable

from washout.verb import FilePath


@runtime_checkable
class Frame(Protocol):
    """A table that can write itself, such as a pandas.DataFrame."""

    index: Any

    def to_csv(self, path: Any, *, index: bool) -> Any:
        """Writes the columns, and the index with them."""


Readings: TypeAlias = FilePath | Frame | Mapping[str, Sequence[Any]]
"""A table of readings: its file, a pandas.DataFrame, or its columns by their heads, all of one length."""


@contextmanager
def file_of(readings: Readings) -> Iterator[Path]:
    """The file of a table; what is not a file yet is one as long as this lasts."""
    if isinstance(readings, (str, os.PathLike)):
        yield Path(readings)
        return
    with TemporaryDirectory(prefix="washout-") as folder:
        path = Path(folder) / "readings.csv"
        if isinstance(readings, Frame):
            # stations stand in the index where it has a name
            readings.to_csv(path, index=readings.index.name is not None)
        else:
            write(path, readings)
        yield path


def write(path: Path, columns: Mapping[str, Sequence[Any]]) -> None:
    """Writes columns by their heads."""
    lengths = {len(column) for column in columns.values()}
    if len(lengths) > 1:
        counts = ", ".join(f"'{head}' {len(column)}" for head, column in columns.items())
        raise ValueError(f"all columns of a table must have as many rows; these have {counts}")
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        writer.writerows([cell(value) for value in row] for row in zip(*columns.values(), strict=True))


def cell(value: Any) -> Any:
    """A value as a cell: empty where there is none."""
    is_none = value is None or (isinstance(value, float) and math.isnan(value))
    return "" if is_none else value
