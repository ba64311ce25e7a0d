"""The viewer in a real JupyterLab: a robot that circles, sliders, RViz's tools, a reload, a kernel restart."""

import json
import math
from pathlib import Path

import pytest

from .pages import settled, start_beside

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

ROBOT = Path(__file__).parents[2] / "robots" / "urdf" / "rdk_x3_robot.urdf"
LAB = "from coursekit.lab import *"
PUBLISHERS = f"""
%ros2 run robot_state_publisher robot_state_publisher {ROBOT} &
"""
JOINTS = "%ros2 run joint_state_publisher joint_state_publisher &"
CIRCLE = """
%%write circle.py
import math, rclpy
from geometry_msgs.msg import PoseStamped, TransformStamped
from nav_msgs.msg import Odometry, Path
from rclpy.node import Node
from sensor_msgs.msg import LaserScan
from tf2_ros import TransformBroadcaster
from visualization_msgs.msg import Marker, MarkerArray

class Circle(Node):
    def __init__(self):
        super().__init__("circle")
        self.tf, self.angle, self.trail = TransformBroadcaster(self), 0.0, []
        self.scan = self.create_publisher(LaserScan, "/scan", 5)
        self.path = self.create_publisher(Path, "/plan", 5)
        self.odom = self.create_publisher(Odometry, "/odom", 5)
        self.markers = self.create_publisher(MarkerArray, "/visualization_marker_array", 5)
        self.create_timer(1 / 30, self.step)
        self.create_timer(0.1, self.sense)

    def step(self):
        self.angle += 0.4 / 30
        msg = TransformStamped(child_frame_id="base_footprint")
        msg.header.frame_id, msg.header.stamp = "odom", self.get_clock().now().to_msg()
        msg.transform.translation.x = 0.6 * math.sin(self.angle)
        msg.transform.translation.y = 0.6 - 0.6 * math.cos(self.angle)
        msg.transform.rotation.z, msg.transform.rotation.w = math.sin(self.angle / 2), math.cos(self.angle / 2)
        self.tf.sendTransform(msg)

    def sense(self):
        x, y, now = 0.6 * math.sin(self.angle), 0.6 - 0.6 * math.cos(self.angle), self.get_clock().now().to_msg()
        scan = LaserScan(angle_min=-math.pi, angle_max=math.pi, angle_increment=2 * math.pi / 360, range_max=8.0)
        scan.header.frame_id, scan.header.stamp = "base_footprint", now
        for beam in range(360):
            a = -math.pi + beam * 2 * math.pi / 360 + self.angle
            c, s = math.cos(a), math.sin(a)
            tx = (1.5 - x) / c if c > 1e-6 else (-1.5 - x) / c if c < -1e-6 else 99.0
            ty = (2.1 - y) / s if s > 1e-6 else (-0.9 - y) / s if s < -1e-6 else 99.0
            scan.ranges.append(min(tx, ty))
        self.scan.publish(scan)
        pose = PoseStamped()
        pose.pose.position.x, pose.pose.position.y = x, y
        self.trail = (self.trail + [pose])[-100:]
        path = Path(poses=self.trail)
        path.header.frame_id, path.header.stamp = "odom", now
        self.path.publish(path)
        sign = Marker(ns="shop", id=1, type=Marker.CYLINDER)
        sign.header.frame_id, sign.pose.position.y, sign.pose.position.z = "odom", 0.6, 0.1
        sign.scale.x = sign.scale.y = sign.scale.z = 0.2
        sign.color.r, sign.color.g, sign.color.b, sign.color.a = 0.25, 0.55, 0.75, 1.0
        text = Marker(ns="shop", id=2, type=Marker.TEXT_VIEW_FACING, text="centre")
        text.header.frame_id, text.pose.position.y, text.pose.position.z, text.scale.z = "odom", 0.6, 0.3, 0.1
        text.color.r, text.color.g, text.color.b, text.color.a = 1.0, 1.0, 0.9, 1.0
        self.markers.publish(MarkerArray(markers=[sign, text]))

def main():
    rclpy.init()
    rclpy.spin(Circle())

if __name__ == "__main__":
    main()
""".strip()
START = start_beside("circle.py")
VIEWER = "shown = viewer(fixed_frame='odom', displays=['Grid', 'RobotModel', {'type': 'TF', 'marker_scale': 0.6,\
 'show_names': False}, 'LaserScan', 'Path', 'MarkerArray'])\nshown"
