"""Any verb of the command line, called from Python."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias

from washout import _washout
from washout.errors import InputError, WashoutError

Document: TypeAlias = dict[str, Any]
"""A JSON document as the command line prints it with `--json`."""

FilePath: TypeAlias = str | os.PathLike[str]
"""Where a file or folder is."""

Progress: TypeAlias = Callable[[str], object]
"""Is called with a line that says what is being done; what it raises stops the work."""

Setting: TypeAlias = bool | int | float | str | Sequence[Any] | Mapping[str, Any]
"""A value of a key of a design: a number, words, a list, or a table such as {"assumed": 4.0, "range": [3.0, 6.0], "why": "not measured"}."""


def run(verb: str, *arguments: FilePath, progress: Progress | None = None) -> Any:
    """The document that `washout VERB ARGUMENTS --json` prints: a dict, of some verbs a list; files are written as there.

    Raises InputError, NotConverged or WashoutError, with the messages of the command line.
    """
    words = [os.fspath(argument) for argument in arguments]
    text = _washout.run([verb, *words], progress)
    try:
        return json.loads(text)
    except json.JSONDecodeError:
        raise WashoutError(f"washout {verb} gives no JSON document") from None


def schema(verb: str | None = None) -> Document:
    """The JSON schema of what a verb prints with `--json` (`solve`: of summary.json; `study`: of `compare` with a study); of
    design files without a verb."""
    document: Document = run("schema", *(("--output", verb) if verb else ()))
    return document


def file_of_design(design: FilePath) -> FilePath:
    """A path; refused where it is the text of a design."""
    if isinstance(design, str) and "\n" in design:
        raise InputError("a design is given by its path here; write the text to a file first", problem="is text, not a path")
    return design


def names(given: str | Sequence[str]) -> list[str]:
    """One name or several."""
    return [given] if isinstance(given, str) else list(given)


def settings(sets: Mapping[str, Setting] | None) -> list[str]:
    """`KEY=VALUE` for each key of a design."""
    return [f"{key}={toml(value)}" for key, value in (sets or {}).items()]


def toml(value: object) -> str:
    """A value as TOML has it; words need no quotes, but within lists and tables."""
    return value if isinstance(value, str) else item(value)


def item(value: object) -> str:
    """A value within another."""
    if hasattr(value, "tolist"):
        value = value.tolist()
    match value:
        case bool():
            return "true" if value else "false"
        case str():
            return json.dumps(value)
        case Mapping():
            return f"{{ {', '.join(f'{key} = {item(own)}' for key, own in value.items())} }}"
        case list() | tuple():
            return f"[{', '.join(map(item, value))}]"
        case _:
            return repr(value)
