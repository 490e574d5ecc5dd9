"""Writes the attributes of balls, solutions and recordings from the program's tables of quantities.

Run it with the package installed: ``python crates/python/tools/quantities.py``. A test holds the classes to the table.
"""

from __future__ import annotations

import re
import textwrap
from pathlib import Path
from typing import Any

from tribodyn import Case, _native

ROOT = Path(__file__).parents[3]
PROTO = ROOT / "crates" / "record" / "proto" / "tribodyn.proto"
TARGET = Path(__file__).parents[1] / "python" / "tribodyn" / "_quantities.py"

HEAD = '''"""Attributes of balls, solutions and recordings, by ``tools/quantities.py`` from the program's tables."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
'''

GROUPS = (
    ("BearingQuantities", "bearing", "float", "Quantities of the bearing in equilibrium."),
    ("BallQuantities", "ball", "float", "Quantities of a ball and of its contacts."),
    ("BallArrays", "ball", "NDArray[np.float64]", "The same of all balls, an array each."),
)

MODELS = {
    "all": "",
    "traction": "; with traction only",
    "lubricated": "; with a lubricant only",
    "run": "; of runs only",
}


#: Classes of what recordings hold: the message whose comments say what a number is, names, type, docstring.
RECORDED = (
    ("StateArrays", "TransientState", "states", "NDArray[np.float64]", "Rings, cage and powers of a run, over time."),
    ("SolutionArrays", "BearingState", "solution", "NDArray[np.float64]", "The bearing of a recorded solution."),
    ("WornArrays", "Wear", "wear", "NDArray[np.float64]", "What has worn off, over time."),
    ("RecordedBallArrays", "Ball", "balls", "NDArray[np.float32]", "Numbers of all balls, by time and ball."),
)


def main() -> None:
    table: dict[str, list[dict[str, Any]]] = _native.quantities()
    text = HEAD
    for name, group, kind, about in GROUPS:
        text += f'\n\nclass {name}:\n    """{about}"""\n\n'
        text += "\n".join(attribute(row, kind) for row in table[group]) + "\n"
    names = _native.recorded_names()
    for name, message, group, kind, about in RECORDED:
        said = comments(message)
        text += f'\n\nclass {name}:\n    """{about}"""\n\n'
        text += "\n".join(recorded(said.get(field, ""), field, kind) for field in names[group]) + "\n"
    text += (
        '\n\nclass SweepColumns:\n    """Columns of sweeps; swept values have those of their paths beside them."""\n\n'
    )
    text += "\n".join(f"    {name}: Any" for name in sweep_columns()) + "\n"
    TARGET.write_text(text, encoding="utf-8")


def sweep_columns() -> list[str]:
    """Columns of a sweep by any model, but for those of swept values."""
    case = Case.read(ROOT / "fixtures" / "cases" / "oil-6206.ron")
    names: dict[str, None] = {}
    for model in ("steady-orbit", "traction", "jones-harris"):
        grid = _native.Grid.product((case.file, case.text), [("ring.z", ["Force(kN(1))"])], (model, False), False)
        names.update(dict.fromkeys(name for name in grid.columns() if name not in grid.swept()))
    return list(names)


def comments(message: str) -> dict[str, str]:
    """What the comments of a message say of its single numbers."""
    body = re.search(rf"^message {message} {{\n(.*?)^}}", PROTO.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    found = re.findall(r"((?:^ +//[^\n]*\n)+) +(?:optional )?\w+ (\w+) = \d+;", body[1] if body else "", re.MULTILINE)
    return {name: " ".join(line.strip().lstrip("/ ") for line in about.strip().splitlines()) for about, name in found}


def recorded(about: str, name: str, kind: str) -> str:
    lines = textwrap.wrap(about.rstrip("."), 110)
    return "".join(f"    #: {line}\n" for line in lines) + f"    {name}: {kind}"


def attribute(row: dict[str, Any], kind: str) -> str:
    unit = f", {row['unit']}" if row["unit"] else ""
    return f"    #: {row['about']}{unit}{MODELS[row['models']]}\n    {row['name']}: {kind}"


if __name__ == "__main__":
    main()
