"""Answers: those of the command, number by number."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np
import pytest
import tribodyn
from tribodyn import Case, InputError, SolveError


@pytest.mark.parametrize("model", ["jones-harris", "traction", "steady-orbit"])
def test_identity_solutions_are_those_of_the_command(command: Callable[..., Any], cases: Path, model: Any) -> None:
    file = cases / "paper-ag.ron"
    printed = command("solve", file, "--model", model, "--json")
    assert tribodyn.solve(Case.read(file), model).to_dict() == printed


def test_identity_a_steady_orbit_is_that_of_the_command(command: Callable[..., Any], cases: Path) -> None:
    file = cases / "angular-7210.ron"
    solution = tribodyn.solve(Case.read(file), "steady-orbit")
    # What goes without saying.
    assert solution.to_dict() == command("solve", file, "--json") == tribodyn.solve(Case.read(file)).to_dict()
    assert solution.points is not None and len(solution.points) > 100


def test_identity_other_answers_are_those_of_the_command(command: Callable[..., Any], cases: Path) -> None:
    file = cases / "bearing-218.ron"
    case = Case.read(file)
    assert tribodyn.rating_life(case).to_dict() == command("rating", file, "--json")
    assert case.check().to_dict() == command("check", file, "--json")
    printed = command("stiffness", file, "--model", "jones-harris", "--speeds", "1000,5000", "--json")
    stiffness = tribodyn.stiffness(case, "jones-harris", speeds=[1000, 5000])
    assert np.array_equal(stiffness.stiffness, [answer["stiffness"] for answer in printed])
    printed = command("hertz", "--body1", "6.35,6.35", "--body2", "inf,inf", "--load", 100, "--json")
    assert tribodyn.hertz((6.35, 6.35), (math.inf, math.inf), 100).to_dict() == printed
    given = ("--body1", "5,inf", "--body2", "25,inf", "--length", 12, "--load", 4000, "--json")
    line = tribodyn.hertz((5, math.inf), (25, math.inf), 4000, length=12)
    assert line.to_dict() == command("hertz", *given) and isinstance(line, tribodyn.LineContact)
    with pytest.raises(InputError, match="length"):
        tribodyn.hertz((5, math.inf), (25, math.inf), 4000)
    printed = command("traction", "--coating", "ptfe", "--pressure", 2.5, "--slip", "0,1,3,10", "--json")
    curve = tribodyn.traction_curve("ptfe", 2.5, [0, 1, 3, 10])
    assert list(curve.coefficient) == printed["coefficient"] and curve.peak_slip == printed["peak_slip"]


def test_identity_modes_and_lives_are_those_of_the_command(command: Callable[..., Any], cases: Path) -> None:
    file = cases / "paper-ag-worn.ron"
    case = Case.read(file)
    modes = tribodyn.modes(case, up_to=5000)
    printed = command("modes", file, "--up-to", 5000, "--json")
    assert modes.to_dict() == printed
    assert len(modes.to_pandas()) == len(printed["modes"])
    life = tribodyn.life(case, strides=3, progress=False)
    assert life.to_dict() == command("life", file, "--strides", 3, "--json")
    assert list(life.to_pandas()["time_h"])[0] == 0.0
    acting = tribodyn.acting_life(case, ["clearance", "traction"], "traction", strides=3, until=1e-3, progress=False)
    options = ("--acting", "clearance,traction", "--model", "traction", "--strides", 3, "--until", 1e-3, "--json")
    assert acting.to_dict() == command("life", file, *options)
    heat = ("--flow", 1, "--power", 181e3, "--json")
    assert case.check(flow=1, power=181e3).to_dict() == command("check", file, *heat)


def test_identity_frames_hold_the_numbers_of_the_balls(paper: Case) -> None:
    solution = tribodyn.solve(paper)
    frame = solution.to_pandas()
    assert list(frame["load_inner_n"]) == [ball.load_inner_n for ball in solution.balls]
    assert frame.attrs["cage_speed_rpm"] == solution.cage_speed_rpm
    data = solution.to_xarray()
    assert data["load_inner_n"].attrs["units"] == "N" and data.sizes["azimuth_deg"] == len(solution.balls)
    assert np.array_equal(data["load_inner_n"].values, solution.balls.load_inner_n)


def test_identity_columns_are_views_of_one_table(paper: Case) -> None:
    balls = tribodyn.solve(paper).balls
    assert np.shares_memory(balls.load_inner_n, balls.values)
    assert np.shares_memory(balls.to_pandas()["load_inner_n"].to_numpy(), balls.values)


def test_limit_what_a_model_does_not_have_is_absent(paper: Case) -> None:
    solution = tribodyn.solve(paper, "jones-harris")
    assert not hasattr(solution, "shaft_torque_nm") and not hasattr(solution.balls, "traction_inner_n")
    with pytest.raises(AttributeError, match="model does not give it"):
        solution.balls.traction_inner_n
    with pytest.raises(AttributeError, match="model does not give it"):
        solution.balls[0].traction_inner_n
    with pytest.raises(AttributeError, match="no attribute colour"):
        solution.balls.colour  # type: ignore[attr-defined]
    with pytest.raises(IndexError):
        solution.balls[99]


def test_identity_attributes_are_the_table_of_quantities() -> None:
    table = tribodyn._native.quantities()
    quantities = tribodyn._quantities
    bearing, ball = ({row["name"] for row in table[group]} for group in ("bearing", "ball"))
    assert set(quantities.BearingQuantities.__annotations__) == bearing
    assert set(quantities.BallQuantities.__annotations__) == ball == set(quantities.BallArrays.__annotations__)


def test_identity_quantities_are_those_of_the_page(cases: Path) -> None:
    """Names and units of every row of docs/quantities.md, of results and of recordings."""
    rows = tribodyn._native.quantities()
    known = {(row["name"], row["unit"]) for group in rows.values() for row in group}
    page = (cases.parents[1] / "docs" / "quantities.md").read_text(encoding="utf-8")
    named: set[tuple[str, str]] = set()
    for line in page.split("## Powers of a run")[0].splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) < 6 or not cells[2].startswith("`"):
            continue
        name, _, unit = cells[2].partition(",")
        for race in ("inner", "outer") if "…" in name else ("",):
            named.add((name.strip("`").replace("…", race), unit.strip()))
    assert named == known


@pytest.mark.parametrize("model", ["jones-harris", "traction", "steady-orbit"])
def test_identity_attributes_of_answers_are_declared(plain: Case, model: Any) -> None:
    solution = tribodyn.solve(plain, model)
    declared = set(get_type_hints(tribodyn.Solution))
    assert {name for name in vars(solution) if not name.startswith("_")} <= declared


def test_identity_attributes_of_other_answers_are_declared(cases: Path) -> None:
    worn = Case.read(cases / "paper-ag-worn.ron")
    modes = tribodyn.modes(worn, up_to=1000)
    answers = [worn.check(), tribodyn.rating_life(worn), tribodyn.hertz((5, 5), (5, 5), 1), modes, modes.modes[0]]
    answers += [tribodyn.traction_curve("ag", 2, [1]), tribodyn.life(worn, strides=1, progress=False)]
    for answer in answers:
        declared = {name for name in get_type_hints(type(answer)) if not name.startswith("_")}
        found = {name for name in vars(answer) if not name.startswith("_")}
        # What a case without fits, growth, a heated flow, a churning cage and grease does not have.
        absent = {"growth", "fits", "heated_flow", "cage_churning_nm"}
        absent |= {"grease_life_hours", "grease_interval_hours", "grease_note", "inner_tilt", "outer_tilt"}
        assert declared - absent <= found <= declared, type(answer)


def test_limit_stiffness_goes_to_rotor_programs(plain: Case) -> None:
    stiffness = tribodyn.stiffness(plain, "jones-harris", speeds=[9000, 3000])
    arguments = stiffness.to_ross(3)
    assert list(arguments["speed"]) == sorted(arguments["speed"]) and "frequency" not in arguments
    assert list(stiffness.to_ross(2)["frequency"]) == list(arguments["speed"])
    assert arguments["kxx"][1] == stiffness.stiffness[0, 0, 0] and stiffness.matrix.shape == (5, 5)
    assert list(stiffness.to_pandas().columns)[:2] == ["k_x_x", "k_x_y"]
    assert float(stiffness.to_xarray().sel(force="x", displacement="x")[0]) == stiffness.matrix[0, 0]
    inverse = stiffness.stiffness @ stiffness.compliance
    assert np.allclose(inverse, np.eye(5), atol=1e-6)


def test_code_ross_builds_a_bearing_element(plain: Case) -> None:
    """The element of the version that is installed has our stiffness at our speeds, and takes them as speeds."""
    ross = pytest.importorskip("ross")
    stiffness = tribodyn.stiffness(plain, "jones-harris", speeds=[3000, 6000, 9000])
    arguments = stiffness.to_ross()
    element = ross.BearingElement(n=0, **arguments)
    damped = ross.BearingElement(n=0, **stiffness.to_ross(damping=1.25e-5))
    speeds = stiffness.inner_speed_rpm * np.pi / 30.0
    for speed, matrix in zip(speeds, stiffness.stiffness):
        assert np.allclose(np.asarray(element.K(speed))[:2, :2], matrix[:2, :2], rtol=1e-6, atol=1.0)
        assert np.all(np.asarray(element.C(speed)) == 0.0)
        lost = 1.25e-5 * matrix[:2, :2]
        assert np.allclose(np.asarray(damped.C(speed))[:2, :2], lost, rtol=1e-6, atol=1e-5)


def test_code_ross_reads_the_bearings_of_a_shaft(command: Callable[..., Any], cases: Path, tmp_path: Path) -> None:
    """The table of a shaft's bearings makes elements with the stiffness of the answer, to the printed digits."""
    ross = pytest.importorskip("ross")
    import pandas

    motor, table = cases.parent / "shafts" / "motor.ron", tmp_path / "ross.csv"
    command("shaft", motor, "--modes", "1000,3000", "--ross", table, "--json")
    frame = pandas.read_csv(table)
    speed_name = "speed" if int(ross.__version__.split(".")[0]) >= 3 else "frequency"
    for bearing in range(2):
        rows = frame[frame["bearing"] == bearing]
        columns = {name: rows[name].to_numpy() for name in ("kxx", "kxy", "kyx", "kyy", "kzz", "cxx", "cyy")}
        columns[speed_name] = rows["speed"].to_numpy()
        element = ross.BearingElement(n=int(rows["node"].iloc[0]), **columns)
        for rpm in (1000.0, 3000.0):
            answer = tribodyn.shaft(motor, {"speed": f"rpm({rpm})"}).duties[0].shaft.bearings[bearing]
            ours = np.asarray(answer.stiffness)
            found = np.asarray(element.K(rpm * np.pi / 30.0))
            assert np.allclose(found[:2, :2], ours[:2, :2], rtol=1e-9, atol=1e-3)
            assert np.isclose(found[2, 2], ours[2, 2], rtol=1e-9)


