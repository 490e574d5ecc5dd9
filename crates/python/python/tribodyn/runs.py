"""What takes long: runs in time, lives of coatings, identification; and recordings read back."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _html, _native, _plots, units
from ._answer import Answer, Comparable, warned
from ._errors import InputError, Stopped
from ._progress import Bar, Progress
from ._quantities import RecordedBallArrays, SolutionArrays, StateArrays, WornArrays
from ._scene import scene
from .answers import ActingLife, Identification, Life
from .case import Case, native
from .procedures import Model

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes

PathLike = Union[str, os.PathLike[str]]


class Series(Comparable, _plots.Pictured):
    """Numbers over time, or one row of them. Attributes are arrays, views of one table; names end in their unit."""

    def __init__(self, names: list[str], values: NDArray[np.float64]) -> None:
        self._names = list(names)
        self._columns = {name: place for place, name in enumerate(names)}
        self._values = values

    @property
    def names(self) -> list[str]:
        """Names of the quantities."""
        return list(self._names)

    @property
    def values(self) -> NDArray[np.float64]:
        """A row for each time, a column for each name."""
        return self._values

    def __getitem__(self, name: str) -> NDArray[np.float64]:
        if name not in self._columns:
            raise KeyError(f"no {name}; allowed are {', '.join(self._names)}")
        column: NDArray[np.float64] = self._values[:, self._columns[name]]
        return column

    if not TYPE_CHECKING:  # The arrays are declared.

        def __getattr__(self, name: str) -> NDArray[np.float64]:
            if name.startswith("_") or name not in self.__dict__.get("_columns", {}):
                raise AttributeError(f"{type(self).__name__} has no attribute {name}")
            return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._names]

    def __len__(self) -> int:
        return len(self._values)

    def to_pandas(self) -> pd.DataFrame:
        """A row for each time, indexed by it; the numbers are not copied."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self._values, columns=self._names, copy=False)
        if "time_s" in self._columns:
            frame = frame.set_index("time_s", drop=False)
        return frame

    def to_xarray(self) -> xr.Dataset:
        """Quantities over time."""
        import xarray

        data = {name: ("time_s", self[name]) for name in self._names if name != "time_s"}
        return xarray.Dataset(data, coords={"time_s": self["time_s"]})

    def plot(self, *names: str, ax: Optional[Axes] = None) -> Axes:
        """Draws numbers over time, by default the first one. Gives matplotlib's axes."""
        ax = _plots.axes(ax)
        self._over_time(ax, names)
        return ax

    def _draw(self, ax: Axes) -> None:
        self._over_time(ax, ())

    def _over_time(self, ax: Axes, names: tuple[str, ...]) -> None:
        usual = [name for name in (self._usual, *self._names) if name in self._columns and name != "time_s"]
        for name in names or usual[:1]:
            ax.plot(self["time_s"], self[name], linewidth=0.8, label=name)
        _plots.label(ax, "time, s", "", legend=True)

    #: what is drawn where nothing is asked for
    _usual = ""

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self)} times, {len(self._names)} quantities)"


class States(StateArrays, Series):
    """Rings, cage and powers of a run."""

    _usual = "cage_speed_rpm"


class SolutionState(SolutionArrays, Series):
    """The bearing of a recorded solution, in one row."""


class Worn(WornArrays, Series):
    """What has worn off, over time."""


