"""Several bearings: pairs, sets, shafts; and one bearing under one load on one page."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal, Optional, Union

from . import _html, _native, _plots
from ._answer import Answer, OfOperatingPoint, warned
from .answers import Fits, Rating
from .case import Case, Value, as_text, native
from .procedures import TIME_LIMIT_S, Model
from .solution import Balls, Solution
from .units import all_in_unit, in_unit

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

PathLike = Union[str, os.PathLike[str]]


class PairBearing(Answer):
    """One bearing of a solved pair."""

    #: position of its middle
    position_m: float
    #: force of its inner ring on the balls: x, y, z of the shaft
    load_n: list[float]
    #: moment about its own middle: x, y of the shaft
    moment_nm: list[float]
    #: the bearing by itself, z along the load that it carries
    solution: Solution

    def __init__(self, data: Mapping[str, Any]) -> None:
        head = dict(data["solution"])
        balls = Balls.of(head.pop("balls"))
        super().__init__({**data, "solution": Solution(head, (balls.names, balls.values), None)})

    def _draw(self, ax: Axes) -> None:
        self.solution._draw(ax)


class Pair(OfOperatingPoint):
    """Two like bearings on one rigid shaft, in equilibrium."""

    _parts = {"bearings": PairBearing}

    #: displacement of the shaft's middle: x, y, z
    shaft_displacement_m: list[float]
    #: tilt of the shaft about X and Y
    shaft_tilt_rad: list[float]
    #: axial force within the pair: the smaller of what the bearings carry against each other; 0 in tandem
    preload_n: float
    #: forces and moments over displacements and tilts of the shaft's middle, by rows
    stiffness: list[list[float]]
    #: largest residual over the loads
    residual: float
    #: the bearing at −z, then that at +z
    bearings: list[PairBearing]

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each ball of both bearings."""
        import pandas

        frames = [bearing.solution.balls.to_pandas() for bearing in self.bearings]
        frame: pd.DataFrame = pandas.concat(frames, keys=["-z", "+z"], names=["bearing", "ball"])
        return frame

    def _draw(self, ax: Axes) -> None:
        for bearing, name in zip(self.bearings, ("at -z", "at +z")):
            balls = bearing.solution.balls
            ax.plot(balls.azimuth_deg, balls.load_inner_n, "o-", label=f"bearing {name}")
        _plots.label(ax, "azimuth, °", "load of the inner contacts, N", legend=True)


class SetCondition(Answer):
    """A set in one condition."""

    #: ``unmounted``, ``mounted`` or ``running``
    condition: str
    #: speed of the inner ring, r/min
    speed_rpm: float
    #: the smaller of what the sides carry without load
    preload_n: float
    #: axial rigidity without load
    rigidity_n_per_m: float
    #: loads along +z and −z under which the other side lifts off; None where it never does
    unloading_force_n: list[Optional[float]]
    #: the same over the preload
    unloading_over_preload: list[Optional[float]]


class SetState(Answer):
    """A set under one axial load."""

    #: axial load, N
    load_n: float
    #: from the unloaded set; in tandem from where its bearings touch
    displacement_m: float
    #: axial rigidity there, N/m
    rigidity_n_per_m: float
    #: axial force on each bearing
    bearing_force_n: list[float]


class SetPoint(Answer):
    """A set at one speed and temperature of a map."""

    #: speed, r/min
    speed_rpm: float
    #: how much warmer shaft and inner ring are than in the case
    warmer_k: float
    #: preload, N
    preload_n: float
    #: axial rigidity without load
    rigidity_n_per_m: float
    #: loads along +z and −z under which the other side lifts off; None where it never does
    unloading_force_n: list[Optional[float]]


class BearingSet(Answer):
    """A set of like bearings, pressed against each other."""

    _parts = {"conditions": SetCondition, "map": SetPoint, "states": SetState}

    #: how far each bearing is pressed in off the shaft
    offset_m: list[float]
    #: off the shaft, mounted, and at the speed and temperatures of the case, as far as they differ
    conditions: list[SetCondition]
    #: over speed and temperature; absent where that was not asked for
    map: list[SetPoint]
    #: under load, in the last of these conditions
    states: list[SetState]
    #: sentences on what is unusual about the bearing that is pressed hardest
    warnings: list[str]

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each load."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame([state.to_dict() for state in self.states])
        return frame

    def _draw(self, ax: Axes) -> None:
        ax.plot([s.load_n for s in self.states], [1e6 * s.displacement_m for s in self.states], "o-")
        _plots.label(ax, "axial load, N", "displacement, µm")


