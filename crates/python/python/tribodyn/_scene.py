"""The bearing of a recording as it moves, in three dimensions, by K3D."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._errors import InputError

if TYPE_CHECKING:
    from .runs import Recording

#: From grey over blue and yellow to red, by pressure in GPa up to where steel yields.
_COLOURS = (
    (0.0, (158, 166, 173)),
    (1.0, (64, 140, 217)),
    (2.0, (242, 204, 64)),
    (3.0, (230, 102, 38)),
    (4.2, (191, 20, 26)),
)
#: Half width of a ring and its depth beyond the pitch circle, its shoulders, over the ball diameter.
_HALF, _DEPTH, _SHOULDER = 0.62, 0.85, 0.28
#: Part of the outer ring that is drawn, so that the balls are to be seen.
_OPEN = (-0.42 * np.pi, 0.92 * np.pi)
#: Length of the largest contact force over the ball diameter.
_LONGEST = 1.4
_RING = 0x8C949E
_FORCE = 0xD93326

#: Points by axis, for each time.
Points = list[NDArray[np.float32]]


def scene(recording: Recording, frames: int) -> Any:
    """A plot of K3D with the rings, the balls coloured by pressure, and the forces of the races on them."""
    try:
        k3d = importlib.import_module("k3d")
    except ImportError as error:
        allowed = "pip install 'tribodyn[scene]'"
        raise InputError(f"K3D is not installed: {allowed}", path="frames", allowed=allowed) from error
    if not frames > 0:
        allowed = "allowed is a number of 1 or more"
        raise InputError(f"frames = {frames}: {allowed}", path="frames", value=str(frames), allowed=allowed)
    facts = recording.metadata.get("simulation", {})
    names = ("ball_diameter_mm", "pitch_diameter_mm", "inner_groove_coefficient", "outer_groove_coefficient")
    missing = [name for name in names if name not in facts]
    if missing or not len(recording.balls):
        allowed = "allowed is a recording that describes its bearing"
        what = missing[0] if missing else "states of the balls"
        raise InputError(f"{recording.path}: no {what}; {allowed}", file=recording.path, path=what, allowed=allowed)
    ball, pitch, inner, outer = (float(facts[name]) for name in names)
    times = recording.balls.time_s
    places = np.unique(np.linspace(0, len(times) - 1, min(frames, len(times))).astype(int))
    plot = k3d.plot(grid_visible=False, camera_auto_fit=True, name=facts.get("bearing", "bearing"))
    for groove, sign, turn in ((inner, -1.0, (0.0, 2.0 * np.pi)), (outer, 1.0, _OPEN)):
        vertices, triangles = _ring(ball, 0.5 * pitch, groove, sign, turn)
        name = "outer ring" if sign > 0 else "inner ring"
        plot += k3d.mesh(vertices, triangles, color=_RING, side="double", opacity=0.7, name=name)
    centres, rods = _motion(recording, ball, places)
    keys = [f"{times[place]:.9g}" for place in places]
    coloured = dict(zip(keys, _coloured(recording, places)))
    plot += k3d.points(
        dict(zip(keys, centres)), colors=coloured, point_size=ball, shader="mesh", mesh_detail=4, name="balls"
    )
    ends = np.arange(len(rods[0]), dtype=np.uint32).reshape(-1, 2)
    plot += k3d.lines(
        dict(zip(keys, rods)),
        ends,
        indices_type="segment",
        shader="mesh",
        width=0.06 * ball,
        color=_FORCE,
        name="contact forces",
    )
    return plot


def _motion(recording: Recording, ball: float, places: NDArray[np.intp]) -> tuple[Points, Points]:
    """For each time the centres of the balls, and the two ends of the rods that stand for the forces of the inner, then
    of the outer race, mm: each rod ends at its contact."""
    balls = recording.balls
    largest = max(float(balls.load_inner_n.max()), float(balls.load_outer_n.max()), 1e-9)
    axial = np.array([0.0, 0.0, 1.0])
    centres, rods = [], []
    for place in places:
        azimuth = np.radians(balls.azimuth_deg[place])
        outwards = np.stack([np.cos(azimuth), np.sin(azimuth), np.zeros_like(azimuth)], axis=1)
        centre = balls.orbit_radius_mm[place][:, None] * outwards
        centre = centre + 1e-3 * balls.axial_displacement_um[place][:, None] * axial
        ends = []
        for side, sign in (("inner", -1.0), ("outer", 1.0)):
            angle = np.radians(balls[f"contact_angle_{side}_deg"][place])[:, None]
            along = sign * (np.cos(angle) * outwards + np.sin(angle) * axial)
            length = _LONGEST * ball * balls[f"load_{side}_n"][place][:, None] / largest
            contact = centre + 0.5 * ball * along
            ends.append(np.stack([contact, contact + length * along], axis=1).reshape(-1, 3))
        centres.append(centre.astype(np.float32))
        rods.append(np.concatenate(ends).astype(np.float32))
    return centres, rods


def _coloured(recording: Recording, places: NDArray[np.intp]) -> list[NDArray[np.uint32]]:
    """Colours of the balls by their larger peak pressure, for each time."""
    balls = recording.balls
    gpa = np.maximum(balls.peak_pressure_inner_gpa[places], balls.peak_pressure_outer_gpa[places])
    steps = [step for step, _ in _COLOURS]
    parts = [np.interp(gpa, steps, [rgb[k] for _, rgb in _COLOURS]).astype(np.uint32) for k in range(3)]
    return list((parts[0] << 16) + (parts[1] << 8) + parts[2])


def _ring(
    ball: float, radius: float, groove: float, sign: float, turn: tuple[float, float]
) -> tuple[NDArray[np.float32], NDArray[np.uint32]]:
    """A ring between its race and a cylinder: vertices (mm) and triangles."""
    z = np.linspace(-_HALF, _HALF, 25) * ball
    depth = np.sqrt(np.maximum((groove * ball) ** 2 - z**2, 0.0)) - (groove - 0.5) * ball
    race = radius + sign * np.maximum(depth, _SHOULDER * ball)
    profile = np.concatenate(
        [np.stack([race, z], axis=1), np.stack([np.full_like(z, radius + sign * _DEPTH * ball), z[::-1]], axis=1)]
    )
    angles = np.linspace(*turn, 97)
    around = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    vertices = np.empty((len(angles), len(profile), 3))
    vertices[:, :, :2] = profile[None, :, :1] * around[:, None, :]
    vertices[:, :, 2] = profile[None, :, 1]
    rows, columns = np.meshgrid(np.arange(len(angles) - 1), np.arange(len(profile)), indexing="ij")
    following = (columns + 1) % len(profile)
    a, b = rows * len(profile) + columns, rows * len(profile) + following
    c, d = a + len(profile), b + len(profile)
    triangles = np.concatenate([np.stack([a, b, d], axis=-1), np.stack([a, d, c], axis=-1)]).reshape(-1, 3)
    return vertices.reshape(-1, 3).astype(np.float32), triangles.astype(np.uint32)
