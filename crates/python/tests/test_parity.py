"""What the command does, Python does, with the same numbers."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tribodyn
from tribodyn import Case, FileError, InputError

from .conftest import ROOT, SHORT_S

#: Each command of the program: the function that answers it.
FUNCTIONS = {
    "new": "Case.new",
    "catalogue": "catalogue",
    "check": "check",
    "hertz": "hertz",
    "traction": "traction_curve",
    "solve": "solve",
    "stiffness": "stiffness",
    "modes": "modes",
    "pair": "pair",
    "sheet": "sheet",
    "set": "bearing_set",
    "shaft": "shaft",
    "run": "run",
    "ensemble": "ensemble",
    "dataset": "dataset",
    "life": "life",
    "film": "film",
    "fmu": "fmu",
    "heat": "heat",
    "torque": "torque",
    "rating": "rating_life",
    "recover": "recover",
    "report": "report",
    "vibration": "vibration",
    "layout": "layout",
    "sweep": "sweep",
    "identify": "identify",
}
#: Commands that Python does not need, and why.
LEFT_OUT = {
    "completions": "a shell completes the command's words; Python has its own ways",
    "help": "docstrings are Python's help",
}


#: Sound bearings and spalls of the outer race, signals of 2.5 ms.
PLAN = """(
    name: "small",
    cases: ["case.ron"],
    faults: [Sound, Outer],
    lengths: [mm(3)],
    loads: [(radial: kN(20))],
    speeds: [rpm(14000)],
    bearings: 2,
    spall: (depth: um(100), width: mm(20), edge_radius: um(20), zone: deg(10)),
    deviations: (
        inner: (first: 2, last: 30, amplitude: um(0.5), exponent: 1, seed: 0),
        outer: (first: 2, last: 30, amplitude: um(0.5), exponent: 1, seed: 0),
        balls: 10,
    ),
    settle: ms(0.5),
    duration: ms(2.5),
    rate: kHz(25.6),
    sensors: [
        (name: "x", direction: deg(0), direct: 1, modes: [(frequency: kHz(3), damping: 0.03, gain: 1)], noise: 0.01),
    ],
    test_share: 0.5,
    seed: 7,
)"""


def test_limit_python_has_every_command(command: Callable[..., Any]) -> None:
    listed = command("--help").split("Commands:\n")[1].split("\n\n")[0]
    names = [line.split()[0] for line in listed.splitlines() if line.startswith("  ") and line[2] != " "]
    assert len(names) > 20
    assert set(names) == set(FUNCTIONS) | set(LEFT_OUT)
    for function in FUNCTIONS.values():
        thing: Any = tribodyn
        for part in function.split("."):
            thing = getattr(thing, part)
        assert callable(thing) and thing.__doc__


def test_identity_pairs_are_those_of_the_command(command: Callable[..., Any], cases: Path) -> None:
    file = cases / "angular-7210.ron"
    case = Case.read(file)
    given = ("--arrangement", "db", "--distance", 20, "--offset", 10, "--model", "jones-harris", "--json")
    pair = tribodyn.pair(case, "DB", 20, offset=10, model="jones-harris")
    assert pair.to_dict() == command("pair", file, *given)
    assert pair.bearings[1].solution.balls.load_inner_n.max() > 0 and len(pair.to_pandas()) == 30
    with pytest.raises(InputError, match="one of offset and spring"):
        tribodyn.pair(case, "DB", 20)
    with pytest.raises(InputError, match="DB, DF, DT"):
        tribodyn.pair(case, "XX", 20, offset=10)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="0 mm or more"):
        tribodyn.pair(case, "DB", float("nan"), offset=10)


def test_identity_sets_sheets_and_shafts_are_those_of_the_command(command: Callable[..., Any], cases: Path) -> None:
    file = cases / "angular-7210.ron"
    case = Case.read(file)
    given = ("--arrangement", "TBT", "--preload", 300, "--given", "mounted", "--loads", "0,500", "--json")
    found = tribodyn.bearing_set(case, "TBT", preload=300, given="mounted", loads=[0, 500])
    assert found.to_dict() == command("set", file, *given)
    assert [state.load_n for state in found.states] == [0, 500]
    sheet = tribodyn.sheet(case, radial=2000, axial=1500, speed=3000)
    printed = command("sheet", file, "--radial", 2000, "--axial", 1500, "--speed", 3000, "--json")
    assert sheet.to_dict() == printed and sheet.rating.frequencies.cage_hz > 0
    path = ROOT / "fixtures" / "shafts" / "motor.ron"
    shaft = tribodyn.shaft(path, {"speed": tribodyn.rpm(1500)}, modes=[0, 1500])
    given = ("--set", "speed=rpm(1500)", "--modes", "0,1500", "--json")
    assert shaft.to_dict() == command("shaft", path, *given)
    assert len(shaft.whirl.speeds) == 2 and shaft.duties[0].shaft.bearings[0].reaction_n
    for refused in ({"arrangement": "XYZ", "preload": 1}, {"arrangement": "DB"}, {"sides": "+?", "preload": 1}):
        with pytest.raises(InputError, match="allowed"):
            tribodyn.bearing_set(case, **refused)  # type: ignore[arg-type]
    with pytest.raises(InputError, match="radial"):
        tribodyn.sheet(case, radial=-1, speed=3000)


def test_identity_films_and_torques_are_those_of_the_command(command: Callable[..., Any], cases: Path) -> None:
    file = cases / "oil-6206.ron"
    case = Case.read(file)
    film = tribodyn.film(case)
    assert film.to_dict() == command("film", "case", file, "--json")
    assert film.oil.density_kg_m3 > 800 and len(film.to_pandas()) == len(film.contacts)
    assert tribodyn.torque(case).to_dict() == command("torque", file, "--json")
    given = ("--oil", "mineral-vg68", "--temperature", 70, "--load", 555, "--speed", 3.46, "--radius", 3.78)
    contact = tribodyn.contact_film("mineral-vg68", temperature=70, load=555, speed=3.46, radius=3.78, across=120)
    assert contact.to_dict() == command("film", "contact", *given, "--across", 120, "--json")
    with pytest.raises(InputError):
        tribodyn.contact_film("olive", temperature=70, load=555, speed=3.46, radius=3.78)


def test_identity_temperatures_are_those_of_the_command(command: Callable[..., Any], cases: Path, paper: Case) -> None:
    file = cases / "oil-6206.ron"
    found = tribodyn.heat(Case.read(file), surroundings=40, cooling=0.5, oil_flow=0.2)
    assert found.to_dict() == command("heat", file, "--surroundings", 40, "--cooling", 0.5, "--oil-flow", 0.2, "--json")
    assert found.heat_shaft_w + found.heat_housing_w + found.heat_oil_w == pytest.approx(
        found.friction_power_w, rel=1e-3
    )
    with pytest.raises(InputError, match="-60 to 150"):
        tribodyn.heat(Case.read(file), surroundings=400)
    with pytest.raises(InputError, match="lubricant"):
        tribodyn.heat(paper)


def test_identity_data_sets_are_those_of_the_command(command: Callable[..., Any], cases: Path, tmp_path: Path) -> None:
    text = (cases / "paper-ag.ron").read_text().replace("RungeKutta4(step: us(10))", "Fast(step: us(10))")
    (tmp_path / "case.ron").write_text(text)
    plan = tmp_path / "plan.ron"
    plan.write_text(PLAN)
    told: list[tuple[float, float]] = []
    made = tribodyn.dataset(plan, tmp_path / "ours", threads=2, progress=lambda done, whole: told.append((done, whole)))
    printed = command("dataset", plan, "-o", tmp_path / "theirs", "--threads", 2, "-q", "--json")
    changing = {"wall_s", "members_per_s_and_thread", "table"}
    assert {k: v for k, v in made.to_dict().items() if k not in changing} == {
        k: v for k, v in printed.items() if k not in changing
    }
    assert made.members == made.finished == made.run and made.failed == 0 and told[-1][1] == made.members
    ours = Path(made.table).read_bytes()
    assert ours == (tmp_path / "theirs" / "members.parquet").read_bytes()
    assert len(made.to_pandas()) == made.members and made.to_pandas().x.map(len).min() > 50
    with pytest.raises(InputError):
        tribodyn.dataset(cases / "oil-6206.ron", tmp_path / "none")


def test_identity_the_list_of_bearings_is_that_of_the_command(command: Callable[..., Any]) -> None:
    found = tribodyn.catalogue("62")
    assert [entry.to_dict() for entry in found] == command("catalogue", "62", "--json")
    with pytest.raises(InputError, match="no bearing"):
        tribodyn.catalogue("99999")


def test_identity_signals_are_judged_as_by_the_command(command: Callable[..., Any], tmp_path: Path) -> None:
    """A made signal: a resonance that a defect of the outer race of a 6206 strikes once a ball."""
    rate, speed = 12_800, 1480.0
    bearing = next(entry for entry in tribodyn.catalogue("6206") if entry.designation == "6206")
    ratio = bearing.ball_diameter_mm / bearing.pitch_diameter_mm
    strikes = 0.5 * bearing.ball_count * (1 - ratio) * speed / 60
    time = np.arange(4 * rate) / rate
    since = (time * strikes) % 1.0 / strikes
    noise = np.random.default_rng(1).normal(0.0, 0.1, len(time))
    signal = np.exp(-900 * since) * np.sin(2 * np.pi * 3200 * since) + noise
    file = tmp_path / "motor.csv"
    file.write_text("acceleration\n" + "\n".join(map(repr, map(float, signal))) + "\n")
    found = tribodyn.vibration(file, rate=rate, bearing="6206", speed=speed)
    printed = command("vibration", file, "--rate", rate, "--bearing", "6206", "--speed", speed, "--json")
    assert found.to_dict() == printed and found.verdict["fault"] == "outer"
    assert len(found.samples) == len(time) and len(found.envelope) == len(found.envelope_hz)
    with pytest.raises(InputError, match="speed"):
        tribodyn.vibration(file, rate=rate, bearing="6206")


def test_identity_layouts_and_recoveries_are_those_of_the_command(
    command: Callable[..., Any], cases: Path, tmp_path: Path
) -> None:
    file = cases / "paper-ag.ron"
    case = Case.read(file)
    command("layout", file, "-o", tmp_path / "layout.json")
    assert json.loads(tribodyn.layout(case)) == json.loads((tmp_path / "layout.json").read_text())
    assert json.loads(tribodyn.layout()) != json.loads(tribodyn.layout(solution=True))
    whole = tmp_path / "run.mcap"
    tribodyn.run(case, SHORT_S, record=whole, progress=False)
    cut = tmp_path / "cut.mcap"
    cut.write_bytes(whole.read_bytes()[:-2000])
    saved = tribodyn.recover(cut, tmp_path / "saved.mcap")
    printed = command("recover", cut, "-o", tmp_path / "again.mcap", "--json")
    assert saved.truncated and saved.messages > 0
    assert {**saved.to_dict(), "output": ""} == {**printed, "output": ""}
    (tmp_path / "theirs.mcap").write_text("not ours")
    with pytest.raises(FileError):
        tribodyn.recover(cut, tmp_path / "theirs.mcap")


def test_identity_reports_are_those_of_the_command(command: Callable[..., Any], cases: Path, tmp_path: Path) -> None:
    case = Case.read(cases / "paper-ag.ron")
    one, two = tmp_path / "one.mcap", tmp_path / "two.mcap"
    tribodyn.run(case, SHORT_S, record=one, progress=False)
    tribodyn.run(case.replace({"cage.pocket_gap": tribodyn.mm(0.8)}), SHORT_S, record=two, progress=False)
    made = tribodyn.report(one, tmp_path / "ours")
    assert made.summary == command("report", one, "-o", tmp_path / "theirs", "--json")
    written = sorted(path.name for path in (tmp_path / "ours").iterdir())
    assert written == sorted(path.name for path in (tmp_path / "theirs").iterdir()) and "report.html" in written
    for name in written:
        assert (tmp_path / "ours" / name).read_bytes() == (tmp_path / "theirs" / name).read_bytes(), name
    assert made.page == str(tmp_path / "ours" / "report.html") and "Cage speed" in made.text
    difference = tribodyn.report(one, tmp_path / "difference", other=two)
    assert difference.summary == command("report", one, two, "-o", tmp_path / "difference", "--json")
    with pytest.raises(InputError, match="against"):
        tribodyn.report(one, tmp_path / "none", other=two, against=tmp_path / "figures.csv")
    with pytest.raises(tribodyn.TribodynError):
        tribodyn.report(cases / "paper-ag.ron", tmp_path / "none")
    assert not (tmp_path / "none").exists()


def test_identity_ensembles_are_those_of_the_command(command: Callable[..., Any], cases: Path, tmp_path: Path) -> None:
    file = cases / "paper-ag.ron"
    spread, table = "mm(0.71 ± 0.02)", tmp_path / "members.csv"
    found = tribodyn.ensemble(
        Case.read(file), {"cage.pocket_gap": spread}, 3, duration=SHORT_S, output=table, progress=False
    )
    given = ("--vary", f"cage.pocket_gap={spread}", "--members", 3, "--duration", SHORT_S, "-q", "--json")
    printed = command("ensemble", file, *given)
    for name in ("quantiles", "varied", "members", "finished", "failed", "seed", "sampling", "failures"):
        assert found.to_dict()[name] == printed[name]
    assert table.exists() and len(found.to_pandas()) == 3 and found.output == str(table)
    with pytest.raises(InputError, match="cage.pocket_gap"):
        tribodyn.ensemble(Case.read(file), {"cage.pocket_gap": "wide"}, 3)


def test_limit_warnings_are_those_of_python(plain: Case) -> None:
    hard = plain.replace({"ring.z": tribodyn.N(1)})
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        solution = tribodyn.solve(hard, "traction")
    said = [str(warning.message) for warning in caught if issubclass(warning.category, tribodyn.TribodynWarning)]
    assert said == solution.warnings and solution.implausible
    # What no bearing does is a category of its own, and stands in the shortest form of the answer.
    kinds = [warning.category for warning in caught]
    assert kinds[-1] is tribodyn.PlausibilityWarning and tribodyn.PlausibilityWarning not in kinds[:-1]
    assert all(warning.filename == __file__ for warning in caught)
    assert f"implausible: {', '.join(solution.implausible)}" in repr(solution)
    with warnings.catch_warnings():
        warnings.simplefilter("error", tribodyn.PlausibilityWarning)
        with pytest.raises(tribodyn.PlausibilityWarning):
            tribodyn.solve(hard, "traction")
