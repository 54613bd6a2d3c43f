"""A wing read and meshed: what can be solved."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from washout import _washout, notebook
from washout.columns import Nodes, Numbers
from washout.errors import InputError, by_argument
from washout.solved import SolvedWing
from washout.verb import Document, FilePath, Progress, Setting, settings

TEXT = "<text>"
"""Stands for the file of a design that is given as text, in messages and in summaries."""


@dataclass(frozen=True)
class Mesh:
    """The mesh of a wing without load; nodes are counted from 0.

    Frame: x along the span from the wing base, y along the chord from the leading edge, z = x × y.
    """

    nodes_mm: Numbers
    """Places of the nodes, (nodes, 3)."""
    triangles: Nodes
    """Nodes of each triangle of the film, (triangles, 3)."""
    beams: Nodes
    """Nodes of each beam element of rod and spars, (beams, 2)."""
    leading_edge: Nodes
    """Nodes along the leading edge from base to tip."""
    trailing_edge: Nodes
    """Nodes along the trailing edge from base to tip."""


class Wing:
    """A wing that is ready to be solved. `Wing.open` makes one. It never changes: `with_value` and `with_effect` give another."""

    def __init__(self, native: _washout.Wing) -> None:
        self._native = native

    @classmethod
    @by_argument()
    def open(cls, design: FilePath, sets: Mapping[str, Setting] | None = None) -> Wing:
        """Reads a design and meshes the wing; solves nothing.

        `design` is a path, or its TOML text (any str of more than one line; files that it names are then looked for from the working
        folder). `sets` changes keys of the design, as `--set` does: `{"flapping.frequency_hz": 25, "mesh.refine": 2}`.

        Raises InputError where a file is refused, or no such wing can be meshed.
        """
        name = os.fspath(design)
        text = name if "\n" in name else None
        return cls(_washout.Wing.open(TEXT if text else name, settings(sets), text))

    def with_value(self, key: str, value: float) -> Wing:
        """The same wing with one key of its design set to another number, in the key's unit: `"flapping.frequency_hz", 25`.

        Raises InputError where the design refuses it, or no such wing can be meshed.
        """
        return Wing(self._native.with_value(key, value))

    def with_effect(self, effect: str, strength: float) -> Wing:
        """The same wing with an effect of the library at a strength; 0 is none. All else of the effect stays as the design has it.

        `washout.run("effects")` lists them, with the unit of each strength. Raises InputError as `with_value`.
        """
        return Wing(self._native.with_effect(effect, strength))

    def solve(self, *, progress: Progress | None = None) -> SolvedWing:
        """The wing in its loaded shape.

        Raises NotConverged where there is no solution that is found, InputError where the wing cannot be set up; Ctrl-C stops.
        `washout.solve` gives the error of the mesh, stresses and masses besides, and takes twice as long.
        """
        return SolvedWing(self, self._native.solve(progress))

    @cached_property
    def design(self) -> Document:
        """The design, with every default, material and setting resolved."""
        document: Document = json.loads(self._native.design())
        return document

    @property
    def name(self) -> str:
        """Name of the wing."""
        return str(self.design["name"])

    @property
    def length_mm(self) -> float:
        """Length from base to tip, before the tip is cut."""
        return self._outline["length_mm"]

    @property
    def mean_chord_mm(self) -> float:
        """Mean chord."""
        return self._outline["mean_chord_mm"]

    @property
    def area_mm2(self) -> float:
        """Area of one wing as built."""
        return self._outline["area_mm2"]

    @cached_property
    def mesh(self) -> Mesh:
        """The mesh."""
        return Mesh(**self._native.mesh())

    @property
    def counts(self) -> dict[str, int]:
        """Nodes, triangles and beam elements of the mesh."""
        mesh = self.mesh
        return {"nodes": len(mesh.nodes_mm), "triangles": len(mesh.triangles), "beams": len(mesh.beams)}

    @cached_property
    def _outline(self) -> dict[str, float]:
        return self._native.outline()

    def _repr_html_(self) -> str:
        rows = [("length, mm", self.length_mm), ("mean chord, mm", self.mean_chord_mm), ("area, mm²", self.area_mm2)]
        rows += [(f"{name} of the mesh", count) for name, count in self.counts.items()]
        return notebook.answer(repr(self).strip("<>"), notebook.table(("wing", self.name), rows))

    def __repr__(self) -> str:
        return f"<washout.Wing {self.name}: {self.length_mm:.1f} mm long, {self.counts['nodes']} nodes>"