class BallSeries(RecordedBallArrays, Comparable, _plots.Pictured):
    """Numbers of all balls over time, in single precision as they are recorded.

    Attributes are arrays by time and ball, views of one table: ``recording.balls.load_inner_n[:, 0]``.
    """

    def __init__(self, times: NDArray[np.float64], names: list[str], values: NDArray[np.float32]) -> None:
        self.time_s = times
        self._names = list(names)
        self._columns = {name: place for place, name in enumerate(names)}
        self._values = values

    @property
    def names(self) -> list[str]:
        """Names of the quantities."""
        return list(self._names)

    def __getitem__(self, name: str) -> NDArray[np.float32]:
        if name not in self._columns:
            raise KeyError(f"no {name}; allowed are {', '.join(self._names)}")
        column: NDArray[np.float32] = self._values[:, :, self._columns[name]]
        return column

    if not TYPE_CHECKING:  # The arrays are declared.

        def __getattr__(self, name: str) -> NDArray[np.float32]:
            if name.startswith("_") or name not in self.__dict__.get("_columns", {}):
                raise AttributeError(f"BallSeries has no attribute {name}")
            return self[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._names]

    def __len__(self) -> int:
        return len(self.time_s)

    def to_xarray(self) -> xr.Dataset:
        """Quantities by time and ball."""
        import xarray

        data = {name: (("time_s", "ball"), self[name]) for name in self._names}
        balls = np.arange(self._values.shape[1])
        return xarray.Dataset(data, coords={"time_s": self.time_s, "ball": balls})

    def to_pandas(self) -> pd.DataFrame:
        """A row for each time and ball."""
        import pandas

        count = self._values.shape[1]
        index = pandas.MultiIndex.from_product([self.time_s, range(count)], names=["time_s", "ball"])
        table = self._values.reshape(-1, len(self._names))
        frame: pd.DataFrame = pandas.DataFrame(table, index=index, columns=self._names)
        return frame

    def plot(self, name: str = "load_inner_n", *, ax: Optional[Axes] = None) -> Axes:
        """Draws a quantity of all balls over time. Gives matplotlib's axes."""
        ax = _plots.axes(ax)
        ax.plot(self.time_s, self[name], linewidth=0.6)
        _plots.label(ax, "time, s", name)
        return ax

    def _draw(self, ax: Axes) -> None:
        self.plot(ax=ax)

    def __repr__(self) -> str:
        return f"BallSeries({len(self)} times, {self._values.shape[1]} balls, {len(self._names)} quantities)"


class Recording(Comparable, _plots.Pictured):
    """A recording read back: a run in time, or one orbit of a solution."""

    #: rings, cage and powers over time
    states: States
    #: balls over time
    balls: BallSeries
    #: what had worn off over time
    wear: Worn
    #: the bearing of a recorded solution; empty for a run
    solution: SolutionState
    #: the log: ``time_s``, ``warning``, ``kind``, ``message``
    events: list[dict[str, Any]]
    #: records about the run by name; ``simulation`` describes it
    metadata: dict[str, dict[str, str]]
    #: the text of the case; None where that part of the file is damaged
    case_text: Optional[str]
    #: False where a part of the file is damaged or missing
    whole: bool

    def __init__(self, path: PathLike, data: dict[str, Any]) -> None:
        self.path = os.fspath(path)
        self.states = States(*data["states"])
        self.balls = BallSeries(*data["balls"])
        self.wear = Worn(*data["wear"])
        self.solution = SolutionState(*data["solution"])
        self.events = data["events"]
        self.metadata = data["metadata"]
        self.case_text = data["case_text"]
        self.whole = data["whole"]

    @property
    def case(self) -> Case:
        """The case that was run."""
        if self.case_text is None:
            raise InputError(f"{self.path}: the case in it is damaged", file=self.path)
        return Case.parse(self.case_text, name=f"{self.path} (case)")

    def to_pandas(self) -> pd.DataFrame:
        """Rings, cage and powers over time."""
        return self.states.to_pandas()

    def to_xarray(self) -> xr.Dataset:
        """Rings, cage and powers over time."""
        return self.states.to_xarray()

    def scene(self, *, frames: int = 240) -> Any:
        """The bearing as it moves, in three dimensions: a plot of K3D (``pip install 'tribodyn[scene]'``).

        Rings are cut open; balls are coloured by their peak pressure, rods are the forces of the races on them. In a
        notebook ``scene.display()`` shows it and ``scene.start_auto_play()`` plays it; ``scene.get_snapshot()`` is a
        page of its own as HTML.

        Args:
            frames: times that are shown, at most, spread over the recording
        """
        return scene(self, int(frames))

    def __repr__(self) -> str:
        return f"Recording({self.path!r}, {len(self.states)} states, {len(self.balls)} times of balls)"

    def _repr_html_(self) -> str:
        rows = [("states", len(self.states)), ("times of balls", len(self.balls)), ("events", len(self.events))]
        return _html.table(self.path, ("", ""), rows) + _plots.svg(self)

    def _draw(self, ax: Axes) -> None:
        """The cage of a run; the balls of a recorded solution over one orbit."""
        if len(self.states):
            self.states._draw(ax)
        else:
            self.balls._draw(ax)


