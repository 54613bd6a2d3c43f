"""Ctrl-C, or a callback that raises, stops what runs, soon; afterwards all is as before."""

from __future__ import annotations

import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

import washout

LONG = "studies/minguet.toml"

SOON_S = 10.0


@pytest.fixture(autouse=True)
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


def test_ctrl_c_stops_a_diagnosis_and_leaves_nothing(run: washout.Run, tmp_path: Path) -> None:
    handler = signal.getsignal(signal.SIGINT)
    took = interrupted_after(0.5, lambda: washout.diagnose(LONG, output=tmp_path / "diagnosis"))
    assert took < SOON_S
    assert list(tmp_path.iterdir()) == []
    assert signal.getsignal(signal.SIGINT) is handler
    assert washout.solve("designs/twist-v2.toml").tip_twist_deg == run.tip_twist_deg


def test_ctrl_c_stops_a_solve() -> None:
    took = interrupted_after(0.5, lambda: washout.solve("designs/twist-v2.toml", {"mesh.refine": 4}))
    assert took < SOON_S


def test_a_callback_that_raises_stops_the_work() -> None:
    def give_up(line: str) -> None:
        raise LookupError(line)

    with pytest.raises(LookupError, match="solving twist-v2"):
        washout.solve("designs/twist-v2.toml", progress=give_up)
