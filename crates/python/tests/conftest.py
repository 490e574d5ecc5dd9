"""What tests have in common: the case files of the project, and its command."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import tribodyn

ROOT = Path(__file__).parents[3]
CASES = ROOT / "fixtures" / "cases"

#: A run of a millisecond: the shortest that has impacts and samples.
SHORT_S = 0.001


@pytest.fixture
def cases() -> Path:
    """Folder of the project's case files."""
    return CASES


@pytest.fixture
def paper() -> tribodyn.Case:
    """The paper's bearing, by its traction."""
    return tribodyn.Case.read(CASES / "paper-ag.ron")


@pytest.fixture
def plain() -> tribodyn.Case:
    """A bearing of the catalogue that is quickly solved."""
    return tribodyn.Case.read(CASES / "angular-7210.ron")


@pytest.fixture
def command() -> Callable[..., Any]:
    """Runs the command and gives what it prints, JSON as data."""
    program = os.environ.get("TRIBODYN_COMMAND")
    if program is None:
        pytest.skip("TRIBODYN_COMMAND does not name the command")

    def call(*arguments: object) -> Any:
        given = [program, *map(str, arguments)]
        done = subprocess.run(given, capture_output=True, text=True, check=False, cwd=ROOT)
        assert done.returncode in (0, 1), done.stderr
        return json.loads(done.stdout) if "--json" in given else done.stdout

    return call


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--full", action="store_true", help="also the long forms of tests")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    if config.getoption("--full"):
        return
    for item in items:
        if "full" in item.keywords:
            item.add_marker(pytest.mark.skip(reason="long form: --full"))