class Sheet(Answer):
    """All that is asked of a bearing first."""

    _parts = {"fits": Fits, "rating": Rating}

    #: name of the bearing
    name: str
    #: number of balls
    ball_count: int
    #: ball diameter, m
    ball_diameter_m: float
    #: pitch diameter, m
    pitch_diameter_m: float
    #: bore, m
    bore_m: float
    #: `catalogue`, or `computed` from the balls
    bore_source: str
    #: in operation
    radial_clearance_m: float
    #: fits by tolerance class, and the clearance over their range; absent where no seat has a class
    fits: Fits
    #: radial load, N
    radial_load_n: float
    #: axial load, N
    axial_load_n: float
    #: speed of the inner ring, r/min
    speed_rpm: float
    #: ratings, equivalent loads, lives, safety
    rating: Rating
    #: displacement of the inner ring under the load: x, y, z; z from where the balls just touch on the side of the load
    ring_displacement_m: list[float]
    #: moment that keeps the rings aligned
    tilting_moment_nm: float
    #: of the inner ring at this load, by rows
    stiffness: list[list[float]]
    #: balls that carry load on the inner race
    loaded_balls: int
    #: load of the most loaded ball, N
    ball_load_max_n: float
    #: least and largest of the loaded balls on the inner race; None without load
    contact_angle_rad: Optional[list[float]]
    #: by a rule of thumb with the bore; None without load
    friction_torque_estimate_nm: Optional[float]
    #: power of that torque, W
    friction_power_estimate_w: Optional[float]
    #: in the lubricant by SKF's model, without seals; absent without a lubricant and at rest
    skf_torque_nm: float
    #: by Palmgren's formula
    palmgren_torque_nm: float
    #: pitch diameter times speed
    speed_factor_mm_rpm: float
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]

    def _draw(self, ax: Axes) -> None:
        self.rating._draw(ax)


class ShaftBearing(Answer):
    """A bearing on its shaft."""

    _parts = {"fits": Fits, "rating": Rating}

    #: name of the bearing in the file
    name: str
    #: distance of its middle from the start of the shaft
    position_m: float
    #: force of the bearing on the shaft: x, y, z
    reaction_n: list[float]
    #: moment of the bearing on the shaft about its own middle: x, y
    reaction_moment_nm: list[float]
    #: radial load, N
    radial_load_n: float
    #: axial load, N
    axial_load_n: float
    #: of the inner against the outer ring from where it stands without load: x, y, z of the shaft
    ring_displacement_m: list[float]
    #: tilt of the inner against the outer ring about x and y, rad
    ring_tilt_rad: list[float]
    #: balls that carry load on the inner race
    loaded_balls: int
    #: load of the most loaded ball on the inner race, N
    ball_load_max_n: float
    #: None where the balls have no equilibrium of their own
    peak_pressure_max_pa: Optional[float]
    #: least and largest contact angle of the loaded balls on the inner race, rad
    contact_angle_rad: list[float]
    #: in the shaft's axes, by rows
    stiffness: list[list[float]]
    #: None where the standards do not rate the bearing
    rating: Optional[Rating]
    #: in operation
    radial_clearance_m: float
    #: fits by tolerance class, and the clearance over their range; absent where no seat has a class
    fits: Fits
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]


class Station(Answer):
    """A place on a shaft."""

    #: distance from the start of the shaft
    position_m: float
    #: displacement along x, y, z, m
    displacement_m: list[float]
    #: slope of the shaft about x and y
    tilt_rad: list[float]
    #: shear force along x and y, N
    shear_force_n: list[float]
    #: above 0 for tension
    axial_force_n: float
    #: bending moment about x and y, N m
    bending_moment_nm: list[float]
    #: torque about z, N m
    torque_nm: float
    #: nominal, without notches
    bending_stress_pa: float
    #: von Mises
    equivalent_stress_pa: float


class Cut(Answer):
    """A cut beside a node, before or beyond what comes in there."""

    #: distance from the start of the shaft
    position_m: float
    #: bending moments about x and y, N m
    bending_moment_nm: list[float]
    #: torque, N m
    torque_nm: float


