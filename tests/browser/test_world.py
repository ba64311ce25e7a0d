"""The world's view in a real JupyterLab: pause and go on, add a box, drag it, remove it, and what gzclient opens."""

from pathlib import Path

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

ROBOT = Path(__file__).parents[2] / "robots" / "urdf" / "robot_lidar.urdf"
LAB = "from coursekit.lab import *"
WORLD = "%ros2 launch gazebo_ros gazebo.launch.py world:=office &"
SPAWN = f"%ros2 run gazebo_ros spawn_entity.py -entity runner -file {ROBOT} -x 0.0 -y 1.0"
VIEW = "world = world_view()\nworld"
HAS = "(name) => Object.values(document.querySelector('.ck-world')?.world?.names ?? {}).includes(name)"
WHERE = """(name) => {
  const panel = document.querySelector('.ck-world'), { view } = panel.viewer;
  const number = Object.entries(panel.world.names).find((one) => one[1] === name)[0];
  const place = view.scene_tree.find(['scene', number]).object.getWorldPosition(panel.viewer.vector());
  const { x, y, z } = place; place.project(view.camera);
  const box = view.dom_element.getBoundingClientRect();
  return { x, y: -z, left: box.left + (place.x + 1) / 2 * box.width, top: box.top + (1 - place.y) / 2 * box.height };
}"""


@pytest.fixture
def opened(notebook):
    """A notebook with a world, a robot, and the view of it, from above."""
    open_notebook = notebook(LAB, WORLD, SPAWN, VIEW, width=1366, height=900)
    open_notebook.run()
    open_notebook.page.wait_for_function(HAS, arg="runner")
    open_notebook.page.locator(".ck-world").scroll_into_view_if_needed()
    return open_notebook


def moved(page, name, before):
    """Wait until a thing is elsewhere; where it is."""
    far = f"([name, x, y]) => {{ const at = ({WHERE})(name); return Math.hypot(at.x - x, at.y - y) > 0.3; }}"
    page.wait_for_function(far, arg=[name, before["x"], before["y"]])
    return page.evaluate(WHERE, name)


def test_a_box_is_added_dragged_and_removed(opened, picture):
    page = opened.page
    panel = page.locator(".ck-world")
    picture(panel, "world")
    page.get_by_role("button", name="From above").click()
    runner = page.evaluate(WHERE, "runner")
    page.get_by_role("button", name="Add a box").click()
    page.mouse.click(runner["left"] + 60, runner["top"])
    page.wait_for_function(HAS, arg="box_1")
    page.wait_for_function(f"(name) => ({WHERE})(name).x !== 0", arg="box_1")  # its name comes before its place
    box = page.evaluate(WHERE, "box_1")
    assert box["x"] > runner["x"] + 0.3 and abs(box["y"] - runner["y"]) < 0.3

    page.mouse.move(box["left"], box["top"])
    page.mouse.down()
    page.mouse.move(box["left"] + 20, box["top"] - 20, steps=4)
    page.mouse.move(box["left"] + 40, box["top"] - 40, steps=4)
    page.mouse.up()
    after = moved(page, "box_1", box)
    assert after["x"] > box["x"] and after["y"] > box["y"], "to the right is east, up is north"
    assert panel.locator(".ck-told").inner_text().startswith("box_1 at")
    picture(panel, "world-from-above")

    page.get_by_role("button", name="Remove box_1").click()
    page.wait_for_function(f"() => !({HAS})('box_1')")


def test_it_is_paused_stepped_and_goes_on(opened):
    page = opened.page
    panel = page.locator(".ck-world")
    time = panel.locator(".ck-time")
    page.get_by_role("button", name="Pause").click()
    page.wait_for_function("() => document.querySelector('.ck-world .ck-time').innerText.includes('paused')")
    before = float(time.inner_text().split()[0])
    for _ in range(4):
        page.get_by_role("button", name="Step").click()
    later = "(least) => parseFloat(document.querySelector('.ck-world .ck-time').innerText) >= least"
    page.wait_for_function(later, arg=before + 0.15)
    assert "paused" in time.inner_text()
    page.get_by_role("button", name="Play").click()
    page.wait_for_function("() => document.querySelector('.ck-world .ck-time').innerText.includes('x real time')")


def test_gzclient_opens_it(notebook):
    start = "%ros2 launch gazebo_ros gazebo.launch.py world:=office &"
    open_notebook = notebook(LAB, start, "%ros2 run gazebo_ros gzclient &", height=900)
    open_notebook.run()
    open_notebook.page.wait_for_selector(".ck-world[data-messages]")
    open_notebook.page.wait_for_function("() => !document.querySelector('.ck-world .ck-nothing:not([hidden])')")


def test_it_fills_the_desk(notebook, picture):
    open_notebook = notebook(LAB, WORLD, "world = world_view()\ndesk(world, pad())", width=1366, height=768)
    open_notebook.run()
    open_notebook.page.wait_for_selector(".jupyterlab-sidecar .ck-world[data-messages]")
    open_notebook.page.wait_for_function(HAS, arg="house")
    assert "beside this notebook: world view, pad" in open_notebook.text()
    sizes = {
        name: open_notebook.page.locator(f".jupyterlab-sidecar {name}").bounding_box() for name in (".ck-world", ".ck-pad")
    }
    assert sizes[".ck-world"]["height"] > 380 and sizes[".ck-pad"]["y"] + sizes[".ck-pad"]["height"] <= 768
    picture(open_notebook.page, "world-desk")
