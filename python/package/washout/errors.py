"""What washout raises. Each message is the one of the command line, with the cure."""

from __future__ import annotations


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
