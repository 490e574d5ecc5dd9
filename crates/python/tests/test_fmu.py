"""The FMU of a case, simulated by FMPy against the solver."""

from __future__ import annotations

import shutil
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tribodyn
from tribodyn import Case, FileError

fmpy = pytest.importorskip("fmpy", reason="FMPy is not installed")
fmi2 = pytest.importorskip("fmpy.fmi2")
validation = pytest.importorskip("fmpy.validation")
needs_compiler = pytest.mark.skipif(shutil.which("cc") is None, reason="there is no C compiler `cc`")

RING = ("displacement_x", "displacement_y", "displacement_z", "tilt_x", "tilt_y")
FORCES = ("force_x", "force_y", "force_z", "moment_x", "moment_y")


def held(case: Case, ring: Any) -> tribodyn.Solution:
    """The solution with the ring held in a place: x, y, z in m, tilts in rad."""
    of = ("ring.x", "ring.y", "ring.z", "ring.tilt_x", "ring.tilt_y")
    units = ("m", "m", "m", "rad", "rad")
    places = {path: f"Held({unit}({float(place)!r}))" for path, unit, place in zip(of, units, ring)}
    return tribodyn.solve(case.replace(places), "jones-harris")


def of_solution(solution: tribodyn.Solution) -> Any:
    """Forces and moments of the bearing on the ring."""
    loads = [getattr(solution, f"ring_load_{axis}_n") for axis in "xyz"]
    return -np.array([*loads, solution.ring_moment_x_nm, solution.ring_moment_y_nm])


def simulated(path: Path, place: Any, kind: str, **options: Any) -> Any:
    """Outputs over time while the ring goes through places, a row each millisecond."""
    steps = len(place)
    rows = [(1e-3 * k, *row) for k, row in enumerate(place)]
    inputs = np.array(rows, dtype=[("time", float)] + [(name, float) for name in RING])
    return fmpy.simulate_fmu(
        str(path),
        fmi_type=kind,
        stop_time=1e-3 * (steps - 1),
        step_size=1e-3,
        output_interval=1e-3,
        input=inputs,
        output=[*FORCES, "cage_speed", "load_inner", "load_outer", "pressure_inner", "pressure_outer"],
        **options,
    )


@needs_compiler
@pytest.mark.parametrize("name", ["angular-7210", "paper-ag", "oil-6206", "bearing-218"])
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_code_fmpy_simulates_what_the_solver_solves(name: str, kind: str, cases: Path, tmp_path: Path) -> None:
    case = Case.read(cases / f"{name}.ron")
    made = tribodyn.fmu(case, tmp_path / "bearing.fmu")
    assert made.platforms == ["linux64"] and made.model_identifier == name.replace("-", "_")
    assert validation.validate_fmu(made.output) == []
    start = np.array([*made.ring_displacement_m, *made.ring_tilt_rad])
    # From the equilibrium of the case along a line that moves all five freedoms.
    away = np.array([8e-6, -5e-6, 6e-6, 1e-4, -8e-5])
    places = [start + share * away for share in np.linspace(0.0, 1.0, 5)]
    found = simulated(Path(made.output), places, kind)
    equilibrium = tribodyn.solve(case, "jones-harris")
    assert np.allclose([*made.force_n, *made.moment_nm], of_solution(equilibrium), rtol=1e-12, atol=1e-9)
    # A step of co-simulation holds its inputs: what comes out at its end belongs to its beginning.
    given = [places[0], *places[:-1]] if kind == "CoSimulation" else places
    for place, row in zip(given, found):
        solution = held(case, place)
        wanted, got = of_solution(solution), np.array([row[name] for name in FORCES])
        size = max(solution.balls.load_inner_n.max(), np.abs(wanted[:3]).max())
        # Moments over a lever of 20 mm, less than any pitch radius here.
        assert np.max(np.abs(got - wanted) / (size * np.array([1.0, 1.0, 1.0, 0.02, 0.02]))) < 1e-6
        assert abs(row["cage_speed"] * 30 / np.pi - solution.cage_speed_rpm) < 1e-6 * abs(solution.cage_speed_rpm)
        for side in ("inner", "outer"):
            pressure = getattr(solution.balls, f"peak_pressure_{side}_pa").max()
            assert abs(row[f"pressure_{side}"] - pressure) < 1e-6 * pressure


