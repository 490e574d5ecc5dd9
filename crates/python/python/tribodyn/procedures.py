"""Single questions about a case or a contact."""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Sequence
from typing import Literal, Optional, Union, overload

from . import _native
from ._answer import warned
from ._errors import ModelWarning, PlausibilityWarning
from .answers import Contact, Derived, LineContact, Modes, Rating, Stiffness, TractionCurve
from .case import Case, native
from .solution import Solution
from .units import all_in_unit, in_unit

#: Equations: raceway control without traction, traction integrals of both contacts, or the periodic motion of balls
#: and cage that a run settles to.
Model = Literal["jones-harris", "traction", "steady-orbit"]

#: Seconds of processor time after which a search for an operating point is given up.
TIME_LIMIT_S = 60.0


def solve(
    case: Case, model: Model = "steady-orbit", *, roots: bool = False, time_limit: float = TIME_LIMIT_S
) -> Solution:
    """The equilibrium of ring and balls, or their steady orbit.

    Args:
        case: the bearing at its operating point
        model: the equations
        roots: also search each ball for other equilibria, the ring held; about as long as a dozen solutions
        time_limit: seconds of processor time after which the search is given up; ``inf`` for none

    Raises:
        InputError: the model cannot use the case
        SolveError: no solution was found
    """
    return warned(Solution(*_native.solve(native(case), model, roots, time_limit)))


def stiffness(
    case: Case,
    model: Model = "steady-orbit",
    *,
    speeds: Union[float, Iterable[float]] = (),
    time_limit: float = TIME_LIMIT_S,
) -> Stiffness:
    """The 5 × 5 stiffness of the inner ring, balls and cage in balance.

    Args:
        case: the bearing at its operating point
        model: the equations of the operating point
        speeds: speeds of the inner ring, r/min; that of the case where none is given
        time_limit: as of :func:`solve`, for all speeds together
    """
    given = all_in_unit(speeds, "rpm", "speeds")
    answer = Stiffness(_native.stiffness(native(case), model, given, time_limit))
    for speed, said, implausible in zip(answer.inner_speed_rpm, answer.warnings, answer.implausible):
        for place, sentence in enumerate(said):
            kind = PlausibilityWarning if implausible and place == len(said) - 1 else ModelWarning
            warnings.warn(f"at {speed:.1f} r/min: {sentence}", kind, stacklevel=2)
    return answer


def modes(case: Case, *, up_to: float = float("inf"), all: bool = False, time_limit: float = TIME_LIMIT_S) -> Modes:
    """Natural modes of balls, cage and rings about the steady orbit, up to a frequency in Hz.

    Masses and supports are those of a run: the case needs its sections ``transient`` and ``supports``. With ``all``
    also those of the balls, which belong to the instant when pocket 0 stands at azimuth 0.
    """
    return warned(Modes(_native.modes(native(case), in_unit(up_to, "Hz", "up_to"), all, time_limit)))


def rating_life(case: Case, model: Optional[Model] = None, *, time_limit: float = TIME_LIMIT_S) -> Rating:
    """Rating life of the bearing's steel by ISO 281 and ISO/TS 16281, and static safety by ISO 76.

    The ball loads are those of the steady orbit where no model is given, or of raceway control for a case without
    traction or cage. How long the coatings last is another question: :func:`life` answers it.
    """
    return warned(Rating(_native.rating(native(case), model, time_limit)))


def check(case: Case, *, flow: Optional[float] = None, power: Optional[float] = None) -> Derived:
    """What follows from a case before anything is solved; the same as ``case.check()``.

    Args:
        case: the bearing
        flow: flow of the cryogen through the bearing, kg/s: the answer has what it is after it has taken up ``power``
        power: heat that the flow takes up, W
    """
    return case.check(flow=flow, power=power)


@overload
def hertz(
    body1: Sequence[float],
    body2: Sequence[float],
    load: float,
    *,
    young1: float = 206.0,
    poisson1: float = 0.3,
    young2: float = 206.0,
    poisson2: float = 0.3,
    angle: float = 0.0,
    length: None = None,
) -> Contact: ...


@overload
def hertz(
    body1: Sequence[float],
    body2: Sequence[float],
    load: float,
    *,
    young1: float = 206.0,
    poisson1: float = 0.3,
    young2: float = 206.0,
    poisson2: float = 0.3,
    angle: float = 0.0,
    length: float,
) -> LineContact: ...


def hertz(
    body1: Sequence[float],
    body2: Sequence[float],
    load: float,
    *,
    young1: float = 206.0,
    poisson1: float = 0.3,
    young2: float = 206.0,
    poisson2: float = 0.3,
    angle: float = 0.0,
    length: Optional[float] = None,
) -> Union[Contact, LineContact]:
    """Hertz contact of two bodies; with ``length`` that of two cylinders along a line.

    Args:
        body1, body2: principal radii in the planes x and y, mm; negative for concave, ``inf`` for flat
        load: normal load, N
        young1, young2: Young's moduli, GPa
        poisson1, poisson2: Poisson's ratios
        angle: angle between the x planes of the two bodies, degrees
        length: length of the contact of cylinders, mm; their radii are ``(rx, inf)``
    """
    radii = [all_in_unit(body, "mm", name) for name, body in (("body1", body1), ("body2", body2))]
    young = [in_unit(young1, "GPa", "young1"), in_unit(young2, "GPa", "young2")]
    along, turned = in_unit(length, "mm", "length"), in_unit(angle, "deg", "angle")
    answer = _native.hertz(radii, in_unit(load, "N", "load"), young, [poisson1, poisson2], turned, along)
    return Contact(answer) if along is None else LineContact(answer)


def traction_curve(coating: str, pressure: float, slip: Iterable[float], *, order: int = 2) -> TractionCurve:
    """Traction coefficient of a coating of the library over slip.

    Args:
        coating: ``"ag"`` or ``"ptfe"``
        pressure: contact pressure, GPa
        slip: slips in the unit of the coating's own data
        order: order of the polynomials in pressure; 2 goes through the three tested pressures
    """
    return TractionCurve(
        _native.traction_curve(coating, in_unit(pressure, "GPa", "pressure"), [float(value) for value in slip], order)
    )
