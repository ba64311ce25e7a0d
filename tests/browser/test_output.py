"""What a cell starts prints into that cell, whatever else the page does meanwhile."""

import pytest

from tests.browser.page_scripts import BROKEN_WORDS

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(240)]

LIVE = """from coursekit.lab import *
%ros2 run turtlesim turtlesim_node &
view = viewer(displays=["Grid", "TF"])
turtlesim_window()"""
PACKAGE = '''%cd -q {workspace()}
%ros2 pkg create --build-type ament_python --destination-directory src broken
edit("src/broken/setup.py", "setup(", "setup(oops")'''
LATE = """import threading, time
threading.Thread(target=lambda: (time.sleep(1), print("said late"))).start()
time.sleep(2)"""

SLOW = """from coursekit.view.progress_bar import ProgressBar
with ProgressBar("Driving home"):
    time.sleep(8)"""


def outputs(page, source):
    """What stands below the cell with this text."""
    cell = page.locator(".jp-CodeCell", has_text=source).first
    return "\n".join(cell.locator(".jp-OutputArea-output").all_inner_texts())


def test_a_build_says_that_it_failed_while_a_live_viewer_is_in_the_page(notebook, picture):
    opened = notebook(LIVE, "view", PACKAGE, "%colcon build --packages-select broken", LATE, width=1300)
    opened.run()
    page = opened.page
    page.wait_for_timeout(1000)
    picture(page, "build-beside-viewer")
    said = outputs(page, "%colcon build")
    assert "Failed   <<< broken" in said and "Summary: 0 packages finished" in said, opened.text()
    assert "said late" in outputs(page, "said late")


def test_a_cell_that_misses_a_name_says_to_run_those_above(notebook, picture):
    opened = notebook("from coursekit.lab import *", "%cd -q /", "print(robot)", "robot = 'Vera'", width=1000, height=700)
    page = opened.page
    page.evaluate("void jupyterapp.commands.execute('notebook:run-all-cells')")
    page.locator(".jp-OutputArea-output", has_text="`robot` is made in another cell").wait_for(timeout=30_000)
    picture(page, "missing-name")
    assert "NameError" in outputs(page, "print(robot)")


def test_the_bar_of_a_slow_cell_is_there_while_a_live_viewer_is_in_the_page(notebook, picture):
    opened = notebook(LIVE, "view", "import time", SLOW, width=1300)
    page = opened.page
    page.evaluate("void jupyterapp.commands.execute('notebook:run-all-cells')")
    page.locator(".jp-OutputArea-output", has_text="Driving home").wait_for(timeout=60_000)
    picture(page, "bar-beside-viewer")


def test_words_of_an_output_stay_whole_in_a_narrow_window_and_a_long_path_stays_in_it(notebook, picture):
    cells = 'print("one robot after the other " * 20)', 'print("/tmp" * 100)', 'raise ValueError("so it is " * 40)'
    opened = notebook(*cells, width=900)
    page = opened.page
    page.evaluate("void jupyterapp.commands.execute('notebook:run-all-cells')")
    page.locator(".jp-OutputArea-output", has_text="Traceback").wait_for(timeout=30_000)
    texts = page.locator(".jp-OutputArea-output pre")
    picture(page, "narrow-output")
    assert [text.evaluate(BROKEN_WORDS) for text in (texts.first, texts.last)] == [[], []]
    assert texts.nth(1).evaluate("(pre) => pre.scrollWidth <= pre.clientWidth + 1")
