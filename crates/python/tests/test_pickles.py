"""Answers go to other processes and come back as they were."""

from __future__ import annotations

import multiprocessing
import pickle
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import tribodyn
from tribodyn import Case
from tribodyn._answer import equal

from .conftest import CASES, SHORT_S


def _worn() -> Case:
    return Case.read(CASES / "paper-ag-worn.ron")


def _plain() -> Case:
    return Case.read(CASES / "angular-7210.ron")


def _oil() -> Case:
    return Case.read(CASES / "oil-6206.ron")


#: What makes each kind of answer, for a case that has it.
MAKERS: dict[str, Callable[[], Any]] = {
    "case": _plain,
    "contact": lambda: tribodyn.hertz((6.35, 6.35), (np.inf, np.inf), 100),
    "line": lambda: tribodyn.hertz((5, np.inf), (25, np.inf), 4000, length=12),
    "curve": lambda: tribodyn.traction_curve("ag", 2.0, [0.0, 1.0]),
    "derived": lambda: _plain().check(),
    "equilibrium": lambda: tribodyn.solve(_plain(), "jones-harris"),
    "heat": lambda: tribodyn.heat(_oil()),
    "roots": lambda: tribodyn.solve(_plain(), "traction", roots=True),
    "oil": lambda: tribodyn.solve(_oil(), "traction"),
    "orbit": lambda: tribodyn.solve(_worn()),
    "balls": lambda: tribodyn.solve(_plain(), "jones-harris").balls,
    "ball": lambda: tribodyn.solve(_plain(), "jones-harris").balls[2],
    "stiffness": lambda: tribodyn.stiffness(_plain(), "jones-harris", speeds=[3000, 9000]),
    "modes": lambda: tribodyn.modes(_worn(), up_to=2000),
    "rating": lambda: tribodyn.rating_life(_plain(), "jones-harris"),
    "life": lambda: tribodyn.life(_worn(), strides=1, progress=False),
    "run": lambda: tribodyn.run(_worn(), SHORT_S, progress=False),
    "sweep": lambda: tribodyn.sweep(_plain(), {"ring.z.Force": "kN(1..3 in 3)"}, model="jones-harris", progress=False),
    "unit": lambda: tribodyn.units.kN,
}


@pytest.mark.parametrize("kind", MAKERS)
def test_identity_an_answer_survives_pickling(kind: str) -> None:
    answer = MAKERS[kind]()
    again = pickle.loads(pickle.dumps(answer))
    assert type(again) is type(answer) and again == answer
    assert repr(again) == repr(answer)
    if hasattr(answer, "_repr_html_"):
        assert again._repr_html_() == answer._repr_html_()
    if hasattr(answer, "to_dict"):
        assert equal(again.to_dict(), answer.to_dict())


@pytest.mark.parametrize("kind", [kind for kind in MAKERS if kind not in ("case", "unit")])
def test_identity_an_answer_is_a_table_and_a_data_set(kind: str) -> None:
    """Of pandas and of xarray, with the same columns."""
    xarray = pytest.importorskip("xarray")
    answer = MAKERS[kind]()
    table, data = answer.to_pandas(), answer.to_xarray()
    assert len(table) > 0 and isinstance(data, (xarray.Dataset, xarray.DataArray))
    assert data.sizes or len(data.data_vars) > 0


def test_limit_answers_of_different_questions_differ() -> None:
    case = _plain()
    one, other = (tribodyn.solve(case.replace({"ring.z": force}), "jones-harris") for force in ("kN(3)", "kN(4)"))
    assert one != other and one.balls != other.balls and one.balls[0] != other.balls[0]
    assert one == tribodyn.solve(case.replace({"ring.z": "kN(3)"}), "jones-harris")
    assert one != one.to_dict() and one != tribodyn.solve(case.replace({"ring.z": "kN(3)"}), "traction")
    one.balls.values[0, 0] += 1e-9
    assert one != tribodyn.solve(case.replace({"ring.z": "kN(3)"}), "jones-harris")


def test_identity_figures_of_a_pickled_solution_are_drawn_as_before() -> None:
    solution = tribodyn.solve(_worn())
    again = pickle.loads(pickle.dumps(solution))
    assert again.figures() == solution.figures() and len(again.figures()) > 5


def _loaded(case: Case, force: str) -> tribodyn.Solution:
    return tribodyn.solve(case.replace({"ring.z": force}), "jones-harris")


@pytest.mark.parametrize("method", multiprocessing.get_all_start_methods())
def test_identity_a_pool_of_processes_gives_what_one_process_gives(method: str, cases: Path) -> None:
    case = Case.read(cases / "angular-7210.ron")
    forces = ["kN(2)", "kN(4)", "kN(6)"]
    context = multiprocessing.get_context(method)
    with ProcessPoolExecutor(2, mp_context=context) as pool:
        solved = list(pool.map(_loaded, [case] * len(forces), forces))
    assert solved == [_loaded(case, force) for force in forces]


def test_identity_joblib_gives_what_one_process_gives(cases: Path) -> None:
    joblib = pytest.importorskip("joblib")
    case = Case.read(cases / "angular-7210.ron")
    forces = ["kN(2)", "kN(4)", "kN(6)"]
    solved = joblib.Parallel(n_jobs=2)(joblib.delayed(_loaded)(case, force) for force in forces)
    assert solved == [_loaded(case, force) for force in forces]


def test_identity_futures_of_dask_give_what_one_process_gives(cases: Path) -> None:
    distributed = pytest.importorskip("distributed")
    case = Case.read(cases / "angular-7210.ron")
    forces = ["kN(2)", "kN(4)", "kN(6)"]

    def loaded(case: Case, force: str) -> tribodyn.Solution:
        return tribodyn.solve(case.replace({"ring.z": force}), "jones-harris")

    options = {"n_workers": 1, "threads_per_worker": 2, "dashboard_address": None, "processes": True}
    with distributed.LocalCluster(**options) as cluster, distributed.Client(cluster) as client:
        futures = [client.submit(loaded, case, force) for force in forces]
        solved = client.gather(futures)
    assert solved == [_loaded(case, force) for force in forces]


def test_identity_joblib_remembers_by_the_values_of_a_case(cases: Path, tmp_path: Path) -> None:
    """Its memory finds the answer of an equal case, and not that of another one."""
    joblib = pytest.importorskip("joblib")
    calls: list[float] = []

    def speed(case: Case) -> float:
        calls.append(0.0)
        return tribodyn.solve(case, "jones-harris").cage_speed_rpm

    remembered = joblib.Memory(tmp_path, verbose=0).cache(speed)
    case = Case.read(cases / "angular-7210.ron")
    first = remembered(case)
    assert remembered(Case.read(cases / "angular-7210.ron")) == first and len(calls) == 1
    assert remembered(case.replace({"ring.z": tribodyn.kN(5)})) != first and len(calls) == 2
