"""What washout raises. Each message is the one of the command line, with the cure; options have the names of the arguments here."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager


class WashoutError(Exception):
    """Anything that went wrong; `file` is the design or study that it is about, where there is one."""

    def __init__(self, message: str, file: str | None = None) -> None:
        super().__init__(message)
        self.file = file


class InputError(WashoutError):
    """A design, study, measurement or option is at fault (exit code 2 of the command line).

    `line` and `column` count from 1; `key` is the dotted key or column, such as `rod[0].section.diameter_mm`, `value` what
    stands there, `problem` what is wrong with it and `cure` what to do. What is not known is None or empty.
    """

    def __init__(
        self,
        message: str,
        file: str | None = None,
        line: int | None = None,
        column: int | None = None,
        key: str = "",
        value: str = "",
        problem: str = "",
        cure: str = "",
    ) -> None:
        super().__init__(message, file)
        self.line = line
        self.column = column
        self.key = key
        self.value = value
        self.problem = problem
        self.cure = cure


class NotConverged(WashoutError):
    """The equations have no solution that was found, or the wing would not stay in it (exit code 3 of the command line)."""


@contextmanager
def by_argument() -> Iterator[None]:
    """What goes wrong within names the arguments of Python (`sets`) where the command line names its options (`--set`)."""
    try:
        yield
    except InputError as error:
        error.args = (in_python(str(error)),)
        error.file = error.file and in_python(error.file)
        error.key, error.problem, error.cure = in_python(error.key), in_python(error.problem), in_python(error.cure)
        raise


ARGUMENTS = {
    "--" + option: argument
    for option, argument in {
        **{name: name for name in ("case", "design", "ladder", "on", "output", "readings", "reference", "seed", "sigma", "significance", "without")},
        **{"effect": "effects", "hold-out": "hold_out", "number": "numbers", "set": "sets", "to": "study", "with": "readings"},
        **{"stroke": "stroke", "stroke-quasi-static": "stroke_quasi_static", "uncertainty": "uncertainty"},
    }.items()
}
"""The argument for an option."""


def in_python(message: str) -> str:
    """A message with arguments for options; whole commands, which stand in backquotes, stay."""
    parts = message.split("`")
    for place in range(0, len(parts), 2):
        parts[place] = re.sub(r"--[a-z-]*[a-z]", lambda found: ARGUMENTS.get(found[0], found[0]), parts[place])
    return "`".join(parts)
