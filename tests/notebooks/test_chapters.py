"""Every chapter runs top to bottom, twice, earns its points and leaves nothing behind."""

import json

import nbformat
import pytest

from coursekit.grade.exercise import all_exercises

from .running import ONLY_TO_READ, chapters, code_cells, read, run

LEFT_BEHIND = """
from coursekit.processes.session import current as _current
import threading as _threading
reset()
print([p.name for p in _current().processes], [n.full_name for g in _current().graphs.values() for n in g.nodes])
"""

pytestmark = [pytest.mark.timeout(600), pytest.mark.slow]


@pytest.fixture(params=chapters(), ids=lambda path: path.stem)
def chapter(request):
    return request.param


def exercises_of(chapter):
    name = f"ch{chapter.stem[:2]}" if chapter.stem[0].isdigit() else f"app{chapter.stem[0].lower()}"
    return {one: exercise for one, exercise in all_exercises().items() if one.startswith(f"{name}.")}


def test_every_exercise_of_a_chapter_is_checked_in_it(chapter):
    sources = [cell.source for cell in code_cells(read(chapter))]
    checked = {source.split('"')[1] for source in sources if source.startswith("check(")}
    assert checked == set(exercises_of(chapter)) and (len(checked) >= 3 or chapter.stem in ONLY_TO_READ)


def test_a_chapter_runs_twice_in_one_kernel_earns_full_points_and_leaves_nothing_behind(chapter, tmp_path):
    notebook = read(chapter)
    notebook.cells.append(nbformat.v4.new_code_cell(LEFT_BEHIND))
    run(notebook, tmp_path, timeout=300, times=2)
    assert notebook.cells[-1].outputs[-1]["text"].splitlines()[-1] == "[] []"
    kept = tmp_path / ".coursekit" / "progress.json"
    progress = json.loads(kept.read_text()) if chapter.stem not in ONLY_TO_READ else {}
    wanted = {name: exercise.points for name, exercise in exercises_of(chapter).items()}
    assert {name: progress[name]["points"] for name in wanted} == wanted


def test_a_chapter_begins_with_what_every_kernel_of_the_lab_has_anyway(chapter):
    """So nothing is missing after a restart, whichever cell is run first."""
    assert code_cells(read(chapter))[0].source == "from coursekit.lab import *\n\nreset()"


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
