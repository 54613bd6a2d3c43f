"""Measured minus modelled, of a design or of a study."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from contextlib import nullcontext

from washout import _washout, notebook
from washout.columns import Columns, Numbers
from washout.errors import by_argument
from washout.readings import Readings, file_of
from washout.verb import Document, FilePath, Progress, Setting, file_of_design, names, settings


@by_argument()
def compare(
    design_or_study: FilePath,
    readings: Readings | None = None,
    sets: Mapping[str, Setting] | None = None,
    *,
    sigma: float | str | None = None,
    hold_out: str | Sequence[str] = (),
    case: str | None = None,
    reference: FilePath | None = None,
    output: FilePath | None = None,
    progress: Progress | None = None,
) -> Comparison | StudyComparison:
    """Compares a design with its measurement, or all cases of a study before and after calibration.

    Of a design, `readings` are what was measured on it: a pandas.DataFrame, columns by their heads, or the file of a table; it is
    compared as a study then, and `sigma` is the standard deviation of readings that state none, `hold_out` conditions that no fit sees. They may also be a
    measurement file, with `case` in it; without them the design names its own. `reference` is the design that measured ratios refer to. `output` keeps
    the pictures and tables in that folder, and each wing as calibrated. Gives what `washout compare --json` prints.
    """
    with nullcontext() if readings is None else file_of(readings) as table:
        text = _washout.compare(
            file_of_design(design_or_study),
            settings(sets),
            table,
            None if sigma is None else str(sigma),
            names(hold_out),
            case,
            reference,
            output,
            progress,
        )
    document: Document = json.loads(text)
    return Comparison(document) if "comparison" in document else StudyComparison(document)


class Comparison:
    """A measurement against a solved wing."""

    def __init__(self, document: Document) -> None:
        self.document = document
        """What `washout compare DESIGN --json` prints."""
        comparison = document["comparison"]
        self.wing: str = comparison["wing"]
        """Name of the wing."""
        self.verdict: str = comparison["verdict"]
        """Where the model fails, in words."""
        self.notes: list[str] = comparison["notes"]
        """What a reader must know besides."""
        self.rows = Columns(comparison["rows"])
        """Every number that could be compared: `channel`, `r_mm`, `measured`, `sigma`, `modelled`, `error`, `unit`, …"""
        self.spans = [Span(span) for span in comparison["span"]]
        """Twist in degrees along the span, for each run that gives it."""

    def __repr__(self) -> str:
        return f"<washout.Comparison {self.wing}: {self.verdict}>"

    def _repr_html_(self) -> str:
        names = ("channel", "r_mm", "r_to_mm", "measured", "sigma", "modelled", "error", "unit")
        rows = [[row.get(name) for name in names] for row in self.rows.rows]
        return notebook.answer(self.verdict, notebook.table(names, rows))


class Span:
    """Twist along the span, measured and modelled, at the same stations; degrees and millimetres."""

    def __init__(self, document: Document) -> None:
        self.document = document
        """The document, as in `comparison.span`."""
        self.stations = Columns(document["stations"])
        """All that is known at each station."""
        self.r_mm: Numbers = self.stations["r_mm"]
        """Stations."""
        self.measured_deg: Numbers = self.stations["measured_deg"]
        """As measured, or as measured rates integrate from the base."""
        self.sigma_deg: Numbers = self.stations["sigma_deg"]
        """Standard deviation of it."""
        self.modelled_deg: Numbers = self.stations["modelled_deg"]
        """As modelled, seen by the instrument of the measurement."""
        self.error_deg: Numbers = self.stations["error_deg"]
        """Measured minus modelled."""
        self.rmse_deg: float = document["rmse_along_span_deg"]
        """Root mean square of the error over the whole span."""


class StudyComparison:
    """A study solved, calibrated within its priors and compared."""

    def __init__(self, document: Document) -> None:
        self.document = document
        """What `washout compare STUDY --json` prints."""
        self.study: str = document["study"]
        """Name of the study."""
        self.words: list[str] = document["words"]
        """What was found, in words."""
        self.rows = Columns(document["rows"])
        """Every measured number: `case`, `channel`, `measured`, `sigma`, `before` and `after` calibration, …"""
        self.groups = Columns(document["groups"])
        """Misfit by wing and channel."""
        self.unknowns = Columns([{**row["unknown"], **row} for row in document["unknowns"]])
        """What was calibrated: `name`, `unit`, prior `mean` and `sigma`, `value`, `standard_error`, `pull`, …"""
        before, after = document["chi_square_per_row"]
        self.chi_square_per_row_before: float = before
        """Chi-square per fitted row, uncalibrated."""
        self.chi_square_per_row_after: float = after
        """Chi-square per fitted row, calibrated."""

    def __repr__(self) -> str:
        return f"<washout.StudyComparison {self.study}: {self.words[0]}>"

    def _repr_html_(self) -> str:
        names = ("name", "unit", "mean", "value", "standard_error", "pull")
        rows = [[row.get(name) for name in names] for row in self.unknowns.rows]
        return notebook.answer(" ".join(self.words), notebook.table(names, rows))

    @property
    def residuals_before(self) -> Numbers:
        """Measured minus modelled, uncalibrated, in the unit of each row's channel."""
        residuals: Numbers = self.rows["measured"] - self.rows["before"]
        return residuals

    @property
    def residuals_after(self) -> Numbers:
        """Measured minus modelled, calibrated."""
        residuals: Numbers = self.rows["measured"] - self.rows["after"]
        return residuals
