"""Solving a design: twist, forces, shape."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from washout import _washout, notebook
from washout.columns import Columns, Numbers
from washout.errors import by_argument
from washout.solved import Forces, Shape, SolvedWing
from washout.verb import Document, FilePath, Progress, Setting
from washout.wing import Wing


@by_argument()
def solve(
    design: FilePath,
    sets: Mapping[str, Setting] | None = None,
    *,
    stroke: int | None = None,
    stroke_quasi_static: int | None = None,
    uncertainty: int | None = None,
    progress: Progress | None = None,
) -> Run:
    """Solves a design as `washout solve` does: the short way from `Wing.open`, which says what `design` and `sets` may be.

    The error of the mesh, stresses and masses are found besides. `stroke`: the whole stroke in motion too, at so many phases;
    `stroke_quasi_static`: phases that each stand still instead; `uncertainty`: a band from the assumed ranges by so many solves,
    in `summary["uncertainty"]`.

    Raises InputError where the design is refused, NotConverged where there is no solution; Ctrl-C stops.
    """
    wing = Wing.open(design, sets)
    return Run(wing, wing._native.run(stroke, stroke_quasi_static, uncertainty, progress))


class Stroke:
    """The wing over its stroke: phases × stations."""

    def __init__(self, document: Document) -> None:
        self.document = document
        """The document, as in summary.json."""
        self.kind: str = document["kind"]
        """`periodic`, or `quasi-static`."""
        self.phases = Columns(document["phases"])
        """What is known at each phase: `phase_deg` (0 is mid-stroke), `tip_twist_deg`, `stop_moment_mn_mm`."""
        self.forces = Columns([phase["forces"] or {} for phase in document["phases"]])
        """`lift_mn`, `drag_mn`, `power_mw` at each phase."""
        self.mean = Forces(**document["mean"]) if document["mean"] else None
        """Mean over the stroke."""
        profile = Columns(document["profile"])
        self.phase_deg: Numbers = np.unique(profile["phase_deg"])
        """Phases of the rows of `twist_deg`."""
        self.r_mm: Numbers = np.unique(profile["r_mm"])
        """Stations of the columns of `twist_deg`."""
        self.twist_deg = self._over_stations(profile, "twist_deg")
        """Twist by phase and station, as the instrument of the design reads it; masked where it cannot be read."""

    def _over_stations(self, profile: Columns, name: str) -> Numbers:
        table = np.zeros((self.phase_deg.size, self.r_mm.size))
        is_absent = np.ones(table.shape, dtype=bool)
        place = np.searchsorted(self.phase_deg, profile["phase_deg"]), np.searchsorted(self.r_mm, profile["r_mm"])
        table[place], is_absent[place] = profile[name], False
        return np.ma.masked_array(table, mask=is_absent) if is_absent.any() else table


class Run:
    """A solved design. The arrays along the span belong together: one value for each station from base to tip."""

    def __init__(self, wing: Wing, native: _washout.Run) -> None:
        self.wing = wing
        """What was solved."""
        self._native = native
        self.summary: Document = json.loads(native.summary())
        """The document summary.json; its `files` are empty until they are written."""

    @property
    def name(self) -> str:
        """Name of the wing."""
        return str(self.summary["name"])

    @cached_property
    def solved(self) -> SolvedWing:
        """The wing in its loaded shape."""
        return SolvedWing(self.wing, self._native.solved())

    @cached_property
    def profile(self) -> Columns:
        """Twist at the stations of the design."""
        return Columns(self.summary["profile"])

    @cached_property
    def along_span(self) -> Columns:
        """The same with 50 places evenly from base to tip: the rows of profile.csv."""
        return Columns(self.summary["along_span"])

    @property
    def r_mm(self) -> Numbers:
        """Stations along the span."""
        return self.profile["r_mm"]

    @property
    def chord_mm(self) -> Numbers:
        """Chord at rest."""
        return self.profile["chord_mm"]

    @property
    def twist_deg(self) -> Numbers:
        """Twist as the instrument of the design reads it; positive is washout."""
        return self.profile["twist_deg"]

    @property
    def alpha_deg(self) -> Numbers | None:
        """Angle of attack of the chord; None without flow."""
        return self.profile.get("alpha_deg")

    @property
    def strips(self) -> dict[str, Numbers]:
        """The air on each strip from base to tip, with the columns of strips.csv: `r_mm`, `alpha_deg`, `cl`, `cd`, …"""
        return self.solved.strips

    @property
    def shape(self) -> Shape:
        """The mesh, at rest and deformed."""
        return self.solved.shape

    @cached_property
    def stroke(self) -> Stroke | None:
        """The wing over its stroke; None unless asked for."""
        document = self.summary["stroke"]
        return Stroke(document) if document else None

    @property
    def tip_twist_deg(self) -> float | None:
        """Twist of the tip station; None where it cannot be read."""
        twist: float | None = self.summary["tip"]["twist_deg"]
        return twist

    @property
    def lift(self) -> Forces | None:
        """Lift, drag and power at the phase of the design; None without flow."""
        return self._forces("solved")

    @property
    def mean_lift(self) -> Forces | None:
        """Mean over the stroke with the solved twist on the paper's ramp; None where the wing does not flap."""
        return self._forces("stroke_mean")

    @property
    def counts(self) -> dict[str, int]:
        """Nodes, triangles and beam elements of the mesh, and degrees of freedom."""
        mesh = self.summary["mesh"]
        counts = {name: int(mesh[name]) for name in ("nodes", "triangles", "beams")}
        return counts | {"dof": int(self.summary["solve"]["dof"])}

    @property
    def convergence(self) -> dict[str, Any]:
        """How well the equations are met, and what it took: `residual`, `iterations`, `twist_change_deg`, …"""
        return dict(self.summary["solve"])

    @property
    def warnings(self) -> list[str]:
        """What limits how far the numbers hold."""
        return list(self.summary["warnings"])

    def write(self, folder: FilePath, *, report: bool = False) -> Path:
        """Writes the files that `washout solve` writes (ParaView, CSV, summary.json), whole or not at all; `report`: the
        HTML report too. An earlier run there is replaced. Gives the folder."""
        return Path(self._native.write(folder, report))

    def _forces(self, when: str) -> Forces | None:
        lift = self.summary["lift"]
        return Forces(**lift[when]) if lift and lift[when] else None

    def _repr_html_(self) -> str:
        return notebook.of_profile(repr(self), self.profile)

    def __repr__(self) -> str:
        return f"<washout.Run {self.name}: {notebook.tip(self.tip_twist_deg)}>"
