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

from washout.errors import InputError
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
        elif isinstance(readings, Mapping):
            write(path, readings)
        else:
            kind = type(readings).__name__
            raise TypeError(f"readings are a DataFrame, columns by their heads such as {{'r (mm)': [...], '22 Hz': [...]}}, or a file; not {kind}")
        try:
            yield path
        except InputError as error:
            raise of_frame(error, path) from None


def of_frame(error: InputError, path: Path) -> InputError:
    """A fault of a table that stands in no file of the user's: told by its row."""
    if str(path) not in str(error):
        return error
    row = "" if error.line is None or error.line < 2 else f" (row {error.line - 2} of the data, from 0)"
    message = str(error).replace(str(path), "readings")
    if row:
        message = message.replace(f"readings:{error.line}", f"readings:{error.line}{row}", 1)
    return InputError(message, None, error.line, error.column, error.key, error.value, error.problem, error.cure)


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
