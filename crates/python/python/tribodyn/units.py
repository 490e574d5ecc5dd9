"""Quantities with a unit, as a case file has them: ``kN(30)``, and lists of them for sweeps: ``kN([10, 20])``.

Any unit of a case file is here by its name, such as ``mm``, ``um``, ``rpm``, ``deg``, ``GPa``, ``N_per_um``; which
ones a value may have, the error says that refuses another one. ``unit("kN")`` is the same as ``kN``.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Union, overload

import numpy as np
from numpy.typing import NDArray


class Unit:
    """A unit that makes quantities.

    >>> from tribodyn.units import kN
    >>> kN(30)
    'kN(30)'
    >>> kN([10, 20])
    ['kN(10)', 'kN(20)']
    """

    def __init__(self, name: str) -> None:
        if not name.isidentifier():
            raise ValueError(f"{name!r} is not the name of a unit; allowed are names such as kN or N_per_um")
        self.name = name

    @overload
    def __call__(self, values: float) -> str: ...

    @overload
    def __call__(self, values: Union[Iterable[float], NDArray[np.float64]]) -> list[str]: ...

    def __call__(self, values: Union[float, Iterable[float], NDArray[np.float64]]) -> Union[str, list[str]]:
        if isinstance(values, (int, float, np.number)):
            return f"{self.name}({number(float(values))})"
        return [f"{self.name}({number(float(value))})" for value in values]

    def __repr__(self) -> str:
        return f"unit({self.name!r})"


def unit(name: str) -> Unit:
    """The unit of a name."""
    return Unit(name)


def number(value: float) -> str:
    """A number in the shortest form that reads back as the same; whole numbers without a point."""
    if value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return repr(value)


m, mm, um, inch = Unit("m"), Unit("mm"), Unit("um"), Unit("inch")
rad, deg, mrad = Unit("rad"), Unit("deg"), Unit("mrad")
N, kN = Unit("N"), Unit("kN")
Pa, MPa, GPa = Unit("Pa"), Unit("MPa"), Unit("GPa")
kg, g = Unit("kg"), Unit("g")
s, ms, us = Unit("s"), Unit("ms"), Unit("us")
rpm = Unit("rpm")
N_per_m, N_per_um = Unit("N_per_m"), Unit("N_per_um")


def __getattr__(name: str) -> Unit:
    if name.startswith("_"):
        raise AttributeError(name)
    return Unit(name)
