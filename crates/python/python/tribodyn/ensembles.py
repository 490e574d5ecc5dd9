"""Many transient runs: ensembles with values drawn at random, data sets of signals with labels."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import _html, _native, _plots
from ._answer import Answer
from ._errors import InputError
from ._progress import Bar, Progress
from .case import Case, native
from .units import in_unit

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

PathLike = Union[str, os.PathLike[str]]


class Quantiles(Answer):
    """Quantiles of one figure over the members that have it."""

    #: name of the figure's column, with the unit
    quantity: str
    #: members that have the figure
    members: int
    #: 5 % of the members lie below
    p05: float
    #: 25 % of the members lie below
    p25: float
    #: the median
    p50: float
    #: 75 % of the members lie below
    p75: float
    #: 95 % of the members lie below
    p95: float


class Ensemble(Answer):
    """What an ensemble comes to: quantiles of the figures of its members, and a table with a row for each member."""

    _parts = {"quantiles": Quantiles}

    #: file of the case
    case: str
    #: name of the bearing
    bearing: str
    #: members that were asked for
    members: int
    #: members that are finished
    finished: int
    #: finished members that an earlier call had finished
    resumed: int
    #: finished members without figures
    failed: int
    #: seed of the draws
    seed: int
    #: how the members lie in the space of the spreads
    sampling: str
    #: varied places: ``column``, ``path``, ``spread``
    varied: list[dict[str, str]]
    #: quantiles of each figure
    quantiles: list[Quantiles]
    #: members without figures: ``member`` and ``error``
    failures: list[dict[str, Any]]
    #: threads and times
    cost: dict[str, Any]
    #: the table, where one was written
    output: str
    #: columns of the members by name
    columns: dict[str, Any]

    def to_dict(self) -> dict[str, Any]:
        """What ``ensemble --json`` prints."""
        answer = super().to_dict()
        del answer["columns"]
        return answer

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each member."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self.columns)
        return frame

    def _draw(self, ax: Axes) -> None:
        self._histogram(ax, "cage_speed_mean_rpm")

    def plot(self, quantity: str = "cage_speed_mean_rpm", *, ax: Optional[Axes] = None) -> Axes:
        """Draws how a figure is spread over the members. Gives matplotlib's axes."""
        ax = _plots.axes(ax)
        self._histogram(ax, quantity)
        return ax

    def _histogram(self, ax: Axes, quantity: str) -> None:
        values = np.asarray(self.columns[quantity], dtype=np.float64)
        ax.hist(values[np.isfinite(values)], bins="auto")
        _plots.label(ax, quantity, "members")

    def _repr_html_(self) -> str:
        head = ("quantity", "5 %", "25 %", "50 %", "75 %", "95 %")
        rows = [(q.quantity, q.p05, q.p25, q.p50, q.p75, q.p95) for q in self.quantiles]
        return _html.table(f"{self.finished} of {self.members} members", head, rows) + _plots.svg(self)


def ensemble(
    case: Case,
    spreads: Optional[Mapping[str, str]] = None,
    members: int = 1,
    *,
    grid: Optional[Mapping[str, str]] = None,
    seed: int = 1,
    latin_hypercube: bool = False,
    duration: Optional[float] = None,
    threads: int = 0,
    output: Optional[PathLike] = None,
    restart: bool = False,
    force: bool = False,
    progress: Progress = True,
) -> Ensemble:
    """Runs a bearing in time many times, with values drawn at random. Nothing is recorded.

    Args:
        case: the bearing; it needs what :func:`run` needs
        spreads: for each path ``"mm(0.2 ± 0.02)"``, a normal distribution with that standard deviation, or
            ``"mm(0.18..0.22)"``, a range in which all values are as likely
        members: number of members
        grid: instead of spreads, values for each path as in a sweep, such as ``"um(0..20 in 5)"``: a member for each
            of them with each of the others
        seed: the same seed and number of a member give the same values on every machine
        latin_hypercube: cut each spread into as many equally likely parts as there are members, one in each
        duration: simulated time of each member, s; that of the case where it is left out
        threads: threads to use; 0 is one for each core
        output: table to write, .parquet or .csv; finished members are beside it until it is whole
        restart: forget the finished members of an ensemble that was stopped
        force: replace a file at ``output`` that tribodyn did not write
        progress: a bar where somebody watches; False for none; or a function of members done and members
    """
    if (spreads is None) == (grid is None):
        raise InputError("either spreads or grid", path="grid", value=repr(grid), allowed="one of spreads and grid")
    request = {
        "spreads": list((spreads or {}).items()),
        "grid": list((grid or {}).items()),
        "members": int(members),
        "seed": int(seed),
        "latin_hypercube": latin_hypercube,
        "duration": in_unit(duration, "s", "duration"),
        "threads": int(threads),
        "output": None if output is None else os.fspath(output),
        "restart": restart,
        "force": force,
    }
    with Bar(float(members), "members", progress) as bar:
        report, columns = _native.ensemble(native(case), request, bar)
    written = {} if output is None else {"output": os.fspath(output)}
    return Ensemble({**report, **written, "columns": {name: _plots.column(values) for name, values in columns.items()}})


class Dataset(Answer):
    """A data set that was made: what is in it, and where."""

    #: members of the set
    members: int
    #: members that are finished
    finished: int
    #: finished members without a signal
    failed: int
    #: for training
    bearings_train: int
    #: for tests; none is in both
    bearings_test: int
    #: members that were run now
    run: int
    #: threads that were used
    threads: int
    #: time that it took, s
    wall_s: float
    #: absent where none was run
    members_per_s_and_thread: float
    #: why the first member without a signal has none; absent where all have one
    first_failure: str
    #: the table (Parquet): a row a member
    table: str
    #: folder of the MATLAB files, where they were asked for
    mat: str

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each member: class, spall, loads, the signals as arrays. It needs pyarrow."""
        import pandas

        return pandas.read_parquet(self.table)

    def _draw(self, ax: Axes) -> None:
        _plots.bars(ax, {"training": self.bearings_train, "tests": self.bearings_test}, "bearings")


def dataset(
    plan: PathLike,
    output: PathLike,
    *,
    mat: bool = False,
    threads: int = 0,
    restart: bool = False,
    force: bool = False,
    progress: Progress = True,
) -> Dataset:
    """Simulates bearings with and without spalls and writes what sensors on the housing see, with labels.

    Finished members are in the folder until the set is whole: after a stop the same call goes on from there.

    Args:
        plan: plan of the data set (RON)
        output: folder to write
        mat: write a MATLAB file (level 5) for each member too
        threads: threads to use; 0 is one for each core
        restart: forget the finished members of a set that was stopped
        force: replace a table that tribodyn did not write
        progress: a bar where somebody watches; False for none; or a function of members done and members
    """
    plan, output = os.fspath(plan), os.fspath(output)
    with Bar(float(_native.dataset_members(plan)), "members", progress) as bar:
        return Dataset(_native.dataset(plan, output, (mat, restart, force), int(threads), bar))