class Run(Answer):
    """A run in time: the numbers that the command prints, and what was recorded."""

    #: file of the case
    case: str
    #: name of the bearing
    bearing: str
    #: the recording; None where none was asked for
    recording: Optional[str]
    #: simulated time that was asked for, s
    duration_s: float
    #: time that it took, s
    wall_s: float
    #: simulated time over the time that it took
    simulated_per_wall: float
    #: the fixed step that was taken; None where steps follow from the error
    step_s: Optional[float]
    #: how that step was chosen: accuracy asked for, errors found, step, whether shorter steps are no better; None where
    #: no accuracy was asked for
    step_choice: Optional[dict[str, Any]]
    #: points of the contact patches
    patch_rule: str
    #: error of the traction by these points over the load
    patch_error_estimate: Optional[float]
    #: error of the outer ring's acceleration by step, patch and linear traction together, rms; None where the run is
    #: too short to tell
    acceleration_error_m_s2: Optional[float]
    #: whether patch rule and scheme are fine enough for accelerations
    accelerations_supported: bool
    #: the time scheme
    scheme: str
    #: steps, evaluations and the like
    scheme_statistics: dict[str, Any]
    #: what limits the steps: fastest rates of the motion
    stiffness: dict[str, Any]
    #: simulated time, s
    simulated_s: float
    #: from when on averages are taken
    averaged_from_s: float
    #: None where the run is not steady, or cannot be judged
    settled_at_s: Optional[float]
    #: samples of the whole run
    samples: int
    #: mean speed of the cage, r/min
    cage_speed_mean_rpm: float
    #: of the first sample
    cage_speed_start_rpm: float
    #: of the last sample, r/min
    cage_speed_end_rpm: float
    #: lowest orbital speed of any ball, r/min
    orbital_speed_min_rpm: float
    #: highest orbital speed of any ball, r/min
    orbital_speed_max_rpm: float
    #: acceleration of the outer ring along X, rms, m/s²
    outer_acceleration_x_rms_m_s2: float
    #: acceleration of the outer ring along Y, rms, m/s²
    outer_acceleration_y_rms_m_s2: float
    #: the largest along X, m/s²
    outer_acceleration_x_peak_m_s2: float
    #: the largest along Y, m/s²
    outer_acceleration_y_peak_m_s2: float
    #: largest inner contact load of any ball, N
    load_inner_max_n: float
    #: largest outer contact load of any ball, N
    load_outer_max_n: float
    #: highest pressure at the inner race, GPa
    peak_pressure_inner_max_gpa: float
    #: highest pressure at the outer race, GPa
    peak_pressure_outer_max_gpa: float
    #: largest force of a pocket on a ball, N
    pocket_force_max_n: float
    #: pocket impacts in the whole run
    impacts: int
    #: fewest balls that carried load at both races at one time
    balls_in_contact_min: int
    #: mean powers, W
    power: dict[str, float]
    #: worn volumes (µm³) and coatings left (µm)
    wear: dict[str, float]
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]
    #: sentences on the state that the run started from
    warnings_at_start: list[str]
    #: races whose pressures left the range in which the coating was tested
    untested_pressures: list[str]
    #: what was recorded
    data: Recording

    def _draw(self, ax: Axes) -> None:
        self.data._draw(ax)

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """Rings, cage and powers over time."""
        return self.data.to_pandas()

    def to_xarray(self) -> xr.Dataset:
        """Rings, cage and powers over time."""
        return self.data.to_xarray()


