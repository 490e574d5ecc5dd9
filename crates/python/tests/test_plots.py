"""Pictures: every answer draws itself into axes of matplotlib, and shows itself with a figure in notebooks."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tribodyn
from tribodyn import InputError

from .conftest import ROOT, SHORT_S
from .test_pickles import MAKERS, _oil, _plain, _worn

matplotlib = pytest.importorskip("matplotlib")

#: What has no numbers to draw.
UNDRAWN = {"case", "unit"}
MORE: dict[str, Any] = {
    "pair": lambda: tribodyn.pair(_plain(), "DB", 20, offset=10, model="jones-harris"),
    "set": lambda: tribodyn.bearing_set(_plain(), "DB", preload=200),
    "sheet": lambda: tribodyn.sheet(_plain(), radial=1000, axial=800, speed=3000),
    "shaft": lambda: tribodyn.shaft(ROOT / "fixtures" / "shafts" / "motor.ron"),
    "film": lambda: tribodyn.film(_oil(), "traction"),
    "torque": lambda: tribodyn.torque(_oil()),
    "listed": lambda: tribodyn.catalogue("6206")[0],
    "ensemble": lambda: tribodyn.ensemble(
        _worn(), {"cage.pocket_gap": "mm(0.71 ± 0.02)"}, 2, duration=SHORT_S, progress=False
    ),
}


@pytest.fixture(autouse=True)
def unseen() -> Any:
    from matplotlib import pyplot

    matplotlib.use("Agg")
    yield
    pyplot.close("all")


@pytest.mark.parametrize("kind", [*sorted(MAKERS.keys() - UNDRAWN), *MORE])
def test_limit_an_answer_draws_itself(kind: str) -> None:
    from matplotlib import pyplot

    answer = {**MAKERS, **MORE}[kind]()
    drawn = answer.plot()
    assert isinstance(drawn, matplotlib.axes.Axes)
    assert drawn.lines or drawn.patches or drawn.images or drawn.containers, kind
    given = pyplot.figure().add_subplot()
    assert answer.plot(ax=given) is given
    if kind != "ball":
        assert "<svg" in answer._repr_html_()


def test_identity_lines_hold_the_numbers_of_the_answer() -> None:
    solution = tribodyn.solve(_plain(), "jones-harris")
    line = solution.plot("contact_angle_inner_deg").lines[0]
    assert np.array_equal(line.get_ydata(), solution.balls.contact_angle_inner_deg)
    assert np.array_equal(line.get_xdata(), solution.balls.azimuth_deg)
    with pytest.raises(InputError, match="load_inner_n"):
        solution.plot("load_iner_n")


def test_limit_a_notebook_leaves_no_figure_open(tmp_path: Path) -> None:
    from matplotlib import pyplot

    rating = tribodyn.rating_life(_plain(), "jones-harris")
    assert rating._repr_html_() == rating._repr_html_() and not pyplot.get_fignums()


def test_identity_a_scene_has_the_balls_where_the_recording_has_them() -> None:
    pytest.importorskip("k3d")
    run = tribodyn.run(tribodyn.Case.read(ROOT / "fixtures" / "cases" / "paper-ag.ron"), SHORT_S, progress=False)
    scene = run.data.scene(frames=3)
    rings, balls, rods = scene.objects[:2], scene.objects[2], scene.objects[3]
    recorded = run.data.balls
    shown = recorded.time_s[[0, (len(recorded) - 1) // 2, -1]].tolist()
    assert [float(time) for time in balls.positions] == pytest.approx(shown, rel=1e-6)
    last = list(balls.positions.values())[-1]
    assert np.hypot(last[:, 0], last[:, 1]) == pytest.approx(recorded.orbit_radius_mm[-1], rel=1e-6)
    angles = np.degrees(np.arctan2(last[:, 1], last[:, 0])) % 360.0
    assert angles == pytest.approx(recorded.azimuth_deg[-1], abs=1e-3)
    # A rod begins where a ball touches its race, half a diameter from its centre, and is as long as the force.
    begun, ended = list(rods.vertices.values())[-1].reshape(-1, 2, 3).transpose(1, 0, 2)
    diameter = float(run.data.metadata["simulation"]["ball_diameter_mm"])
    assert np.linalg.norm(begun - np.concatenate([last, last]), axis=1) == pytest.approx(diameter / 2, rel=1e-4)
    loads = np.concatenate([recorded.load_inner_n[-1], recorded.load_outer_n[-1]])
    lengths = np.linalg.norm(ended - begun, axis=1)
    assert lengths / lengths.max() == pytest.approx(loads / loads.max(), abs=1e-4)
    # Rings stay outside of the balls, and hold them.
    inner, outer = (np.hypot(ring.vertices[:, 0], ring.vertices[:, 1]) for ring in rings)
    assert inner.max() < recorded.orbit_radius_mm[-1].mean() < outer.min()
    assert "<html" in scene.get_snapshot().lower()
    with pytest.raises(InputError, match="1 or more"):
        run.data.scene(frames=0)
