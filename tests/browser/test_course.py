"""The course as a student opens it: `coursekit lab`, chapter 1, the turtle, a terminal; then chapter 5."""

import re

import pytest

from tests.browser.pages import settled

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(420)]
PATIENCE_MS = 120_000
SCREEN = """(wanted) => {
    const buffer = jupyterapp.shell.currentWidget?.content?._term?.buffer.active;
    const lines = [...Array(buffer?.length ?? 0).keys()].map((i) => buffer.getLine(i)?.translateToString(true) ?? '');
    return lines.some((line) => line.trim() && line.includes(wanted));
}"""
"""Whether a line of the terminal in front contains a text."""


def show(locator):
    """Bring a part of the page into view."""
    locator.scroll_into_view_if_needed(timeout=PATIENCE_MS)
    return locator


def pose(page):
    """How far the turtle has come, as its window says."""
    text = page.locator(".ck-turtle .ck-pose").first.inner_text()
    return [float(number) for number in re.findall(r"-?\d+\.\d+", text)]


def test_chapter_1_runs_and_the_turtle_is_driven_by_keys(chapter, picture):
    opened = chapter("01_first_nodes.ipynb")
    page = opened.page
    assert opened.run_to("graph()") > 0
    page.locator(".ck-terminal .ck-screen", has_text="I heard: [Hello World: 1]").wait_for(timeout=PATIENCE_MS)
    page.wait_for_timeout(500)
    picture(page, "chapter1")

    opened.run_to("turtlesim_window()")
    canvas = show(page.locator(".ck-turtle canvas").first)
    page.locator('.ck-turtle[data-state="running"]').first.wait_for(timeout=PATIENCE_MS)
    canvas.click(position={"x": 40, "y": 40})
    before = settled(page, lambda: pose(page))
    page.keyboard.down("ArrowUp")
    page.wait_for_timeout(1200)
    page.keyboard.up("ArrowUp")
    assert settled(page, lambda: pose(page)) != before, "the turtle did not move"
    picture(page, "turtle")

    opened_terminal = page.evaluate(
        "async () => { const made = await jupyterapp.commands.execute('terminal:create-new'); return made.id; }"
    )
    assert opened_terminal
    page.locator(".jp-Terminal .xterm-helper-textarea").wait_for(state="attached", timeout=PATIENCE_MS)
    page.wait_for_function(SCREEN, arg="", timeout=60_000)
    page.locator(".jp-Terminal .xterm-screen").click()
    page.keyboard.type("ros2 topic echo /turtle1/pose --once\n")
    page.wait_for_function(SCREEN, arg="linear_velocity:", timeout=60_000)
    page.wait_for_timeout(500)
    picture(page, "terminal")
    page.evaluate("() => jupyterapp.shell.currentWidget.dispose()")
    page.locator(".jp-NotebookPanel").first.wait_for()

    show(page.locator(".ck-terminal", has_text="turtlesim_node").locator(".ck-stop").first).click()
    page.locator('.ck-terminal:not([data-state="running"])', has_text="turtlesim_node").first.wait_for(timeout=30_000)


def test_chapter_5_runs_to_its_camera(chapter, picture):
    opened = chapter("05_parameters_launch_images.ipynb")
    assert opened.run_to("image_view(") > 0
    image = show(opened.page.locator(".ck-picture img").first)
    image.wait_for(timeout=PATIENCE_MS)
    opened.page.wait_for_timeout(1500)
    picture(opened.page, "chapter5")
    errors = opened.page.locator(".jp-OutputArea-output[data-mime-type='application/vnd.jupyter.stderr']").count()
    assert errors == 0
