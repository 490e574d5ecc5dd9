"""Quantities: numbers with a unit, as a case file has them.

>>> from tribodyn.units import kN, rpm
>>> kN(3)
kN(3)
>>> kN(3) + 500, kN(3).unit, kN(3).value
(3500.0, 'kN', 3.0)
>>> round(rpm(14000), 1), round(rpm(14000).to("rad_per_s"), 1)
(1466.1, 1466.1)
>>> kN([10, 20])
[kN(10), kN(20)]

All units of case files are here by their name; which ones a value may have, the error says that refuses another one.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Iterable
from typing import Any, Optional, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import InputError


class Quantity(float):
    """A number with a unit. As a number it is in SI: ``kN(3) + 500`` is 3500.0.

    What is computed with it is a plain number in SI, so that :class:`tribodyn.Case` asks for its unit again:
    ``case["ring.z"] = N(2 * case["ring.z"])``.
    """

    #: the number as it is written
    value: float
    #: its unit, such as ``kN``
    unit: str
    #: as it stands in a case file, such as ``Force(kN(3))``
    text: str
    #: the choice around it, such as ``Force``; None without one
    choice: Optional[str]

    def __new__(cls, value: float, unit: str, choice: Optional[str] = None, text: Optional[str] = None) -> Quantity:
        si = _native.in_si(unit, float(value))
        if si is None:
            raise _no_unit(unit)
        made = super().__new__(cls, si)
        made.value, made.unit, made.choice = float(value), unit, choice
        written = f"{unit}({number(float(value))})"
        made.text = text if text is not None else f"{choice}({written})" if choice else written
        return made

    def to(self, unit: str) -> float:
        """The number in another unit of its kind."""
        if unit not in _kind(self.unit):
            allowed = f"allowed are {', '.join(_kind(self.unit))}"
            raise InputError(f"{self} in {unit}: {allowed}", path="unit", value=unit, allowed=allowed)
        zero, one = (_native.in_si(unit, number) or 0.0 for number in (0.0, 1.0))
        return (float(self) - zero) / (one - zero)

    def to_pint(self, registry: Any = None) -> Any:
        """The same of Pint's, in the unit of this one; ``registry`` is Pint's own where none is given."""
        if registry is None:
            registry = importlib.import_module("pint").get_application_registry()
        return registry.Quantity(self.value, pint_name(self.unit))

    def __repr__(self) -> str:
        return self.text

    def __str__(self) -> str:
        return self.text

    def __format__(self, form: str) -> str:
        return format(float(self), form) if form else self.text

    def __reduce__(self) -> tuple[Any, ...]:
        return Quantity, (self.value, self.unit, self.choice, self.text)


class Unit:
    """A unit that makes quantities: ``kN(30)``, or a list of them: ``kN([10, 20])``."""

    def __init__(self, name: str) -> None:
        if not _kind(name):
            raise _no_unit(name)
        self.name = name

    @overload
    def __call__(self, values: float) -> Quantity: ...

    @overload
    def __call__(self, values: Union[Iterable[float], NDArray[np.float64]]) -> list[Quantity]: ...

    def __call__(self, values: Union[float, Iterable[float], NDArray[np.float64]]) -> Union[Quantity, list[Quantity]]:
        if isinstance(values, (int, float, np.number)):
            return Quantity(float(values), self.name)
        return [Quantity(float(value), self.name) for value in values]

    def __repr__(self) -> str:
        return f"unit({self.name!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Unit) and self.name == other.name

    def __hash__(self) -> int:
        return hash(self.name)


def unit(name: str) -> Unit:
    """The unit of a name."""
    return Unit(name)


@overload
def in_unit(value: float, unit: str, name: str) -> float: ...


@overload
def in_unit(value: Optional[float], unit: str, name: str) -> Optional[float]: ...


def in_unit(value: Optional[float], unit: str, name: str) -> Optional[float]:
    """The argument of a name in its unit: a quantity, or one of Pint's, is turned into it; None stays None."""
    allowed = f"allowed are a number, in {unit}, and quantities in {', '.join(_kind(unit))}"
    given: Any = value
    if isinstance(given, Quantity) and given.unit in _kind(unit):
        return given.to(unit)
    if hasattr(given, "magnitude") and hasattr(given, "to"):
        return float(given.to(pint_name(unit)).magnitude)
    if isinstance(given, (Quantity, str)):
        raise InputError(f"{name} = {given!r}: {allowed}", path=name, value=str(given), allowed=allowed)
    try:
        return None if given is None else float(given)
    except (TypeError, ValueError):
        raise InputError(f"{name} = {given!r}: {allowed}", path=name, value=repr(given), allowed=allowed) from None


