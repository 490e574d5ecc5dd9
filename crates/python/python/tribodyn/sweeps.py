"""Sweeps: equilibria, or steady orbits, over a grid of case values, or over samples."""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _html, _native, _plots
from ._answer import Answer, Comparable
from ._errors import InputError, PlausibilityWarning
from ._progress import Bar, Progress
from ._quantities import SweepColumns
from .case import Case, as_text, native
from .procedures import Model
from .units import Quantity, Unit

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes

PathLike = Union[str, os.PathLike[str]]

#: Values of a path: text as the command has it (``"kN(10..60 by 5)"``), or one by one.
Values = Union[str, float, Iterable[Any]]


class Plan(Answer):
    """A sweep that is not begun."""

    #: rows of the whole grid
    grid_rows: int
    #: rows of this shard
    rows: int
    #: part of the whole, such as ``0/1``
    shard: str
    #: rows that are solved one after the other
    chunk_rows: int
    #: threads to use
    threads: int
    #: of each swept path its column and number of values
    axes: list[dict[str, Any]]
    #: time of one row that starts cold, from one try
    cold_row_s: float
    #: mean time of the rows after it
    next_row_s: float
    #: time of all rows on these threads, s
    estimated_time_s: float


class Sweep(SweepColumns, Comparable, _plots.Pictured):
    """The rows of a sweep. Columns are arrays by name, in the order of the grid."""

    def __init__(self, columns: dict[str, Any], swept: list[str]) -> None:
        self._columns = columns
        #: names of the columns of swept values
        self.swept = swept

    @property
    def names(self) -> list[str]:
        """Names of the columns."""
        return list(self._columns)

    def __getitem__(self, name: str) -> Any:
        if name not in self._columns:
            raise KeyError(f"no column {name}; allowed are {', '.join(self._columns)}")
        return self._columns[name]

    if not TYPE_CHECKING:  # The columns are declared; those of swept values are `sweep["…"]`.

        def __getattr__(self, name: str) -> Any:
            columns = self.__dict__.get("_columns", {})
            if name.startswith("_") or name not in columns:
                raise AttributeError(f"Sweep has no column {name}")
            return columns[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *(name for name in self._columns if name.isidentifier())]

    def __len__(self) -> int:
        return len(self._columns["row"])

    @property
    def failed(self) -> int:
        """Rows without a solution; the column ``error`` says why."""
        return int(len(self) - np.count_nonzero(self._columns["converged"]))

    @property
    def implausible_rows(self) -> int:
        """Rows that name what no bearing does; the column ``implausible`` says what."""
        return sum(1 for names in self._columns["implausible"] if names is not None)

    def to_pandas(self) -> pd.DataFrame:
        """A row for each row of the sweep."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self._columns).set_index("row", drop=False).rename_axis(None)
        return frame

    def to_xarray(self) -> xr.Dataset:
        """The columns as arrays with one dimension for each swept value: the sweep as an n-dimensional cube.

        An :class:`InputError` where the rows are no grid, as those of samples are not.
        """
        import xarray

        values = {name: list(dict.fromkeys(np.asarray(self[name]).tolist())) for name in self.swept}
        shape = tuple(len(steps) for steps in values.values())
        places: NDArray[np.intp] = np.zeros(len(self), dtype=np.intp)
        for name, steps in values.items():
            place_of = {value: place for place, value in enumerate(steps)}
            there = [place_of[value] for value in np.asarray(self[name]).tolist()]
            places = places * len(steps) + np.array(there, dtype=np.intp)
        if len(self) != math.prod(shape) or len(np.unique(places)) != len(self):
            allowed = "allowed are the rows of a grid: each value of a path with each of the others"
            message = f"{len(self)} rows over {', '.join(values)}: {allowed}; to_pandas() has them"
            raise InputError(message, path="swept", value=", ".join(values), allowed=allowed)
        order = np.argsort(places)
        columns = [name for name in self.names if name not in values]
        arrays = {name: (list(values), np.asarray(self[name])[order].reshape(shape)) for name in columns}
        return xarray.Dataset(arrays, coords=values)

    def __repr__(self) -> str:
        implausible = f", {self.implausible_rows} implausible" if self.implausible_rows else ""
        return f"Sweep({len(self)} rows, {self.failed} without solution{implausible})"

    def _repr_html_(self) -> str:
        shown = [*self.swept, "converged", "cage_speed_rpm", "shaft_torque_nm", "implausible", "error"]
        shown = [name for name in shown if name in self._columns]
        rows = list(zip(*(list(self._columns[name]) for name in shown)))
        return _html.table(repr(self), shown, rows) + _plots.svg(self)

    def plot(self, quantity: str = "cage_speed_rpm", *, over: Optional[str] = None, ax: Optional[Axes] = None) -> Axes:
        """Draws a column over another one, by default over the first swept one. Gives matplotlib's axes."""
        ax = _plots.axes(ax)
        x = over or next(iter(self.swept), "row")
        ax.plot(self[x], self[quantity], "o", markersize=3)
        _plots.label(ax, x, quantity)
        return ax

    def _draw(self, ax: Axes) -> None:
        self.plot(ax=ax)


