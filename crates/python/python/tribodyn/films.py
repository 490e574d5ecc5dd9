"""Lubricated bearings: films of their contacts, friction torque by cause, temperatures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

from . import _native, _plots
from ._answer import Answer, OfOperatingPoint, warned
from .case import Case, native
from .procedures import TIME_LIMIT_S, Model
from .units import in_unit

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes


class Oil(Answer):
    """An oil at a temperature."""

    #: temperature, °C
    temperature_deg_c: float
    #: kinematic viscosity, mm²/s
    kinematic_viscosity_mm2_s: float
    #: at ambient pressure
    dynamic_viscosity_pa_s: float
    #: density, kg/m³
    density_kg_m3: float
    #: pressure–viscosity coefficient, 1/Pa
    pressure_viscosity_per_pa: float


class ContactFilm(Answer):
    """The film of one contact."""

    _parts = {"oil": Oil}

    #: from 0; absent where only one contact was asked for
    ball: int
    #: ``inner`` or ``outer``; likewise
    race: str
    #: load of the contact, N
    load_n: float
    #: mean speed of the surfaces into the contact, m/s
    entrainment_speed_m_s: float
    #: central film thickness, m
    film_central_m: float
    #: least film thickness, m
    film_minimum_m: float
    #: film parameter λ
    lambda_ratio: float
    #: absent where traction is not solved for
    film_temperature_rise_k: float
    #: the oil at the inlet, where only one contact was asked for
    oil: Oil

    def _draw(self, ax: Axes) -> None:
        _plots.bars(ax, {"central": 1e6 * self.film_central_m, "least": 1e6 * self.film_minimum_m}, "film, µm")


class Films(OfOperatingPoint):
    """The films of all loaded contacts of a case."""

    _parts = {"oil": Oil, "contacts": ContactFilm}

    #: the oil at the inlet
    oil: Oil
    #: film thickness over that of flooded contacts
    starvation: float
    #: viscosity ratio κ; None at rest
    viscosity_ratio: Optional[float]
    #: viscosity that ISO 281 asks for at this speed; None at rest
    reference_viscosity_mm2_s: Optional[float]
    #: pitch diameter times speed, mm r/min
    speed_factor_mm_rpm: float
    #: ball by ball
    contacts: list[ContactFilm]

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each contact."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame([contact.to_dict() for contact in self.contacts])
        return frame

    def _draw(self, ax: Axes) -> None:
        for race in ("inner", "outer"):
            of = [contact for contact in self.contacts if contact.race == race]
            ax.plot([c.ball for c in of], [1e6 * c.film_minimum_m for c in of], "o", label=f"{race} race")
        _plots.label(ax, "ball", "least film thickness, µm", legend=True)


class Torque(OfOperatingPoint):
    """Torque that the shaft needs, by cause, beside SKF's model and Palmgren's formula."""

    #: of the rings against each other
    speed_rpm: float
    #: radial load, N
    radial_load_n: float
    #: axial load, N
    axial_load_n: float
    #: all of it
    torque_nm: float
    #: resistance of the films' inlets to rolling
    rolling_nm: float
    #: elastic hysteresis of balls and rings as they are rolled over
    hysteresis_nm: float
    #: shear of the films at the inner race
    sliding_inner_nm: float
    #: sliding in the outer contacts, N m
    sliding_outer_nm: float
    #: drag and churning of the fluid around the balls
    fluid_nm: float
    #: pockets, and drag of guiding land and surroundings
    cage_nm: float
    #: SKF's model; absent without a lubricant, as are those below
    skf_rolling_nm: float
    #: its sliding part, N m
    skf_sliding_nm: float
    #: without seals and the drag of an oil bath
    skf_torque_nm: float
    #: Palmgren's formula: of the lubricant
    palmgren_viscous_nm: float
    #: of the load
    palmgren_load_nm: float
    #: torque by Palmgren's formula, N m
    palmgren_torque_nm: float
    #: what the formulas had to assume
    notes: list[str]

    def _draw(self, ax: Axes) -> None:
        causes = ("rolling", "hysteresis", "sliding_inner", "sliding_outer", "fluid", "cage", "torque")
        names = tuple(f"{cause}_nm" for cause in causes)
        found = {
            name: getattr(self, name) for name in (*names, "skf_torque_nm", "palmgren_torque_nm") if hasattr(self, name)
        }
        _plots.bars(ax, {name[:-3].replace("_", " "): 1e3 * value for name, value in found.items()}, "torque, N mm")


def torque(case: Case, model: Model = "steady-orbit", *, time_limit: float = TIME_LIMIT_S) -> Torque:
    """Friction torque of a bearing by cause, beside SKF's model and Palmgren's formula."""
    return warned(Torque(_native.torque(native(case), model, time_limit)))


class Heat(OfOperatingPoint):
    """Temperatures at which all friction of a bearing leaves it."""

    #: of the inner ring, °C
    inner_temperature_deg_c: float
    #: of the balls, °C
    ball_temperature_deg_c: float
    #: of the outer ring, °C
    outer_temperature_deg_c: float
    #: oil or grease between them
    oil_temperature_deg_c: float
    #: of the housing, °C
    housing_temperature_deg_c: float
    #: mean of the surfaces, which the films have at their inlets
    film_inlet_temperature_deg_c: float
    #: there
    kinematic_viscosity_mm2_s: float
    #: friction torque, N m
    torque_nm: float
    #: friction power, W
    friction_power_w: float
    #: to the surroundings along the shaft
    heat_shaft_w: float
    #: from the housing
    heat_housing_w: float
    #: with the oil that flows through
    heat_oil_w: float
    #: of the running bearing; below 0 it is preloaded
    radial_clearance_m: float
    #: solutions that it took
    rounds: int
    #: what had to be assumed
    notes: list[str]

    def _draw(self, ax: Axes) -> None:
        names = ("inner", "ball", "outer", "oil", "housing")
        _plots.bars(ax, {name: getattr(self, f"{name}_temperature_deg_c") for name in names}, "temperature, °C")


def heat(
    case: Case,
    model: Model = "steady-orbit",
    *,
    surroundings: float = 20.0,
    cooling: float = 1.0,
    width: Optional[float] = None,
    oil_flow: float = 0.0,
    time_limit: float = TIME_LIMIT_S,
) -> Heat:
    """Temperatures of a lubricated bearing in steady state: its friction heats it, and what is warmer has other films,
    friction and clearance.

    Args:
        case: the bearing; it needs a lubricant
        model: the equations, with friction
        surroundings: temperature of the surroundings and of the oil that flows in, °C
        cooling: conductances of shaft and housing to the surroundings over those of ISO 15312's reference
        width: width of the bearing, mm; half of D − d where left out
        oil_flow: oil that flows through the bearing, l/min
        time_limit: as of :func:`solve`, for all solutions together
    """
    given = (in_unit(surroundings, "degC", "surroundings"), cooling, in_unit(width, "mm", "width"), oil_flow)
    return warned(Heat(_native.heat(native(case), model, given, time_limit)))


def film(case: Case, model: Model = "steady-orbit", *, time_limit: float = TIME_LIMIT_S) -> Films:
    """Films of every loaded contact of a case with a lubricant: Hamrock and Dowson, inlet heating, starvation."""
    return warned(Films(_native.films(native(case), model, time_limit)))


def contact_film(
    oil: str,
    *,
    temperature: float,
    load: float,
    speed: float,
    radius: float,
    across: Optional[float] = None,
    slide_to_roll: float = 0.0,
    roughness: float = 0.07,
    starvation: float = 1.0,
    young: float = 208.0,
    poisson: float = 0.3,
) -> ContactFilm:
    """The film of one contact of two like bodies.

    Args:
        oil: of the library: mineral, pao, ester or polyglycol with a grade, such as ``"mineral-vg68"``
        temperature: of the oil before the contact, °C
        load: normal load, N
        speed: entrainment speed, the mean of both surface speeds, m/s
        radius: of relative curvature along rolling, mm
        across: the same across rolling, mm; as along it where left out
        slide_to_roll: slide-to-roll ratio
        roughness: root mean square of both surfaces together, um
        starvation: film thickness over that of a flooded contact; 0.7 for grease
        young: Young's modulus of both bodies, GPa
        poisson: Poisson's ratio of both bodies
    """
    request = {
        "oil": oil,
        "temperature": in_unit(temperature, "degC", "temperature"),
        "load": in_unit(load, "N", "load"),
        "speed": speed,
        "radius": in_unit(radius, "mm", "radius"),
        "across": in_unit(radius if across is None else across, "mm", "across"),
        "slide_to_roll": slide_to_roll,
        "roughness": in_unit(roughness, "um", "roughness"),
        "starvation": starvation,
        "young": in_unit(young, "GPa", "young"),
        "poisson": poisson,
    }
    return ContactFilm(_native.contact_film(request))
