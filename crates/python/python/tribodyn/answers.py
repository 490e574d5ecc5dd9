"""Answers to single questions. Names end in their unit; they are those of the command's JSON."""

from __future__ import annotations

import importlib.metadata
import warnings
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _html, _plots
from ._answer import Answer, OfOperatingPoint
from ._errors import InputError, ModelWarning, PlausibilityWarning

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr
    from matplotlib.axes import Axes


class Growth(Answer):
    """Growth of the rings by fits and speed."""

    #: free contact angle as drawn, °
    contact_angle_drawn_deg: float
    #: the same in its seats, °
    contact_angle_mounted_deg: float
    #: the same at speed and temperature, °
    contact_angle_running_deg: float
    #: radial internal clearance on the diameter as drawn, m
    radial_clearance_drawn_m: float
    #: the same in its seats, m
    radial_clearance_mounted_m: float
    #: the same at speed and temperature, m
    radial_clearance_running_m: float
    #: growth of the radius of the inner race, m
    raceway_growth_inner_m: float
    #: growth of the radius of the outer race, m
    raceway_growth_outer_m: float
    #: pressure between shaft and inner ring, Pa; None without a fit
    seat_pressure_inner_pa: Optional[float]
    #: pressure between outer ring and housing, Pa; None without a fit
    seat_pressure_outer_pa: Optional[float]

    def _draw(self, ax: Axes) -> None:
        states = ("drawn", "mounted", "running")
        ax.plot(states, [1e6 * getattr(self, f"radial_clearance_{state}_m") for state in states], "o-")
        _plots.label(ax, "", "radial internal clearance, µm")


class SeatFit(Answer):
    """A ring on a seat of a tolerance class."""

    #: ``inner`` or ``outer``
    ring: str
    #: of the seat (ISO 286)
    seat_class: str
    #: of the bearing (ISO 492)
    ring_class: str
    #: nominal
    diameter_m: float
    #: limit deviations of the seat, low and high, m
    seat_deviations_m: list[float]
    #: limit deviations of the ring, low and high, m
    ring_deviations_m: list[float]
    #: loosest, likely loosest, mean, likely tightest, tightest; below 0 for play
    interference_m: list[float]
    #: of the case, after its surfaces are smoothed
    effective_interference_m: float


class Fits(Answer):
    """Fits by tolerance class, and the clearance over their range."""

    _parts = {"seats": SeatFit}

    #: the seats that have a class
    seats: list[SeatFit]
    #: at rest and cold: both seats loosest, likely loosest, mean, likely tightest, tightest
    radial_clearance_mounted_m: list[Optional[float]]
    #: at speed and temperature
    radial_clearance_running_m: list[Optional[float]]


class Frequencies(Answer):
    """Frequencies of a bearing and of its defects."""

    #: rotation of the shaft, Hz
    shaft_hz: float
    #: rotation of the cage, FTF, Hz
    cage_hz: float
    #: a defect of the outer race, BPFO, Hz
    ball_pass_outer_hz: float
    #: a defect of the inner race, BPFI, Hz
    ball_pass_inner_hz: float
    #: of a ball about its own axis
    ball_spin_hz: float
    #: a defect of a ball meets a race
    ball_defect_hz: float

    def _draw(self, ax: Axes) -> None:
        _plots.bars(ax, self.to_dict(), "frequency, Hz")


