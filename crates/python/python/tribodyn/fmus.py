"""Functional mock-up units: bearings for multibody and system simulation."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Union

from . import _native, _plots
from ._answer import OfOperatingPoint, warned
from .case import Case, native
from .procedures import TIME_LIMIT_S

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Fmu(OfOperatingPoint):
    """An FMU that was written: what it holds, and where it starts."""

    #: the file
    output: str
    #: version of the interface
    fmi_version: str
    #: name of its libraries
    model_identifier: str
    #: platforms with a compiled library, such as ``linux64``; other ones compile the sources
    platforms: list[str]
    #: of the inner ring at the start, the equilibrium of the case: x, y, z
    ring_displacement_m: list[float]
    #: about X and Y
    ring_tilt_rad: list[float]
    #: of the bearing on the inner ring there: x, y, z; the opposite of the ring's load
    force_n: list[float]
    #: about X and Y
    moment_nm: list[float]

    def _draw(self, ax: Axes) -> None:
        _plots.bars(ax, dict(zip("xyz", self.force_n)), "force on the inner ring, N")


def fmu(
    case: Case,
    output: Union[str, os.PathLike[str]],
    *,
    compile: bool = True,
    force: bool = False,
    time_limit: float = TIME_LIMIT_S,
) -> Fmu:
    """Writes a case as a functional mock-up unit (FMI 2.0, co-simulation and model exchange).

    The FMU gives forces and moments of the bearing on its inner ring from displacements, tilts and speeds, by the
    equations of ``"jones-harris"``. It starts in the equilibrium of the case.

    Args:
        case: the bearing at its operating point
        output: the file to write
        compile: compile its C sources where there is a compiler, ``cc`` or what the variable ``CC`` names
        force: replace a file at ``output`` that tribodyn did not write
        time_limit: seconds of processor time after which the search for the equilibrium is given up
    """
    return warned(Fmu(_native.fmu(native(case), os.fspath(output), (compile, force), time_limit)))