class LoadedShaft(Answer):
    """A shaft in equilibrium."""

    _parts = {"bearings": ShaftBearing, "stations": Station, "cuts": Cut}

    #: speed of the shaft, r/min
    speed_rpm: float
    #: of the shaft with its discs
    mass_kg: float
    #: the bearings, in the order of the file
    bearings: list[ShaftBearing]
    #: places along the shaft, from its start
    stations: list[Station]
    #: both ends of every element, where moments and torques jump at the nodes between them
    cuts: list[Cut]
    #: largest residual over the largest force
    residual: float
    #: sum of loads and reactions over the largest force or moment
    unbalanced: float
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each place on the shaft."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame([station.to_dict() for station in self.stations])
        return frame

    def _draw(self, ax: Axes) -> None:
        places = [1e3 * s.position_m for s in self.stations]
        for axis, name in enumerate("xyz"):
            ax.plot(places, [1e6 * s.displacement_m[axis] for s in self.stations], label=name)
        for bearing in self.bearings:
            ax.axvline(1e3 * bearing.position_m, linestyle=":", color="0.5")
        _plots.label(ax, "place, mm", "displacement, µm", legend=True)


class Duty(Answer):
    """One load case of a shaft."""

    _parts = {"shaft": LoadedShaft}

    #: share of time
    share: float
    #: factor on the loads
    load: float
    #: the shaft under it
    shaft: LoadedShaft


class ShaftMode(Answer):
    """A mode of a shaft at one speed."""

    #: frequency, Hz
    frequency_hz: float
    #: below 0 where the mode grows
    damping_ratio: float
    #: sense of whirl
    whirl: str
    #: amplitudes of each node along x, y, z over the largest of all
    shape: list[list[float]]


class ShaftSpeed(Answer):
    """Modes of a shaft and its response to unbalance at one speed."""

    _parts = {"modes": ShaftMode}

    #: speed of the shaft, r/min
    speed_rpm: float
    #: the modes at this speed
    modes: list[ShaftMode]
    #: largest amplitude of each bearing's node by the unbalances; empty without unbalance
    amplitude_m: list[float]
    #: largest amplitude of any place, m; None without unbalance
    amplitude_max_m: Optional[float]
    #: largest force on each bearing by the unbalances, N; empty without unbalance
    bearing_force_n: list[float]


class Critical(Answer):
    """A speed at which a shaft turns as fast as it swings."""

    #: critical speed, r/min
    speed_rpm: float
    #: sense of whirl there
    whirl: str


class Whirl(Answer):
    """A shaft over speed."""

    _parts = {"speeds": ShaftSpeed, "critical": Critical}

    #: by growing speed
    speeds: list[ShaftSpeed]
    #: critical speeds between them
    critical: list[Critical]
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]

    def _draw(self, ax: Axes) -> None:
        for speed in self.speeds:
            ax.plot([speed.speed_rpm] * len(speed.modes), [m.frequency_hz for m in speed.modes], "o", color="C0")
        top = max(speed.speed_rpm for speed in self.speeds)
        ax.plot([0, top], [0, top / 60.0], "--", color="0.5", label="once in a turn")
        _plots.label(ax, "speed, r/min", "frequency, Hz", legend=True)