class Table(Answer):
    """A sweep that was written to a table."""

    #: the table that was written
    output: str
    #: rows of the table: those of the shard
    rows: int
    #: rows without a solution
    failed_rows: int
    #: rows that name what no bearing does; the column ``implausible`` says what
    implausible_rows: int
    #: rows that an earlier sweep had finished
    resumed_rows: int

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """The table, read back."""
        import pandas

        frame: pd.DataFrame
        if self.output.endswith(".csv"):
            with warnings.catch_warnings():
                # The option goes where it becomes the default.
                warnings.filterwarnings("ignore", message="The 'float_precision' argument")
                frame = pandas.read_csv(self.output, float_precision="round_trip")
        else:
            frame = pandas.read_parquet(self.output)
        return frame

    def _draw(self, ax: Axes) -> None:
        self.to_pandas().plot(x="row", y="cage_speed_rpm", ax=ax)


def grid(
    case: Case,
    values: Optional[Mapping[str, Values]] = None,
    *,
    samples: Optional[Mapping[str, Iterable[Any]]] = None,
    model: Model = "steady-orbit",
    cold: bool = False,
) -> _native.Grid:
    """The rows of a sweep, checked. Single values of ``values`` are changes of the case beside ``samples``."""
    if samples is None:
        return _native.Grid.product(_named(case), product_values(values or {}), (model, cold), True)
    case = case.replace({path: as_text(single(path, given)) for path, given in (values or {}).items()})
    drawn = sample_values(samples)
    count = len(drawn[0][1]) if drawn else 0
    return _native.Grid.samples(_named(case), drawn, (0, count), (model, cold))


def _named(case: Case) -> tuple[str, str]:
    native(case)
    return case.file, case.text


def single(path: str, given: Values) -> Any:
    """The single value of a path beside samples."""
    values = [given] if isinstance(given, (str, float, int, bool)) else list(given)
    if len(values) != 1:
        allowed = "allowed is a single value beside samples"
        raise InputError(f"{path} has {len(values)} values; {allowed}", path=path, value=str(given), allowed=allowed)
    return values[0]


def product_values(values: Mapping[str, Values]) -> list[tuple[str, Union[str, list[str]]]]:
    """Values of a grid as the compiled half takes them."""
    taken: list[tuple[str, Union[str, list[str]]]] = []
    for path, given in values.items():
        if isinstance(given, str):
            taken.append((path, given))
        elif isinstance(given, (bool, int, float)):
            taken.append((path, [as_text(given)]))
        else:
            taken.append((path, [as_text(value) for value in given]))
    return taken


def sample_values(samples: Mapping[str, Iterable[Any]]) -> list[tuple[str, list[str]]]:
    """Samples as the compiled half takes them."""
    return [(path, [as_text(value) for value in drawn]) for path, drawn in samples.items()]


def sweep(
    case: Case,
    values: Optional[Mapping[str, Values]] = None,
    *,
    samples: Optional[Mapping[str, Iterable[Any]]] = None,
    threads: int = 0,
    model: Model = "steady-orbit",
    cold: bool = False,
    progress: Progress = True,
) -> Sweep:
    """Equilibria, or steady orbits, for every combination of case values, or for samples, on all cores; in memory.

    Rows are those of the command, bit for bit.

    Args:
        case: the bearing
        values: values by path: text as the command has it, ``{"ring.z.Force": "kN(10..60 by 5)"}``, or one by one,
            ``{"ring.z.Force": kN([10, 20])}``; the last path varies fastest
        samples: values by path, one for each row: see :func:`latin_hypercube` and :func:`sobol`
        threads: threads to use; 0 is one for each core
        model: equations of every row: ``"jones-harris"``, ``"traction"`` or ``"steady-orbit"``
        cold: solve every row from its own initial guess instead of a neighbour's solution; the steady orbit always does
        progress: a bar where somebody watches; False for none; or a function of rows done and rows

    Raises:
        InputError: a value is refused, before anything is solved
    """
    rows = grid(case, values, samples=samples, model=model, cold=cold)
    with Bar(float(rows.rows), "rows", progress) as bar:
        columns = rows.solve((0, rows.chunks), threads, bar)
    answer = Sweep({name: _plots.column(column) for name, column in columns.items()}, rows.swept())
    if answer.implausible_rows:
        message = f"{answer.implausible_rows} of {len(answer)} rows name what no bearing does: column `implausible`"
        warnings.warn(message, PlausibilityWarning, stacklevel=2)
    return answer


