"""The reference of the Python package, by Sphinx from docstrings and comments of attributes.

With the package installed: ``python -m sphinx -W crates/python/reference target/reference``.
"""

from __future__ import annotations

import re
from typing import Any

import tribodyn

project = "tribodyn"
author = "tribodyn developers"
copyright = author
release = version = tribodyn.__version__
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.viewcode"]
html_theme = "furo"
html_title = f"tribodyn {version}"
html_copy_source = False
autodoc_member_order = "bysource"
autodoc_typehints = "description"
autodoc_typehints_description_target = "documented"
autodoc_type_aliases = {"PathLike": "PathLike", "Model": "Model", "Value": "Value", "Values": "Values"}
autodoc_default_options = {"members": True, "undoc-members": True, "show-inheritance": True}
python_use_unqualified_type_names = True
napoleon_google_docstring = True
napoleon_numpy_docstring = False
napoleon_use_ivar = True

#: Endings of names and what they say; longer ones first.
UNITS = {
    "n_per_m_1_5": "N/m^1.5",
    "n_per_um": "N/µm",
    "n_per_m": "N/m",
    "mm_rpm": "mm r/min",
    "kg_m2": "kg m²",
    "kg_m3": "kg/m³",
    "rad_s2": "rad/s²",
    "m_s2": "m/s²",
    "mm2_s": "mm²/s",
    "m3_s": "m³/s",
    "um3_s": "µm³/s",
    "rad_s": "rad/s",
    "mm_s": "mm/s",
    "m_s": "m/s",
    "pa_s": "Pa s",
    "per_s": "1/s",
    "per_pa": "1/Pa",
    "per_m": "1/m",
    "per_k": "1/K",
    "um3": "µm³",
    "deg_c": "°C",
    "mrev": "million turns",
    "percent": "%",
    "revolutions": "turns",
    "hours": "h",
    "nmm": "N mm",
    "nm": "N m",
    "rpm": "r/min",
    "deg": "°",
    "mrad": "mrad",
    "rad": "rad",
    "gpa": "GPa",
    "pa": "Pa",
    "hz": "Hz",
    "mm": "mm",
    "um": "µm",
    "kg": "kg",
    "ppb": "parts per billion",
    "n": "N",
    "m": "m",
    "w": "W",
    "j": "J",
    "s": "s",
    "h": "h",
    "k": "K",
}


def unit_of(name: str) -> str:
    """The unit that a name ends in; empty where it ends in none."""
    ending = next((ending for ending in UNITS if name.endswith(f"_{ending}")), "")
    return UNITS.get(ending, "")


def told(app: Any, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Adds to what an attribute's comment says the unit that its name says, where the comment does not."""
    unit = unit_of(name.rsplit(".", 1)[-1]) if what == "attribute" else ""
    text = " ".join(lines).strip()
    if unit and text and not re.search(rf"(^|[\s,;(]){re.escape(unit)}([\s,;).]|$)", text):
        end = next(place for place in reversed(range(len(lines))) if lines[place].strip())
        lines[end] = f"{lines[end].rstrip('.')} [{unit}]"


def setup(app: Any) -> None:
    app.connect("autodoc-process-docstring", told)