def run(
    case: Case,
    duration: Optional[float] = None,
    *,
    record: Optional[PathLike] = None,
    resume: bool = False,
    restart: bool = False,
    progress: Progress = True,
) -> Run:
    """Runs a bearing in time.

    Args:
        case: the bearing; it needs its sections ``transient``, ``supports`` and ``recording``
        duration: simulated time, s; that of the case where it is left out
        record: recording to write (MCAP, opens in Foxglove); without it the recording is read into memory and deleted
        resume: go on with a recording that was stopped or killed
        restart: forget a run that was stopped
        progress: a bar where somebody watches; False for none; or a function of simulated time and duration

    Raises:
        Stopped: Ctrl-C, a ``KeyboardInterrupt``; the recording is closed, and ``resume=True`` goes on with it
    """
    if resume and restart:
        raise InputError("resume and restart exclude each other", path="resume", value="True", allowed="one of both")
    if record is None:
        if resume:
            raise InputError("resume needs a recording", path="record", value="None", allowed="a path")
        with tempfile.TemporaryDirectory(prefix="tribodyn-") as folder:
            answer = _run(case, duration, Path(folder) / "run.mcap", "new", progress)
            answer.data.states  # read before the folder goes
            answer.__dict__["recording"] = None
            return warned(answer)
    return warned(_run(case, duration, Path(record), "resume" if resume else "restart" if restart else "new", progress))


def _run(case: Case, duration: Optional[float], path: Path, beginning: str, progress: Progress) -> Run:
    seconds = units.in_unit(duration, "s", "duration")
    with Bar(seconds if seconds is not None else _duration(case), "s", progress) as bar:
        answer, stopped = _native.run(native(case), os.fspath(path), seconds, beginning, bar)
    stopped_s = answer.pop("stopped_s")
    if stopped is not None and stopped_s is not None:
        if not isinstance(stopped, KeyboardInterrupt):
            raise stopped
        message = f"stopped after {stopped_s} of {answer['duration_s']} s; run(..., resume=True) continues it"
        facts = {"simulated_s": stopped_s, "duration_s": answer["duration_s"], "recording": os.fspath(path)}
        raise Stopped(message, **facts) from stopped
    answer["data"] = read_recording(path, limits=False)
    return Run(answer)


def _duration(case: Case) -> float:
    text = native(case).value("transient.duration") or ""
    return float(units.read(text) or 0.0)


def life(
    case: Case,
    model: Model = "steady-orbit",
    *,
    strides: int = 20,
    until: Optional[float] = None,
    clearance_limit: Optional[float] = None,
    progress: Progress = True,
) -> Life:
    """Wears the raceways of a bearing until a coating is through, or wear has added a clearance that is given.

    Args:
        case: the bearing with its coatings and wear coefficients
        model: equations of each stride, with traction
        strides: strides in which a new coating is worn away at its fastest spot, or the clearance limit used up; the
            error falls with their number
        until: running time after which a life ends, should the coatings last longer, h
        clearance_limit: radial internal clearance added by wear at which the life ends, on the diameter, um: for races
            without coating
        progress: a bar where somebody watches; False for none; or a function of strides done and strides
    """
    with Bar(float(strides), "strides", progress) as bar:
        limits = (None if until is None else float(until), units.in_unit(clearance_limit, "um", "clearance_limit"))
        return warned(Life(_native.life(native(case), model, int(strides), limits, bar)))


