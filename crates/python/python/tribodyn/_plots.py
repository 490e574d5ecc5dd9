"""Pictures by matplotlib, which is optional: only those who ask for a picture need it."""

from __future__ import annotations

import io
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _html
from ._errors import InputError

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Pictured:
    """What draws itself."""

    def plot(self, *, ax: Optional[Axes] = None) -> Axes:
        """Draws the answer, into axes of matplotlib or into new ones, and gives them."""
        ax = axes(ax)
        self._draw(ax)
        return ax

    def _draw(self, ax: Axes) -> None:
        numbers = {n: v for n, v in vars(self).items() if isinstance(v, (int, float)) and not isinstance(v, bool)}
        bars(ax, numbers, "")


def axes(ax: Optional[Axes]) -> Axes:
    """The axes that are given, or new ones."""
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError as error:
        allowed = "pip install 'tribodyn[plot]'"
        raise InputError(f"matplotlib is not installed: {allowed}", path="ax", allowed=allowed) from error
    return pyplot.subplots()[1]


def svg(answer: Pictured) -> str:
    """The picture of an answer for a page; nothing without matplotlib. No figure stays open."""
    try:
        import matplotlib
        from matplotlib.figure import Figure
    except ImportError:
        return ""
    figure = Figure(figsize=(6.4, 3.6), layout="constrained")
    answer._draw(figure.add_subplot())
    text = io.StringIO()
    # The same answer gives the same text.
    with matplotlib.rc_context({"svg.hashsalt": "tribodyn"}):
        figure.savefig(text, format="svg", metadata={"Date": None})
    return _html.figure(text.getvalue())


def label(ax: Axes, x: str, y: str, *, legend: bool = False) -> None:
    """Names of the axes, a grid, a legend."""
    ax.set_xlabel(x)
    ax.set_ylabel(y)
    ax.grid(True, alpha=0.3)
    if legend and ax.get_legend_handles_labels()[1]:
        ax.legend()


def bars(ax: Axes, numbers: Mapping[str, Optional[float]], unit: str) -> None:
    """Numbers as horizontal bars, the first one on top."""
    found = {name: value for name, value in numbers.items() if value is not None and np.isfinite(value)}
    ax.barh(list(found), list(found.values()))
    ax.invert_yaxis()
    ax.set_xlabel(unit)


def pressure(ax: Axes, semi_axes_m: Mapping[str, float], peak_pa: float) -> None:
    """Hertz pressure along the axes of a contact ellipse."""
    for name, half in semi_axes_m.items():
        place = np.linspace(-1.0, 1.0, 201)
        ax.plot(1e3 * half * place, 1e-9 * peak_pa * np.sqrt(1.0 - place**2), label=name)
    label(ax, "place, mm", "pressure, GPa", legend=True)


def heat(ax: Axes, matrix: Any, names: tuple[str, ...]) -> None:
    """Entries of a matrix over the roots of its diagonal, so that units fall out."""
    scale = np.sqrt(np.abs(np.diag(matrix)))
    scale[scale == 0.0] = 1.0
    image = ax.imshow(np.asarray(matrix) / np.outer(scale, scale), cmap="RdBu_r", vmin=-1.0, vmax=1.0)
    ax.set_xticks(range(len(names)), names, rotation=45)
    ax.set_yticks(range(len(names)), names)
    ax.figure.colorbar(image, ax=ax, label="K_ij / √(K_ii K_jj)")


def section(ax: Axes, listed: Any) -> None:
    """A bearing of the list, its balls seen along the axis."""
    from matplotlib.patches import Circle

    for diameter in (listed.outside_diameter_mm, listed.bore_mm):
        ax.add_patch(Circle((0.0, 0.0), 0.5 * diameter, fill=False, linewidth=1.5))
    for ball in range(listed.ball_count):
        at = 2.0 * np.pi * ball / listed.ball_count
        centre = (0.5 * listed.pitch_diameter_mm * np.cos(at), 0.5 * listed.pitch_diameter_mm * np.sin(at))
        ax.add_patch(Circle(centre, 0.5 * listed.ball_diameter_mm, alpha=0.5))
    half = 0.55 * listed.outside_diameter_mm
    ax.set_xlim(-half, half)
    ax.set_ylim(-half, half)
    ax.set_aspect("equal")
    ax.set_xlabel("mm")
    ax.set_title(listed.designation)


def column(values: Any) -> Any:
    """A column of a table as an array; one of texts holds objects."""
    if isinstance(values, list):
        texts = np.empty(len(values), dtype=object)
        texts[:] = values
        return texts
    return values
