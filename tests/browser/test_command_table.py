"""A table of commands on a narrow page: its columns stand below each other, and no meaning is cut."""

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(240)]

LONG = "reads a robot's description and prints its tree, or what is wrong with it, in the words of the ROS tool"
TABLE = f"%%commands\ncheck_urdf robot.urdf | {LONG}\nros2 node list | all nodes"
LEFT = "all => all.map(one => Math.round(one.getBoundingClientRect().left))"
CUT = "all => all.filter(one => one.scrollWidth > one.clientWidth).length"


def test_the_meanings_of_commands_stand_below_each_other_and_whole(notebook, picture):
    opened = notebook(TABLE)
    opened.run()
    page = opened.page
    page.set_viewport_size({"width": 1100, "height": 700})
    page.wait_for_function("() => document.querySelectorAll('.widget-text').length === 2", timeout=30_000)
    meanings = page.locator(".widget-text + *")
    assert meanings.count() == 2 and len(set(meanings.evaluate_all(LEFT))) == 1
    assert meanings.evaluate_all(CUT) == 0 and LONG in meanings.first.inner_text()
    picture(page.locator(".jp-OutputArea-output").first, "command-table")