class Derived(Answer):
    """What follows from a case before anything is solved."""

    _parts = {"growth": Growth, "fits": Fits, "frequencies": Frequencies}

    #: name of the bearing
    name: str
    #: free contact angle
    contact_angle_deg: float
    #: diametral clearance
    radial_clearance_m: float
    #: axial play without load, m
    axial_play_m: float
    #: radius of the inner groove over the ball diameter
    groove_coefficient_inner: float
    #: radius of the outer groove over the ball diameter
    groove_coefficient_outer: float
    #: distance of the centres of the grooves, m
    groove_centre_distance_m: float
    #: mass of a ball, kg
    ball_mass_kg: float
    #: moment of inertia of a ball, kg m²
    ball_inertia_kg_m2: float
    #: load over approach to the power of 1.5
    contact_stiffness_inner_n_per_m_1_5: float
    #: the same of the outer contact, N/m^1.5
    contact_stiffness_outer_n_per_m_1_5: float
    #: longer over shorter axis of the inner contact
    ellipticity_inner: float
    #: longer over shorter axis of the outer contact
    ellipticity_outer: float
    #: balls that roll at the free contact angle
    cage_speed_free_rpm: float
    #: drag of the fluid on a ball, N; None without a fluid
    drag_per_ball_n: Optional[float]
    #: moments of the fluid on both faces, the bore and the outside of the cage, N m; absent without cage.churning
    cage_churning_nm: list[float]
    #: density of what the balls run in, kg/m³; None without a fluid
    effective_fluid_density_kg_m3: Optional[float]
    #: of the cryogen at the case's temperature and pressure; absent for another fluid
    fluid_phase: str
    #: what a flow of the cryogen is at the outlet; absent where that was not asked for
    heated_flow: dict[str, Any]
    #: what the bearing is lubricated with
    lubrication: str
    #: C_r; None for a bearing that the standards do not rate
    dynamic_rating_n: Optional[float]
    #: C_0r
    static_rating_n: Optional[float]
    #: None where the ring is held along x, y or z, like all that follows from loads
    radial_load_n: Optional[float]
    #: axial load, N
    axial_load_n: Optional[float]
    #: least load so that balls roll, by a rule of thumb, 0.01 C_r, N; None for a bearing that the standards do not rate
    minimum_load_n: Optional[float]
    #: s_0 = C_0r/P_0; None without load
    static_safety: Optional[float]
    #: life of a charge of grease that nine of ten bearings reach, an estimate, h; absent without grease
    grease_life_hours: float
    #: of the hardest pressed ball, by a first estimate
    peak_pressure_estimate_pa: Optional[float]
    #: pitch diameter times the speed of the rings against each other
    pitch_speed_mm_rpm: float
    #: growth of the rings; absent without fits, speed and heat
    growth: Growth
    #: absent where no seat has a class
    fits: Fits
    #: of defects, balls that roll at the nominal contact angle; absent at rest
    frequencies: Frequencies
    #: where values of the case come from, by path
    sources: dict[str, Any]
    #: sentences on how the case is read
    notes: list[str]
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]

    def _draw(self, ax: Axes) -> None:
        if hasattr(self, "growth"):
            self.growth._draw(ax)
        else:
            _plots.bars(ax, {"inner": self.ellipticity_inner, "outer": self.ellipticity_outer}, "ellipticity")


class Rating(OfOperatingPoint):
    """Ratings and lives of a bearing's steel by ISO 281, ISO/TS 16281 and ISO 76, under the loads of a model."""

    _parts = {"frequencies": Frequencies}

    #: nominal contact angle, °
    nominal_contact_angle_deg: float
    #: basic dynamic load rating C_r
    dynamic_rating_n: float
    #: ``catalogue`` or ``computed``
    dynamic_rating_source: str
    #: basic static load rating C_0r
    static_rating_n: float
    #: ``catalogue`` or ``computed``
    static_rating_source: str
    #: C_u
    fatigue_load_limit_n: float
    #: ``catalogue`` or ``computed``
    fatigue_load_limit_source: str
    #: radial load, N
    radial_load_n: Optional[float]
    #: axial load, N
    axial_load_n: Optional[float]
    #: P = X F_r + Y F_a
    equivalent_load_n: Optional[float]
    #: L_10 = (C_r/P)³, million turns
    rating_life_l10_mrev: Optional[float]
    #: P_ref, of the load distribution
    reference_load_n: Optional[float]
    #: L_10r, million turns
    rating_life_l10r_mrev: Optional[float]
    #: a_ISO; None where the case does not give the lubrication
    life_modification_factor: Optional[float]
    #: a_1
    reliability_factor: float
    #: L_nmr, million turns
    rating_life_lnmr_mrev: Optional[float]
    #: rating life of the steel at the speed, h
    rating_life_hours: Optional[float]
    #: life of a charge of grease that nine of ten bearings reach, an estimate, h; absent without grease
    grease_life_hours: float
    #: the same that 99 of 100 reach, the relubrication interval, h
    grease_interval_hours: float
    #: why a greased bearing has no estimate; absent where it has one
    grease_note: str
    #: P_0
    static_equivalent_load_n: Optional[float]
    #: s_0 = C_0r/P_0
    static_safety: Optional[float]
    #: highest pressure of any ball, Pa
    peak_pressure_max_pa: Optional[float]
    #: load to 4.2 GPa over load
    pressure_safety: Optional[float]
    #: of defects, balls that roll at the mean contact angle of the loaded ones; absent at rest and without a solution
    frequencies: Frequencies

    def _draw(self, ax: Axes) -> None:
        names = ("rating_life_l10_mrev", "rating_life_l10r_mrev", "rating_life_lnmr_mrev")
        lives = {name[len("rating_life_") : -len("_mrev")]: self.__dict__.get(name) for name in names}
        _plots.bars(ax, lives, "life, million turns")


