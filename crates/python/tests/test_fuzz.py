"""Arguments drawn at random: whatever comes, it is an answer or an exception, and the interpreter lives."""

from __future__ import annotations

import math
import os
import random
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import tribodyn
from tribodyn import Case, TribodynError

from .conftest import CASES

#: Calls of the short form; the long one has 100 000.
SHORT, LONG = 5_000, 100_000

#: What a caller may get wrong. Anything else is a fault.
EXPECTED = (TribodynError, TypeError, ValueError, OverflowError, AttributeError, KeyError)

NUMBERS = [0.0, -0.0, 1.0, -1.0, 1e-320, 1e308, -1e308, math.inf, -math.inf, math.nan, 2.5, 1e-9, 40.0, 7210.0]
TEXTS = [
    "",
    "mm(1)",
    "mm(-1)",
    "kN(30)",
    "N(3",
    "geometry",
    "geometry.ball_diameter",
    "ring.z",
    "ring.z.Force",
    "(",
    ")",
]
TEXTS += [
    "\0",
    "µ\u202e",
    "a" * 5000,
    "((((",
    "[0]",
    "sources",
    'Library("ag")',
    "Force(kN(1))",
    "nan",
    "6206",
    "7210B",
]
TEXTS += ["traction", "jones-harris", "geometry.ball_count", "numerics.max_iterations", "3", "500000000", "true"]
OTHERS: list[Any] = [None, True, False, 3, -7, 2**70, [], {}, (), object(), b"bytes", [1.0, 2.0], ["kN(1)", "kN(2)"]]


def anything(draw: random.Random) -> Any:
    kind = draw.random()
    if kind < 0.4:
        return draw.choice(NUMBERS) * draw.choice([1.0, draw.random()])
    if kind < 0.8:
        text = draw.choice(TEXTS)
        if draw.random() < 0.3 and text:
            at = draw.randrange(len(text))
            text = text[:at] + chr(draw.choice([0, 34, 40, 41, 46, 58, 92, 955, 0x1F600])) + text[at + 1 :]
        return text
    return draw.choice(OTHERS)


def calls(case: Case, draw: random.Random) -> list[Callable[[], object]]:
    """Calls that take some microseconds up to a millisecond, with arguments of any kind."""
    one = lambda: anything(draw)  # noqa: E731
    return [
        lambda: case[one()],
        lambda: case.copy().__setitem__(one(), one()),
        lambda: case.replace({one(): one(), "ring.z.Force": one()}),
        lambda: Case.parse(one(), name=one()),
        lambda: Case.parse(mutated(case.text, draw)),
        lambda: Case.new(one(), angle=one()),
        lambda: Case.new(bore=one(), outside=one(), width=one(), angle=one(), balls=one(), ball=one()),
        lambda: Case.read(one()),
        lambda: tribodyn.hertz((one(), one()), (one(), one()), one(), young1=one(), poisson2=one(), angle=one()),
        lambda: tribodyn.hertz(one(), one(), one()),
        lambda: tribodyn.traction_curve(draw.choice(["ag", "ptfe", one()]), one(), [one(), one()], order=one()),
        lambda: tribodyn.stiffness(case, "jones-harris", speeds=one()),
        lambda: tribodyn.solve(case, one(), roots=one()),
        lambda: tribodyn.solve(one(), "jones-harris"),
        lambda: tribodyn.life(case, strides=one(), until=draw.choice([-1.0, math.nan, "x"]), progress=False),
        lambda: tribodyn.read_recording(one()),
        lambda: tribodyn.identify(one(), seed=one(), starts=one(), progress=False),
        lambda: tribodyn.merge([one(), one()], one()),
        lambda: tribodyn.sweep(case, {one(): one(), "ring.z.Force": one()}, progress=False),
        lambda: tribodyn.sweeps.grid(case, samples={one(): [one(), one()], "ring.x.Force": [one(), one()]}),
        lambda: tribodyn._native.Grid.product(one(), one(), one(), one()),
        lambda: tribodyn._native.hertz(one(), one(), one(), one(), one(), one()),
        lambda: tribodyn._native.Case.make({"designation": one(), "angle": one(), "bore": one()}),
    ]


def mutated(text: str, draw: random.Random) -> str:
    at = draw.randrange(len(text))
    return (
        text[:at] + draw.choice(["", "(", ")", "\0", "nan", "-", "9" * 30, text[:at]]) + text[at + draw.randrange(9) :]
    )


def fuzz(count: int, seed: int) -> Counter[str]:
    draw = random.Random(seed)
    case = Case.read(CASES / "paper-ag.ron")
    outcomes: Counter[str] = Counter()
    made = calls(case, draw)
    for _ in range(count):
        try:
            draw.choice(made)()
            outcomes["answered"] += 1
        except EXPECTED as error:
            outcomes[type(error).__name__] += 1
            assert "fault of the program" not in str(error), error
    return outcomes


@pytest.mark.parametrize("count", [SHORT, pytest.param(LONG, marks=pytest.mark.full)])
def test_limit_no_argument_ends_the_interpreter(tmp_path: Path, count: int) -> None:
    """In a process of its own: what kills it is seen."""
    program = f"from tests.test_fuzz import fuzz; print(sum(fuzz({count}, 20251122).values()))"
    done = subprocess.run(
        [sys.executable, "-c", program],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[1])},
        timeout=3600,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    assert int(done.stdout) == count
    assert "panicked" not in done.stderr
    # Whatever was called, nothing was left behind.
    assert not os.listdir(tmp_path)
