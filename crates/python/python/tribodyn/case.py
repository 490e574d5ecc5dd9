"""Cases: one bearing with its operating point."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Optional, Union

from . import _html, _native
from ._errors import CaseError, FileError
from .answers import Derived

#: What a value of a case may be given as: text of a case file, a number, or a truth value.
Value = Union[str, float, int, bool]

_QUANTITY = re.compile(r"\s*[A-Za-z_][A-Za-z_0-9]*\(\s*[-+0-9.eE]+\s*\)\s*")
_CHOICE = re.compile(r"\s*([A-Za-z_][A-Za-z_0-9]*)\s*\(")


class Case:
    """A bearing with its operating point, as a case file describes it. Every value was read and checked.

    >>> import tribodyn
    >>> case = tribodyn.Case.new("7210", angle=40)
    >>> case["geometry.ball_count"]
    '15'
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
        """
        request = {
            "designation": designation,
            "angle": angle,
            "bore": bore,
            "outside": outside,
            "width": width,
            "balls": balls,
            "ball": ball,
            "dynamic_rating": dynamic_rating,
            "static_rating": static_rating,
            "radial": radial,
            "axial": axial,
            "speed": speed,
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

    def __getitem__(self, path: str) -> str:
        """The text of the value at a path, such as ``kN(54.76)`` at ``ring.z.Force``."""
        value = self._native.value(path)
        if value is None:
            known = [known for known in self if known.startswith(path.split(".")[0])]
            allowed = f"allowed are paths such as {', '.join(known[:8])}" if known else f"allowed are {', '.join(self)}"
            raise CaseError(f"{self.file}: nothing at {path}; {allowed}", file=self.file, path=path, allowed=allowed)
        return value

    def __setitem__(self, path: str, value: Value) -> None:
        """Changes the value at a path; the case stays as it was where the new one is refused.

        A plain quantity keeps the choice that it stands in: ``case["ring.z"] = "kN(30)"`` makes ``Force(kN(30))`` of
        ``Force(kN(54.76))``.
        """
        self._native = self._replaced({path: value})

    def __iter__(self) -> Iterator[str]:
        """Paths of all single values."""
        return (path for path, _ in self._native.values())

    def values(self) -> dict[str, str]:
        """All single values by path, as text."""
        return dict(self._native.values())

    def replace(self, changes: Optional[Mapping[str, Value]] = None, **more: Value) -> Case:
        """A copy with other values: ``case.replace(**{"ring.z.Force": "kN(30)"})``, or with a dictionary."""
        return Case(self._replaced({**(changes or {}), **more}))

    def copy(self) -> Case:
        """A copy."""
        return Case(self._native)

    def check(self) -> Derived:
        """What follows from the case before anything is solved: angles, clearances, masses, contact constants."""
        return Derived(_native.check(self._native))

    def _replaced(self, changes: Mapping[str, Value]) -> _native.Case:
        texts = [(path, as_text(value)) for path, value in changes.items()]
        try:
            return self._native.replaced(texts)
        except CaseError:
            # A quantity for a choice, such as `Force`: once more with the choices that stand there.
            kept = [(self._into_choice(path, text), text) for path, text in texts]
            if kept == texts:
                raise
            try:
                return self._native.replaced(kept)
            except CaseError:
                pass
            raise

    def _into_choice(self, path: str, text: str) -> str:
        if not _QUANTITY.fullmatch(text):
            return path
        choice = _CHOICE.match(self._native.value(path) or "")
        return f"{path}.{choice.group(1)}" if choice else path

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


def as_text(value: Value) -> str:
    """A value as a case file has it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        return repr(value)
    if hasattr(value, "item"):
        return as_text(value.item())
    if not isinstance(value, str):
        raise TypeError(f"a value of a case is text, a number or a truth value, not {type(value).__name__}")
    return value