class Contact(Answer):
    """A Hertz contact."""

    #: longer over shorter axis, 1 or more
    ellipticity: float
    #: half the longer axis, m
    semi_major_m: float
    #: half the shorter axis, m
    semi_minor_m: float
    #: pressure in the middle, Pa
    peak_pressure_pa: float
    #: approach of the bodies, m
    approach_m: float
    #: load over approach to the power of 1.5
    stiffness_n_per_m_1_5: float
    #: largest shear stress below the middle of the contact, in body 1 and in body 2; None without load
    max_shear_pa: Optional[list[float]]
    #: how deep that is, m
    max_shear_depth_m: Optional[list[float]]
    #: von Mises stress at that depth
    von_mises_pa: Optional[list[float]]

    def _draw(self, ax: Axes) -> None:
        half = {"along the longer axis": self.semi_major_m, "along the shorter axis": self.semi_minor_m}
        _plots.pressure(ax, half, self.peak_pressure_pa)


class LineContact(Answer):
    """A Hertz contact of two cylinders along a line, its ends left out."""

    #: length of the contact, m
    length_m: float
    #: load per length, N/m
    load_per_length_n_per_m: float
    #: half the width of the strip, m
    half_width_m: float
    #: pressure in the middle, Pa
    peak_pressure_pa: float
    #: largest shear stress across the strip below its middle, in body 1 and in body 2, Pa; None without load
    max_shear_pa: Optional[list[float]]
    #: how deep that is, m
    max_shear_depth_m: Optional[list[float]]
    #: von Mises stress at that depth, Pa
    von_mises_pa: Optional[list[float]]

    def _draw(self, ax: Axes) -> None:
        _plots.pressure(ax, {"across the strip": self.half_width_m}, self.peak_pressure_pa)


class TractionCurve(Answer):
    """Traction coefficient of a coating over slip, at one pressure."""

    #: slips that were asked for, shape (slips,)
    slip: NDArray[np.float64]
    #: traction coefficient at each of them, shape (slips,)
    coefficient: NDArray[np.float64]
    #: parameter A of Kragelskii's curve
    a: float
    #: parameter B
    b: float
    #: parameter C
    c: float
    #: parameter D
    d: float
    #: slip of the largest coefficient
    peak_slip: float
    #: largest coefficient
    peak_coefficient: float
    #: coefficient far beyond the peak
    residual_coefficient: float
    #: contact pressure, GPa
    pressure_gpa: float
    #: outside the tested pressures
    extrapolated: bool
    #: outside the pressures for which the fit may be used, whose nearest end is taken instead
    clamped: bool
    #: where the parameters come from
    source: str
    #: what the reader must know about the pressure
    note: Optional[str]

    def __init__(self, data: dict[str, Any]) -> None:
        super().__init__(data)
        self.slip = np.asarray(data["slip"], dtype=np.float64)
        self.coefficient = np.asarray(data["coefficient"], dtype=np.float64)

    def _draw(self, ax: Axes) -> None:
        ax.plot(self.slip, self.coefficient, "o-")
        _plots.label(ax, "slip", "traction coefficient")

    def to_pandas(self) -> pd.Series[Any]:
        """Coefficients over slip."""
        import pandas

        series: pd.Series[Any] = pandas.Series(
            self.coefficient, index=pandas.Index(self.slip, name="slip"), name="coefficient"
        )
        return series


