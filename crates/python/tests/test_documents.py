"""Examples of the pages: every block of Python runs, and prints what stands below it."""

from __future__ import annotations

import contextlib
import doctest
import importlib
import importlib.metadata
import io
import math
import re
import subprocess
import sys
import zlib
from pathlib import Path

import pytest
import tribodyn

from .conftest import ROOT

PAGES = ["docs/python.md", "docs/python-studies.md", "docs/fmu.md", "README.md", "crates/python/README.md"]
MODULES = ("answers", "solution", "sets", "films", "signals", "ensembles", "runs", "sweeps", "distributed", "units")
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


@pytest.mark.parametrize("page", PAGES)
def test_limit_examples_print_what_pages_say(page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One after the other in one session, in a folder with the project's case files."""
    if page == "docs/fmu.md":
        pytest.importorskip("fmpy", reason="FMPy is not installed")
    (tmp_path / "fixtures").symlink_to(ROOT / "fixtures")
    monkeypatch.chdir(tmp_path)
    blocks = FENCE.findall((ROOT / page).read_text(encoding="utf-8"))
    session: dict[str, object] = {"__name__": "page"}
    ran = 0
    for place, (language, text) in enumerate(blocks):
        if language != "python":
            continue
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(text, f"{page}, block {place}", "exec"), session)
        ran += 1
        if place + 1 < len(blocks) and blocks[place + 1][0] == "text":
            agree(printed.getvalue(), blocks[place + 1][1], f"{page}, block {place}")
        else:
            assert not printed.getvalue(), f"{page}, block {place} prints: {printed.getvalue()}"
    assert ran > 0


def agree(printed: str, said: str, where: str) -> None:
    """Words as they are, numbers to 1 %; `…` on a line of its own leaves the rest out."""
    ours, theirs = printed.strip().splitlines(), said.strip().splitlines()
    if theirs and theirs[-1].strip() == "…":
        theirs = theirs[:-1]
        ours = ours[: len(theirs)]
    assert len(ours) == len(theirs), f"{where} prints:\n{printed}"
    for our, their in zip(ours, theirs):
        words = [" ".join(NUMBER.sub("#", line).split()) for line in (our, their)]
        assert words[0] == words[1], f"{where} prints:\n{printed}"
        for number, expected in zip(NUMBER.findall(our), NUMBER.findall(their)):
            assert math.isclose(float(number), float(expected), rel_tol=1e-2, abs_tol=1e-9), (
                f"{where} prints:\n{printed}"
            )


@pytest.mark.parametrize("module", ["tribodyn", "tribodyn.case", "tribodyn.units"])
def test_limit_examples_of_docstrings(module: str) -> None:
    found = doctest.testmod(importlib.import_module(module))
    assert found.attempted > 0 and found.failed == 0


def test_identity_the_package_has_the_licence_of_the_project() -> None:
    """Both in the wheel and beside the sources."""
    assert (ROOT / "crates" / "python" / "LICENSE").read_bytes() == (ROOT / "LICENSE").read_bytes()
    metadata = importlib.metadata.metadata("tribodyn")
    assert metadata["License-Expression"] == "MIT" and "LICENSE" in (metadata.get_all("License-File") or [])


def test_limit_everything_public_is_documented() -> None:
    for name in tribodyn.__all__:
        thing = getattr(tribodyn, name)
        if callable(thing):
            assert thing.__doc__, name


def test_limit_every_attribute_of_an_answer_says_what_it_is() -> None:
    """In a comment above it, which the reference shows; with its unit, where it has one."""
    pycode = pytest.importorskip("sphinx.pycode")
    found = 0
    for module in MODULES:
        analyzer = pycode.ModuleAnalyzer.for_module(f"tribodyn.{module}")
        analyzer.analyze()
        for name, kind in vars(importlib.import_module(f"tribodyn.{module}")).items():
            if not isinstance(kind, type) or kind.__module__ != f"tribodyn.{module}" or name.startswith("_"):
                continue
            for attribute in vars(kind).get("__annotations__", {}):
                if not attribute.startswith("_"):
                    found += 1
                    assert (name, attribute) in analyzer.attr_docs, f"{module}.{name}.{attribute}"
    assert found > 300


def test_limit_the_reference_has_every_public_name(tmp_path: Path) -> None:
    """Without a warning; with all names of the package, and its attributes with their units."""
    pytest.importorskip("furo", reason="Sphinx or its theme is not installed")
    source = ROOT / "crates" / "python" / "reference"
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-d", str(tmp_path / "d")]
    done = subprocess.run([*command, str(source), str(tmp_path / "html")], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    inventory = (tmp_path / "html" / "objects.inv").read_bytes().split(b"zlib.\n", 1)[1]
    names = {line.split(" ")[0] for line in zlib.decompress(inventory).decode().splitlines()}
    # Units have a list of their own, as `tribodyn.kN` and the like.
    public = [name for name in tribodyn.__all__ if name not in ("__version__", "units")]
    assert not [name for name in public if f"tribodyn.{name}" not in names]
    assert "tribodyn.Solution.cage_speed_rpm" in names and "tribodyn.distributed.sweep" in names
    cases = (tmp_path / "html" / "cases.html").read_text(encoding="utf-8")
    assert all(f">{name}<" in cases for kind in tribodyn._native.unit_names() for name in kind)
    page = (tmp_path / "html" / "equilibria.html").read_text(encoding="utf-8")
    assert "Torque that the shaft needs" in page and "where a ball meets a wall of its pocket [°]" in page