def all_in_unit(values: Union[float, Iterable[float]], unit: str, name: str) -> list[float]:
    """One number of an argument or several, in its unit. Text is not taken letter by letter."""
    given: Any = values
    if isinstance(given, (int, float, str, np.number)) or hasattr(given, "magnitude"):
        given = [given]
    return [in_unit(value, unit, name) for value in given]


def number(value: float) -> str:
    """A number in the shortest form that reads back as the same; whole numbers without a point."""
    if value != value:
        return "NaN"
    if value in (float("inf"), float("-inf")):
        return "inf" if value > 0 else "-inf"
    if value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return repr(value)


_KINDS: list[list[str]] = _native.unit_names()
_WRITTEN = re.compile(r"\s*([A-Za-z_]\w*)\s*\(\s*([-+0-9._eE]+|-?NaN|[-+]?inf)\s*\)\s*")
_CHOSEN = re.compile(r"\s*([A-Za-z_]\w*)\s*\((.*)\)\s*", re.DOTALL)


def _kind(name: str) -> list[str]:
    """Units of the same kind as one."""
    return next((names for names in _KINDS if name in names), [])


def _no_unit(name: str) -> InputError:
    allowed = f"allowed are {', '.join(dict.fromkeys(name for names in _KINDS for name in names))}"
    return InputError(f"{name!r} is not the name of a unit; {allowed}", path="unit", value=name, allowed=allowed)


def read(text: str) -> Optional[Quantity]:
    """The quantity that a text of a case file is, with or without a choice around it; None for any other text."""
    choice, inner = None, text
    chosen = _CHOSEN.fullmatch(text)
    if chosen and not _kind(chosen.group(1)):
        choice, inner = chosen.group(1), chosen.group(2)
    found = _WRITTEN.fullmatch(inner)
    if found is None or not _kind(found.group(1)):
        return None
    try:
        return Quantity(float(found.group(2)), found.group(1), choice, text.strip())
    except ValueError:
        return None


def choice_of(text: str) -> Optional[str]:
    """The choice that stands around a single number or quantity of a case file; None where none does."""
    chosen = _CHOSEN.fullmatch(text)
    if chosen is None or _kind(chosen.group(1)):
        return None
    inner = chosen.group(2).strip()
    return chosen.group(1) if read(inner) is not None or re.fullmatch(r"[-+0-9._eE]+", inner) else None


def pint_name(name: str) -> str:
    """A unit in the words of Pint."""
    text = f"_{name}".replace("_per_", "/").lstrip("_").replace("_", "*")
    text = re.sub(r"\bNm", "N*m", re.sub(r"([a-z])(\d)", r"\1**\2", text)).replace("cSt", "centistokes")
    return f"1{text}" if text.startswith("/") else text


m, mm, um, inch = Unit("m"), Unit("mm"), Unit("um"), Unit("inch")
rad, deg, mrad = Unit("rad"), Unit("deg"), Unit("mrad")
Pa, kPa, MPa, GPa, psi, ksi = Unit("Pa"), Unit("kPa"), Unit("MPa"), Unit("GPa"), Unit("psi"), Unit("ksi")
kg_per_m3, g_per_cm3, lb_per_in3 = Unit("kg_per_m3"), Unit("g_per_cm3"), Unit("lb_per_in3")
N, kN, lbf = Unit("N"), Unit("kN"), Unit("lbf")
Nm, Nmm, lbf_in = Unit("Nm"), Unit("Nmm"), Unit("lbf_in")
rad_per_s, rpm = Unit("rad_per_s"), Unit("rpm")
K, degC, degF = Unit("K"), Unit("degC"), Unit("degF")
Pa_s, mPa_s, uPa_s = Unit("Pa_s"), Unit("mPa_s"), Unit("uPa_s")
N_per_m, N_per_um, lbf_per_in = Unit("N_per_m"), Unit("N_per_um"), Unit("lbf_per_in")
s, ms, us = Unit("s"), Unit("ms"), Unit("us")
kg, g, lb = Unit("kg"), Unit("g"), Unit("lb")
kg_m2, kg_mm2 = Unit("kg_m2"), Unit("kg_mm2")
N_s_per_m, s_per_m, per_K = Unit("N_s_per_m"), Unit("s_per_m"), Unit("per_K")
Hz, kHz = Unit("Hz"), Unit("kHz")
Nm_per_rad, Nm_per_mrad = Unit("Nm_per_rad"), Unit("Nm_per_mrad")
Nm_s_per_rad = Unit("Nm_s_per_rad")
kg_m, g_mm = Unit("kg_m"), Unit("g_mm")
m2_per_s, mm2_per_s, cSt = Unit("m2_per_s"), Unit("mm2_per_s"), Unit("cSt")
per_Pa, per_GPa = Unit("per_Pa"), Unit("per_GPa")
m_per_s2 = Unit("m_per_s2")