#: Share of a stiffness that tilts would take away, from which on :meth:`Stiffness.to_ross` says so.
TOLD_SOFTER = 0.01
#: Directions of the stiffness: forces and moments by rows, displacements (m) and tilts (rad) by columns.
AXES = ("x", "y", "z", "tilt_x", "tilt_y")


class Stiffness(Answer):
    """Stiffness of the inner ring over its speed.

    Rows of a matrix are forces along x, y, z (N) and moments about x, y (N m); columns are displacements along x, y, z
    (m) and tilts about x, y (rad).
    """

    #: speeds of the inner ring
    inner_speed_rpm: NDArray[np.float64]
    #: a matrix for each speed
    stiffness: NDArray[np.float64]
    #: its inverse; NaN where a displacement meets no resistance
    compliance: NDArray[np.float64]
    #: largest estimated error of an element over √(K_ii K_jj), of orbits and of equilibria with traction; NaN otherwise
    error_estimate: NDArray[np.float64]
    #: equations of the operating point
    model: str
    #: what the bearing is lubricated with
    lubrication: str
    #: for each speed: False where nothing loads the bearing
    loaded: list[bool]
    #: for each speed: sentences on what is unusual, beyond what was tested, or more than the model can mean
    warnings: list[list[str]]
    #: for each speed: names of what no bearing does
    implausible: list[list[str]]

    def __init__(self, answers: list[dict[str, Any]]) -> None:
        missing = [[float("nan")] * 5] * 5
        super().__init__(
            {
                "inner_speed_rpm": np.array([a["inner_speed_rpm"] for a in answers], dtype=np.float64),
                "stiffness": np.array([a["stiffness"] for a in answers], dtype=np.float64),
                "compliance": np.array([a.get("compliance", missing) for a in answers], dtype=np.float64),
                "error_estimate": np.array([a.get("error_estimate", float("nan")) for a in answers], dtype=np.float64),
                "model": answers[0]["model"],
                "lubrication": answers[0]["lubrication"],
                "loaded": [a["loaded"] for a in answers],
                "warnings": [a["warnings"] for a in answers],
                "implausible": [a["implausible"] for a in answers],
            }
        )

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The stiffness at the first speed."""
        first: NDArray[np.float64] = self.stiffness[0]
        return first

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each speed, a column for each entry: ``k_x_x`` to ``k_tilt_y_tilt_y``, as ``--csv`` has them."""
        import pandas

        names = [f"k_{row}_{column}" for row in AXES for column in AXES]
        speeds = pandas.Index(self.inner_speed_rpm, name="inner_speed_rpm")
        frame: pd.DataFrame = pandas.DataFrame(self.stiffness.reshape(len(speeds), 25), index=speeds, columns=names)
        frame["implausible"] = [", ".join(names) for names in self.implausible]
        frame["warnings"] = ["; ".join(warnings) for warnings in self.warnings]
        return frame

    def to_xarray(self) -> xr.DataArray:  # type: ignore[override]
        """Entries by speed, row and column."""
        import xarray

        coordinates = {"inner_speed_rpm": self.inner_speed_rpm, "force": list(AXES), "displacement": list(AXES)}
        return xarray.DataArray(
            self.stiffness, dims=("inner_speed_rpm", "force", "displacement"), coords=coordinates, name="stiffness"
        )

    def to_ross(
        self, major: Optional[int] = None, *, damping: Union[float, Modes, Sequence[Modes]] = 0.0
    ) -> dict[str, NDArray[np.float64]]:
        """Arguments of ROSS's ``BearingElement``: ``kxx``, ``kxy``, ``kyx``, ``kyy``, ``kzz`` in N/m and ``cxx`` to
        ``czz`` in N s/m over the speed in rad/s, by rising speed.

        The element has translations only: tilts are held, and moments are left out. A :class:`ModelWarning` says how
        much of the stiffness would be gone were the ring free to tilt.

        Args:
            major: major version of ROSS that they are for, by default that which is installed, or 3. From 3 on the
                speed of the rotor is ``speed``, and ``frequency`` that of the whirl; before, the speed is
                ``frequency``
            damping: a time in s by which the stiffness is multiplied, 0 for none; or the :class:`Modes` of the
                bearing, one for all speeds or one for each in the order of ``inner_speed_rpm``. Of the modes that
                take the inner ring along x, y, z each that does so most gives a time τ = 2ζ/ω, and c_ij is
                √(τ_i τ_j) k_ij. What the supports of the case damp is in it: give it undamped ones for the bearing's
                own

        What is implausible is a Python warning: the arguments have no room for it.
        """
        for speed, implausible, said in zip(self.inner_speed_rpm, self.implausible, self.warnings):
            if implausible:
                message = f"stiffness at {speed:.1f} r/min: {'; '.join(said)}"
                warnings.warn(message, PlausibilityWarning, stacklevel=2)
        softer = self._softer_by_tilts()
        if np.max(softer) > TOLD_SOFTER:
            shares = ", ".join(f"{name} by {100 * share:.0f} %" for name, share in zip(("kxx", "kyy", "kzz"), softer))
            message = f"the element has no tilts: a ring that is free to tilt is softer, {shares}"
            warnings.warn(message, ModelWarning, stacklevel=2)
        if major is None:
            try:
                major = int(importlib.metadata.version("ross-rotordynamics").split(".")[0])
            except importlib.metadata.PackageNotFoundError:
                major = 3
        order = np.argsort(self.inner_speed_rpm)
        stiffness = self.stiffness[order]
        root = np.sqrt(self._damping_times(damping)[order])
        lost = stiffness[:, :3, :3] * root[:, :, None] * root[:, None, :]
        entries = {"xx": (0, 0), "xy": (0, 1), "yx": (1, 0), "yy": (1, 1), "zz": (2, 2)}
        arguments = {
            letter + name: np.ascontiguousarray(matrices[:, i, j])
            for letter, matrices in (("k", stiffness), ("c", lost))
            for name, (i, j) in entries.items()
        }
        arguments["speed" if major >= 3 else "frequency"] = self.inner_speed_rpm[order] * np.pi / 30.0
        return arguments

    def _softer_by_tilts(self) -> NDArray[np.float64]:
        """Share of the stiffness along x, y, z that is gone where the ring is free to tilt, the most of all speeds."""
        matrices = self.stiffness
        freed = matrices[:, :3, :3] - matrices[:, :3, 3:] @ np.linalg.pinv(matrices[:, 3:, 3:]) @ matrices[:, 3:, :3]
        held = np.diagonal(matrices[:, :3, :3], axis1=1, axis2=2)
        gone = np.divide(held - np.diagonal(freed, axis1=1, axis2=2), held, out=np.zeros_like(held), where=held != 0)
        most: NDArray[np.float64] = np.abs(gone).max(axis=0)
        return most

    def _damping_times(self, damping: Union[float, Modes, Sequence[Modes]]) -> NDArray[np.float64]:
        """Damping over stiffness along x, y, z at each speed, s."""
        count = len(self.inner_speed_rpm)
        if isinstance(damping, Modes):
            return np.tile(damping.damping_times_s(), (count, 1))
        if isinstance(damping, (int, float)):
            if not 0.0 <= damping < float("inf"):
                allowed = "allowed is a time in s, 0 or more, or modes"
                raise InputError(f"damping = {damping}: {allowed}", path="damping", value=str(damping), allowed=allowed)
            return np.full((count, 3), float(damping))
        if len(damping) != count:
            allowed = f"allowed are modes for all speeds, or for each of the {count}"
            message = f"damping = {len(damping)} modes: {allowed}"
            raise InputError(message, path="damping", value=str(len(damping)), allowed=allowed)
        return np.array([modes.damping_times_s() for modes in damping])

    def _draw(self, ax: Axes) -> None:
        if len(self.inner_speed_rpm) == 1:
            _plots.heat(ax, self.matrix, AXES)
            return
        for place, name in enumerate(AXES[:3]):
            ax.plot(self.inner_speed_rpm, 1e-6 * self.stiffness[:, place, place], "o-", label=f"along {name}")
        _plots.label(ax, "speed of the inner ring, r/min", "stiffness, N/µm", legend=True)

    def __repr__(self) -> str:
        names = sorted({name for names in self.implausible for name in names})
        return f"Stiffness({len(self.inner_speed_rpm)} speeds{'; implausible: ' + ', '.join(names) if names else ''})"

    def _repr_html_(self) -> str:
        pairs = zip(self.inner_speed_rpm, self.stiffness)
        return "".join(
            _html.table(
                f"stiffness at {speed:.1f} r/min",
                ("", *AXES),
                [(name, *map(float, row)) for name, row in zip(("F_x", "F_y", "F_z", "M_x", "M_y"), matrix)],
            )
            for speed, matrix in pairs
        ) + _plots.svg(self)


