"""Cases: reading, changing, making, and what is refused."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import pytest
import tribodyn
from tribodyn import Case, CaseError, FileError, InputError
from tribodyn.units import GPa, N_per_um, deg, kN, mm, rpm, unit


def test_limit_values_are_read_and_changed_by_their_paths(paper: Case) -> None:
    assert paper["ring.z.Force"] == 54_760 and paper["ring.z.Force"].text == "kN(54.76)"
    changed = paper.replace(**{"ring.z.Force": kN(30)})
    assert changed["ring.z.Force"].text == "kN(30)"
    assert paper["ring.z.Force"].text == "kN(54.76)"
    changed["ring.x"] = "kN(2.5)"
    assert changed["ring.x"].text == "Force(kN(2.5))"
    changed["traction.varying"] = False
    assert changed["traction.varying"] is False
    assert "geometry.ball_count" in list(paper)
    assert paper.values()["ring.z"] == paper["ring.z"] == 54_760


def test_limit_a_quantity_is_a_number_in_si_with_its_unit(paper: Case) -> None:
    load = paper["ring.z"]
    assert isinstance(load, float) and isinstance(load, tribodyn.Quantity)
    assert (float(load), load.value, load.unit, load.choice, load.text) == (
        54_760.0,
        54.76,
        "kN",
        "Force",
        "Force(kN(54.76))",
    )
    assert type(2 * load) is float and 2 * load == 109_520.0 and f"{load:.1f} {load}" == "54760.0 Force(kN(54.76))"
    assert load.to("kN") == pytest.approx(54.76, rel=1e-15) and tribodyn.degC(20).to("degF") == pytest.approx(68)
    assert paper["geometry.ball_count"] == 13 and type(paper["geometry.ball_count"]) is int
    assert pickle.loads(pickle.dumps(load)) == load and pickle.loads(pickle.dumps(load)).text == load.text
    other = paper.replace({"ring.z": tribodyn.N(2 * load)})
    assert other["ring.z"] == 2 * load and other["ring.z"].text == "Force(N(109520))"
    # What was read can be written again, choice and all.
    other["ring.z"] = load
    assert other == paper
    with pytest.raises(InputError, match="N, kN, lbf"):
        load.to("mm")


def test_identity_every_value_of_every_case_can_be_written_back(cases: Path) -> None:
    for file in sorted(cases.glob("*.ron")):
        case = Case.read(file)
        again = case.replace(case.values())
        assert {path: tribodyn.case.as_text(value) for path, value in again.values().items()} == {
            path: tribodyn.case.as_text(value) for path, value in case.values().items()
        }
        assert again.check() == case.check()


@pytest.mark.parametrize(
    ("path", "value", "said"),
    [
        ("ring.z", 3000, ["ring.z.Force = 3000", "a force with its unit", "N, kN, lbf"]),
        ("ring.z.Force", 3000.5, ["ring.z.Force = 3000.5", "a force with its unit", "N, kN, lbf"]),
        ("ring.z", "mm(3)", ["ring.z.Force = mm(3)", "N, kN, lbf"]),
        ("ring.z", tribodyn.mm(3), ["ring.z.Force = mm(3)", "N, kN, lbf"]),
        ("ring.z", kN(float("nan")), ["ring.z.Force = kN(NaN)", "must be finite"]),
        ("ring.z", kN(float("inf")), ["ring.z.Force = kN(inf)", "must be finite"]),
        ("ring.z", float("nan"), ["ring.z.Force = NaN", "a force with its unit"]),
        ("ring.z", [kN(1), kN(2)], ["ring.z", "not list"]),
        ("ring.z", None, ["ring.z", "not NoneType"]),
        ("geometry.ball_count", 13.5, ["geometry.ball_count = 13.5", "whole number"]),
        ("geometry.ball_count", kN(3), ["geometry.ball_count = kN(3)", "whole number"]),
        ("geometry.ball_diameter", "30 mm", ["geometry.ball_diameter", "mm(30.16)"]),
        ("geometry.ball_diameter", mm(-3), ["geometry.ball_diameter = mm(-3)"]),
    ],
)
def test_limit_a_refused_value_says_why(paper: Case, path: str, value: object, said: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        paper[path] = value
    for words in said:
        assert words in str(caught.value), str(caught.value)


def test_limit_quantities_of_pint_go_both_ways(paper: Case) -> None:
    pint = pytest.importorskip("pint")
    registry = pint.UnitRegistry()
    assert paper["ring.z"].to_pint(registry).to("newton").magnitude == pytest.approx(54_760)
    paper["ring.z"] = 30 * registry.kilonewton
    assert paper["ring.z"].text == "Force(kN(30))"
    for names in tribodyn._native.unit_names():
        for name in names:
            # In base units both say the same.
            ours = tribodyn.units.Quantity(2.0, name)
            theirs = ours.to_pint(registry).to_base_units()
            assert theirs.magnitude == pytest.approx(float(ours), rel=1e-6), name
    with pytest.raises(CaseError, match="turned into kN"):
        paper["ring.z"] = 3 * registry.metre


def test_limit_a_refused_change_leaves_the_case_as_it_was(paper: Case) -> None:
    before = paper.text
    for path, value in [
        ("geometry.ball_diameter", "mm(-3)"),
        ("geometry.ball_diameter", "N(3)"),
        ("ring.z", "mm(3)"),
        ("geometry.bal_diameter", "mm(3)"),
        ("geometry", "nonsense"),
    ]:
        with pytest.raises(CaseError):
            paper[path] = value
        assert paper.text == before


def test_limit_an_error_says_where_and_what_is_allowed(paper: Case, tmp_path: Path) -> None:
    with pytest.raises(CaseError) as caught:
        paper.replace({"geometry.ball_diameter": "N(3)"})
    error = caught.value
    assert error.path == "geometry.ball_diameter" and error.value == "N(3)"
    assert error.file is not None and error.file.endswith("paper-ag.ron")
    assert error.line is not None and error.column is not None
    assert error.text is not None and error.text[error.column - 1 :].startswith("N(3)")
    assert error.allowed is not None and "m, mm, um, inch" in error.allowed
    assert isinstance(error, ValueError)

    broken = tmp_path / "broken.ron"
    broken.write_text(paper.text.replace("ball_diameter: mm", "ball_diametre: mm"))
    with pytest.raises(CaseError) as caught:
        Case.read(broken)
    assert caught.value.path == "geometry.ball_diametre" and caught.value.file == str(broken)
    assert caught.value.allowed is not None and "ball_diameter" in caught.value.allowed
    assert str(caught.value).startswith(f"{broken}:{caught.value.line}:{caught.value.column}: ")

    again = pickle.loads(pickle.dumps(caught.value))
    assert (str(again), again.line, again.allowed) == (str(caught.value), caught.value.line, caught.value.allowed)


def test_limit_files_that_cannot_be_read_are_named(tmp_path: Path) -> None:
    with pytest.raises(FileError) as caught:
        Case.read(tmp_path / "absent.ron")
    assert caught.value.file == str(tmp_path / "absent.ron") and isinstance(caught.value, OSError)
    (tmp_path / "bytes.ron").write_bytes(b"\xff\xfe\x00(")
    with pytest.raises(FileError):
        Case.read(tmp_path / "bytes.ron")


def test_limit_new_cases_come_from_the_catalogue_or_from_dimensions(tmp_path: Path) -> None:
    case = Case.new("7210", angle=40)
    assert case["geometry.fit.ContactAngle"].text == "deg(40)"
    assert any("Assumed" in source for source in case.sources.values())
    loaded = Case.new("6206", radial=1000, axial=500, speed=3000)
    assert tribodyn.solve(loaded, "jones-harris").ring_load_x_n == pytest.approx(1000, rel=1e-4)
    assert Case.new("6206", lubricant="vg32")["lubricant.oil.Library"] == '"mineral-vg32"'
    own = Case.new(bore=50, outside=90, width=20, angle=40, balls=15, ball=12.7)
    assert own["geometry.ball_count"] == 15
    own.write(tmp_path / "own.ron")
    assert Case.read(tmp_path / "own.ron") == own
    with pytest.raises(FileError):
        own.write(tmp_path / "own.ron")


@pytest.mark.parametrize(
    "request_",
    [
        {"designation": "9999"},
        {"designation": "7210", "angle": 50},
        {"designation": "7210", "angle": float("nan")},
        {"bore": 50.0},
        {"designation": "6206", "bore": 50.0, "outside": 90.0, "width": 20.0},
        {"bore": -50.0, "outside": 90.0, "width": 20.0},
        {"bore": 50.0, "outside": 90.0, "width": 20.0, "balls": 2, "ball": 12.7},
        {"designation": "6206", "dynamic_rating": -1.0, "static_rating": 5.0},
        {"designation": "6206", "speed": float("inf")},
        {"designation": "6206", "lubricant": "butter"},
    ],
)
def test_limit_impossible_new_cases_are_refused(request_: dict[str, Any]) -> None:
    with pytest.raises(InputError) as caught:
        Case.new(**request_)
    assert caught.value.allowed


def test_limit_a_missing_path_names_those_that_are_there(paper: Case) -> None:
    with pytest.raises(CaseError) as caught:
        paper["geometry.nothing"]
    assert caught.value.path == "geometry.nothing"
    assert "geometry." in (caught.value.allowed or "")


def test_identity_a_case_survives_pickling(paper: Case) -> None:
    again = pickle.loads(pickle.dumps(paper))
    assert again == paper and again.file == paper.file
    assert paper.copy() == paper and paper != paper.replace({"traction.varying": False})


def test_limit_what_follows_from_a_case(paper: Case) -> None:
    derived = paper.check()
    assert 0 < derived.contact_angle_deg < 90 and derived.ball_mass_kg > 0
    assert derived.name == paper.name
    assert tribodyn.check(paper).to_dict() == derived.to_dict()


def test_limit_units_make_the_texts_of_case_files() -> None:
    assert list(map(str, [kN(30), mm(30.16), deg(0.1), rpm(-1e20)])) == [
        "kN(30)",
        "mm(30.16)",
        "deg(0.1)",
        "rpm(-1e+20)",
    ]
    assert list(map(str, N_per_um([1, 2.5]))) == ["N_per_um(1)", "N_per_um(2.5)"]
    assert unit("GPa")(2) == GPa(2) == 2e9 and mm(0.12) == 0.00012
    with pytest.raises(ValueError, match="name of a unit"):
        unit("kN(")
    with pytest.raises(AttributeError):
        tribodyn.units.kiloN  # type: ignore[attr-defined]
    # All units of case files are here by their name, but for one that is a word of Python.
    known = {name for names in tribodyn._native.unit_names() for name in names} - {"in"}
    assert known == {n for n, u in vars(tribodyn.units).items() if isinstance(u, tribodyn.Unit)}
    assert known == {n for n, u in vars(tribodyn).items() if isinstance(u, tribodyn.Unit)}


def test_limit_notebooks_show_a_case(paper: Case) -> None:
    page = paper._repr_html_()
    assert "geometry.ball_count" in page and "<table>" in page
    assert "<script" not in paper.replace({"name": '"<script>"'})._repr_html_()


def test_identity_arguments_take_quantities_in_any_unit_of_their_kind(plain: Case) -> None:
    """A number stands in the unit that the function says; a quantity is turned into it."""
    from tribodyn import degF, inch, lbf, m, psi, rad_per_s

    sheet = tribodyn.sheet(plain, radial=lbf(450), axial=kN(0.8), speed=rad_per_s(314.15926535897933))
    same = tribodyn.sheet(plain, radial=2001.6997268672, axial=800, speed=3000)
    assert sheet.rating.rating_life_l10_mrev == pytest.approx(same.rating.rating_life_l10_mrev, rel=1e-12)
    assert sheet.speed_rpm == pytest.approx(3000, rel=1e-12)
    apart = tribodyn.pair(plain, "DB", mm(20), offset=m(10e-6), model="jones-harris")
    assert apart.preload_n == pytest.approx(
        tribodyn.pair(plain, "DB", 20, offset=10, model="jones-harris").preload_n, rel=1e-9
    )
    contact = tribodyn.hertz((inch(0.25), inch(0.25)), (float("inf"), float("inf")), lbf(10), young1=psi(30e6))
    assert contact.peak_pressure_pa == pytest.approx(
        tribodyn.hertz(
            (6.35, 6.35), (float("inf"), float("inf")), 44.482216152605, young1=206.8427187
        ).peak_pressure_pa,
        rel=1e-9,
    )
    film = tribodyn.contact_film("mineral-vg68", temperature=degF(158), load=555, speed=3.46, radius=mm(3.78))
    assert film.oil.temperature_deg_c == pytest.approx(70, rel=1e-12)
    made = Case.new("6206", radial=kN(2), speed=rpm(3000))
    assert made.text == Case.new("6206", radial=2000, speed=3000).text
    with pytest.raises(InputError, match="N, kN, lbf"):
        tribodyn.sheet(plain, radial=mm(3), speed=3000)