def test_identity_fits_take_from_the_clearance() -> None:
    """k5 on the shaft and J6 in the housing, by ISO 286 and ISO 492."""
    checked = Case.new("6206", shaft_fit="k5", housing_fit="J6").check()
    inner, outer = checked.fits.seats
    assert (inner.seat_class, outer.seat_class, inner.ring_class) == ("k5", "J6", "Normal")
    assert np.allclose(np.asarray(inner.interference_m)[[0, 2, 4]], [2e-6, 11.5e-6, 21e-6], rtol=1e-9)
    assert checked.fits.radial_clearance_mounted_m[2] == checked.growth.radial_clearance_mounted_m
    with pytest.raises(InputError, match="such as k5"):
        Case.new("6206", shaft_fit="zz9")


def test_identity_a_set_over_speed_and_temperature() -> None:
    case = Case.new("7012C", shaft_fit="js4")
    found = tribodyn.bearing_set(case, "DB", preload=300, speeds=[0, 8000], warmer=[0, 10], loads=[0])
    assert [(point.speed_rpm, point.warmer_k) for point in found.map] == [(0, 0), (8000, 0), (0, 10), (8000, 10)]
    assert found.map[2].preload_n > found.map[0].preload_n


def test_identity_damping_for_rotor_programs_is_that_of_the_modes(cases: Path) -> None:
    """A mass on the spring and the dashpot of an axis has frequency and damping of the mode that they are from."""
    case = Case.read(cases / "paper-ag-worn.ron")
    stiffness, modes = tribodyn.stiffness(case), tribodyn.modes(case, up_to=5000)
    arguments = stiffness.to_ross(3, damping=modes)
    for name in "xyz":
        k, c = arguments[f"k{name}{name}"][0], arguments[f"c{name}{name}"][0]
        # λ² m + λ c + k = 0 of the mass that has the modulus of the mode's eigenvalue.
        eigenvalues = [complex(mode.growth_rate_per_s, 2 * np.pi * mode.frequency_hz) for mode in modes.modes]
        rests = [abs(v**2 * k / abs(v) ** 2 + v * c + k) / k for v in eigenvalues if v.imag > 0]
        assert min(rests) < 1e-9, name
    assert arguments["cxy"][0] == pytest.approx(
        np.sqrt(arguments["cxx"] * arguments["cyy"] / (arguments["kxx"] * arguments["kyy"]))[0] * arguments["kxy"][0]
    )
    each = stiffness.to_ross(3, damping=[modes])
    assert all(np.array_equal(each[name], arguments[name]) for name in arguments)
    for bad in (-1.0, float("nan"), [modes, modes]):
        with pytest.raises(InputError, match="allowed"):
            stiffness.to_ross(3, damping=bad)