class Mode(Answer):
    """A natural mode: frequency, damping, shape."""

    #: frequency, Hz
    frequency_hz: float
    #: damping over the critical one; below 0 where the mode grows
    damping_ratio: float
    #: above 0 where the mode grows
    growth_rate_per_s: float
    #: shares of the kinetic energy
    energy_shares: dict[str, float]
    #: amplitudes along x, y, z over the largest of the translations of all bodies
    inner_ring: list[float]
    #: along x, y
    outer_ring: list[float]
    #: tilts of an inner ring that is free to tilt, about x, y, times the pitch radius; else absent
    inner_tilt: list[float]
    #: the same of the outer ring
    outer_tilt: list[float]
    #: of each ball: axial, radial, along the orbit
    balls: list[list[float]]

    def _energy_along(self, axis: int) -> float:
        """Share of the kinetic energy that the inner ring has along x, y or z."""
        squares = np.abs(np.asarray(self.inner_ring)) ** 2
        total = float(squares.sum())
        return float(self.energy_shares["inner_ring"] * squares[axis] / total) if total > 0.0 else 0.0

    def _draw(self, ax: Axes) -> None:
        _plots.bars(ax, self.energy_shares, "share of the kinetic energy")


class Modes(OfOperatingPoint):
    """Natural modes of balls, cage and rings about the steady orbit, by frequency."""

    _parts = {"modes": Mode}

    #: speed of the cage in the orbit, r/min
    cage_speed_rpm: float
    #: what is left, a turn of the cage later, of a small disturbance of a ball: above 1 it grows
    multiplier: float
    #: the same as a rate
    growth_rate_per_s: float
    #: the modes by their frequency
    modes: list[Mode]

    def damping_times_s(self) -> NDArray[np.float64]:
        """Damping over stiffness 2ζ/ω along x, y, z, s: each by the mode that has most of its energy in the inner ring
        along it. An :class:`InputError` where no mode that swings and dies away has any."""
        swinging = [mode for mode in self.modes if mode.frequency_hz > 0.0 and 0.0 < mode.damping_ratio < 1.0]
        times = np.zeros(3)
        for axis, name in enumerate("xyz"):
            energies = [mode._energy_along(axis) for mode in swinging]
            if not energies or max(energies) == 0.0:
                allowed = "allowed are modes of which one swings the inner ring along each axis, and dies away"
                message = f"modes: none along {name}: {allowed}"
                raise InputError(message, path="modes", value=name, allowed=allowed)
            mode = swinging[int(np.argmax(energies))]
            # The frequency is that of the damped oscillation.
            natural = 2.0 * np.pi * mode.frequency_hz / np.sqrt(1.0 - mode.damping_ratio**2)
            times[axis] = 2.0 * mode.damping_ratio / natural
        return times

    def _draw(self, ax: Axes) -> None:
        ax.plot([mode.frequency_hz for mode in self.modes], [mode.damping_ratio for mode in self.modes], "o")
        _plots.label(ax, "frequency, Hz", "damping ratio")

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each mode."""
        import pandas

        rows = [
            {
                "frequency_hz": mode.frequency_hz,
                "damping_ratio": mode.damping_ratio,
                "growth_rate_per_s": mode.growth_rate_per_s,
                **{f"energy_{name}": share for name, share in mode.energy_shares.items()},
            }
            for mode in self.modes
        ]
        frame: pd.DataFrame = pandas.DataFrame(rows)
        return frame

    def _repr_html_(self) -> str:
        frame = self.to_pandas()
        rows = [tuple(row) for row in frame.itertuples(index=False)]
        return _html.table(f"{len(self.modes)} modes", list(frame.columns), rows) + _plots.svg(self)


class Life(Answer):
    """The life of a bearing's raceways."""

    #: file of the case
    case: str
    #: name of the bearing
    bearing: str
    #: ``worn-through``, ``clearance-limit``, ``time`` or ``grooves``
    ended_by: str
    #: races whose coating is through at the end: ``inner``, ``outer``
    worn_through: list[str]
    #: running time at the end, h
    end_h: float
    #: turns of the inner ring at the end
    end_revolutions: float
    #: when steel first showed in the middle of a track; None where it did not
    steel_shows_h: Optional[float]
    #: added clearance at which the life was to end; None where none was given
    clearance_limit_um: Optional[float]
    #: part of a new coating that a stride takes at its fastest spot
    loss_per_stride: float
    #: the state at the start of each stride, and at the end
    strides: list[dict[str, float]]
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]

    def _draw(self, ax: Axes) -> None:
        for name in self.strides[0]:
            if name.startswith("coating_") and name.endswith("_um"):
                words = name[:-3].replace("_", " ")
                ax.plot([s["time_h"] for s in self.strides], [s[name] for s in self.strides], label=words)
        _plots.label(ax, "time, h", "coating left, µm", legend=True)

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each stride; columns with their units in their names."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self.strides)
        return frame


