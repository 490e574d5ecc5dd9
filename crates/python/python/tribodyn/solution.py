"""Solutions: an equilibrium of ring and balls, or their steady orbit."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Optional, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import _html, _native, _plots
from ._answer import Answer, Comparable, OfOperatingPoint
from ._errors import InputError
from ._quantities import BallArrays, BallQuantities, BearingQuantities

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes


class Ball(BallQuantities, Answer):
    """A ball with its two contacts. What its model does not have is absent."""


class Balls(Comparable, _plots.Pictured, BallArrays):
    """All balls by azimuth. Attributes are arrays, such as ``balls.load_inner_n``; ``balls[0]`` is one ball.

    Arrays are views of one table: nothing is copied.
    """

    def __init__(self, names: list[str], values: NDArray[np.float64]) -> None:
        self._names = names
        self._columns = {name: place for place, name in enumerate(names)}
        self._values = values

    @classmethod
    def of(cls, rows: list[dict[str, float]]) -> Balls:
        """From a dictionary for each ball, as the command's JSON has it."""
        names = list(dict.fromkeys(name for row in rows for name in row))
        numbers = [[row.get(name, np.nan) for name in names] for row in rows]
        return cls(names, np.array(numbers, dtype=np.float64).reshape(len(rows), len(names)))

    def plot(self, *names: str, ax: Optional[Axes] = None) -> Axes:
        """Draws quantities over the azimuth, by default the contact loads. Gives matplotlib's axes."""
        ax = _plots.axes(ax)
        self._over_azimuth(ax, names)
        return ax

    def _draw(self, ax: Axes) -> None:
        self._over_azimuth(ax, ())

    def _over_azimuth(self, ax: Axes, names: tuple[str, ...]) -> None:
        shown = names or ("load_inner_n", "load_outer_n")
        for name in shown:
            if name not in self._columns:
                allowed = f"allowed are {', '.join(self._names)}"
                raise InputError(f"no quantity {name}; {allowed}", path="names", value=name, allowed=allowed)
            ax.plot(self.azimuth_deg, self._values[:, self._columns[name]], "o-", markersize=3, label=name)
        y = "contact load, N" if not names else shown[0] if len(shown) == 1 else ""
        _plots.label(ax, "azimuth, °", y, legend=True)

    @property
    def names(self) -> list[str]:
        """Names of the quantities that the model has."""
        return list(self._names)

    @property
    def values(self) -> NDArray[np.float64]:
        """A row for each ball, a column for each name."""
        return self._values

    if not TYPE_CHECKING:  # The arrays are declared.

        def __getattr__(self, name: str) -> NDArray[np.float64]:
            columns = self.__dict__.get("_columns", {})
            if name in columns:
                return self._values[:, columns[name]]
            if name in BallArrays.__annotations__:
                raise AttributeError(f"these balls have no {name}: their model does not give it")
            raise AttributeError(f"Balls has no attribute {name}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._names]

    def __len__(self) -> int:
        return len(self._values)

    @overload
    def __getitem__(self, index: int) -> Ball: ...

    @overload
    def __getitem__(self, index: Union[slice, list[int], NDArray[Any]]) -> Balls: ...

    def __getitem__(self, index: Union[int, slice, list[int], NDArray[Any]]) -> Union[Ball, Balls]:
        """One ball, or some: by a slice, by their places, or by a mask such as ``balls.load_inner_n > 0``."""
        if not isinstance(index, (int, np.integer)):
            return Balls(self._names, self._values[index])
        return Ball(self._row(self._values[index].tolist()))

    def _row(self, numbers: list[float]) -> dict[str, float]:
        """What a ball has: there is no film where it has left its race."""
        return {name: number for name, number in zip(self._names, numbers) if number == number}

    def to_list(self) -> list[dict[str, float]]:
        """A dictionary for each ball, as the command's JSON has it."""
        return [self._row(numbers) for numbers in self._values.tolist()]

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
        return self._table() + _plots.svg(self)

    def _table(self) -> str:
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


class Solution(BearingQuantities, OfOperatingPoint):
    """The equilibrium of ring and balls, or their steady orbit. What its model does not have is absent."""

    #: ``jones-harris``, ``traction`` or ``steady-orbit``
    model: str
    #: whether the residual is within the tolerance
    converged: bool
    #: True if the ring comes back from a small push; absent where that was not judged
    stable: bool
    #: largest relative residual of all balances
    residual: float
    #: Newton steps taken
    iterations: int
    #: torque and cage speed of an orbit with half and twice of an assumed value
    sensitivities: list[dict[str, Any]]
    #: million turns; absent for a bearing that the standards do not rate
    rating_life_l10_mrev: float
    #: of the load distribution, million turns
    rating_life_l10r_mrev: float
    #: rating life of the steel at the speed, h
    rating_life_hours: float
    #: s_0 = C_0r/P_0
    static_safety: float
    #: friction of all inner contacts of an orbit, W; absent for an equilibrium, as are those below
    power_loss_inner_w: float
    #: friction of all outer contacts, W
    power_loss_outer_w: float
    #: drag and churning of all balls, W
    power_loss_fluid_w: float
    #: friction and damping in all pockets, W
    power_loss_pocket_w: float
    #: largest force of a pocket on a ball, N
    pocket_force_max_n: float
    #: where a ball meets a wall of its pocket
    pocket_contact_azimuths_deg: list[float]
    #: intervals of the orbit's mesh
    intervals: int
    #: error of its worst interval over what is allowed; absent where none errs by more
    mesh_error: float
    #: True where no orbit was found on a mesh fine enough for the pocket forces; absent elsewhere
    pocket_force_unresolved: bool
    #: damping, over the cage speed, of balls that swing in their grooves without end; absent where none do
    swing_damping: float
    #: mass of a ball over the case's, and stiffness of the pockets over the case's; absent where they are the case's
    ball_mass_factor: float
    #: stiffness of the pockets over the case's; absent where it is the case's
    pocket_stiffness_share: float
    #: damping ratio of the contacts, where no orbit was found with that of the case; absent elsewhere
    raised_contact_damping: float
    #: other equilibria of each ball, where they were searched for
    roots: list[dict[str, Any]]

    #: all balls by azimuth
    balls: Balls
    #: a ball round its orbit, every two degrees of azimuth; None for an equilibrium
    points: Optional[Balls]

    def __init__(self, head: dict[str, Any], balls: _native.BallTable, points: Optional[_native.BallTable]) -> None:
        round_ = None if points is None else Balls(*points)
        super().__init__({**head, "balls": Balls(*balls), "points": round_})

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
        answer = super().to_dict()
        if self.points is None:
            del answer["points"]
        return answer

    def figures(self) -> dict[str, str]:
        """Figures over the azimuth as SVG, by name: ``contact-angles``, ``contact-loads``, …"""
        balls = self.balls if self.points is None else self.points
        return _native.solution_figures(self._numbers(), balls.names, np.ascontiguousarray(balls.values))

    def plot(self, *names: str, ax: Optional[Axes] = None) -> Axes:
        """Draws quantities of the balls over the azimuth, by default the contact loads. Gives matplotlib's axes."""
        return (self.balls if self.points is None else self.points).plot(*names, ax=ax)

    def _draw(self, ax: Axes) -> None:
        (self.balls if self.points is None else self.points)._draw(ax)

    def _numbers(self) -> dict[str, Any]:
        return {n: v for n, v in self._single().items() if v is not None}

    def _repr_html_(self) -> str:
        rows = [(name, value) for name, value in self._numbers().items()]
        figures = self.figures()
        drawn = next((figures[name] for name in ("contact-loads", *figures) if name in figures), "")
        return (
            _html.table(f"{self.model} solution", ("", ""), rows)
            + self.balls._table()
            + _html.warnings(self.warnings)
            + _html.figure(drawn)
        )
