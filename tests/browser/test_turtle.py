"""The turtle is driven in a real browser."""

import json

import pytest

from tests.browser.pages import settled

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(180)]

SETUP = (
    "from coursekit.lab import *",
    "%ros2 run turtlesim turtlesim_node &",
    "window = turtlesim_window()\nwindow",
)
TURTLE = "_t = window.simulator.world.turtles[window.turtle]; "
STATE = TURTLE + "import json; print(json.dumps({'x': _t.x, 'y': _t.y, 'theta': _t.theta}))"
SPEED = TURTLE + "print(_t.speed, _t.turning)"
FAST = TURTLE + "print(_t.speed > 1.5)"


def state(notebook):
    return json.loads(notebook.ask(STATE))


def test_arrow_keys_drive_the_turtle_and_letting_go_stops_it(notebook, picture):
    opened = notebook(*SETUP)
    opened.run()
    page = opened.page
    sheet = page.locator(".ck-turtle .ck-sheet")
    sheet.wait_for(timeout=30_000)
    page.locator('.ck-turtle[data-state="running"]').wait_for(timeout=30_000)
    sheet.scroll_into_view_if_needed()
    sheet.locator("canvas").click(position={"x": 60, "y": 60})
    before = state(opened)

    page.keyboard.down("ArrowUp")
    page.keyboard.down("ArrowLeft")
    page.wait_for_timeout(1800)
    opened.eventually(SPEED, "2.0 2.0")
    page.keyboard.up("ArrowLeft")
    page.wait_for_timeout(700)
    page.keyboard.up("ArrowUp")
    opened.eventually(SPEED, "0.0 0.0")
    stopped = settled(page, lambda: state(opened))
    assert (stopped["x"], stopped["y"]) != (before["x"], before["y"])
    picture(page.locator(".ck-turtle"), "turtle")
    assert f"x {stopped['x']:.2f}" in page.locator(".ck-turtle .ck-pose").inner_text()

    page.keyboard.down("ArrowUp")
    opened.eventually(SPEED, "2.0 0.0")
    page.evaluate("document.activeElement.blur()")
    opened.eventually(SPEED, "0.0 0.0")
    page.keyboard.up("ArrowUp")


def test_the_stick_drives_and_another_turtle_can_be_picked(notebook, picture):
    opened = notebook(*SETUP)
    opened.run()
    page = opened.page
    page.locator('.ck-turtle[data-state="running"]').wait_for(timeout=30_000)
    spawn = "%ros2 service call /spawn turtlesim/srv/Spawn '{x: 2.0, y: 9.0, theta: 0.0, name: leo}'"
    opened.ask(spawn)
    opened.eventually("print('leo' in window.simulator.world.turtles)", "True")
    page.wait_for_timeout(400)
    canvas = page.locator(".ck-turtle canvas")
    canvas.scroll_into_view_if_needed()
    side = canvas.bounding_box()["width"]
    canvas.click(position={"x": 2.0 / 11.09 * side, "y": (1 - 9.0 / 11.09) * side})
    opened.eventually("print(window.turtle)", "leo")
    box = page.locator(".ck-turtle .ck-stick").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x, y - box["height"] / 2, steps=4)
    opened.eventually(FAST, "True")
    picture(page.locator(".ck-turtle"), "turtle_stick")
    page.mouse.up()
    opened.eventually(SPEED, "0.0 0.0")


def test_the_pad_drives_any_twist_topic(notebook, picture):
    opened = notebook(
        "from coursekit.lab import *\n%ros2 run turtlesim turtlesim_node &",
        "window = turtlesim_window()",
        "pad('/turtle1/cmd_vel', linear=1.0, angular=1.5)",
    )
    opened.run()
    page = opened.page
    field = page.locator(".ck-pad .ck-field")
    field.click(position={"x": 300, "y": 20})
    page.keyboard.down("w")
    page.keyboard.down("a")
    opened.eventually(SPEED, "1.0 1.5")
    picture(page.locator(".ck-pad"), "pad")
    page.keyboard.up("w")
    page.keyboard.up("a")
    opened.eventually(SPEED, "0.0 0.0")


def test_a_gamepad_drives_and_stops_with_the_stick_and_with_the_window_s_focus(notebook):
    opened = notebook(
        "from coursekit.lab import *\n%ros2 run turtlesim turtlesim_node &",
        "window = turtlesim_window()",
        "pad('/turtle1/cmd_vel', linear=1.0, angular=2.0)",
    )
    opened.page.evaluate("window.axes = [0, 0]; navigator.getGamepads = () => [null, { axes: window.axes }]")
    opened.run()
    page = opened.page
    page.locator(".ck-pad .ck-field").wait_for()
    page.evaluate("window.axes = [-0.5, -1]")
    opened.eventually(SPEED, "1.0 1.0")
    page.evaluate("window.axes = [0.05, 0.05]")
    opened.eventually(SPEED, "0.0 0.0")
    page.evaluate("window.axes = [0.5, 0]")
    opened.eventually(SPEED, "0.0 -1.0")
    page.evaluate("document.hasFocus = () => false; window.dispatchEvent(new Event('blur'))")
    opened.eventually(SPEED, "0.0 0.0")
