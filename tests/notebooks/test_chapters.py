"""Every chapter runs top to bottom, twice, leaves nothing behind, and its student's copy fails only at the stubs."""

import json

import nbformat
import pytest

from coursekit.grade.copy import student_notebook
from coursekit.grade.exercise import all_exercises

from .running import chapters, run

LEFT_BEHIND = """
from coursekit.core.session import current as _current
import threading as _threading
reset()
print([p.name for p in _current().processes], [n.full_name for g in _current().graphs.values() for n in g.nodes])
"""

pytestmark = [pytest.mark.timeout(600), pytest.mark.slow]


def read(path):
    return nbformat.read(path, as_version=4)


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code" and cell.source.strip()]


@pytest.fixture(params=chapters(), ids=lambda path: path.stem)
def chapter(request):
    return request.param


def test_a_chapter_runs_twice_in_one_kernel_and_leaves_nothing_behind(chapter, tmp_path):
    notebook = read(chapter)
    notebook.cells.append(nbformat.v4.new_code_cell(LEFT_BEHIND))
    run(notebook, tmp_path, timeout=300, times=2)
    assert notebook.cells[-1].outputs[-1]["text"].splitlines()[-1] == "[] []"


def test_a_student_s_copy_fails_only_at_the_stubs(chapter, tmp_path):
    copy = student_notebook(json.loads(chapter.read_text(encoding="utf-8")))
    notebook = nbformat.reads(json.dumps(copy), as_version=4)
    run(notebook, tmp_path, allow_errors=True, timeout=300)
    for cell in code_cells(notebook):
        errors = [output for output in cell.outputs if output.output_type == "error"]
        kind = cell.metadata.get("nbgrader", {})
        if errors:
            assert kind or "after-exercise" in cell.metadata.get("tags", []), (cell.source, errors[0]["evalue"])
            assert errors[0]["ename"] in ("NotImplementedError", "CheckFailed", "NameError"), errors[0]
        elif kind.get("locked"):
            pytest.fail(f"the check passes without a solution: {cell.source}")


def test_a_solved_chapter_earns_full_points(chapter, tmp_path):
    notebook = read(chapter)
    name = f"ch{chapter.stem[:2]}" if chapter.stem[0].isdigit() else f"app{chapter.stem[0].lower()}"
    wanted = {one for one in all_exercises() if one.startswith(f"{name}.")}
    checked = {cell.source.split('"')[1] for cell in code_cells(notebook) if cell.source.startswith("check(")}
    assert checked == wanted and len(wanted) >= 3
    run(notebook, tmp_path, timeout=300)
    progress = json.loads((tmp_path / ".coursekit" / "progress.json").read_text())
    assert {one: progress[one]["points"] for one in wanted} == {one: all_exercises()[one].points for one in wanted}


def test_a_chapter_is_short_to_read_and_every_section_is_compared(chapter):
    notebook = read(chapter)
    section, compared = "", {}
    for cell in notebook.cells:
        if cell.cell_type == "markdown" and cell.source.startswith("## "):
            section = cell.source.splitlines()[0]
            compared.setdefault(section, None)
        elif cell.cell_type == "code" and cell.source.strip():
            assert len(cell.source.splitlines()) <= 15, cell.source
            compared[section] = bool(compared.get(section)) or bool(cell.outputs)
    compared.pop("", None)  # the lines above the first section
    assert not [name for name, done in compared.items() if done is False]
