"""Cases: one bearing with its operating point."""

from __future__ import annotations

import math
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Optional, Union

from . import _html, _native, units
from ._errors import CaseError, FileError, InputError
from .answers import Derived

#: What a value of a case may be given as: a quantity (``tribodyn.kN(3)``, or one of Pint's), a number where the value
#: has no unit, a truth value, or text as in a case file.
Value = Any

_NUMBER = re.compile(r"[-+]?(?:\d[\d_]*\.?\d*(?:[eE][-+]?\d+)?|NaN|inf)")


class Case:
    """A bearing with its operating point, as a case file describes it. Every value was read and checked.

    >>> import tribodyn
    >>> case = tribodyn.Case.new("7210", angle=40)
    >>> case["geometry.ball_count"], case["geometry.ball_diameter"]
    (15, mm(12.7))
    """

    def __init__(self, native: _native.Case) -> None:
        self._native = native

    @classmethod
    def read(cls, path: Union[str, os.PathLike[str]], *, limits: bool = True) -> Case:
        """Reads a case file (RON).

        ``limits=False`` lifts the bounds on what a file may ask for: balls, nodes, steps.

        Raises:
            FileError: the file cannot be read
            CaseError: the case is refused, with file, line, column, path, value and what is allowed
        """
        return cls(_native.Case.read(os.fspath(path), not limits))

    @classmethod
    def parse(cls, text: str, *, name: str = "case", limits: bool = True) -> Case:
        """Reads the text of a case file; ``name`` stands for the file in messages."""
        return cls(_native.Case.parse(text, name, not limits))

    @classmethod
    def new(
        cls,
        designation: Optional[str] = None,
        *,
        angle: Optional[float] = None,
        bore: Optional[float] = None,
        outside: Optional[float] = None,
        width: Optional[float] = None,
        balls: Optional[int] = None,
        ball: Optional[float] = None,
        dynamic_rating: Optional[float] = None,
        static_rating: Optional[float] = None,
        radial: Optional[float] = None,
        axial: Optional[float] = None,
        speed: Optional[float] = None,
        lubricant: Optional[str] = None,
        shaft_fit: Optional[str] = None,
        housing_fit: Optional[str] = None,
    ) -> Case:
        """A complete case from a designation, or from boundary dimensions.

        What is not given is assumed; ``case.sources`` says so, with reason and usual range.

        Args:
            designation: a size of the list, such as ``"6206"`` or ``"7210B"``
            angle: nominal contact angle, degrees
            bore, outside, width: boundary dimensions, mm, instead of a designation
            balls: number of balls
            ball: ball diameter, mm
            dynamic_rating, static_rating: load ratings C_r and C_0r, N
            radial, axial: loads, N
            speed: speed of the inner ring, r/min
            lubricant: ``"vg32"``, ``"pao-vg46"``, ``"grease"``, ``"ag"``, ``"ptfe"``; where left out, or
                ``"usual"``, grease for sealed bearings and oil VG 68 for open ones
            shaft_fit, housing_fit: tolerance classes of the seats (ISO 286), such as ``"k5"`` and ``"H7"``
        """
        request = {
            "designation": designation,
            "angle": units.in_unit(angle, "deg", "angle"),
            "bore": units.in_unit(bore, "mm", "bore"),
            "outside": units.in_unit(outside, "mm", "outside"),
            "width": units.in_unit(width, "mm", "width"),
            "balls": balls,
            "ball": units.in_unit(ball, "mm", "ball"),
            "dynamic_rating": units.in_unit(dynamic_rating, "N", "dynamic_rating"),
            "static_rating": units.in_unit(static_rating, "N", "static_rating"),
            "radial": units.in_unit(radial, "N", "radial"),
            "axial": units.in_unit(axial, "N", "axial"),
            "speed": units.in_unit(speed, "rpm", "speed"),
            "lubricant": lubricant,
            "shaft_fit": shaft_fit,
            "housing_fit": housing_fit,
        }
        return cls(_native.Case.make(request))

    @property
    def name(self) -> str:
        """Name of the bearing."""
        return self._native.bearing

    @property
    def file(self) -> str:
        """Name of the file, as messages have it."""
        return self._native.name

    @property
    def text(self) -> str:
        """The text of the case, changes made."""
        return self._native.text

    @property
    def sources(self) -> Mapping[str, Any]:
        """Where values come from, by path."""
        return self.check().sources

    def write(self, path: Union[str, os.PathLike[str]]) -> None:
        """Writes the text to a file that does not exist yet."""
        try:
            with Path(path).open("x", encoding="utf-8") as file:
                file.write(self.text)
        except OSError as error:
            raise FileError(f"cannot write {os.fspath(path)}: {error}", file=os.fspath(path)) from error

    def __getitem__(self, path: str) -> Any:
        """The value at a path: a :class:`Quantity`, a number, a truth value, or the text of anything else.

        ``case["ring.z"]`` is ``Force(kN(54.76))``: 54760.0 as a number, ``.value`` 54.76, ``.unit`` kN, ``.text`` as in
        the file.
        """
        text = self._native.value(path)
        if text is None:
            known = [known for known in self if known.startswith(path.split(".")[0])]
            allowed = f"allowed are paths such as {', '.join(known[:8])}" if known else f"allowed are {', '.join(self)}"
            raise CaseError(f"{self.file}: nothing at {path}; {allowed}", file=self.file, path=path, allowed=allowed)
        return _value(text)

    def __setitem__(self, path: str, value: Value) -> None:
        """Changes the value at a path; the case stays as it was where the new one is refused.

        A quantity alone keeps the choice that it stands in: ``case["ring.z"] = kN(30)`` makes ``Force(kN(30))`` of
        ``Force(kN(54.76))``. A number without its unit is refused where there is one.
        """
        self._native = self._replaced({path: value})

    def __iter__(self) -> Iterator[str]:
        """Paths of all single values."""
        return (path for path, _ in self._native.values())

    def values(self) -> dict[str, Any]:
        """All single values by path."""
        return {path: _value(text) for path, text in self._native.values()}

    def replace(self, changes: Optional[Mapping[str, Value]] = None, **more: Value) -> Case:
        """A copy with other values: ``case.replace({"ring.z": kN(30)})``."""
        return Case(self._replaced({**(changes or {}), **more}))

    def copy(self) -> Case:
        """A copy."""
        return Case(self._native)

    def check(self, *, flow: Optional[float] = None, power: Optional[float] = None) -> Derived:
        """What follows from the case before anything is solved: angles, clearances, masses, contact constants.

        With a flow of the cryogen (kg/s) and the heat that it takes up (W) also what it is at the outlet.
        """
        if (flow is None) != (power is None):
            raise InputError("flow and power go together", path="flow", value=repr(flow), allowed="both or none")
        heat = None if flow is None or power is None else [float(flow), float(power)]
        return Derived(_native.check(self._native, heat))

    def _replaced(self, changes: Mapping[str, Value]) -> _native.Case:
        return self._native.replaced([self._change(path, value) for path, value in changes.items()])

    def _change(self, path: str, value: Value) -> tuple[str, str]:
        """The change as the compiled half takes it: a number or a quantity alone goes into the choice around it."""
        there = self._native.value(path) or ""
        if hasattr(value, "magnitude") and hasattr(value, "to"):
            value = _of_pint(path, value, units.read(there))
        try:
            text = as_text(value)
        except TypeError as error:
            raise InputError(f"{path}: {error}", path=path, value=repr(value), allowed=str(error)) from None
        quantity = units.read(text)
        alone = quantity is not None and quantity.choice is None
        choice = units.choice_of(there) if alone or _NUMBER.fullmatch(text.strip()) else None
        return (f"{path}.{choice}" if choice else path), text

    def __repr__(self) -> str:
        return f"Case({self.name!r}, file={self.file!r})"

    def _repr_html_(self) -> str:
        rows = [(path, value) for path, value in self._native.values()]
        return _html.table(self.name, ("value", "as it is written"), rows)

    def __getstate__(self) -> dict[str, str]:
        return {"text": self.text, "name": self.file}

    def __setstate__(self, state: dict[str, str]) -> None:
        # What was accepted once may go beyond the limits for files from elsewhere.
        self._native = _native.Case.parse(state["text"], state["name"], True)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Case) and self.text == other.text

    __hash__ = None  # type: ignore[assignment]


