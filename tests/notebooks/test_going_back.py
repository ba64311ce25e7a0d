"""A chapter runs top to bottom; a student goes back to its exercises, from the last to the first; then it runs once more.

That earns its points, and leaves nothing behind.
"""

import json
import re
from collections import Counter
from contextlib import contextmanager

import nbformat
import pytest
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError

from .running import chapters, clock_of, course_environment, exercises_of, read

pytestmark = [pytest.mark.timeout(900), pytest.mark.slow]

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
    """A function that runs one cell as JupyterLab does, which says which cell it is; it gives what was printed."""
    (folder / "ros2_ws" / "src").mkdir(parents=True)
    with course_environment(folder, clock_of(notebook)):
        resources = {"metadata": {"path": str(folder)}}
        client = NotebookClient(notebook, timeout=300, kernel_name="python3", resources=resources)
        with client.setup_kernel():

            def run(index):
                cell = notebook.cells[index]
                client.kc.session.metadata = {"cellId": cell.id}
                try:
                    client.execute_cell(cell, index)
                except CellExecutionError as error:
                    raise AssertionError(f"{error}\nBefore it:\n{shown(notebook.cells[max(0, index - 12) : index])}") from None
                return printed(cell)

            yield run


def printed(cell):
    """What a cell has printed, and what it shows as text."""
    return "".join(one.get("text", "") or one.get("data", {}).get("text/plain", "") for one in cell.get("outputs", []))


def shown(cells):
    """Cells and what they printed: what went wrong began above the cell that failed."""
    return "\n".join(f"In: {cell.source[:300]}\nOut: {printed(cell)[-1500:]}" for cell in cells if cell.cell_type == "code")


def exercises(notebook):
    """The cells of each exercise, from its heading to its check, in order."""
    found, start = [], 0
    for index, cell in enumerate(notebook.cells):
        if cell.cell_type == "markdown" and re.search(r"^## ", cell.source, re.MULTILINE):
            start = index
        elif cell.metadata.get("nbgrader", {}).get("grade_id", "").endswith("-check"):
            found.append([one for one in range(start, index + 1) if notebook.cells[one].cell_type == "code"])
    return found


def doubled(folder):
    """Entries that stand twice in what a build reads: executables, files to install, dependencies."""
    for path in sorted((folder / "ros2_ws" / "src").rglob("*")):
        if path.name in ("setup.py", "package.xml", "CMakeLists.txt"):
            lines = Counter(line.strip() for line in path.read_text().splitlines() if re.search(r"\w{3}", line))
            entries = {line: count for line, count in lines.items() if re.search(r"_exe|depend>|glob\(|find_package|\.msg", line)}
            yield from (f"{path.name}: {line}" for line, count in entries.items() if count > 1)


def test_exercises_can_be_run_again_and_the_whole_chapter_too(chapter, tmp_path):
    notebook = read(chapter)
    notebook.cells.append(nbformat.v4.new_code_cell(LEFT_BEHIND))
    with kernel_of(notebook, tmp_path) as run:
        for index in range(len(notebook.cells) - 1):
            run(index)
        before = list(doubled(tmp_path))
        for cells in reversed(exercises(notebook)):
            said = [run(index) for index in cells]
            assert "Failed   <<<" not in "".join(said)
            assert said[-1].startswith("✔"), said[-1]
            assert list(doubled(tmp_path)) == before
        said = [run(index) for index in range(len(notebook.cells))]
    assert said[-1].splitlines()[-1] == "[] []"
    assert points_of(tmp_path, chapter) == {name: exercise.points for name, exercise in exercises_of(chapter).items()}


def points_of(folder, chapter):
    """What a student has, by exercise."""
    kept = folder / ".coursekit" / "progress.json"
    progress = json.loads(kept.read_text()) if exercises_of(chapter) else {}
    return {name: progress[name]["points"] for name in exercises_of(chapter)}