DRAWN = "() => Number(document.querySelector('.ck-viewer')?.dataset.messages ?? 0)"
JOINT = "base_joint"
FLEXIBLE = Path(__file__).parents[2] / "coursekit" / "share" / "urdf_tutorial" / "urdf" / "06-flexible.urdf"
WHEEL = Path(__file__).parents[2] / "robots" / "urdf" / "wheel.urdf"
TURNS = """() => { const found = []; const scene = document.querySelector('.ck-viewer')?.viewer;
  scene?.view.scene_tree.object.traverse((one) => {
    if (!one.isMesh) return;
    one.updateWorldMatrix(true, false);
    found.push(one.matrixWorld.elements.map((x) => x.toFixed(3)).join(' '));
  });
  return found.sort().join('; '); }"""
OBJECTS = """() => { const scene = document.querySelector('.ck-viewer')?.viewer;
  const node = scene?.view.scene_tree.find(['scene']); return node ? Object.keys(node.children).length : 0; }"""


SHADOW = """() => { const [robot] = document.querySelector('.ck-viewer').viewer.shadows.robots.values();
  return robot.spot.visible && robot.spot.position.toArray(); }"""


def appears(page):
    """Wait until something was drawn. A scene in which nothing changes has no more messages than that."""
    page.wait_for_function(f"() => ({DRAWN})() >= 1", timeout=60_000)


def drawn(page, more=10):
    """Wait until so many more messages were drawn, of a scene that changes."""
    before = page.evaluate(DRAWN)
    page.wait_for_function(f"() => ({DRAWN})() >= {before + more}", timeout=60_000)


def test_a_robot_circles_and_survives_a_reload(notebook, picture):
    opened = notebook(LAB, PUBLISHERS.strip(), JOINTS, CIRCLE, START, VIEWER, height=1200)
    opened.run()
    page = opened.page
    drawn(page)
    page.wait_for_function(f"() => ({OBJECTS})() > 30", timeout=60_000)
    page.wait_for_timeout(6000)
    panel = page.locator(".ck-viewer").first
    panel.scroll_into_view_if_needed()
    picture(panel, "viewer")
    levels = panel.locator(".ck-row .ck-dot").evaluate_all("dots => dots.map((dot) => dot.title)")
    assert levels == ["Ok"] * 6
    assert panel.locator(".ck-text.ck-light", has_text="centre").count() == 1, "a light text needs a dark ground"
    x, y, z = page.evaluate(SHADOW)
    assert abs(math.hypot(x, y - 0.6) - 0.6) < 0.12 and abs(z) < 0.05, "the robot circles at 0.6 m, and its shadow below it"

    count = page.evaluate(OBJECTS)
    page.evaluate("window.jupyterapp.commands.execute('docmanager:save')")
    page.wait_for_timeout(1000)
    page.reload()
    page.wait_for_function(f"() => ({OBJECTS})() >= {count}", timeout=60_000)
    drawn(page)


def test_the_robot_follows_a_slider(notebook, picture):
    sliders = "%ros2 run joint_state_publisher_gui joint_state_publisher_gui &"
    shown = "shown = viewer(displays=['RobotModel'])\nshown"
    opened = notebook(
        LAB, PUBLISHERS.replace(str(ROBOT), str(WHEEL)).strip(), sliders, "hand = joint_sliders()\nhand", shown, height=1200
    )
    opened.run()
    page = opened.page
    page.wait_for_function(f"() => ({OBJECTS})() > 0", timeout=60_000)
    slider = page.get_by_role("slider", name=JOINT)
    before = settled(page, lambda: page.evaluate(TURNS))
    assert before, "the wheel is drawn"
    box = slider.bounding_box()
    middle = box["y"] + box["height"] / 2
    page.mouse.move(box["x"] + box["width"] / 2, middle)
    page.mouse.down()
    page.mouse.move(box["x"] + 0.8 * box["width"], middle, steps=5)
    page.mouse.up()
    page.wait_for_function(f"(before) => ({TURNS})() !== before", arg=before, timeout=20_000)
    after = settled(page, lambda: page.evaluate(TURNS))
    at = json.loads(opened.ask(f"print(hand.positions['{JOINT}'])"))
    assert at > 1.0
    picture(page.locator(".jp-Notebook"), "viewer_slider")
    assert f"{math.cos(at):.3f} {math.sin(at):.3f}" in after, "what is drawn has turned as far as the slider says"


