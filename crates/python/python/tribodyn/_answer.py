"""What all answers have in common: plain attributes with the names of the command's JSON."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from . import _html

if TYPE_CHECKING:
    import pandas as pd


class Answer:
    """Numbers of an answer as attributes. What a model does not have is absent, not zero."""

    def __init__(self, data: Mapping[str, Any]) -> None:
        self.__dict__.update(data)

    def to_dict(self) -> dict[str, Any]:
        """All attributes, as the command's JSON has them."""
        return {name: _plain(value) for name, value in self.__dict__.items() if not name.startswith("_")}

    def to_pandas(self) -> pd.Series[Any]:
        """The single values as a series."""
        import pandas

        single = {n: v for n, v in self.__dict__.items() if not n.startswith("_") and _is_single(v)}
        series: pd.Series[Any] = pandas.Series(single, name=type(self).__name__, dtype=object)
        return series

    def __getattr__(self, name: str) -> Any:
        if name in _known(type(self)):
            raise AttributeError(f"this {type(self).__name__} has no {name}: its model does not give it")
        raise AttributeError(f"{type(self).__name__} has no attribute {name}")

    def __repr__(self) -> str:
        single = [f"{n}={_html.number(v)}" for n, v in self.__dict__.items() if not n.startswith("_") and _is_single(v)]
        return f"{type(self).__name__}({', '.join(single[:6])}{', …' if len(single) > 6 else ''})"

    def _repr_html_(self) -> str:
        rows = [(n, v) for n, v in self.__dict__.items() if not n.startswith("_") and _is_single(v)]
        return _html.table(type(self).__name__, ("", ""), rows)


def _is_single(value: object) -> bool:
    return value is None or isinstance(value, (bool, int, float, str))


def _plain(value: Any) -> Any:
    if isinstance(value, Answer):
        return value.to_dict()
    if isinstance(value, (list, tuple)):
        return [_plain(part) for part in value]
    return value


def _known(kind: type) -> set[str]:
    return {name for base in kind.__mro__ for name in getattr(base, "__annotations__", {})}
