"""Which physics the model of a study lacks."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from contextlib import nullcontext

import numpy as np

from washout import _washout, notebook
from washout.columns import Columns, Numbers
from washout.errors import by_argument
from washout.readings import Readings, file_of
from washout.verb import Document, FilePath, Progress, Setting, file_of_design, names, run, settings


@by_argument()
def diagnose(
    design_or_study: FilePath,
    readings: Readings | None = None,
    sets: Mapping[str, Setting] | None = None,
    *,
    sigma: float | str | None = None,
    hold_out: str | Sequence[str] = (),
    effects: str | Sequence[str] = (),
    without: str | Sequence[str] = (),
    significance: float = 0.01,
    seed: int = 1,
    own_data: bool = False,
    output: FilePath | None = None,
    progress: Progress | None = None,
) -> Diagnosis:
    """Finds which effect the model of a study lacks, how sure that is, and what else it could be.

    Of a design, `readings` are what was measured on it: a pandas.DataFrame, columns by their heads, or the file of a table, long or
    wide; `sigma` is the standard deviation of those that state none, such as 0.3 or "0.3 deg, 0.05 mm", and `hold_out` are conditions that no fit sees, such as "22 Hz", so
    that they test what is found. A study names its own.

    `effects`: try these only; `without`: not these, which cannot be; `significance`: accepted probability of a false alarm; `seed`: of the draws of noise;
    `own_data`: even data that `washout synthesize` made with the same formulas; `output` keeps pictures and tables in that
    folder. Gives what `washout diagnose --json` prints.
    """
    with nullcontext() if readings is None else file_of(readings) as table:
        text = _washout.diagnose(
            file_of_design(design_or_study),
            settings(sets),
            names(effects),
            names(without),
            significance,
            seed,
            own_data,
            table,
            None if sigma is None else str(sigma),
            names(hold_out),
            output,
            progress,
        )
    return Diagnosis(json.loads(text))


class Diagnosis:
    """What a study says about the model.

    `print(diagnosis)` shows the verdict, what it means, the error step by step and the rivals. Attributes: `sentence`, `check_first`, `verdict`, `p_nothing`, `tried`, `hypotheses`, `effects`, `unseen`, `misfit`, `added_variables`, `ladder`,
    `predictions`, `next_experiment`, `unknown_cause`, `notes`, `residuals`; `document` holds all. Each table is a
    `Columns`: `table["name"]`, `table.rows`, `table.to_frame()`. What their columns mean: `washout schema` and
    docs/reference/outputs.md.
    """

    def __init__(self, document: Document) -> None:
        self.document = document
        """What `washout diagnose STUDY --json` prints."""
        self.sentence: str = document["sentence"]
        """The verdict in one sentence."""
        self.check_first: str | None = document["check_first"]
        """The case to check before all else, because it misses by far more than all others; None where there is none."""
        self.verdict: str = document["verdict"]
        """`nothing`, `effect`, `set`, `pair`, `novel`, …: the word for it."""
        self.p_nothing: float = document["p_nothing"]
        """Probability that nothing is missing."""
        self.tried: int = document["tried"]
        """How many of the known effects were tried."""
        self.hypotheses = Columns([{"what": what(row), **row, "standard_error": row.get("standard_error") or None} for row in document["hypotheses"]])
        """What may be missing, most probable first: `what`, `probability`, `strength`, `standard_error` (none where a strength is all or
        none, or stands in steps), `in_set`, …"""
        self.effects = Columns(document["effects"])
        """Every effect that was tried: `effect`, `score`, `detectability`, `probability`, `refitted`, …"""
        self.unseen: list[str] = document["unseen"]
        """Effects that these data could not show."""
        self.misfit = Columns(document["misfit"]["by_condition"])
        """Where the calibrated model fails, by case and channel."""
        self.added_variables = {plot["effect"]: Columns(plot["points"]) for plot in document["added_variables"]}
        """Of the effects that the data see best, every fitted number: `condition`, `channel`, `r_mm`, its `residual`, and its
        `signature`: how far a unit of the effect would move it, less what the model absorbs; both in sigma."""
        self.ladder = Columns(document["ladder"])
        """The error from the uncalibrated model down to the noise."""
        self.predictions = Columns(document["predictions"])
        """Held-out numbers, as measured, and as predicted by the `calibrated` and the `explained` model."""
        self.next_experiment: Document | None = document["next_experiment"]
        """What to measure next: `sentence`, `best`, `candidates`; None where nothing has to be decided."""
        self.unknown_cause: Document = document["novel"]
        """The cause that no known effect is: its `probability`, and what is known of it."""
        self.notes: list[str] = document["notes"]
        """What a reader must know besides."""

    def __repr__(self) -> str:
        return f"<washout.Diagnosis: {self.sentence}>"

    def __str__(self) -> str:
        parts = [self.sentence, *self.meanings, "", self._errors(), *self._pulled(), ""]
        parts.append(aligned([["what is missing", "probability", "strength", "error"], *self._most_probable()]))
        if self.next_experiment is not None:
            parts += ["", self.next_experiment["sentence"]]
        if self.unseen:
            parts += ["", f"Could not have been seen: {len(self.unseen)} effects (unseen)."]
        parts += ["", *(f"Note: {note}" for note in self.notes)]
        return "\n".join(parts)

    @property
    def meanings(self) -> list[str]:
        """What each effect of the most probable explanation is, and what its strength means."""
        leads = next((row for row in self.hypotheses.rows if row["families"]), None)
        if self.verdict not in ("effect", "set") or leads is None:
            return []
        cards = [run("effects", effect) for effect in leads["effects"]]
        return [f"{card['name']}: {card['summary']} Strength: {card['parameters'][0]['meaning']}." for card in cards]

    def _errors(self) -> str:
        """The error step by step, in the unit of the channel."""
        rows = self.ladder.rows
        heads = [f"error of {rows[0]['channel']}, rms" if rows else "error", "fitted", "held out"]
        steps = [row for row in rows if self.verdict != "nothing" or not row["name"].startswith("+")]
        return aligned([heads, *([step["name"].replace("raw", "uncalibrated"), shown(step["in_sample"]), shown(step["held_out"])] for step in steps)])

    def _pulled(self) -> list[str]:
        """The input that calibration alone had to pull most, where it had to pull one."""
        flagged = [pull for pull in self.document["misfit"]["pulls"] if pull["is_flagged"]]
        if not flagged:
            return []
        most = max(flagged, key=lambda pull: abs(pull["pull"]))
        return [f"calibrated alone, {most['unknown']} lies {most['pull']:+.1f} sigma from what is known of it"]

    def _most_probable(self) -> list[list[str]]:
        """The hypotheses that count, cell by cell."""
        names = ("probability", "strength", "standard_error")
        return [[str(row["what"]), *(shown(row.get(name)) for name in names)] for row in self.hypotheses.rows[:6]]

    def _repr_html_(self) -> str:
        heads = ("what is missing", "probability", "strength", "error")
        names = ("what", "probability", "strength", "standard_error")
        rows = [[row.get(name) for name in names] for row in self.hypotheses.rows[:6]]
        steps = [[step["name"], step["chi_square_per_number"], step["in_sample"]] for step in self.ladder.rows]
        return notebook.answer(
            self.sentence, notebook.table(heads, rows), notebook.table(("model", "chi-square per reading", "error"), steps)
        )

    @property
    def residuals(self) -> Numbers:
        """Measured less calibrated model of every fitted number, in sigma; empty where no effect can be seen."""
        points = next(iter(self.added_variables.values()), None)
        return np.zeros(0) if points is None else points["residual"]


def shown(value: float | None) -> str:
    """A number for people."""
    return "" if value is None else f"{value:.3g}"


def aligned(rows: Sequence[Sequence[str]]) -> str:
    """Cells in columns."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows)


def what(hypothesis: Mapping[str, Sequence[str]]) -> str:
    """The words for a hypothesis."""
    match list(hypothesis["effects"]):
        case []:
            return "nothing"
        case ["novel"]:
            return "unknown cause"
        case effects:
            return " + ".join(effects)