def test_limit_tilts_that_rotor_programs_do_not_have_are_told(plain: Case) -> None:
    stiffness = tribodyn.stiffness(plain, "jones-harris")
    with pytest.warns(tribodyn.ModelWarning, match="kxx by") as caught:
        stiffness.to_ross(3)
    messages = [str(warning.message) for warning in caught]
    said = float(next(m for m in messages if "kxx by" in m).split("kxx by ")[1].split(" %")[0])
    compliance = np.linalg.inv(stiffness.matrix)
    freed = np.linalg.inv(compliance[:3, :3])
    assert said == round(100 * (1 - freed[0, 0] / stiffness.matrix[0, 0]))


def test_limit_bad_questions_are_refused(paper: Case, plain: Case) -> None:
    with pytest.raises(InputError, match="jones-harris, traction, steady-orbit"):
        tribodyn.solve(paper, "newton")  # type: ignore[arg-type]
    with pytest.raises(InputError, match="roots"):
        tribodyn.solve(paper, "steady-orbit", roots=True)
    with pytest.raises(InputError, match="finite speeds"):
        tribodyn.stiffness(plain, speeds=[float("nan")])
    with pytest.raises(InputError, match="above 0 Hz"):
        tribodyn.modes(plain, up_to=-1)
    with pytest.raises(InputError, match="ag"):
        tribodyn.traction_curve("gold", 2.0, [1.0])
    for radii in ((0.0, 1.0), (float("nan"), 1.0)):
        with pytest.raises(InputError, match="body1"):
            tribodyn.hertz(radii, (1.0, 1.0), 10)
    with pytest.raises(InputError, match="load"):
        tribodyn.hertz((1.0, 1.0), (1.0, 1.0), -10)
    with pytest.raises(InputError, match="strides"):
        tribodyn.life(paper, strides=0)
    with pytest.raises((TypeError, ValueError)):
        tribodyn.hertz((1.0,), (1.0, 1.0), 10)


