"""Runs in time: their numbers, their recordings, and how they are stopped."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np
import pytest
import tribodyn
from tribodyn import Case, FileError, InputError, Stopped

from .conftest import CASES, SHORT_S


def test_identity_a_run_is_that_of_the_command(
    command: Callable[..., Any], paper: Case, cases: Path, tmp_path: Path
) -> None:
    printed = command("run", cases / "paper-ag.ron", "-o", tmp_path / "a.mcap", "--duration", SHORT_S, "-q", "--json")
    answer = tribodyn.run(paper, SHORT_S, record=tmp_path / "b.mcap", progress=False)
    ours = answer.to_dict()
    for name, value in printed.items():
        if name not in ("recording", "wall_s", "simulated_per_wall"):
            assert ours[name] == value, name
    declared = {name for name in get_type_hints(tribodyn.Run) if not name.startswith("_")}
    assert {name for name in vars(answer) if not name.startswith("_")} == declared
    theirs, own = (tribodyn.read_recording(tmp_path / name) for name in ("a.mcap", "b.mcap"))
    assert np.array_equal(theirs.states.values, own.states.values)
    assert np.array_equal(theirs.balls.load_inner_n, own.balls.load_inner_n)
    assert own.case == paper.replace({"transient.duration": f"s({SHORT_S})"}) and own.whole


def test_limit_time_series_are_views(paper: Case) -> None:
    answer = tribodyn.run(paper, SHORT_S, progress=False)
    assert answer.recording is None
    states, balls = answer.data.states, answer.data.balls
    assert np.shares_memory(states.cage_speed_rpm, states.values) and len(states) == answer.samples
    assert np.shares_memory(balls.load_inner_n, balls.load_outer_n.base)
    assert states.time_s[-1] == pytest.approx(SHORT_S, rel=0.1)
    frame = answer.to_pandas()
    assert np.shares_memory(frame["cage_speed_rpm"].to_numpy(), states.values) or len(frame) == len(states)
    assert answer.to_xarray()["cage_speed_rpm"].dims == ("time_s",)
    assert balls.to_xarray().sizes["ball"] == balls.load_inner_n.shape[1]
    assert len(balls.to_pandas()) == balls.load_inner_n.size
    with pytest.raises(KeyError, match="cage_speed_rpm"):
        states["nothing"]
    with pytest.raises(AttributeError):
        states.nothing
    assert "states" in answer.data._repr_html_()


@pytest.mark.alone
def test_limit_progress_is_told_and_other_threads_go_on(paper: Case) -> None:
    told: list[tuple[float, float]] = []
    turns, done = [0], threading.Event()

    def turn() -> None:
        while not done.wait(0.001):
            turns[0] += 1

    thread = threading.Thread(target=turn)
    thread.start()
    began = time.perf_counter()
    tribodyn.run(paper, 20 * SHORT_S, progress=lambda reached, whole: told.append((reached, whole)))
    elapsed = time.perf_counter() - began
    done.set()
    thread.join()
    assert told and all(whole == 20 * SHORT_S for _, whole in told)
    assert [reached for reached, _ in told] == sorted(reached for reached, _ in told)
    # With the interpreter locked the thread would have had no turn.
    assert turns[0] > 50 * elapsed, (turns, elapsed)


@pytest.mark.alone
def test_limit_an_interrupt_stops_a_run_and_it_goes_on(tmp_path: Path) -> None:
    """Ctrl-C in a process of its own; then the recording is that of a run that was never stopped."""
    program = textwrap.dedent(
        f"""
        import signal
        import tribodyn
        # As it is unless these tests were started with interrupts ignored, in the background of a script.
        signal.signal(signal.SIGINT, signal.default_int_handler)
        case = tribodyn.Case.read({str(CASES / "paper-ag.ron")!r})
        try:
            print("begun", flush=True)
            tribodyn.run(case, 0.2, record={str(tmp_path / "run.mcap")!r}, progress=False)
        except tribodyn.Stopped as stopped:
            print("stopped", 0 < stopped.simulated_s < stopped.duration_s == 0.2, flush=True)
        """
    )
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True)
    assert process.stdout is not None and process.stdout.readline() == "begun\n"
    time.sleep(1.0)
    process.send_signal(signal.SIGINT)
    began = time.monotonic()
    assert process.communicate(timeout=60)[0] == "stopped True\n"
    assert process.returncode == 0 and time.monotonic() - began < 10


def test_identity_a_stopped_run_goes_on_where_it_was(paper: Case, tmp_path: Path) -> None:
    def stop(reached: float, whole: float) -> None:
        if reached > 0.2 * whole:
            raise KeyboardInterrupt

    path = tmp_path / "run.mcap"
    with pytest.raises(Stopped) as caught:
        tribodyn.run(paper, 40 * SHORT_S, record=path, progress=stop)
    assert caught.value.recording == str(path) and isinstance(caught.value, KeyboardInterrupt)
    with pytest.raises(InputError, match="not finished"):
        tribodyn.run(paper, 40 * SHORT_S, record=path, progress=False)
    resumed = tribodyn.run(paper, 40 * SHORT_S, record=path, resume=True, progress=False)
    straight = tribodyn.run(paper, 40 * SHORT_S, progress=False)
    assert np.array_equal(resumed.data.states.values, straight.data.states.values)
    assert resumed.power == straight.power


def test_limit_what_cannot_be_run_is_refused(paper: Case, plain: Case, tmp_path: Path) -> None:
    with pytest.raises(InputError):
        tribodyn.run(paper, -1.0)
    with pytest.raises(InputError):
        tribodyn.run(paper, float("nan"))
    with pytest.raises(InputError):
        tribodyn.run(paper, resume=True)
    with pytest.raises(InputError):
        tribodyn.run(paper, SHORT_S, record=tmp_path / "a.mcap", resume=True)
    with pytest.raises(FileError):
        tribodyn.run(paper, SHORT_S, record=tmp_path / "no" / "such" / "folder" / "a.mcap")
    with pytest.raises(FileError) as caught:
        tribodyn.read_recording(tmp_path / "absent.mcap")
    assert caught.value.file == str(tmp_path / "absent.mcap")
    (tmp_path / "text.mcap").write_text("no recording")
    with pytest.raises(FileError):
        tribodyn.read_recording(tmp_path / "text.mcap")
    assert not [name for name in os.listdir(tmp_path) if name.startswith("a.mcap") and name != "a.mcap.lock"]


def test_identity_an_identification_is_that_of_the_command(command: Callable[..., Any], tmp_path: Path) -> None:
    problem = tmp_path / "problem.ron"
    (tmp_path / "case.ron").write_text((CASES / "paper-handset.ron").read_text())
    problem.write_text(PROBLEM)
    told: list[float] = []
    answers = tribodyn.identify(problem, progress=lambda done, starts: told.append(starts))
    printed = command("identify", problem, "--json")
    assert [answer.to_dict() for answer in answers] == printed
    assert list(answers[0].to_pandas()["name"]) == ["axial load"] and "axial load" in answers[0]._repr_html_()
    assert all(starts == 2.0 for starts in told)
    problem.write_text(PROBLEM.replace("bounds", "limits"))
    with pytest.raises(InputError) as caught:
        tribodyn.identify(problem)
    assert caught.value.line is not None and caught.value.file == str(problem)


#: The axial load by its effect on the peak pressure.
PROBLEM = """(
    name: "axial load",
    case: "case.ron",
    seed: 1,
    starts: 2,
    parameters: [(name: "axial load", paths: ["ring.z.Force.kN"], bounds: (25, 70))],
    runs: {"qsjh": (model: JonesHarris)},
    data: [(id: "p", run: "qsjh", quantity: PeakPressureInner(azimuth: 0), value: 2.46, uncertainty: 0.01)],
)
"""
