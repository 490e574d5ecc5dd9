"""Measured and recorded signals, recordings that were damaged, layouts for viewers, and the list of bearings."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _html, _native, _plots
from ._answer import Answer, warned
from .case import Case, native
from .units import in_unit

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes

PathLike = Union[str, os.PathLike[str]]


class Vibration(Answer):
    """What a vibration signal says of a bearing."""

    #: program and version
    generator: str
    #: the file that was read
    file: str
    #: name of the column
    channel: str
    #: samples a second, Hz
    rate_hz: float
    #: beginning of the part that was evaluated
    from_s: float
    #: length of the part that was evaluated, s
    duration_s: float
    #: moments and extremes of that part, in the unit of the file
    statistics: dict[str, Any]
    #: rms and peak velocity in the bands of bearing testers, m/s; empty unless the column is an acceleration in m/s²
    velocity_bands: list[dict[str, Any]]
    #: class of bearing testers by them, ``name``, ``limits_m_s`` and ``bore_m``: of a deep groove bearing with a known
    #: bore at 1800 r/min; None else
    velocity_class: Optional[dict[str, Any]]
    #: balls, diameters, contact angle, turns of the rings over those of the shaft
    bearing: dict[str, Any]
    #: speed of the shaft
    shaft: dict[str, Any]
    #: whether the lines are those over shaft angle, frequencies then those at the mean speed
    order_tracked: bool
    #: bands of the kurtogram, from wide to narrow
    kurtogram: list[dict[str, Any]]
    #: the band of the envelope spectrum
    band: dict[str, Any]
    #: whether that band was cut from the whitened signal
    whitened: bool
    #: evidence for each fault, in its best band
    evidence: list[dict[str, Any]]
    #: speed of the cage by the lines that were found; None without them
    cage: Optional[dict[str, Any]]
    #: ``fault`` and ``reasons``
    verdict: dict[str, Any]
    #: sentences on what is unusual or beyond what was tested
    warnings: list[str]
    #: samples that were evaluated
    samples: NDArray[np.float64]
    #: frequencies of the spectrum of the squared envelope
    envelope_hz: NDArray[np.float64]
    #: its amplitudes over the mean of the squared envelope
    envelope: NDArray[np.float64]

    def to_dict(self) -> dict[str, Any]:
        """What ``vibration --json`` prints."""
        answer = super().to_dict()
        for name in ("samples", "envelope_hz", "envelope"):
            del answer[name]
        return answer

    def to_pandas(self) -> pd.DataFrame:  # type: ignore[override]
        """A row for each kind of fault, with the evidence for it."""
        import pandas

        frame: pd.DataFrame = pandas.DataFrame(self.evidence)
        return frame

    def _draw(self, ax: Axes) -> None:
        top = 4.5 * max(found["expected_hz"] for found in self.evidence)
        shown = (self.envelope_hz > 0) & (self.envelope_hz <= top)
        ax.plot(self.envelope_hz[shown], self.envelope[shown], linewidth=0.8)
        for place, found in enumerate(self.evidence):
            ax.axvline(found["frequency_hz"], linestyle=":", color=f"C{place + 1}", label=found["fault"])
        _plots.label(ax, "frequency, Hz", "squared envelope over its mean", legend=True)

    def _repr_html_(self) -> str:
        rows = [(e["fault"], e["expected_hz"], e["frequency_hz"], e["log_chance"]) for e in self.evidence]
        head = ("line", "rolling, Hz", "found, Hz", "log10 of chance")
        said = "".join(f"<p>{_html.text(reason)}</p>" for reason in self.verdict["reasons"])
        title = f"{self.channel}: {self.verdict['fault'] or 'no fault seen'}"
        return _html.table(title, head, rows) + said + _plots.svg(self)


class Recovered(Answer):
    """What was saved of a recording."""

    #: the recording that was read
    recording: str
    #: the file that was written
    output: str
    #: messages that were saved
    messages: int
    #: of unknown topics, which are left out
    messages_lost: int
    #: of the last message
    simulated_s: float
    #: chunks that were damaged
    chunks_bad: int
    #: bytes that could not be read
    bytes_lost: int
    #: read, but no checksum vouches for them
    messages_unchecked: int
    #: whether the file ended before its end mark
    truncated: bool
    #: whether the summary at the end was damaged
    summary_bad: bool
    #: whether a checksum did not agree
    checksum_bad: bool

    def _draw(self, ax: Axes) -> None:
        _plots.bars(ax, {name: getattr(self, name) for name in ("messages", "messages_lost", "messages_unchecked")}, "")


class Listed(Answer):
    """A bearing of the built-in list."""

    #: its designation
    designation: str
    #: bore, mm
    bore_mm: float
    #: outside diameter, mm
    outside_diameter_mm: float
    #: width, mm
    width_mm: float
    #: nominal contact angle, °
    contact_angle_deg: float
    #: C_r by the catalogue
    dynamic_rating_n: Optional[float]
    #: C_0r by the catalogue
    static_rating_n: Optional[float]
    #: number of balls
    ball_count: int
    #: ball diameter, mm
    ball_diameter_mm: float
    #: pitch diameter, mm
    pitch_diameter_mm: float
    #: True for balls that are published; the others follow from the ratings
    balls_published: bool
    #: the larger deviation of the ratings of these balls from the catalogue's
    rating_deviation: Optional[float]
    #: the same of the set that comes second: where it is near, the balls are not certain
    next_rating_deviation: Optional[float]
    #: where the dimensions come from
    source: str

    def _draw(self, ax: Axes) -> None:
        _plots.section(ax, self)


def vibration(
    file: PathLike,
    *,
    channel: Optional[str] = None,
    rate: Optional[float] = None,
    bearing: Union[str, PathLike, None] = None,
    angle: Optional[float] = None,
    speed: Union[str, float, None] = None,
    key_phase: Optional[str] = None,
    pulses: float = 1.0,
    start: Optional[float] = None,
    end: Optional[float] = None,
    speed_tolerance: float = 1.5,
    slip: float = 2.0,
) -> Vibration:
    """Finds the faults of a bearing in a vibration signal: lines of its envelope spectrum, its cage, a verdict.

    Args:
        file: numbers in columns (.csv, .txt, .tsv, .dat), .wav, .mat (level 5), .parquet, or a recorded run (.mcap)
        channel: the column to evaluate, by its name or number
        rate: sampling rate, Hz, where the file does not say it
        bearing: a case file, a designation such as ``"6205"``, or ``"balls,ball mm,pitch mm[,angle °]"``
        angle: nominal contact angle of an angular-contact designation, degrees
        speed: of the shaft, r/min, or the column that holds it
        key_phase: column with the pulses of a key phase or tachometer
        pulses: pulses of it in a turn
        start, end: the part to evaluate, s
        speed_tolerance: how far the true speed may lie from the one given in r/min, %
        slip: how far slip and contact angle may move the cage from pure rolling, %
    """
    name = os.fspath(file)
    request = {
        "file": name,
        "channel": channel,
        "rate": in_unit(rate, "Hz", "rate"),
        "bearing": None if bearing is None else os.fspath(bearing),
        "angle": in_unit(angle, "deg", "angle"),
        "speed": speed if speed is None or isinstance(speed, str) else str(in_unit(speed, "rpm", "speed")),
        "key_phase": key_phase,
        "pulses": float(pulses),
        "start": in_unit(start, "s", "start"),
        "end": in_unit(end, "s", "end"),
        "speed_tolerance": float(speed_tolerance),
        "slip": float(slip),
    }
    answer, samples, (frequencies, amplitudes) = _native.vibration(request)
    arrays = {"samples": samples, "envelope_hz": frequencies, "envelope": amplitudes}
    return warned(Vibration({"generator": f"tribodyn {_native.VERSION}", "file": name, **answer, **arrays}))


def recover(recording: PathLike, output: PathLike, *, force: bool = False) -> Recovered:
    """Makes a whole recording of one that was cut off or damaged; ``output`` may be the damaged one itself.

    ``force`` replaces a file at ``output`` that tribodyn did not write.
    """
    return Recovered(_native.recover(os.fspath(recording), os.fspath(output), force))


def layout(case: Optional[Case] = None, *, solution: bool = False) -> str:
    """The Foxglove layout (JSON) for viewers of a live run; recordings carry theirs.

    Args:
        case: the bearing that sets the distance of the camera, the rows of balls and the band of the spectra
        solution: for recordings of solutions, not of runs
    """
    return _native.layout(None if case is None else native(case), solution)


def catalogue(pattern: str = "") -> list[Listed]:
    """The bearings of the built-in list, by a part of their designation, or a pattern with ``*`` for any letters."""
    return [Listed(entry) for entry in _native.catalogue(pattern)]