@needs_compiler
def test_limit_parameters_and_speeds_are_those_of_another_case(plain: Case, tmp_path: Path) -> None:
    """An FMU with another pitch diameter and speed is the FMU of a case that has them."""
    made = tribodyn.fmu(plain, tmp_path / "bearing.fmu")
    pitch = float(plain["geometry.pitch_diameter"]) * 1.01
    start = [*made.ring_displacement_m, *made.ring_tilt_rad]
    other = plain.replace({"geometry.pitch_diameter": tribodyn.m(pitch), "speed.inner": tribodyn.rad_per_s(500)})
    given = {"pitch_diameter": pitch, "inner_speed": 500.0}
    row = simulated(Path(made.output), [start, start], "CoSimulation", start_values=given)[-1]
    wanted = of_solution(held(other, start))
    assert np.allclose([row[name] for name in FORCES], wanted, rtol=1e-6, atol=1e-6 * np.abs(wanted).max())


@needs_compiler
def test_identity_states_come_back(plain: Case, tmp_path: Path) -> None:
    """A master that takes a step back finds the outputs of before, from memory and from bytes."""
    made = tribodyn.fmu(plain, tmp_path / "bearing.fmu")
    folder = fmpy.extract(made.output)
    try:
        description = fmpy.read_model_description(folder)
        reference = {variable.name: variable.valueReference for variable in description.modelVariables}
        identifier = description.coSimulation.modelIdentifier
        slave = fmi2.FMU2Slave(
            guid=description.guid, unzipDirectory=folder, modelIdentifier=identifier, instanceName="bearing"
        )
        slave.instantiate()
        slave.setupExperiment(startTime=0.0)
        slave.enterInitializationMode()
        slave.exitInitializationMode()
        force = [reference["force_z"]]
        first = slave.getReal(force)
        state = slave.getFMUState()
        bytes_of_it = slave.serializeFMUstate(state)
        slave.setReal([reference["displacement_z"]], [made.ring_displacement_m[2] + 1e-5])
        slave.doStep(0.0, 1e-3)
        assert slave.getReal(force) != first
        slave.setFMUState(state)
        assert slave.getReal(force) == first
        slave.freeFMUState(state)
        slave.setReal([reference["displacement_z"]], [0.0])
        slave.setFMUState(slave.deSerializeFMUstate(bytes_of_it))
        assert slave.getReal(force) == first
        slave.terminate()
        slave.freeInstance()
    finally:
        shutil.rmtree(folder)


def test_identity_fmus_are_those_of_the_command(
    command: Callable[..., Any], plain: Case, cases: Path, tmp_path: Path
) -> None:
    printed = command("fmu", cases / "angular-7210.ron", "-o", tmp_path / "theirs.fmu", "--no-compile", "--json")
    made = tribodyn.fmu(plain, tmp_path / "ours.fmu", compile=False)
    assert {**made.to_dict(), "output": ""} == {**printed, "output": ""}
    assert made.platforms == []
    ours, theirs = (tmp_path / "ours.fmu").read_bytes(), (tmp_path / "theirs.fmu").read_bytes()
    assert ours == theirs
    with zipfile.ZipFile(tmp_path / "ours.fmu") as archive:
        assert archive.testzip() is None
        assert archive.namelist()[0] == "modelDescription.xml" and "sources/model.h" in archive.namelist()


def test_limit_files_of_others_are_not_replaced(plain: Case, tmp_path: Path) -> None:
    path = tmp_path / "bearing.fmu"
    path.write_bytes(b"somebody's")
    with pytest.raises(FileError, match="an FMU"):
        tribodyn.fmu(plain, path, compile=False)
    tribodyn.fmu(plain, path, compile=False, force=True)
    tribodyn.fmu(plain, path, compile=False)
