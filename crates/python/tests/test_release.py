"""What a release is made by: the workflow file, and the lists that it repeats."""

from __future__ import annotations

import re
import shutil
import subprocess
from typing import Any

import pytest

from .conftest import ROOT

WORKFLOW = ROOT / ".github" / "workflows" / "release.yml"


@pytest.fixture
def jobs() -> Any:
    yaml = pytest.importorskip("yaml")
    workflow = yaml.safe_load(WORKFLOW.read_text(encoding="utf-8"))
    # YAML reads `on` as true.
    assert workflow["name"] == "release" and workflow[True]
    return workflow["jobs"]


def test_limit_the_workflow_is_whole(jobs: Any) -> None:
    for name, job in jobs.items():
        assert set(job.get("needs", [])) <= set(jobs), name
        matrix = job.get("strategy", {}).get("matrix", {}).get("include", [])
        text = str(job)
        used = set(re.findall(r"\$\{\{ matrix\.(\w+) \}\}", text))
        assert all(used <= set(entry) for entry in matrix) and bool(matrix) == bool(used), name
        for step in job["steps"]:
            assert ("uses" in step) != ("run" in step), step
            assert "uses" not in step or re.fullmatch(r"[\w.-]+/[\w.-]+@v\d+", step["uses"]), step
    # Linux, macOS and Windows, on x86-64 and ARM.
    for kind in ("command", "wheels"):
        targets = [entry["target"] for entry in jobs[kind]["strategy"]["matrix"]["include"]]
        assert len(targets) == 5 and sum("aarch64" in target for target in targets) == 2


def test_limit_its_shell_scripts_are_read_by_a_shell(jobs: Any) -> None:
    shell = shutil.which("bash")
    if shell is None:
        pytest.skip("there is no bash")
    scripts = [step["run"] for job in jobs.values() for step in job["steps"] if "run" in step]
    assert len(scripts) > 8
    for script in scripts:
        # What GitHub puts in is a word.
        plain = re.sub(r"\$\{\{[^}]*\}\}", "word", script)
        done = subprocess.run([shell, "-n"], input=plain, capture_output=True, text=True, check=False)
        assert done.returncode == 0, (script, done.stderr)


def test_identity_unpublished_crates_are_left_out_everywhere() -> None:
    manifests = {path: path.read_text(encoding="utf-8") for path in ROOT.glob("crates/*/Cargo.toml")}
    manifests[ROOT / "xtask" / "Cargo.toml"] = (ROOT / "xtask" / "Cargo.toml").read_text(encoding="utf-8")
    private = {
        re.search(r'^name = "(.+)"', text, re.MULTILINE)[1]  # type: ignore[index]
        for text in manifests.values()
        if re.search(r"^publish = false", text, re.MULTILINE)
    }
    assert {"xtask", "tribodyn-paper"} <= private
    for page in (WORKFLOW, ROOT / "CONTRIBUTING.md"):
        line = next(
            line for line in page.read_text(encoding="utf-8").splitlines() if "cargo package --workspace" in line
        )
        assert set(re.findall(r"--exclude (\S+)", line)) == private, page
    # Nothing that is published needs what is not.
    for path, text in manifests.items():
        if "publish = false" not in text:
            needed = text.split("[dependencies]")[1].split("\n[")[0]
            assert not [name for name in private if re.search(rf"^{name}[ .]", needed, re.MULTILINE)], path
