"""Costs of the package over the library and the command: long forms, for release builds on an idle machine.

``cargo build --release -p tribodyn-cli``, ``cargo build --release -p tribodyn-study --example solve_time`` and
``maturin build --release`` make what is compared; ``TRIBODYN_COMMAND`` names the command.
"""

from __future__ import annotations

import os
import subprocess
import time
from pathlib import Path
from typing import Any

import pytest
import tribodyn
from tribodyn import Case

#: 10 000 rows.
GRID = {
    "ring.z.Force": "kN(30..60 in 50)",
    "ring.x.Force": "kN(5..25 in 10)",
    "speed.inner.Constant": "rpm(8000..15600 in 20)",
}


@pytest.fixture
def program() -> Path:
    path = os.environ.get("TRIBODYN_COMMAND")
    if path is None:
        pytest.skip("TRIBODYN_COMMAND does not name the command")
    return Path(path)


def printed(*arguments: object) -> str:
    return subprocess.run([*map(str, arguments)], capture_output=True, text=True, check=True).stdout


@pytest.mark.full
@pytest.mark.parametrize("model", ["jones-harris", "traction", "steady-orbit"])
def test_limit_a_solve_costs_little_over_that_of_the_library(program: Path, cases: Path, model: Any) -> None:
    file = cases / "paper-ag.ron"
    case = Case.read(file)
    ours, library = [], []
    for _ in range(5):
        library.append(1e-3 * float(printed(program.parent / "examples" / "solve_time", file, model, 20)))
        for _ in range(20):
            began = time.perf_counter()
            tribodyn.solve(case, model)
            ours.append(time.perf_counter() - began)
    ratio = min(ours) / min(library)
    print(f"{model}: {1e3 * min(ours):.3f} ms, library {1e3 * min(library):.3f} ms, ratio {ratio:.3f}")
    assert ratio < 1.2


@pytest.mark.full
def test_limit_a_sweep_costs_little_over_that_of_the_command(program: Path, cases: Path, tmp_path: Path) -> None:
    file = cases / "paper-ag.ron"
    case = Case.read(file)
    settings = [word for path, values in GRID.items() for word in ("--set", f"{path}={values}")]
    ours, command = [], []
    for turn in range(2):
        began = time.perf_counter()
        printed(program, "sweep", file, *settings, "--model", "traction", "-o", tmp_path / f"{turn}.parquet")
        command.append(time.perf_counter() - began)
        began = time.perf_counter()
        table = tribodyn.sweep(case, GRID, model="traction", progress=False)
        ours.append(time.perf_counter() - began)
        assert len(table.to_pandas()) == 10_000
    ratio = min(ours) / min(command)
    print(f"10 000 rows: {min(ours):.2f} s, command {min(command):.2f} s, ratio {ratio:.3f}")
    assert ratio < 1.1
