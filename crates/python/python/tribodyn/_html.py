"""Tables and figures for notebooks."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

_MOST_ROWS = 200


def table(title: str, head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """A table with a title."""
    rows = list(rows)
    cells = "".join(f"<th style='text-align:left'>{escape(name)}</th>" for name in head)
    body = "".join(_row(row) for row in rows[:_MOST_ROWS])
    rest = f"<p>… and {len(rows) - _MOST_ROWS} more rows</p>" if len(rows) > _MOST_ROWS else ""
    return f"<p><b>{escape(title)}</b></p><table><tr>{cells}</tr>{body}</table>{rest}"


def _row(row: Sequence[object]) -> str:
    return "<tr>" + "".join(f"<td style='text-align:left'>{escape(number(cell))}</td>" for cell in row) + "</tr>"


def number(value: object) -> str:
    """A cell: numbers with six digits."""
    if isinstance(value, float):
        return f"{value:.6g}"
    return str(value)


def figure(svg: str) -> str:
    """A figure in a page; what stands before the drawing belongs to files only."""
    start = svg.find("<svg")
    return f"<div style='max-width:60em'>{svg[start:]}</div>" if start >= 0 else ""


def text(words: str) -> str:
    """Words that may hold what HTML reads otherwise."""
    return escape(words)


def warnings(sentences: Iterable[str]) -> str:
    """Warnings, a paragraph each."""
    return "".join(f"<p>warning: {escape(sentence)}</p>" for sentence in sentences)