def acting_life(
    case: Case,
    acting: Sequence[str] = ("clearance", "traction"),
    model: Model = "steady-orbit",
    *,
    strides: int = 20,
    until: Optional[float] = None,
    bare_limit: float = 0.5,
    mission: Optional[PathLike] = None,
    output: Optional[PathLike] = None,
    map: Optional[PathLike] = None,
    progress: Progress = True,
) -> ActingLife:
    """Wears the raceways of a bearing while their wear acts on it: ``tribodyn life --acting``.

    Args:
        case: the bearing with its coatings and wear coefficients
        acting: what wear does, any of ``clearance``, ``curvature``, ``traction`` and ``transfer``
        model: equations of each stride, with traction
        strides: strides in which a new coating is worn away at its fastest spot
        until: running time after which the life ends, h
        bare_limit: part of a race's load on bare steel at which it ends
        mission: table of phases that are repeated
        output: table of the strides to write, .parquet or .csv
        map: table of the worn cells of both grooves at the end
        progress: a bar where somebody watches; False for none; or a function of strides done and strides
    """
    path = [None if p is None else os.fspath(p) for p in (mission, output, map)]
    with Bar(float(strides), "strides", progress) as bar:
        hours = None if until is None else float(until)
        found = _native.acting_life(
            native(case), model, int(strides), hours, list(acting), float(bare_limit), path[0], (path[1], path[2]), bar
        )
        return warned(ActingLife(found))


def identify(
    problem: PathLike,
    *,
    seed: Optional[int] = None,
    starts: Optional[int] = None,
    threads: int = 0,
    progress: Progress = True,
) -> list[Identification]:
    """Identifies unknown parameters of a case from published or measured figures, under each hypothesis.

    Args:
        problem: problem file (RON), which names the case beside it
        seed: seed of the start points, instead of the problem's
        starts: number of start points, instead of the problem's
        threads: threads to use; 0 is one for each core
        progress: a bar where somebody watches; False for none; or a function of starts done and starts
    """
    path = os.fspath(problem)
    with Bar(float(_native.identification_starts(path, starts)), "starts", progress) as bar:
        return [Identification(answer) for answer in _native.identify(path, seed, starts, threads, bar)]


def read_recording(path: PathLike, *, limits: bool = True) -> Recording:
    """Reads a recording (MCAP), also one of a run that was killed (``run.mcap.active``).

    ``limits=False`` lifts the bound on the memory that its numbers may take.
    """
    return Recording(path, _native.read_recording(os.fspath(path), not limits))


class Report(Comparable):
    """A report that was written."""

    #: the page
    page: str
    #: its numbers, as ``summary.json`` has them
    summary: dict[str, Any]
    #: the same for a terminal
    text: str

    def __init__(self, summary: dict[str, Any], text: str, page: str) -> None:
        self.summary = summary
        self.text = text
        self.page = page

    def __repr__(self) -> str:
        return f"Report({self.page!r})"


def report(
    recording: PathLike,
    output: PathLike,
    *,
    other: Optional[PathLike] = None,
    against: Optional[PathLike] = None,
    force: bool = False,
    limits: bool = True,
) -> Report:
    """Writes figures, spectra and a summary of a recorded run or solution, or what two recordings differ in.

    Args:
        recording: recording of a run or a solution (MCAP), whole or not
        output: folder for ``report.html``, ``summary.md``, ``summary.json``, ``foxglove-layout.json`` and the figures
        other: a second recording, with which the first one is compared
        against: published or measured figures to set beside those of a run: a CSV file with the columns id, quantity,
            published, tolerance, source; a quantity is a field of ``summary.json``
        force: replace files that tribodyn did not write
        limits: ``False`` lifts the bound on the memory that the recordings may take
    """
    recordings = (os.fspath(recording), None if other is None else os.fspath(other))
    figures = None if against is None else os.fspath(against)
    summary, text, page = _native.report(recordings, os.fspath(output), figures, (force, not limits))
    return Report(summary, text, os.fspath(page))
