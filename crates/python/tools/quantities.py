"""Writes the attributes of balls and solutions from the program's table of quantities.

Run it with the package installed: ``python crates/python/tools/quantities.py``. A test holds the classes to the table.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tribodyn import _native

TARGET = Path(__file__).parents[1] / "python" / "tribodyn" / "_quantities.py"

HEAD = '''"""Attributes of balls and solutions, by ``tools/quantities.py`` from the program's table of quantities."""

from __future__ import annotations

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


def main() -> None:
    table: dict[str, list[dict[str, Any]]] = _native.quantities()
    text = HEAD
    for name, group, kind, about in GROUPS:
        text += f'\n\nclass {name}:\n    """{about}"""\n\n'
        text += "\n".join(attribute(row, kind) for row in table[group]) + "\n"
    TARGET.write_text(text, encoding="utf-8")


def attribute(row: dict[str, Any], kind: str) -> str:
    unit = f", {row['unit']}" if row["unit"] else ""
    return f"    #: {row['about']}{unit}{MODELS[row['models']]}\n    {row['name']}: {kind}"


if __name__ == "__main__":
    main()
