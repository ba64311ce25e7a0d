"""A robot is driven with the pad in a real browser, and its map grows in the view."""

from pathlib import Path

import pytest

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

CART = Path(__file__).parents[2] / "robots" / "urdf" / "robot_lidar.urdf"
WORLD = f"""
from coursekit.lab import *
%ros2 launch gazebo_ros gazebo.launch.py world:=tec_warehouse &
%ros2 run robot_state_publisher robot_state_publisher {CART} --ros-args -p use_sim_time:=true &
%ros2 run gazebo_ros spawn_entity.py -entity robot_lidar -file {CART} -x 0.5 -y 0.5
%ros2 launch slam_toolbox online_async_launch.py &
"""
WAIT = "wait(2.0)"
VIEW = """
shown = viewer(fixed_frame="map", displays=["Grid", "Map /map", "LaserScan /scan", "RobotModel"],
               view={"distance": 14.0, "pitch": 1.2, "yaw": -1.57, "target": [2, 0, 0]})
shown
"""
KNOWN = "from coursekit.lab.map_view import map_view as look; print((look().grid.cells >= 0).sum())"
DRIVEN = "from coursekit.lab.simulated import simulator; one = simulator(); one.advance(); {}"
WHERE = DRIVEN.format("print(one.simulation.robots['robot_lidar'].place.x)")
STANDS = DRIVEN.format("print(abs(one.simulation.velocity_of('robot_lidar')[0]) < 0.01)")


def test_the_map_grows_while_the_pad_drives(notebook, picture):
    opened = notebook(WORLD.strip(), WAIT, "hand = pad(linear=0.6)\nhand", VIEW.strip(), height=1300)
    opened.run()
    page = opened.page
    page.wait_for_function("() => document.querySelectorAll('.ck-viewer .ck-row').length === 4", timeout=60_000)
    opened.eventually("print(shown.status('Map').split(':')[0])", "Ok", patience=60.0)
    before, began = int(opened.ask(KNOWN)), float(opened.ask(WHERE))

    field = page.locator(".ck-pad .ck-field")
    field.click()
    page.keyboard.down("ArrowUp")
    opened.eventually(f"{WHERE.replace('print(', 'print(2.5 < ')}", "True", patience=60.0)
    page.keyboard.up("ArrowUp")
    opened.eventually(STANDS, "True")
    assert float(opened.ask(WHERE)) > began + 1.5

    opened.eventually(f"{KNOWN.replace('print((', f'print({before} + 500 < (')}", "True", patience=60.0)
    panel = page.locator(".ck-viewer").first
    panel.scroll_into_view_if_needed()
    levels = panel.locator(".ck-row .ck-dot").evaluate_all("dots => dots.map((dot) => dot.title)")
    assert levels == ["Ok"] * 4
    picture(page.locator(".jp-Notebook"), "mapping")
