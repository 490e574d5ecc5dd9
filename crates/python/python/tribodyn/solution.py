"""Solutions: an equilibrium of ring and balls, or their steady orbit."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.typing import NDArray

from . import _html, _native
from ._answer import Answer
from ._quantities import BallArrays, BallQuantities, BearingQuantities

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


class Ball(BallQuantities, Answer):
    """A ball with its two contacts. What its model does not have is absent."""


class Balls(BallArrays):
    """All balls by azimuth. Attributes are arrays, such as ``balls.load_inner_n``; ``balls[0]`` is one ball.

    Arrays are views of one table: nothing is copied.
    """

    def __init__(self, names: list[str], values: NDArray[np.float64]) -> None:
        self._names = names
        self._columns = {name: place for place, name in enumerate(names)}
        self._values = values

    @property
    def names(self) -> list[str]:
        """Names of the quantities that the model has."""
        return list(self._names)

    @property
    def values(self) -> NDArray[np.float64]:
        """The table: a row for each ball, a column for each name."""
        return self._values

    def __getattr__(self, name: str) -> NDArray[np.float64]:
        columns = self.__dict__.get("_columns", {})
        if name in columns:
            column: NDArray[np.float64] = self._values[:, columns[name]]
            return column
        if name in BallArrays.__annotations__:
            raise AttributeError(f"these balls have no {name}: their model does not give it")
        raise AttributeError(f"Balls has no attribute {name}")

    def __len__(self) -> int:
        return len(self._values)

    def __getitem__(self, index: int) -> Ball:
        return Ball(dict(zip(self._names, self._values[index].tolist())))

    def __iter__(self) -> Iterator[Ball]:
        return (self[index] for index in range(len(self)))

    def to_pandas(self) -> pd.DataFrame:
        """A row for each ball."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self._values, columns=self._names, copy=False)
        return frame

    def to_xarray(self) -> xr.Dataset:
        """Quantities over the azimuth, with their units as attributes."""
        import xarray

        units = {row["name"]: row for row in _native.quantities()["ball"]}
        azimuth = self._values[:, self._columns["azimuth_deg"]]
        data = {
            name: xarray.Variable(
                "azimuth_deg", column, {"units": units[name]["unit"], "long_name": units[name]["about"]}
            )
            for name, column in zip(self._names, self._values.T)
            if name != "azimuth_deg"
        }
        return xarray.Dataset(data, coords={"azimuth_deg": ("azimuth_deg", azimuth, {"units": "°"})})

    def __repr__(self) -> str:
        return f"Balls({len(self)} balls, {len(self._names)} quantities)"

    def _repr_html_(self) -> str:
        shown = [name for name in _SHOWN if name in self._columns]
        rows = zip(*(self._values[:, self._columns[name]].tolist() for name in shown))
        return _html.table(f"{len(self)} balls", shown, rows)


#: Quantities in the table of a notebook; all of them are attributes.
_SHOWN = (
    "azimuth_deg",
    "contact_angle_inner_deg",
    "contact_angle_outer_deg",
    "load_inner_n",
    "load_outer_n",
    "peak_pressure_inner_pa",
    "peak_pressure_outer_pa",
    "orbital_speed_rad_s",
    "slide_to_roll_inner",
    "slide_to_roll_outer",
)


class Solution(BearingQuantities, Answer):
    """The equilibrium of ring and balls, or their steady orbit. What its model does not have is absent."""

    #: ``jones-harris``, ``traction`` or ``steady-orbit``
    model: str
    converged: bool
    #: True if the ring comes back from a small push; absent where that was not judged
    stable: bool
    #: largest relative residual of all balances
    residual: float
    #: Newton steps taken
    iterations: int
    #: what the bearing is lubricated with
    lubrication: str
    #: False where nothing loads the bearing
    loaded: bool
    warnings: list[str]
    #: names of what no bearing does
    implausible: list[str]
    #: torque and cage speed of an orbit with half and twice of an assumed value
    sensitivities: list[dict[str, Any]]
    #: million turns; absent for a bearing that the standards do not rate
    rating_life_l10_mrev: float
    #: of the load distribution, million turns
    rating_life_l10r_mrev: float
    rating_life_hours: float
    static_safety: float
    #: friction of all inner contacts of an orbit, W; absent for an equilibrium, as are those below
    power_loss_inner_w: float
    power_loss_outer_w: float
    #: drag and churning of all balls, W
    power_loss_fluid_w: float
    #: friction and damping in all pockets, W
    power_loss_pocket_w: float
    pocket_force_max_n: float
    #: where a ball meets a wall of its pocket
    pocket_contact_azimuths_deg: list[float]
    #: intervals of the orbit's mesh
    intervals: int
    #: damping, over the cage speed, of balls that swing in their grooves without end; absent where none do
    swing_damping: float
    #: mass of a ball over the case's, and stiffness of the pockets over the case's; absent where they are the case's
    ball_mass_factor: float
    pocket_stiffness_share: float
    #: other equilibria of each ball, where they were searched for
    roots: list[dict[str, Any]]

    def __init__(self, native: _native.Solution) -> None:
        super().__init__(native.head())
        self._native = native

    @cached_property
    def balls(self) -> Balls:
        """All balls by azimuth."""
        return Balls(*self._native.balls())

    @cached_property
    def points(self) -> Optional[Balls]:
        """A ball round its orbit, every two degrees of azimuth; None for an equilibrium."""
        points = self._native.points()
        return None if points is None else Balls(*points)

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each ball; numbers of the bearing are in ``frame.attrs``."""
        frame = self.balls.to_pandas()
        frame.attrs.update(self._numbers())
        return frame

    def to_xarray(self) -> xr.Dataset:
        """Quantities of a ball over the azimuth; numbers of the bearing are attributes."""
        data = self.balls.to_xarray()
        data.attrs.update(self._numbers())
        return data

    def to_dict(self) -> dict[str, Any]:
        """What ``solve --json`` prints."""
        answer = {name: value for name, value in self._native.head().items()}
        for name, balls in (("balls", self.balls), ("points", self.points)):
            if balls is not None:
                answer[name] = [dict(zip(balls.names, row)) for row in balls.values.tolist()]
        return answer

    def figures(self) -> dict[str, str]:
        """Figures over the azimuth as SVG, by name: ``contact-angle``, ``contact-load``, …"""
        return self._native.figures()

    def _numbers(self) -> dict[str, Any]:
        return {n: v for n, v in self._native.head().items() if isinstance(v, (int, float, str))}

    def _repr_html_(self) -> str:
        rows = [(name, value) for name, value in self._numbers().items()]
        figures = self.figures()
        drawn = next((figures[name] for name in ("contact-load", *figures) if name in figures), "")
        warnings = "".join(f"<p>warning: {warning}</p>" for warning in self.warnings)
        return (
            _html.table(f"{self.model} solution", ("", ""), rows)
            + self.balls._repr_html_()
            + warnings
            + _html.figure(drawn)
        )

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._native.head()]
