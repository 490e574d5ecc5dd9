"""Tribo-dynamics of ball bearings.

>>> import tribodyn
>>> case = tribodyn.Case.new("7210", angle=40)
>>> tribodyn.solve(case, model="jones-harris").to_pandas().shape
(15, 29)

Numbers are in SI units; names of attributes end in their unit where it is not plain, as in ``cage_speed_rpm``.
"""

from __future__ import annotations

from . import units
from ._errors import CaseError, ClusterError, FileError, InputError, SolveError, Stopped, TribodynError
from ._native import VERSION as __version__
from .answers import Contact, Derived, Identification, Life, Mode, Modes, Rating, Stiffness, TractionCurve
from .case import Case
from .procedures import check, hertz, modes, rating_life, solve, stiffness, traction_curve
from .runs import BallSeries, Recording, Run, Series, identify, life, read_recording, run
from .solution import Ball, Balls, Solution
from .sweeps import Plan, Sweep, Table, from_unit_cube, latin_hypercube, merge, plan, sobol, sweep, sweep_to

__all__ = [
    "Ball",
    "BallSeries",
    "Balls",
    "Case",
    "CaseError",
    "ClusterError",
    "Contact",
    "Derived",
    "FileError",
    "Identification",
    "InputError",
    "Life",
    "Mode",
    "Modes",
    "Plan",
    "Rating",
    "Recording",
    "Run",
    "Series",
    "Solution",
    "SolveError",
    "Stiffness",
    "Stopped",
    "Sweep",
    "Table",
    "TractionCurve",
    "TribodynError",
    "__version__",
    "check",
    "from_unit_cube",
    "hertz",
    "identify",
    "latin_hypercube",
    "life",
    "merge",
    "modes",
    "plan",
    "rating_life",
    "read_recording",
    "run",
    "sobol",
    "solve",
    "stiffness",
    "sweep",
    "sweep_to",
    "traction_curve",
    "units",
]
