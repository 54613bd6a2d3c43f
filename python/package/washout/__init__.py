"""The twist of flexible wings under air load, and which physics a model of it lacks.

    >>> import washout
    >>> run = washout.solve("designs/twist-v2.toml")
    >>> run.tip_twist_deg, run.lift.lift_mn

Twist is washout: positive where it reduces the angle of attack. Every name says its unit. Long work can be stopped by
Ctrl-C, leaves Python's lock to other threads, and gives the same numbers as the command line, bit for bit.
"""

from importlib.metadata import version as _version

from washout.columns import Columns
from washout.compare import Comparison, Span, StudyComparison, compare
from washout.diagnose import Diagnosis, diagnose
from washout.errors import InputError, NotConverged, WashoutError
from washout.solve import Run, Stroke, solve
from washout.solved import Forces, LiftReport, Shape, SolvedWing
from washout.study import add, init_study
from washout.verb import run, schema
from washout.wing import Mesh, Wing

__version__ = _version("washout")

__all__ = [
    "Columns",
    "Comparison",
    "Diagnosis",
    "Forces",
    "InputError",
    "LiftReport",
    "Mesh",
    "NotConverged",
    "Run",
    "Shape",
    "SolvedWing",
    "Span",
    "Stroke",
    "StudyComparison",
    "WashoutError",
    "Wing",
    "add",
    "compare",
    "diagnose",
    "init_study",
    "run",
    "schema",
    "solve",
]
