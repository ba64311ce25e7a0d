"""Chapter 7's network of four robots and eight cylinders: how much faster than time it runs, with a viewer and without."""

import json
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient

sys.path.insert(0, str(Path(__file__).parents[2]))  # this runs as a script, from elsewhere
from tests.notebooks.running import NOTEBOOKS, course_environment

SKIP = ("check(", "turtle_tf2", "turtlesim_window", "tf2_echo", "cmd_vel", "frames()", "graph()")
MEASURE = """
import time

def speed():
    begun = time.perf_counter()
    wait(10)
    return 10 / (time.perf_counter() - begun)

viewed = max(speed() for _ in range(12))  # the least disturbed, as timeit takes it
hall.close()
print([viewed, max(speed() for _ in range(12))])
"""


def cells() -> list[nbformat.NotebookNode]:
    """The chapter's cells that build and start the network and show it."""
    chapter = nbformat.read(next(NOTEBOOKS.glob("07_*.ipynb")), as_version=4)
    sources = [cell.source for cell in chapter.cells if cell.cell_type == "code"]
    shown = next(number for number, source in enumerate(sources) if source.endswith("\ndesk(hall)"))
    wanted = [source for source in sources[: shown + 1] if not any(word in source for word in SKIP)]
    return [nbformat.v4.new_code_cell(source) for source in (*wanted, MEASURE)]


def speeds() -> list[float]:
    """Times real time, with the viewer and without."""
    notebook = nbformat.v4.new_notebook(cells=cells())
    with tempfile.TemporaryDirectory() as course, course_environment(Path(course)):
        (Path(course) / "ros2_ws" / "src").mkdir(parents=True)
        NotebookClient(notebook, timeout=300, kernel_name="python3", resources={"metadata": {"path": course}}).execute()
    measured: list[float] = json.loads(notebook.cells[-1].outputs[0]["text"])
    return measured


if __name__ == "__main__":
    print(json.dumps(speeds()))
