"""The workflow files say what GitHub reads, name every Python that the course is for, and commands that there are."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml

from coursekit.cli.system_checks import NEWEST

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).resolve().parents[1]
FILES = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
SYSTEMS = ("ubuntu-22.04", "ubuntu-24.04", "macos", "windows")


def read(file: Path) -> dict[str, Any]:
    """A workflow; YAML of before 2009 takes the word `on` for a truth value."""
    return dict(yaml.safe_load(file.read_text(encoding="utf-8")))


def test_there_is_a_workflow() -> None:
    assert FILES


@pytest.mark.parametrize("file", FILES, ids=lambda one: one.name)
def test_a_workflow_is_one_by_github_s_schema(file: Path) -> None:
    pytest.importorskip("check_jsonschema", reason="NOT TESTED: check-jsonschema is not installed")
    command = [sys.executable, "-m", "check_jsonschema", "--builtin-schema", "vendor.github-workflows", str(file)]
    done = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def test_each_system_is_tested_with_each_python_from_the_oldest_to_the_newest() -> None:
    with open(ROOT / "pyproject.toml", "rb") as file:
        oldest = int(tomllib.load(file)["project"]["requires-python"].removeprefix(">=3."))
    (matrix,) = [job["strategy"]["matrix"] for workflow in FILES for job in read(workflow)["jobs"].values()]
    assert matrix["python"] == [f"3.{minor}" for minor in range(oldest, NEWEST[1] + 1)]
    assert all(any(runner.startswith(system) for runner in matrix["os"]) for system in SYSTEMS)


@pytest.mark.parametrize("file", FILES, ids=lambda one: one.name)
def test_each_value_in_double_braces_is_one_that_the_workflow_has(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    known = {f"matrix.{key}" for job in read(file)["jobs"].values() for key in job["strategy"]["matrix"]} | {"runner.os"}
    assert set(re.findall(r"\$\{\{ *([\w.]+) *\}\}", text)) <= known
    assert set(re.findall(r"^ *if: ([\w.]+)", text, re.M)) <= known


@pytest.mark.parametrize("file", FILES, ids=lambda one: one.name)
def test_the_files_that_its_steps_run_are_there(file: Path) -> None:
    commands = [step["run"] for job in read(file)["jobs"].values() for step in job["steps"] if "run" in step]
    named = [word for command in commands for word in command.split() if word.endswith(".py") or word.startswith(".")]
    assert named and all((ROOT / path).is_file() for path in named)
    assert all(
        any(action in step["uses"] for action in ("checkout@v", "setup-python@v"))
        for job in read(file)["jobs"].values()
        for step in job["steps"]
        if "uses" in step
    )


def test_the_readme_says_that_nobody_has_seen_it_run() -> None:
    text = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())
    assert "`.github/workflows/tests.yml`" in text and "has not run yet" in text