def test_limit_arguments_of_another_kind_are_named(plain: Case) -> None:
    other: Any = "7210B.ron"
    text: Any = "3000"
    bad: dict[str, Callable[[], Any]] = {
        "case": lambda: tribodyn.solve(other),
        "speeds": lambda: tribodyn.stiffness(plain, "jones-harris", speeds=text),
        "modes": lambda: tribodyn.shaft("shaft.ron", modes=text),
        "loads": lambda: tribodyn.bearing_set(plain, "DB", preload=200, loads=text),
        "offset": lambda: tribodyn.pair(plain, "DB", 60, offset=text),
        "duration": lambda: tribodyn.run(plain, duration=text),
        "ring.z.Force": lambda: tribodyn.sobol({"ring.z.Force": ("N", (3, 2))}, 4, seed=1),
    }
    for name, question in bad.items():
        with pytest.raises(InputError, match="allowed") as caught:
            question()
        assert caught.value.path == name


def test_limit_bearings_in_tandem_have_no_preload(plain: Case) -> None:
    with pytest.raises(InputError, match="same way"):
        tribodyn.bearing_set(plain, "DT", preload=500)
    with pytest.raises(InputError, match="one of preload, offset and spring"):
        tribodyn.bearing_set(plain, "DB")
    assert tribodyn.bearing_set(plain, "DT", loads=1000).states[0].displacement_m > 0.0


def test_limit_an_equilibrium_that_is_not_found_says_how_far_it_came(paper: Case) -> None:
    hard = paper.replace({"numerics.max_iterations": 1})
    with pytest.raises(SolveError) as caught:
        tribodyn.solve(hard, "traction")
    assert caught.value.residual is not None and caught.value.residual > 0
    assert caught.value.iterations is not None and isinstance(caught.value, RuntimeError)


def test_limit_notebooks_show_answers(paper: Case) -> None:
    solution = tribodyn.solve(paper)
    page = solution._repr_html_()
    assert "<svg" in page and "cage_speed_rpm" in page and "load_inner_n" in page
    assert all(figure.count("<svg") == 1 for figure in solution.figures().values()) and len(solution.figures()) > 5
    assert "k_x" in tribodyn.stiffness(paper, "traction").to_pandas().columns[0]
    assert "Rating" in tribodyn.rating_life(paper, "traction")._repr_html_()
