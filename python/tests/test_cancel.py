"""Ctrl-C, or a callback that raises, stops what runs, soon; afterwards all is as before."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest
from conftest import SOON_S, interrupted_after

import washout

LONG = "studies/minguet.toml"

pytestmark = pytest.mark.usefixtures("listening")


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
