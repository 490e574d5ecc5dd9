"""Cases: reading, changing, making, and what is refused."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest
import tribodyn
from tribodyn import Case, CaseError, FileError, InputError
from tribodyn.units import GPa, N_per_um, deg, kN, mm, rpm, unit


def test_limit_values_are_read_and_changed_by_their_paths(paper: Case) -> None:
    assert paper["ring.z.Force"] == "kN(54.76)"
    changed = paper.replace(**{"ring.z.Force": kN(30)})
    assert changed["ring.z.Force"] == "kN(30)"
    assert paper["ring.z.Force"] == "kN(54.76)"
    changed["ring.x"] = "kN(2.5)"
    assert changed["ring.x"] == "Force(kN(2.5))"
    changed["traction.varying"] = False
    assert changed["traction.varying"] == "false"
    assert "geometry.ball_count" in list(paper)
    assert paper.values()["ring.z"] == "Force(kN(54.76))" or paper.values()["ring.z.Force"] == "kN(54.76)"


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
    assert case["geometry.fit.ContactAngle"] == "deg(40)"
    assert any("Assumed" in source for source in case.sources.values())
    loaded = Case.new("6206", radial=1000, axial=500, speed=3000)
    assert tribodyn.solve(loaded, "jones-harris").ring_load_x_n == pytest.approx(1000, rel=1e-4)
    own = Case.new(bore=50, outside=90, width=20, angle=40, balls=15, ball=12.7)
    assert own["geometry.ball_count"] == "15"
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
    ],
)
def test_limit_impossible_new_cases_are_refused(request_: dict[str, float]) -> None:
    with pytest.raises(InputError) as caught:
        Case.new(**request_)  # type: ignore[arg-type]
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
    assert [kN(30), mm(30.16), deg(0.1), rpm(-1e20)] == ["kN(30)", "mm(30.16)", "deg(0.1)", "rpm(-1e+20)"]
    assert N_per_um([1, 2.5]) == ["N_per_um(1)", "N_per_um(2.5)"]
    assert unit("GPa")(2) == GPa(2) == "GPa(2)"
    with pytest.raises(ValueError, match="name of a unit"):
        unit("kN(")


def test_limit_notebooks_show_a_case(paper: Case) -> None:
    page = paper._repr_html_()
    assert "geometry.ball_count" in page and "<table>" in page
    assert "<script" not in paper.replace({"name": '"<script>"'})._repr_html_()
