"""Nothing of a solution is in what people get: the wheel, the source archive, the student's copy, a release."""

import io
import json
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import pytest

from coursekit.grade.copy import Course
from coursekit.grade.release import release
from tests.grade.solutions import MARKER, NOTEBOOKS, found_in, solutions

ROOT = NOTEBOOKS.parent
KNOW_THE_MARKER = ("coursekit/grade/copy.py", "docs/own_exercises.md", "docs/adding.md")


@pytest.fixture(scope="module")
def archives(tmp_path_factory):
    """The source archive, and the wheel that is built of it, as {name: text}."""
    folder = tmp_path_factory.mktemp("dist")
    _build(ROOT, "sdist", folder)
    with tarfile.open(next(folder.glob("*.tar.gz"))) as packed:
        packed.extractall(folder / "unpacked", **({"filter": "data"} if hasattr(tarfile, "data_filter") else {}))
    unpacked = next((folder / "unpacked").iterdir())
    source = {path.relative_to(unpacked).as_posix(): path.read_bytes() for path in unpacked.rglob("*") if path.is_file()}
    _build(unpacked, "wheel", folder)
    with zipfile.ZipFile(next(folder.glob("*.whl"))) as packed:
        return {"sdist": source, "wheel": {name: packed.read(name) for name in packed.namelist()}}


def _build(root: Path, target: str, out: Path) -> None:
    command = [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", str(out)]
    done = subprocess.run(command, cwd=root, capture_output=True, encoding="utf-8")
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("kind", ["sdist", "wheel"])
def test_an_archive_holds_the_chapters_without_their_solutions(archives, kind):
    files = archives[kind]
    assert ("docs/teachers.md" if kind == "sdist" else "coursekit/teachers.md") in files
    chapters = {path.name for path in NOTEBOOKS.glob("*.ipynb")}
    assert {Path(name).name for name in files if name.endswith(".ipynb")} == chapters
    pictures = {path.name for path in NOTEBOOKS.glob("images/*")}
    assert {Path(name).name for name in files if "/notebooks/images/" in name} == pictures
    for name, content in files.items():
        text = content.decode("utf-8", "replace")
        said = [finding for finding in found_in(text) if not (finding == "a marker" and name in KNOW_THE_MARKER)]
        assert not said, f"{name} holds {said}"


def test_the_copy_and_the_release_hold_no_solution(tmp_path):
    Course(tmp_path / "course").update(NOTEBOOKS)
    written = release(sorted(NOTEBOOKS.glob("*.ipynb")), tmp_path / "release")
    texts = [path.read_text() for path in [*tmp_path.glob("course/*.ipynb"), *tmp_path.glob("release/*.ipynb")]]
    with zipfile.ZipFile(next(path for path in written if path.suffix == ".zip")) as packed:
        texts += [io.TextIOWrapper(packed.open(name), "utf-8").read() for name in packed.namelist()]
    assert len(texts) == 3 * len(list(NOTEBOOKS.glob("*.ipynb"))) + len(list(NOTEBOOKS.glob("images/*")))
    assert [found_in(text) for text in texts] == [[]] * len(texts)


def test_the_search_finds_what_it_looks_for():
    long = max(solutions(), key=len)
    assert len(solutions()) > 30
    assert found_in(f"# hidden\n{long}") and found_in("x\n" + MARKER) == ["a marker"]
    notebook = {"cells": [{"cell_type": "code", "source": "def other_name(a):\n    pass\n"}]}
    assert found_in(json.dumps(notebook, indent=1)) == []
    notebook["cells"][0]["source"] = long
    assert found_in(json.dumps(notebook, indent=1))
    function = next(solution for solution in solutions() if solution.startswith("def ") and len(solution) > 200)
    renamed = function.replace("def ", "def my_", 1).replace("    ", "  ")
    assert any("syntax tree" in finding for finding in found_in(renamed + "\n# not the same text"))