class Shaft(Answer):
    """A shaft in its bearings: reactions, deflections, stresses, lives, modes."""

    _parts = {"duties": Duty, "whirl": Whirl}

    #: name of the shaft
    name: str
    #: load cases; one where the file has no spectrum
    duties: list[Duty]
    #: mean speed over the load cases, r/min
    mean_speed_rpm: float
    #: of each bearing; None where it is not rated in a load case
    equivalent_load_n: list[Optional[float]]
    #: rating life of each bearing; None for one that is not rated, does not turn or carries nothing
    life_h: list[Optional[float]]
    #: that all bearings reach together; None where one of them is not rated
    system_life_h: Optional[float]
    #: absent where no speeds were asked for
    whirl: Whirl

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each place on the shaft, in the first load case."""
        return self.duties[0].shaft.to_pandas()

    def _draw(self, ax: Axes) -> None:
        self.duties[0].shaft._draw(ax)

    def _repr_html_(self) -> str:
        rows = [(b.name, *b.reaction_n, life) for b, life in zip(self.duties[0].shaft.bearings, self.life_h)]
        head = ("bearing", "reaction x, N", "y", "z", "life, h")
        return _html.table(self.name, head, rows) + _plots.svg(self)


def pair(
    case: Case,
    arrangement: Literal["DB", "DF", "DT"],
    distance: float,
    *,
    offset: Optional[float] = None,
    spring: Optional[float] = None,
    model: Optional[Model] = None,
    time_limit: float = TIME_LIMIT_S,
) -> Pair:
    """Two bearings of a case on one rigid shaft, preloaded; the loads of the case act in the middle between them.

    Args:
        case: one of the bearings with the loads of the shaft
        arrangement: ``"DB"`` back to back, ``"DF"`` face to face, ``"DT"`` tandem
        distance: between the middles of the bearings, mm
        offset: axial gap between the rings that clamping closes, um
        spring: instead of it, force of a soft spring on the bearing at +z, whose outer ring slides, N
        model: equations of each bearing; the steady orbit, or raceway control for a case without traction or cage
        time_limit: as of :func:`solve`
    """
    apart = in_unit(distance, "mm", "distance")
    pressed = in_unit(offset, "um", "offset"), in_unit(spring, "N", "spring")
    return warned(Pair(_native.pair(native(case), arrangement, apart, pressed, model, time_limit)))


def bearing_set(
    case: Case,
    arrangement: Optional[str] = None,
    *,
    sides: Optional[str] = None,
    preload: Optional[float] = None,
    given: Literal["unmounted", "mounted", "running"] = "unmounted",
    offset: Optional[float] = None,
    spring: Optional[float] = None,
    loads: Union[float, Iterable[float]] = (),
    speeds: Union[float, Iterable[float]] = (),
    warmer: Union[float, Iterable[float]] = (),
) -> BearingSet:
    """Preload, unloading force and axial rigidity of a set of like bearings, and its displacement under axial load.

    Args:
        case: one of the bearings, at its speed and temperatures
        arrangement: ``"DB"``, ``"DF"``, ``"DT"``, ``"TBT"``, ``"TFT"``, ``"TT"``, ``"QBC"``, ``"QFC"``, …
        sides: instead of it the side that each bearing carries, from −z to +z, such as ``"++-"``
        preload: N, in the condition ``given``; bearings that all carry the same way have none
        offset: instead of it how far each bearing is pressed in off the shaft, um
        spring: instead of both the force of a soft spring, N
        loads: axial loads along +z, N; up to the unloading force without them
        speeds: speeds of a map of the preload, r/min
        warmer: how much warmer than in the case shaft and inner ring of the map are, K; the balls by half of it
    """
    request = {
        "arrangement": arrangement,
        "sides": sides,
        "preload": in_unit(preload, "N", "preload"),
        "given": given,
        "offset": in_unit(offset, "um", "offset"),
        "spring": in_unit(spring, "N", "spring"),
        "loads": all_in_unit(loads, "N", "loads"),
        "speeds": all_in_unit(speeds, "rpm", "speeds"),
        "warmer": all_in_unit(warmer, "K", "warmer"),
    }
    return warned(BearingSet(_native.set(native(case), request)))


def sheet(case: Case, *, radial: float, axial: float = 0.0, speed: float) -> Sheet:
    """Life, safety, deflection, stiffness, torque, frequencies of defects and limits of a bearing under a load.

    Args:
        case: the bearing; its own loads and speed have no part in it, and the rings stay aligned
        radial, axial: loads, N; a negative axial one is along -z
        speed: of the inner ring, r/min
    """
    loads = in_unit(radial, "N", "radial"), in_unit(axial, "N", "axial")
    return warned(Sheet(_native.sheet(native(case), *loads, in_unit(speed, "rpm", "speed"))))


def shaft(
    path: PathLike,
    changes: Optional[Mapping[str, Value]] = None,
    *,
    modes: Union[float, Iterable[float]] = (),
    up_to: float = 2000.0,
) -> Shaft:
    """A shaft in its bearings: reactions, deflections, stresses, lives, modes, critical speeds, unbalance.

    Args:
        path: the shaft's file (RON)
        changes: other values for this call, by path
        modes: speeds at which modes and response to unbalance are asked for, r/min
        up_to: highest frequency of these modes, Hz
    """
    texts = [(place, as_text(value)) for place, value in (changes or {}).items()]
    speeds = all_in_unit(modes, "rpm", "modes")
    answer = Shaft(_native.shaft(os.fspath(path), texts, speeds, in_unit(up_to, "Hz", "up_to")))
    for duty in answer.duties:
        warned(duty.shaft)
    return answer