def native(case: Case) -> _native.Case:
    """The compiled half of a case that is an argument."""
    if isinstance(case, Case):
        return case._native
    allowed = "allowed is a Case, as of Case.read(path) and Case.new(designation)"
    raise InputError(f"case = {case!r}: {allowed}", path="case", value=repr(case), allowed=allowed)


def as_text(value: Value) -> str:
    """A value as a case file has it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, units.Quantity):
        return value.text
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else units.number(value)
    if hasattr(value, "item"):
        return as_text(value.item())
    if not isinstance(value, str):
        raise TypeError(f"allowed are a quantity, a number, a truth value or text, not {type(value).__name__}")
    return value


def _value(text: str) -> Any:
    """A value of a case file as Python has it."""
    quantity = units.read(text)
    if quantity is not None:
        return quantity
    word = text.strip()
    if word in ("true", "false"):
        return word == "true"
    if _NUMBER.fullmatch(word):
        plain = word.replace("_", "")
        return int(plain) if re.fullmatch(r"[-+]?\d+", plain) else float(plain)
    return word


def _of_pint(path: str, value: Any, there: Optional[units.Quantity]) -> units.Quantity:
    """A quantity of Pint's in the unit that stands at the path."""
    if there is None:
        allowed = "allowed is a quantity of tribodyn.units: the value there has no unit to convert to"
        raise InputError(f"{path} = {value}: {allowed}", path=path, value=str(value), allowed=allowed)
    try:
        return units.Quantity(float(value.to(units.pint_name(there.unit)).magnitude), there.unit)
    except (TypeError, ValueError, AttributeError) as error:
        allowed = f"allowed is what can be turned into {there.unit}"
        message = f"{path} = {value}: {allowed}: {error}"
        raise CaseError(message, path=path, value=str(value), allowed=allowed) from error
