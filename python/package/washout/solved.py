"""A wing solved: its loaded shape, and what is read of it."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from washout import _washout, notebook
from washout.columns import Columns, Nodes, Numbers
from washout.verb import Document, FilePath, Progress

if TYPE_CHECKING:
    from washout.wing import Wing


@dataclass(frozen=True)
class Forces:
    """What the air does to one wing."""

    name: str
    """When: `mid-stroke`, `mean over the stroke (20/60/20 ramp)`, …"""
    lift_mn: float
    """Lift, mN."""
    drag_mn: float
    """Drag, mN."""
    power_mw: float
    """Power against the air, mW."""
    lift_to_drag: float | None
    """Lift over drag; None without drag."""
    lift_per_power_n_per_w: float | None
    """Lift over power, N/W; None without power."""


@dataclass(frozen=True)
class LiftReport:
    """Lift, drag and power of one wing."""

    solved: Forces
    """At the phase of the design."""
    stroke_mean: Forces | None
    """Mean over the stroke with the solved twist on the paper's ramp; None in a steady stream and off mid-stroke."""


@dataclass(frozen=True)
class Shape:
    """The mesh of a solved wing, as `wing-rest.vtu` and `wing.vtu` have it; nodes are counted from 0.

    Frame: x along the span from the wing base, y along the chord from the leading edge, z = x × y.
    """

    rest_mm: Numbers
    """Places of the nodes without load, (nodes, 3)."""
    deformed_mm: Numbers
    """Places of the nodes under load, (nodes, 3)."""
    twist_deg: Numbers
    """Rotation of the chord through each node; positive is washout."""
    air_force_mn: Numbers
    """Force of the air on each node, (nodes, 3)."""
    triangles: Nodes
    """Nodes of each triangle of the film, (triangles, 3)."""
    pressure_pa: Numbers
    """Pressure on each triangle, positive toward +z of the deformed film."""
    beams: Nodes
    """Nodes of each beam element of rod and spars, (beams, 2)."""
    leading_edge: Nodes
    """Nodes along the leading edge from base to tip."""
    trailing_edge: Nodes
    """Nodes along the trailing edge from base to tip."""


class SolvedWing:
    """A wing in its loaded shape; `Wing.solve` makes one.

    What is read by the instrument of the design raises InputError where that cannot see the wing.
    """

    def __init__(self, wing: Wing, native: _washout.Solved) -> None:
        self.wing = wing
        """What was solved."""
        self._native = native

    @property
    def name(self) -> str:
        """Name of the wing."""
        return self.wing.name

    @overload
    def twist_at(self, r_mm: float) -> float | None: ...
    @overload
    def twist_at(self, r_mm: Sequence[float] | Numbers) -> Numbers: ...
    def twist_at(self, r_mm: float | Sequence[float] | Numbers) -> float | Numbers | None:
        """Twist in degrees at `r_mm` from the wing base, as the instrument of the design reads it; positive is washout.

        Of a number: a number; None where the twist cannot be read there, such as off the wing. Of an array: an array of the same
        shape, masked (numpy.ma) at such places, never NaN.
        """
        places = np.asarray(r_mm, dtype=np.float64)
        twist_deg = self._native.twist_at(places.ravel()).reshape(places.shape)
        is_absent = np.isnan(twist_deg)
        if places.ndim == 0:
            return None if is_absent else float(twist_deg)
        if not is_absent.any():
            return twist_deg
        twist_deg[is_absent] = 0.0
        return np.ma.masked_array(twist_deg, mask=is_absent)

    @property
    def tip_twist_deg(self) -> float | None:
        """Twist of the tip station; None where it cannot be read."""
        return self._native.tip_twist_deg()

    @cached_property
    def profile(self) -> Columns:
        """Twist at the stations of the design: `place`, `r_mm`, `chord_mm`, `twist_deg`, `alpha_deg`, …"""
        return Columns(json.loads(self._native.profile()))

    @cached_property
    def along_span(self) -> Columns:
        """The same with 50 places evenly from base to tip: the rows of profile.csv."""
        return Columns(json.loads(self._native.along_span()))

    @cached_property
    def stages(self) -> Columns:
        """Stages of the profile from base to tip: `from_mm`, `to_mm`, `rate_deg_per_mm`, with standard errors `to_error_mm`,
        `rate_error_deg_per_mm`. No rows where it has too few readings for a fit."""
        return Columns(json.loads(self._native.stages()))

    @cached_property
    def lift(self) -> LiftReport | None:
        """Lift, drag and power; None without flow."""
        report: Document | None = json.loads(self._native.lift())
        if report is None:
            return None
        mean = report["stroke_mean"]
        return LiftReport(Forces(**report["solved"]), Forces(**mean) if mean else None)

    @cached_property
    def strips(self) -> dict[str, Numbers]:
        """The air on each strip from base to tip, with the columns of strips.csv: `r_mm`, `alpha_deg`, `cl`, `cd`, …"""
        return self._native.strips()

    @cached_property
    def shape(self) -> Shape:
        """The mesh, at rest and deformed."""
        return Shape(**self._native.shape())

    def write(self, folder: FilePath, *, report: bool = False, progress: Progress | None = None) -> Path:
        """Writes the files that `washout solve` writes (ParaView, CSV, summary.json), whole or not at all; `report`: the HTML report
        too. An earlier run there is replaced. Gives the folder.

        Stresses and masses are found first. The error of the mesh is not known: the wing was solved on one mesh.
        """
        return Path(self._native.write(folder, report, progress))

    def _repr_html_(self) -> str:
        return notebook.of_profile(repr(self), self.profile)

    def __repr__(self) -> str:
        return f"<washout.SolvedWing {self.name}: {notebook.tip(self.tip_twist_deg)}>"