def test_a_goal_is_dragged_and_a_display_switched_off(notebook, picture):
    bare = "shown = viewer(fixed_frame='map', displays=['Grid', 'Pose /goal_pose'], view={'distance': 8.0})\nshown"
    opened = notebook(LAB, bare)
    opened.run()
    page = opened.page
    appears(page)
    panel = page.locator(".ck-viewer").first
    panel.get_by_role("button", name="2D Goal Pose").click()
    box = page.locator(".ck-viewer .ck-aim svg").bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 60, y - 30, steps=4)
    page.mouse.up()
    page.locator(".ck-viewer .ck-told", has_text="/goal_pose").wait_for(timeout=20_000)
    page.wait_for_function(f"() => ({OBJECTS})() === 2", timeout=20_000)
    picture(panel, "viewer_goal")
    seen = json.loads(opened.ask("at = shown.stage.displays[1].shown.pose.position\nprint([at.x, at.y])"))
    assert abs(seen[0]) < 0.05 and abs(seen[1]) < 0.05, "the middle of the view is its target, the origin"

    panel.locator(".ck-row input[type=checkbox]").nth(1).uncheck()
    page.wait_for_function(f"() => ({OBJECTS})() === 1", timeout=20_000)


def test_after_a_kernel_restart_the_cells_show_it_again(notebook):
    opened = notebook(LAB, "shown = viewer(fixed_frame='map', displays=['Grid'])\nshown")
    opened.run()
    page = opened.page
    appears(page)
    page.evaluate("() => jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart()")
    opened.eventually("print('shown' in globals())", "False")
    opened.run()
    page.wait_for_function(f"() => ({OBJECTS})() === 1 && !document.querySelector('.ck-veil')", timeout=60_000)


def test_the_window_of_rviz2_appears_below_the_cell_that_launched_it(notebook, picture):
    opened = notebook(LAB, "%ros2 launch urdf_tutorial display.launch.py gui:=false &", "print('done')")
    opened.run()
    page = opened.page
    page.wait_for_function(f"() => ({OBJECTS})() > 1", timeout=60_000)
    picture(page.locator(".jp-Notebook"), "viewer_launched")
    assert page.locator(".jp-CodeCell").nth(1).locator(".ck-viewer").count() == 1
    page.locator(".ck-terminal .ck-stop").first.click()
    page.locator(".ck-viewer").first.wait_for(state="detached", timeout=20_000)


def test_the_sliders_appear_below_the_cell_that_launched_them_until_a_cell_shows_them(notebook, picture):
    opened = notebook(LAB, f"%ros2 launch urdf_tutorial display.launch.py model:={FLEXIBLE} &", "print('done')")
    opened.run()
    page = opened.page
    page.wait_for_function(f"() => ({OBJECTS})() > 1", timeout=60_000)
    first = page.locator(".jp-CodeCell").nth(1)
    first.get_by_role("slider").first.wait_for(timeout=30_000)
    picture(page.locator(".jp-Notebook"), "viewer_sliders")
    before = page.evaluate(TURNS)
    opened.ask("hand = joint_sliders(); hand.move(next(iter(hand.positions)), 0.3)")
    first.get_by_role("slider").first.wait_for(state="detached", timeout=20_000)
    page.wait_for_function(f"(before) => ({TURNS})() !== before", arg=before, timeout=20_000)


def test_the_live_tree_of_frames_tells_where_a_frame_is_also_when_it_is_redrawn_while_it_is_pressed(notebook, picture):
    opened = notebook(LAB, PUBLISHERS.strip(), JOINTS, "live = frames(live=True)\nlive")
    opened.run()
    page = opened.page
    page.locator(".ck-frames .ck-part[data-name=left_front_link]").wait_for(timeout=30_000)  # it comes last, and moves all
    page.locator(".ck-frames .ck-part[data-name=base_link]").first.hover()
    page.mouse.down()
    opened.ask("live.on_times({'on': True})")  # the tree changes
    page.mouse.up()
    page.locator(".ck-frames .ck-drawing", has_text="Broadcaster").wait_for(timeout=20_000)
    page.locator(".ck-frames .ck-details pre", has_text="position").wait_for(timeout=20_000)
    picture(page.locator(".ck-frames").first, "frames")
