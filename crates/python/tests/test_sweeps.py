"""Sweeps: rows of the command, samples, tables and their parts."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pandas
import pytest
import tribodyn
from pandas.testing import assert_frame_equal
from tribodyn import Case, FileError, InputError
from tribodyn.units import Unit, deg, kN, rpm, um

GRID = {"ring.z.Force": "kN(1..3 in 5)", "speed.inner.Constant": rpm([6000, 9000])}


def test_identity_rows_are_those_of_the_command(
    command: Callable[..., Any], plain: Case, cases: Path, tmp_path: Path
) -> None:
    table = tmp_path / "table.csv"
    settings = ["--set", "ring.z.Force=kN(1..3 in 5)", "--set", "speed.inner.Constant=rpm(6000),rpm(9000)"]
    command("sweep", cases / "angular-7210.ron", *settings, "-o", table, "--quiet", "--json")
    rows = tribodyn.sweep(plain, GRID, progress=False)
    printed = pandas.read_csv(table, float_precision="round_trip")
    ours = rows.to_pandas().reset_index(drop=True)
    assert list(ours.columns) == list(printed.columns)
    for name in printed.columns:
        if name == "implausible":
            assert list(ours[name].fillna("")) == list(printed[name].fillna("")), name
        elif name != "error":
            assert np.array_equal(ours[name].to_numpy(), printed[name].to_numpy(), equal_nan=True), name
    assert rows.failed == 0 and list(rows["ring.z.Force [kN]"])[:3] == [1.0, 1.0, 1.5]
    assert "10 rows" in repr(rows) and "ring.z.Force" in rows._repr_html_()


def test_identity_a_grid_is_a_cube_with_a_dimension_for_each_path(plain: Case) -> None:
    rows = tribodyn.sweep(plain, {**GRID, "geometry.fit.ContactAngle": deg([38, 40])}, model="jones-harris")
    cube = rows.to_xarray()
    assert dict(cube.sizes) == {
        "ring.z.Force [kN]": 5,
        "speed.inner.Constant [rpm]": 2,
        "geometry.fit.ContactAngle [deg]": 2,
    }
    for row in range(len(rows)):
        place = {name: rows[name][row] for name in rows.swept}
        assert float(cube.cage_speed_rpm.sel(place)) == rows.cage_speed_rpm[row]
        assert int(cube.row.sel(place)) == rows.row[row] and bool(cube.converged.sel(place)) == rows.converged[row]
    drawn = tribodyn.latin_hypercube(
        {"ring.z.Force": ("kN", (2.0, 3.0)), "speed.inner.Constant": ("rpm", (3000, 6000))}, 4, seed=1
    )
    with pytest.raises(InputError, match="rows of a grid"):
        tribodyn.sweep(plain, samples=drawn, model="jones-harris", progress=False).to_xarray()


@pytest.mark.parametrize("ending", ["csv", "parquet"])
def test_identity_tables_and_their_shards_hold_the_rows_of_memory(plain: Case, tmp_path: Path, ending: str) -> None:
    values = {"ring.z.Force": "kN(1..3 in 20)"}
    whole = tribodyn.sweep(plain, values, model="traction", progress=False)
    table = tribodyn.sweep_to(tmp_path / f"whole.{ending}", plain, values, model="traction", progress=False)
    assert (table.rows, table.failed_rows, table.resumed_rows) == (20, 0, 0)
    parts = [tmp_path / f"part-{i}.{ending}" for i in range(3)]
    for i, part in enumerate(parts):
        tribodyn.sweep_to(part, plain, values, shard=f"{i}/3", model="traction", progress=False)
    merged = tribodyn.merge(reversed(parts), tmp_path / f"merged.{ending}")
    assert merged.rows == 20 and merged.failed_rows == 0
    for read in (table.to_pandas(), merged.to_pandas()):
        assert_frame_equal(read, whole.to_pandas().reset_index(drop=True), check_exact=True, check_dtype=False)
    if ending == "csv":
        assert (tmp_path / "merged.csv").read_bytes() == (tmp_path / "whole.csv").read_bytes()
    with pytest.raises(FileError, match="rows .* are in none of the tables"):
        tribodyn.merge([parts[0], parts[2]], tmp_path / f"lacking.{ending}")
    with pytest.raises(FileError, match="there twice"):
        tribodyn.merge([*parts, parts[1]], tmp_path / f"twice.{ending}")
    assert not (tmp_path / f"lacking.{ending}").exists()
    other = tribodyn.sweep_to(
        tmp_path / f"other.{ending}", plain, {"ring.x.Force": "kN(0),kN(1)"}, model="traction", progress=False
    )
    with pytest.raises(FileError, match="other"):
        tribodyn.merge([parts[0], other.output], tmp_path / f"mixed.{ending}")


def test_limit_threads_do_not_change_a_row(plain: Case) -> None:
    values = {"ring.z.Force": "kN(1..3 in 40)"}
    one, two = (tribodyn.sweep(plain, values, threads=n, model="traction", progress=False).to_pandas() for n in (1, 2))
    assert_frame_equal(one, two, check_exact=True)


def test_identity_samples_are_solved_as_they_are_drawn(plain: Case) -> None:
    spreads = {"ring.z.Force": (kN, (1.0, 3.0)), "geometry.fit.ContactAngle": ("deg", (38.0, 42.0))}
    drawn = tribodyn.latin_hypercube(spreads, 16, seed=7)
    assert drawn == tribodyn.latin_hypercube(spreads, 16, seed=7) != tribodyn.latin_hypercube(spreads, 16, seed=8)
    rows = tribodyn.sweep(plain, {"speed.inner.Constant": "rpm(7000)"}, samples=drawn, model="traction", progress=False)
    assert len(rows) == 16 and rows.failed == 0
    forces = rows["ring.z.Force [kN]"]
    assert [kN(float(force)) for force in forces] == drawn["ring.z.Force"]
    # One sample in each sixteenth.
    assert sorted(np.floor((forces - 1.0) / 2.0 * 16)) == list(range(16))
    case = plain.replace({"speed.inner.Constant": "rpm(7000)", **{path: values[5] for path, values in drawn.items()}})
    alone = tribodyn.solve(case, "traction")
    assert rows["cage_speed_rpm"][5] == pytest.approx(alone.cage_speed_rpm, rel=1e-5)
    cold = tribodyn.sweep(
        plain, {"speed.inner.Constant": "rpm(7000)"}, samples=drawn, cold=True, model="traction", progress=False
    )
    assert cold["cage_speed_rpm"][5] == alone.cage_speed_rpm


def test_limit_tolerances_may_be_distributions(plain: Case) -> None:
    stats = pytest.importorskip("scipy.stats")
    spreads = {"geometry.fit.ContactAngle": (deg, stats.norm(40.0, 0.5)), "geometry.ball_count": (14.0, 15.9)}
    angles = [angle.value for angle in tribodyn.sobol(spreads, 64, seed=1)["geometry.fit.ContactAngle"]]
    assert abs(np.mean(angles) - 40.0) < 0.1 and 0.4 < np.std(angles) < 0.6
    with pytest.raises(InputError, match="allowed are"):
        tribodyn.sobol({"a.b": "nonsense"}, 4)
    with pytest.raises(InputError, match="finite"):
        tribodyn.from_unit_cube(np.array([[0.0], [1.0]]), {"a.b": stats.norm(0, 1)})
    assert tribodyn.from_unit_cube(np.array([[0.25]]), {"a.b": (Unit("um"), (0, 4))}) == {"a.b": um([1.0])}


def test_limit_rows_without_a_solution_say_why(plain: Case) -> None:
    samples = {"geometry.ball_diameter": ["mm(12.7)", "mm(30)", "mm(12.7)"]}
    rows = tribodyn.sweep(plain, samples=samples, model="traction", progress=False)
    assert list(rows["converged"]) == [True, False, True] and rows.failed == 1
    assert rows["error"][0] is None and "ball" in rows["error"][1]
    assert np.isnan(rows["cage_speed_rpm"][1]) and np.isnan(rows["iterations"][1])


def test_limit_bad_values_are_refused_before_anything_is_solved(plain: Case, tmp_path: Path) -> None:
    for values, path in [
        ({"ring.z.Force": "mm(1..3 in 5)"}, "ring.z.Force"),
        ({"ring.z.Force": kN([1, 2]), "geometry.ball_diameter": ["mm(-1)", "mm(12)"]}, "geometry.ball_diameter"),
        ({"ring.z.Force": "kN(1..3 of 5)"}, "ring.z.Force"),
        ({"ring.z.Force": []}, "ring.z.Force"),
    ]:
        with pytest.raises(InputError) as caught:
            tribodyn.sweep_to(tmp_path / "table.csv", plain, values)
        assert caught.value.path == path and caught.value.allowed
    with pytest.raises(InputError):
        tribodyn.sweep(plain, {"ring.q.Force": "kN(1),kN(2)"})
    with pytest.raises(InputError, match="as many samples"):
        tribodyn.sweep(plain, samples={"ring.z.Force": kN([1, 2]), "ring.x.Force": kN([1])})
    with pytest.raises(InputError, match="single value"):
        tribodyn.sweep(plain, {"ring.z.Force": kN([1, 2])}, samples={"ring.x.Force": kN([1])})
    with pytest.raises(InputError, match="parquet"):
        tribodyn.sweep_to(tmp_path / "table.xls", plain, GRID)
    with pytest.raises(InputError, match="I/N"):
        tribodyn.sweep_to(tmp_path / "table.csv", plain, GRID, shard="3/3")
    assert not os.listdir(tmp_path)


def test_limit_a_sweep_that_is_stopped_goes_on(plain: Case, tmp_path: Path) -> None:
    values = {"ring.z.Force": "kN(1..3 in 400)"}

    def stop(done: float, rows: float) -> None:
        if done > 20:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        tribodyn.sweep_to(tmp_path / "table.parquet", plain, values, threads=1, model="traction", progress=stop)
    assert not (tmp_path / "table.parquet").exists()
    with pytest.raises(InputError, match="other"):
        tribodyn.sweep_to(
            tmp_path / "table.parquet", plain, {"ring.z.Force": "kN(1..4 in 400)"}, model="traction", progress=False
        )
    table = tribodyn.sweep_to(tmp_path / "table.parquet", plain, values, model="traction", progress=False)
    assert table.resumed_rows > 20 and table.rows == 400
    whole = tribodyn.sweep(plain, values, model="traction", progress=False).to_pandas().reset_index(drop=True)
    assert_frame_equal(table.to_pandas(), whole, check_exact=True, check_dtype=False)


def test_limit_a_plan_writes_nothing(plain: Case) -> None:
    plan = tribodyn.plan(plain, {"ring.z.Force": "kN(1..3 in 100)"}, threads=2)
    assert (plan.rows, plan.threads, plan.axes[0]["values"]) == (100, 2, 100)
    assert 0 < plan.next_row_s < 10 and plan.estimated_time_s > 0
