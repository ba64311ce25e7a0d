"""A student's way on Windows: the course of Windows' own Python under Wine, in a real Chromium; `make windows` runs it.

Each chapter is the student's copy, with the exercises solved. It is run cell by cell, on the wall clock. No cell but those
that are meant to may end in an error, and every check gives its point.
"""

import os
import re
import sys
import time
import urllib.request

import nbformat
import pytest

from tests.browser.pages import serving
from tests.windows import wine

pytestmark = [
    pytest.mark.browser,
    pytest.mark.slow,
    pytest.mark.timeout(2400),
    pytest.mark.skipif("COURSEKIT_WINE_LAB" not in os.environ, reason="`make windows` runs it, in Wine"),
]
SERVE = """
import sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
from tests.windows import wine
sys.exit(wine.run(wine.PYTHON, *sys.argv[2:], folder=Path.cwd()))
"""
"""Runs a program of Windows in the folder that this program is in."""
SOLVE = """(solved) => {
    for (const cell of jupyterapp.shell.currentWidget.content.widgets) {
        const text = solved[cell.model.getMetadata('nbgrader')?.grade_id];
        if (text !== undefined) cell.model.sharedModel.setSource(text);
    }
}"""
RUN_TO = """async ([from, to]) => {
    const panel = jupyterapp.shell.currentWidget;
    const cells = panel.content.widgets;
    for (let i = from; i <= Math.min(to, cells.length - 1); i++) {
        if (cells[i].model.type !== 'code') continue;
        panel.content.activeCellIndex = i;
        panel.content.deselectAll();
        await jupyterapp.commands.execute('notebook:run-cell');
    }
    await panel.content.scrollToItem(Math.min(to, cells.length - 1), 'center');
}"""
SOURCES = "() => jupyterapp.shell.currentWidget.content.widgets.map((cell) => cell.model.sharedModel.getSource())"
OUTPUTS = """() => jupyterapp.shell.currentWidget.content.widgets.filter((one) => one.model.type === 'code').map((cell) => ({
    source: cell.model.sharedModel.getSource(),
    wanted: (cell.model.getMetadata('tags') ?? []).includes('raises-exception'),
    outputs: cell.model.outputs.toJSON().map((one) => one.output_type === 'error' ? { error: one.traceback.join('\\n') }
        : { text: one.text ?? one.data?.['text/plain'] ?? '' }),
}))"""
PLAIN = re.compile(r"\x1b\[[\d;]*m")


@pytest.fixture(scope="module")
def course(tmp_path_factory, browser):
    """`coursekit lab` of Windows' Python in an empty folder, as a student starts it."""
    folder = tmp_path_factory.mktemp("student")
    env = {name: value for name, value in os.environ.items() if not name.startswith(("COURSEKIT_TIME", "ROS_", "AMENT_"))}
    command = [sys.executable, "-c", SERVE, str(wine.ROOT), "-m", "coursekit.cli.coursekit", "lab", "--no-browser", "--"]
    with serving(folder, command, env) as served:
        yield served
        request = urllib.request.Request(f"{served.url}/api/shutdown?token={served.token}", method="POST")
        urllib.request.urlopen(request, timeout=60).close()


def solutions(name):
    """The solved exercises of a chapter by their names."""
    cells = nbformat.read(wine.ROOT / "notebooks" / name, as_version=4).cells
    return {cell.metadata.nbgrader.grade_id: cell.source for cell in cells if "nbgrader" in cell.metadata}


def take(opened, page_of, picture, *stops):
    """Run a chapter to its end, with pictures of the cells that contain the `stops`; what each cell printed."""
    page = opened.page
    page.evaluate(SOLVE, solutions(page_of))
    cells = page.evaluate(SOURCES)
    at = 0
    for number, stop in enumerate(stops):
        until = next(i for i, source in enumerate(cells) if stop in source and i >= at)
        page.evaluate(RUN_TO, [at, until])
        page.wait_for_timeout(4000)
        picture(page, f"windows-{page_of[:2]}-{number}")
        at = until + 1
    page.evaluate(RUN_TO, [at, len(cells)])
    return page.evaluate(OUTPUTS)


PASSED = r": (\d+) of \1 points?|: skipped\s+why: There is no C\+\+ compiler here, and this exercise has no points"


def faults(cells):
    """Cells with an error that was not meant, and checks without all their points; those in C++ need none."""
    said = []
    for cell in cells:
        text = PLAIN.sub("", "\n".join("".join(output.get("text", "")) for output in cell["outputs"]))
        errors = [output["error"] for output in cell["outputs"] if "error" in output]
        if errors and not cell["wanted"]:
            said.append(f"{cell['source'][:200]}\n{PLAIN.sub('', errors[0])[-1500:]}")
        if cell["source"].startswith("check(") and not re.search(PASSED, text):
            said.append(f"{cell['source']}\n{text}")
    return said


CHAPTERS = {
    "00_start_here.ipynb": ("viewer(", "drive.press(", "terminals("),
    "01_first_nodes.ipynb": ("graph()", "turtlesim_window()", "keys = terminal(", "terminals("),
    "02_topics.ipynb": ("graph()", "%colcon build", "%ros2 run s2_py_pubsub subscriber_exe &", "graph()", "terminals("),
    "08_maps_and_slam.ipynb": ("viewer(", "map_view(tour=around)", "view = viewer(", "%show warehouse.yaml", "map_view()"),
}


@pytest.mark.parametrize("name", CHAPTERS)
def test_a_chapter_is_taken_to_its_end(chapter, picture, name):
    began = time.monotonic()
    cells = take(chapter(name), name, picture, *CHAPTERS[name])
    print(f"{name}: {len(cells)} cells in {time.monotonic() - began:.0f} s")
    assert not (problems := faults(cells)), "\n----\n".join(problems)
    assert all(cell["outputs"] is not None for cell in cells) and len(cells) > 20


def test_the_package_and_the_map_of_the_chapters_are_files_of_windows(course):
    """Built by setuptools as on Windows, and saved by the map's own program."""
    [workspace] = [folder for folder in course.folder.rglob("ros2_ws") if folder.is_dir()]
    [program] = workspace.glob("install/s2_py_pubsub/[Ll]ib/s2_py_pubsub/publisher_exe.exe")  # one folder to Windows
    assert program.is_file()
    told = (workspace / "warehouse.yaml").read_text(encoding="utf-8")
    assert "image: warehouse.pgm" in told and (workspace / "warehouse.pgm").stat().st_size > 1000
