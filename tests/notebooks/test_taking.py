"""A chapter as students take it: read to its end, its exercises solved, wrongly at first, all of it run once more.

A copy without solutions fails only at its stubs. Wrong answers are refused with words that help. Exercises may be run again
from the last to the first. That earns all points, and leaves nothing behind.
"""

import json
import re
from collections import Counter
from contextlib import contextmanager

import nbformat
import pytest
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

from coursekit.grade.copy import student_notebook
from coursekit.grade.exercise import all_exercises
from tests.needs import can_compile, in_wine

from .answers import MODULES, answers_of, grade_id, is_check, is_graded, is_solution, must_fail, must_pass, verdict_of
from .running import chapters, clock_of, course_environment, exercises_of, read

SECONDS = 3600 if in_wine() else 1200
"""For a chapter: in Wine Numba compiles for minutes, in every kernel anew."""

pytestmark = [pytest.mark.timeout(SECONDS), pytest.mark.slow]

LEFT_BEHIND = """
from coursekit.processes.session import current as _current
reset()
print([p.name for p in _current().processes], [n.full_name for g in _current().graphs.values() for n in g.nodes])
"""


@pytest.fixture(params=chapters(), ids=lambda path: path.stem)
def chapter(request):
    return request.param


@contextmanager
def kernel_of(notebook, folder):
    """A function that executes a cell, given with its place, as JupyterLab does: it says which cell it is."""
    (folder / "ros2_ws" / "src").mkdir(parents=True)
    with course_environment(folder, clock_of(notebook)):
        resources = {"metadata": {"path": str(folder)}}
        client = NotebookClient(notebook, timeout=SECONDS / 4, kernel_name="python3", resources=resources)
        with client.setup_kernel():

            def execute(cell, index):
                client.kc.session.metadata = {"cellId": cell.id}
                stored = notebook.cells[index]
                try:
                    client.execute_cell(cell, index)
                finally:
                    notebook.cells[index] = stored  # nbclient puts there what it executed

            yield execute


def run(execute, notebook, index):
    """Execute a cell of a notebook, which must not fail; what it printed."""
    cell = notebook.cells[index]
    try:
        execute(cell, index)
    except CellExecutionError as error:
        raise AssertionError(f"{error}\nBefore it:\n{shown(notebook.cells[max(0, index - 12) : index])}") from None
    return printed(cell)


def printed(cell):
    """What a cell has printed, and what it shows as text."""
    return "".join(
        output.get("text", "") or output.get("data", {}).get("text/plain", "") for output in cell.get("outputs", [])
    )


def shown(cells):
    """Cells and what they printed: what went wrong began above the cell that failed."""
    return "\n".join(f"In: {cell.source[:300]}\nOut: {printed(cell)[-1500:]}" for cell in cells if cell.cell_type == "code")


def exercises(notebook):
    """The cells of each exercise that is judged here, from its heading to its check, in order."""
    cell_numbers, start = [], 0
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type == "markdown" and re.search(r"^## ", cell.source, re.MULTILINE):
            start = index
        elif grade_id(cell).endswith("-check") and is_judged(cell):
            cell_numbers.append([number for number in range(start, index + 1) if notebook.cells[number].cell_type == "code"])
    return cell_numbers


def is_judged(cell):
    """Whether this computer can judge an exercise: those in C++, which are voluntary, need a compiler."""
    name = grade_id(cell).removesuffix("-check").replace("-", ".")
    return all_exercises()[name].points > 0 or can_compile()


def doubled(folder):
    """Entries that stand twice in what a build reads: executables, files to install, dependencies."""
    for path in sorted((folder / "ros2_ws" / "src").rglob("*")):
        if path.name in ("setup.py", "package.xml", "CMakeLists.txt"):
            lines = Counter(line.strip() for line in path.read_text().splitlines() if re.search(r"\w{3}", line))
            entries = {
                line: count for line, count in lines.items() if re.search(r"_exe|depend>|glob\(|find_package|\.msg", line)
            }
            yield from (f"{path.name}: {line}" for line, count in entries.items() if count > 1)


def test_every_exercise_has_two_wrong_answers():
    known = {name for module in MODULES.values() for name, texts in module.WRONG.items() if len(texts) >= 2}
    assert known == {name for name in all_exercises() if name.startswith(("ch0", "app"))}  # others are of a teacher's own


def test_a_chapter_is_read_solved_gone_back_to_and_run_once_more(chapter, tmp_path):
    notebook = read(chapter)
    notebook.cells.append(nbformat.v4.new_code_cell(LEFT_BEHIND))
    with kernel_of(notebook, tmp_path) as execute:
        read_without_solving(execute, notebook, chapter)
        for cells in exercises(notebook):
            solve(execute, notebook, chapter, cells)
        before = list(doubled(tmp_path))
        for cells in reversed(exercises(notebook)):
            said = [run(execute, notebook, index) for index in cells]
            assert "Failed   <<<" not in "".join(said)
            assert said[-1].startswith("✔"), said[-1]
            assert list(doubled(tmp_path)) == before
        said = [run(execute, notebook, index) for index in once_more(notebook)]
    assert said[-1].splitlines()[-1] == "[] []"
    assert points_of(tmp_path, chapter) == {name: exercise.points for name, exercise in exercises_of(chapter).items()}


def read_without_solving(execute, notebook, chapter):
    """Run a student's copy, which fails only at the stubs that they are to fill in, and where their solutions are needed."""
    copy = nbformat.reads(json.dumps(student_notebook(json.loads(chapter.read_text(encoding="utf-8")))), as_version=4)
    for index, cell in enumerate(copy.cells):
        try:
            execute(cell, index)
        except CellExecutionError as error:
            assert is_graded(cell) or "after-exercise" in cell.metadata.get("tags", []), (cell.source, str(error))
            assert error.ename in ("NotImplementedError", "CheckFailed", "NameError"), str(error)
        else:
            assert not is_check(cell) or not is_judged(cell), f"the check passes without a solution: {cell.source}"


def solve(execute, notebook, chapter, cells):
    """Run an exercise's cells; before its solution all of its other answers."""
    wrong, right = answers_of(chapter, "WRONG"), answers_of(chapter, "RIGHT")
    for index in cells:
        cell = notebook.cells[index]
        if is_solution(cell):
            name = grade_id(cell).replace("-", ".")
            for answer in wrong.get(name, []):
                must_fail(execute, notebook.cells, index, answer)
            for answer in right.get(name, []):
                must_pass(execute, notebook.cells, index, answer)
        run(execute, notebook, index)
        assert not is_check(cell) or verdict_of(cell).startswith("✔"), verdict_of(cell)


def once_more(notebook):
    """The places of all cells, those under "Break it" twice: a text that is broken already is not kept as the good one."""
    heading = ""
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type == "markdown":
            heading = [heading, *re.findall(r"^## .*", cell.source, re.MULTILINE)][-1]
        yield from [index] * (2 if heading == "## Break it" else 1)


def points_of(folder, chapter):
    """What a student has, by exercise."""
    kept = folder / ".coursekit" / "progress.json"
    progress = json.loads(kept.read_text()) if exercises_of(chapter) else {}
    return {name: progress[name]["points"] for name in exercises_of(chapter)}
