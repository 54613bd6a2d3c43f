"""What the tests share: the repository, the command line that the package is held against, one solved wing."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import washout
from washout.verb import Document

REPOSITORY = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("WASHOUT", REPOSITORY / "target/release/washout"))

CommandLine = Callable[..., subprocess.CompletedProcess[str]]
Printed = Callable[..., Document]

SOON_S = 10.0
"""What stops soon after Ctrl-C stops within this."""


@pytest.fixture(autouse=True, scope="session")
def in_repository() -> Iterator[None]:
    """Paths of designs and studies are given as in the documentation."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(REPOSITORY)
        yield


@pytest.fixture(scope="session")
def command_line() -> CommandLine:
    """Runs the program itself."""

    def run(*arguments: object) -> subprocess.CompletedProcess[str]:
        words = [str(PROGRAM), *map(str, arguments)]
        return subprocess.run(words, capture_output=True, text=True, cwd=REPOSITORY, check=False)

    return run


@pytest.fixture(scope="session")
def printed(command_line: CommandLine) -> Printed:
    """The document that the program prints."""

    def document(*arguments: object) -> Document:
        done = command_line(*arguments, "--json", "--quiet")
        assert done.returncode == 0, done.stderr
        parsed: Document = json.loads(done.stdout)
        return parsed

    return document


@pytest.fixture(scope="session")
def run() -> washout.Run:
    """Twist v2, solved once."""
    return washout.solve("designs/twist-v2.toml")


@pytest.fixture
def listening() -> Iterator[None]:
    """Ctrl-C as at a terminal, also where the tests run in the background of a shell, which ignores it there."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def interrupted_after(seconds: float, work: Callable[[], object]) -> float:
    """Seconds that `work` took to stop after Ctrl-C."""
    pressed: list[float] = []

    def press() -> None:
        pressed.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, press)
    timer.start()
    with pytest.raises(KeyboardInterrupt, match="interrupted; nothing was written"):
        work()
    timer.cancel()
    return time.monotonic() - pressed[0]