class ActingLife(Answer):
    """A life in which wear acts on the bearing."""

    #: name of the case
    case: str
    #: name of the bearing
    bearing: str
    #: the effects that were on: ``clearance``, ``curvature``, ``traction``, ``transfer``
    effects: list[str]
    #: ``worn-through`` or ``time``
    ended_by: str
    #: running time at the end, h
    end_h: float
    #: turns of the inner ring at the end
    end_revolutions: float
    #: race, azimuth, contact angle and time of the first spot without coating; None where there was none
    first_through: Optional[dict[str, Any]]
    #: share of a race's load on bare steel at which the life was to end
    bare_limit: float
    #: part of a new coating that a stride takes at its fastest spot
    loss_per_stride: float
    #: the state at the start of each stride, and at the end
    strides: list[dict[str, float]]
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]

    def _draw(self, ax: Axes) -> None:
        for name in ("precoated_inner", "self_lubricated", "unlubricated_inner", "unlubricated_outer"):
            ax.plot([s["time_h"] for s in self.strides], [s[name] for s in self.strides], label=name.replace("_", " "))
        _plots.label(ax, "time, h", "share of the load", legend=True)

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each stride; columns with their units in their names."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self.strides)
        return frame


class Identification(Answer):
    """Unknown parameters under one hypothesis."""

    #: name of the hypothesis; None for the problem as it stands
    hypothesis: Optional[str]
    #: sum of squared residuals over uncertainties, priors included
    cost: float
    #: the part of the figures, without priors
    data_cost: float
    #: by Laplace's approximation, up to a constant of the data
    log_evidence: float
    #: signs that a figure is read wrongly or that the model lacks something
    conflicts: list[str]
    #: of each parameter its ``name``, ``value``, ``spread``, and whether it is ``determined`` or ``at_bound``
    parameters: list[dict[str, Any]]
    #: correlations of the parameters, by rows
    correlation: list[list[float]]
    #: of each figure its value, the computed one and the residual
    data: list[dict[str, Any]]
    #: distinct minima, the best first
    minima: list[dict[str, Any]]
    #: starts without an equilibrium
    failed_starts: int
    #: change of the sensitivities when their step is halved
    sensitivity_check: float
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]
    #: the case file with the identified values and their sources
    case_text: str

    def _draw(self, ax: Axes) -> None:
        names = [parameter["name"] for parameter in self.parameters]
        spreads = [abs((p["spread"] or 0.0) / p["value"]) if p["value"] else 0.0 for p in self.parameters]
        ax.errorbar(range(len(names)), [1.0] * len(names), yerr=spreads, fmt="o", capsize=4)
        ax.set_xticks(range(len(names)), names, rotation=45)
        _plots.label(ax, "", "value with its spread, over the value")

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each parameter."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self.parameters)
        return frame

    def _repr_html_(self) -> str:
        rows = [(p["name"], p["value"], p["spread"], p["determined"], p["at_bound"]) for p in self.parameters]
        head = ("parameter", "value", "spread", "determined", "at bound")
        return _html.table(self.hypothesis or "the case as it is", head, rows) + _plots.svg(self)
