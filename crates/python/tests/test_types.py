"""Types: a misspelt attribute is refused before a program runs, and when it runs."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
import tribodyn
from tribodyn import Case

from .conftest import CASES, SHORT_S

PACKAGE = Path(__file__).parents[1]

#: Lines that are right, and after them the same with a letter wrong.
RIGHT = """
import tribodyn
case = tribodyn.Case.new("7210", angle=40)
case["ring.z"] = tribodyn.kN(3)
solution = tribodyn.solve(case)
print(solution.cage_speed_rpm + solution.balls.load_inner_n.max() + solution.balls[0].load_inner_n)
print(solution.balls[solution.balls.load_inner_n > 0].contact_angle_inner_deg, solution.power_loss_fluid_w)
recording = tribodyn.read_recording("run.mcap")
print(recording.states.cage_speed_rpm, recording.balls.load_inner_n[:, 0], recording.wear.volume_inner_um3)
print(tribodyn.sweep(case, {}).cage_speed_rpm, tribodyn.rating_life(case).static_safety, case.check().growth)
"""
MISSPELT = [
    ("solution.cage_speed_rpm", "solution.cage_sped_rpm"),
    ("solution.balls.load_inner_n", "solution.balls.load_iner_n"),
    ("solution.balls[0].load_inner_n", "solution.balls[0].load_inner"),
    ("solution.power_loss_fluid_w", "solution.power_los_fluid_w"),
    ("recording.states.cage_speed_rpm", "recording.states.cage_speed"),
    ("recording.balls.load_inner_n", "recording.balls.load_iner_n"),
    ("recording.wear.volume_inner_um3", "recording.wear.volume_inner_m3"),
    (").cage_speed_rpm, tribodyn", ").cage_sped_rpm, tribodyn"),
    (".static_safety", ".static_safty"),
    (".growth", ".grwth"),
    ("tribodyn.kN(3)", "tribodyn.kn(3)"),
    ("tribodyn.solve(case)", "tribodyn.slove(case)"),
]


def test_limit_mypy_refuses_a_misspelt_attribute(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    script = tmp_path / "script.py"
    wrong = [RIGHT.replace(right, misspelt) for right, misspelt in MISSPELT]
    assert all(text != RIGHT for text in wrong)
    files = [script, *(tmp_path / f"misspelt_{place}.py" for place in range(len(wrong)))]
    for file, text in zip(files, [RIGHT, *wrong]):
        file.write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "mypy", "--config-file", "pyproject.toml", "--no-pretty", *map(str, files)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=PACKAGE)
    errors = [line for line in done.stdout.splitlines() if ": error:" in line]
    # A cache may know the same text from another folder.
    assert not [line for line in errors if f"{script.name}:" in line], done.stdout
    for file in files[1:]:
        found = [line for line in errors if f"/{file.name}:" in line]
        assert found and all("attr-defined" in line for line in found), (file.read_text(), done.stdout)


def test_limit_a_misspelt_attribute_is_refused_at_run_time(plain: Case) -> None:
    solution = tribodyn.solve(plain, "jones-harris")
    for thing in (solution, solution.balls, solution.balls[0], plain.check(), tribodyn.rating_life(plain)):
        with pytest.raises(AttributeError, match="no attribute cage_sped_rpm"):
            thing.cage_sped_rpm  # type: ignore[attr-defined]


def test_identity_names_of_an_answer_are_listed_once(plain: Case) -> None:
    solution = tribodyn.solve(plain, "jones-harris")
    run = tribodyn.run(Case.read(CASES / "paper-ag.ron"), SHORT_S, progress=False)
    sweep = tribodyn.sweep(plain, model="jones-harris", progress=False)
    for thing in (solution, solution.balls, solution.balls[0], run, run.data, run.data.states, run.data.balls, sweep):
        names = dir(thing)
        assert len(names) == len(set(names)), type(thing)
    assert {"cage_speed_rpm", "balls"} <= set(dir(solution)) and "shaft_torque_nm" not in dir(solution)
    assert "load_inner_n" in dir(solution.balls) and "cage_speed_rpm" in dir(run.data.states)
    assert "cage_speed_rpm" in dir(sweep)


def test_identity_declared_series_are_those_of_recordings() -> None:
    names, declared = tribodyn._native.recorded_names(), tribodyn._quantities
    assert list(declared.StateArrays.__annotations__) == list(names["states"])
    assert list(declared.SolutionArrays.__annotations__) == list(names["solution"])
    assert list(declared.WornArrays.__annotations__) == list(names["wear"])
    assert list(declared.RecordedBallArrays.__annotations__) == list(names["balls"])


@pytest.mark.parametrize("model", ["steady-orbit", "traction", "jones-harris"])
def test_identity_declared_columns_are_those_of_sweeps(model: str) -> None:
    case = Case.read(CASES / "oil-6206.ron")
    grid = tribodyn._native.Grid.product((case.file, case.text), [("ring.z", ["Force(kN(1))"])], (model, False), False)
    assert set(grid.columns()) - set(grid.swept()) <= set(tribodyn._quantities.SweepColumns.__annotations__)


def test_limit_some_balls_are_taken_by_slices_and_masks(plain: Case) -> None:
    balls = tribodyn.solve(plain, "jones-harris").balls
    assert len(balls[2:5]) == 3 and balls[2:5][0] == balls[2] and balls[-1] == balls[len(balls) - 1]
    hard = balls[balls.load_inner_n > 700]
    assert 0 < len(hard) < len(balls) and (hard.load_inner_n > 700).all()
    assert balls[[1, 3]][1] == balls[3]
