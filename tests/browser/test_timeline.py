"""The time line in the page: viewer, graph and plot go back together, play, and are live again; in the dark, too."""

import pytest

from .pages import set_theme, settled, start_beside

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

DRIVE = """
%%write drive.py
import rclpy
from geometry_msgs.msg import TransformStamped, Twist
from rclpy.node import Node
from tf2_ros import TransformBroadcaster

class Drive(Node):
    def __init__(self):
        super().__init__("drive")
        self.frames, self.speed, self.x = TransformBroadcaster(self), self.create_publisher(Twist, "cmd_vel", 10), 0.0
        self.create_timer(0.05, self.step)

    def step(self):
        self.x += 0.02
        there = TransformStamped(child_frame_id="base")
        there.header.frame_id, there.header.stamp = "odom", self.get_clock().now().to_msg()
        there.transform.translation.x, there.transform.rotation.w = self.x, 1.0
        self.frames.sendTransform(there)
        speed = Twist()
        speed.linear.x = self.x
        self.speed.publish(speed)

rclpy.init()
rclpy.spin(Drive())
""".strip()
CELLS = (
    "from coursekit.lab import *",
    DRIVE,
    start_beside("drive.py"),
    "shown, line = viewer(fixed_frame='odom', displays=['Grid', 'TF'], height=260), timeline()",
    "import ipywidgets; ipywidgets.VBox([shown, line, plot('/cmd_vel.linear.x')])",
    "graph(live=True)",
)
PULL = "(one) => { one.value = -4; for (const kind of ['input', 'change']) one.dispatchEvent(new Event(kind)); }"
WHERE = """() => {
  const node = document.querySelector('.ck-viewer')?.viewer?.view.scene_tree.find(['scene']).object;
  const found = [];
  node?.traverse((one) => found.push(one.position.x));
  return Math.max(0, ...found);
}"""


def test_panels_go_back_together_play_and_are_live_again(notebook, picture):
    opened = notebook(*CELLS, width=1366, height=1100)
    opened.run()
    page = opened.page
    page.wait_for_function(f"({WHERE})() > 2", timeout=60_000)
    line = page.locator(".ck-timeline")
    line.scroll_into_view_if_needed()
    picture(page, "timeline-live")
    assert line.locator(".ck-when").inner_text() == "now"
    slider = line.get_by_label("how long ago")
    slider.evaluate(PULL)
    page.wait_for_selector(".ck-viewer.ck-of-past")
    page.wait_for_selector(".ck-graph.ck-of-past")
    was = settled(page, lambda: page.evaluate(WHERE))
    opened.ask("1 + 1")
    assert page.evaluate(WHERE) == was, "what is shown stays"
    assert "ago" in line.locator(".ck-when").inner_text()
    assert " of " in page.locator(".ck-plot .ck-when").inner_text(), "the plot went back, too"
    picture(page, "timeline-back")
    set_theme(page, light=False)
    page.wait_for_selector("#jupyterlab-splash", state="detached")
    picture(page, "timeline-dark")
    set_theme(page, light=True)
    line.get_by_role("button", name="Play").click()
    page.wait_for_function(f"({WHERE})() > {was} + 0.2", timeout=30_000)
    line.get_by_role("button", name="Live").click()
    page.wait_for_selector(".ck-viewer:not(.ck-of-past)")
    page.wait_for_function(f"({WHERE})() > {was} + 1.5", timeout=30_000)
    page.wait_for_function("() => document.querySelector('.ck-timeline .ck-when').textContent === 'now'")
    assert page.locator(".ck-graph.ck-of-past").count() == 0
