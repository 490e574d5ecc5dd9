"""What all answers have in common: plain attributes with the names of the command's JSON."""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

import numpy as np

from . import _html, _plots
from ._errors import ModelWarning, PlausibilityWarning

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


class Comparable:
    """Things that are equal where all their attributes are; a number that is NaN is equal to itself.

    They are pickled by their attributes too.
    """

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and equal(vars(self), vars(other))

    __hash__ = None  # type: ignore[assignment]


def equal(one: Any, other: Any) -> bool:
    """Whether two values are the same, arrays by their elements, NaN equal to NaN."""
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        if not (isinstance(one, np.ndarray) and isinstance(other, np.ndarray)):
            return False
        if one.shape != other.shape or one.dtype != other.dtype:
            return False
        if one.dtype == object:
            return all(map(equal, one.ravel(), other.ravel()))
        return np.array_equal(one, other, equal_nan=one.dtype.kind == "f")
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        return one.keys() == other.keys() and all(equal(value, other[name]) for name, value in one.items())
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        return len(one) == len(other) and all(map(equal, one, other))
    if isinstance(one, float) and isinstance(other, float):
        return one == other or (one != one and other != other)
    return bool(one == other)


class Answer(Comparable, _plots.Pictured):
    """Numbers of an answer as attributes. What a model does not have is absent, not zero."""

    #: attributes that are answers themselves, or lists of them
    _parts: ClassVar[Mapping[str, type[Answer]]] = {}

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.__dict__.update(data)
        for name, kind in self._parts.items():
            part = data.get(name)
            if isinstance(part, dict):
                self.__dict__[name] = kind(part)
            elif isinstance(part, list):
                self.__dict__[name] = [kind(each) for each in part]

    def to_dict(self) -> dict[str, Any]:
        """All attributes, as the command's JSON has them."""
        return {name: plain(value) for name, value in self.__dict__.items() if not name.startswith("_")}

    def to_pandas(self) -> pd.Series[Any]:
        """The single values as a series."""
        import pandas

        series: pd.Series[Any] = pandas.Series(self._single(), name=type(self).__name__, dtype=object)
        return series

    def to_xarray(self) -> xr.Dataset:
        """What :meth:`to_pandas` gives as a data set: a table by its index, single values without dimension."""
        import pandas
        import xarray

        table: Any = self.to_pandas()
        if not isinstance(table, pandas.Series):
            data: xr.Dataset = table.to_xarray()
            return data
        if table.index.name:
            return xarray.Dataset({table.name: table.to_xarray()})
        # An array has no None.
        return xarray.Dataset({name: value for name, value in table.items() if value is not None})

    if not TYPE_CHECKING:  # Attributes are declared: a misspelt one is an error of type checkers too.

        def __getattr__(self, name: str) -> Any:
            if name in _known(type(self)):
                raise AttributeError(f"this {type(self).__name__} has no {name}: its model does not give it")
            raise AttributeError(f"{type(self).__name__} has no attribute {name}")

    def _single(self) -> dict[str, Any]:
        """Values that are not lists or sections."""
        return {n: v for n, v in self.__dict__.items() if not n.startswith("_") and _is_single(v)}

    def __repr__(self) -> str:
        single = [f"{n}={_html.number(v)}" for n, v in self._single().items()]
        single += [f"{len(v)} {n}" for n, v in self.__dict__.items() if n in self._parts and isinstance(v, list)]
        implausible = self.__dict__.get("implausible")
        end = f"; implausible: {', '.join(implausible)}" if implausible else ""
        return f"{type(self).__name__}({', '.join(single[:6])}{', …' if len(single) > 6 else ''}{end})"

    def _repr_html_(self) -> str:
        table = _html.table(type(self).__name__, ("", ""), list(self._single().items()))
        return table + _html.warnings(self.__dict__.get("warnings", [])) + _plots.svg(self)


class OfOperatingPoint(Answer):
    """An answer that rests on an operating point, with what must be known of that."""

    #: equations of the operating point
    model: str
    #: what the bearing is lubricated with
    lubrication: str
    #: False where nothing loads the bearing
    loaded: bool
    #: sentences on what is unusual, beyond what was tested, or more than the model can mean
    warnings: list[str]
    #: names of what no bearing does
    implausible: list[str]


A = TypeVar("A", bound=Answer)


def warned(answer: A) -> A:
    """The answer, its sentences said as warnings of Python to who asked for it."""
    implausible = bool(answer.__dict__.get("implausible"))
    said = answer.__dict__.get("warnings", [])
    for place, sentence in enumerate(said):
        # What is implausible stands last.
        last = implausible and place == len(said) - 1
        warnings.warn(sentence, PlausibilityWarning if last else ModelWarning, stacklevel=3)
    return answer


def _is_single(value: object) -> bool:
    return value is None or isinstance(value, (bool, int, float, str))


def plain(value: Any) -> Any:
    """As JSON has it."""
    if hasattr(value, "to_dict"):
        return value.to_dict()
    if hasattr(value, "to_list"):
        return value.to_list()
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, (list, tuple)):
        return [plain(part) for part in value]
    return value


def _known(kind: type) -> set[str]:
    return {name for base in kind.__mro__ for name in getattr(base, "__annotations__", {})}
