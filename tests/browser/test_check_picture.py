"""The picture beside a verdict: seen in the light and the dark, said to those who do not see, still until it is to move."""

import re

import pytest

from tests.browser.pages import set_theme

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

LAB = "from coursekit.lab import *"
INFLATION = """import math

def inflation_cost(distance, inscribed=0.2, scaling=3.0, radius=0.55):
    if distance <= inscribed:
        return 253 if distance > 0 else 254
    return int(252 * math.exp(-scaling * (distance - inscribed))) if distance <= radius else 0"""
STEP_OUT = """def manage(free, homes, loads):
    return {name: [(row, column), (row, column + 1)] for name, (row, column) in homes.items()}"""
PAPER = "(svg) => getComputedStyle(svg.querySelector('rect')).fill"
RUNNING = "() => document.querySelector('.ck-drawn .mover').getAnimations().length"
RULES = {"runOnly": {"type": "tag", "values": ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa"]}}


@pytest.fixture
def opened(notebook):
    open_notebook = notebook(LAB, INFLATION, 'check("ch09.q1")', STEP_OUT, 'check("ch09.q4")', width=1366, height=1500)
    open_notebook.run()
    return open_notebook


def test_a_picture_is_there_after_a_reload(opened):
    page = opened.page
    page.evaluate("jupyterapp.commands.execute('docmanager:save')")
    page.wait_for_function("() => !jupyterapp.shell.currentWidget.context.model.dirty")
    opened.load_again()
    page.get_by_role("img", name=re.compile("^Cost over the distance")).wait_for()


def test_a_picture_has_its_text_and_follows_the_theme(opened, picture):
    page = opened.page
    drawn = page.get_by_role("img", name=re.compile("^Cost over the distance from a wall"))
    drawn.wait_for()
    papers = []
    for light in (True, False):
        set_theme(page, light=light)
        papers.append(drawn.locator("svg").evaluate(PAPER))
        picture(page, f"check-{'light' if light else 'dark'}")
    assert papers == ["rgb(255, 255, 255)", "rgb(43, 53, 61)"]


def test_what_is_wrong_is_marked_and_robots_move_when_they_are_asked_to(opened, picture):
    page = opened.page
    drawn = page.get_by_role("img", name=re.compile("^warehouse 1 from above"))
    assert drawn.locator(".ring").count() > 0 and "what is wrong" in page.locator(".ck-drawn figcaption").last.inner_text()
    assert page.evaluate(RUNNING) == 0
    box = page.get_by_label("see them move")
    box.focus()
    page.keyboard.press("Space")
    assert box.is_checked() and page.evaluate(RUNNING) == 1 and drawn.locator(".mover").first.is_visible()
    picture(page, "check-moving")
    page.keyboard.press("Space")
    assert not box.is_checked() and page.evaluate(RUNNING) == 0


def test_pictures_have_no_fault_for_axe(opened):
    axe = pytest.importorskip("axe_playwright_python.sync_playwright").Axe()
    for light in (True, False):
        set_theme(opened.page, light=light)
        audit = axe.run(opened.page, context={"include": [[".ck-drawn"]]}, options=RULES).response
        assert audit["passes"] and not audit["violations"], audit["violations"]
