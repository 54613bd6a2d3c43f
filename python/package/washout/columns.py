"""Tables: rows of a document as NumPy columns."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from washout import notebook

Row = Mapping[str, Any]

Numbers = NDArray[np.float64]
Nodes = NDArray[np.int64]


class Columns(Mapping[str, NDArray[Any]]):
    """A table by its columns: `table["error"]` is an array with one value for each row.

    Words are arrays of str. A number that some rows lack is masked there (numpy.ma), never NaN. What is neither number nor
    word stands in `rows` only, the rows as the document has them, which pandas.DataFrame takes as they are.
    """

    def __init__(self, rows: Sequence[Row]) -> None:
        self.rows = rows
        names = dict.fromkeys(name for row in rows for name in row)
        columns = {name: column([row.get(name) for row in rows]) for name in names}
        self._columns = {name: values for name, values in columns.items() if values is not None}

    def __getitem__(self, name: str) -> NDArray[Any]:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def to_frame(self) -> Any:
        """The rows as a pandas.DataFrame; needs pandas."""
        import pandas

        return pandas.DataFrame(list(self.rows))

    def _repr_html_(self) -> str:
        names = list(self._columns)
        return notebook.table(names, [[row.get(name) for name in names] for row in self.rows])

    def __repr__(self) -> str:
        return f"Columns({len(self.rows)} rows: {', '.join(self._columns)})"


def column(values: Sequence[Any]) -> NDArray[Any] | None:
    """Values as an array: words, truths or numbers, masked where None; None where they are none of these."""
    kinds = {type(value) for value in values if value is not None}
    if kinds == {str}:
        blank: object = ""
    elif kinds == {bool}:
        blank = False
    elif kinds and kinds <= {int, float}:
        blank = 0
    else:
        return None
    absent = [value is None for value in values]
    filled = np.array([blank if value is None else value for value in values])
    return np.ma.masked_array(filled, mask=absent) if any(absent) else filled