def sweep_to(
    output: PathLike,
    case: Case,
    values: Mapping[str, Values],
    *,
    shard: str = "0/1",
    threads: int = 0,
    model: Model = "steady-orbit",
    cold: bool = False,
    restart: bool = False,
    progress: Progress = True,
) -> Table:
    """The command's sweep: rows go to a table (``.parquet`` or ``.csv``), which a stopped sweep goes on with.

    Args:
        output: the table
        shard: part ``I/N`` of the grid, for several machines; :func:`merge` puts their tables together
        restart: forget the finished rows of a sweep that was stopped
        case, values, threads, model, cold, progress: as for :func:`sweep`
    """
    rows = grid(case, values, model=model, cold=cold)
    path = os.fspath(output)
    with Bar(float(rows.rows), "rows", progress) as bar:
        count, failed, implausible, resumed = rows.write_table(path, shard, restart, threads, bar)
    return _table(path, count, failed, implausible, resumed)


def plan(
    case: Case, values: Mapping[str, Values], *, threads: int = 0, model: Model = "steady-orbit", cold: bool = False
) -> Plan:
    """What a sweep would do, and about how long it would take; a few rows are solved for that."""
    return Plan(grid(case, values, model=model, cold=cold).plan(threads))


def merge(tables: Iterable[PathLike], output: PathLike, *, force: bool = False) -> Table:
    """The tables of all shards, or of a dataset's partitions, as one: every row once, in the order of the sweep."""
    found = [os.fspath(table) for table in tables]
    rows, failed, implausible = _native.merge_tables(found, os.fspath(output), force)
    return _table(os.fspath(output), rows, failed, implausible, 0)


def _table(output: str, rows: int, failed: int, implausible: int, resumed: int) -> Table:
    counts = {"rows": rows, "failed_rows": failed, "implausible_rows": implausible, "resumed_rows": resumed}
    return Table({"output": output, **counts})


Distribution = Any
#: A value of a path: a quantity, or a plain number.
Sample = Union[Quantity, float]
#: A range with its ends, a frozen distribution of ``scipy.stats``, or either with a unit before it.
Spread = Union[tuple[float, float], Distribution, tuple[Union[Unit, str], Any]]


def latin_hypercube(
    spreads: Mapping[str, Spread], count: int, *, seed: Union[int, None] = None
) -> dict[str, list[Sample]]:
    """Samples by a Latin hypercube (SciPy): for :func:`sweep`.

    Args:
        spreads: for each path ``(unit, (low, high))`` or ``(unit, scipy.stats.norm(mean, spread))``; without a unit
            for plain numbers
        count: number of samples
        seed: seed; the same seed gives the same samples
    """
    from scipy.stats import qmc

    return _drawn(qmc.LatinHypercube(len(spreads), seed=seed).random(count), spreads)


def sobol(spreads: Mapping[str, Spread], count: int, *, seed: Union[int, None] = None) -> dict[str, list[Sample]]:
    """Samples by a scrambled Sobol sequence (SciPy); ``count`` is best a power of two. As :func:`latin_hypercube`."""
    from scipy.stats import qmc

    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", message="The balance properties of Sobol")
        return _drawn(qmc.Sobol(len(spreads), seed=seed).random(count), spreads)


def from_unit_cube(points: NDArray[np.float64], spreads: Mapping[str, Spread]) -> dict[str, list[Sample]]:
    """Samples from points in the unit cube, a column for each path: for other samplers, such as SALib's."""
    return _drawn(np.asarray(points, dtype=np.float64), spreads)


def _drawn(points: NDArray[np.float64], spreads: Mapping[str, Spread]) -> dict[str, list[Sample]]:
    return {path: _values(points[:, i], path, spread) for i, (path, spread) in enumerate(spreads.items())}


def _values(shares: NDArray[np.float64], path: str, spread: Spread) -> list[Sample]:
    unit: Optional[Unit] = None
    given: Any = spread
    if isinstance(given, Sequence) and len(given) == 2 and isinstance(given[0], (Unit, str)):
        unit = given[0] if isinstance(given[0], Unit) else Unit(given[0])
        given = given[1]
    if hasattr(given, "ppf"):
        numbers = np.asarray(given.ppf(shares), dtype=np.float64)
    else:
        try:
            low, high = (float(end) for end in given)
        except (TypeError, ValueError):
            allowed = "allowed are (low, high), a distribution of scipy.stats, or either with a unit before it"
            raise InputError(f"{path}: {spread!r}; {allowed}", path=path, value=repr(spread), allowed=allowed) from None
        if low > high:
            allowed = "allowed are (low, high), low not above high"
            raise InputError(f"{path}: {spread!r}; {allowed}", path=path, value=repr(spread), allowed=allowed)
        numbers = low + (high - low) * shares
    if not np.all(np.isfinite(numbers)):
        allowed = "allowed are finite numbers: a distribution is asked for shares from 0 to below 1"
        raise InputError(f"{path}: {allowed}", path=path, value=repr(spread), allowed=allowed)
    return [*unit(numbers)] if unit is not None else [float(number) for number in numbers]
