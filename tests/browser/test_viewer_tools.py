"""RViz's three tools by mouse: what is dragged on the floor arrives as a message in the fixed frame."""

import json
import math

import pytest

from .test_viewer import appears

pytestmark = [pytest.mark.browser, pytest.mark.slow, pytest.mark.timeout(300)]

LAB = "from coursekit.lab import *"
LISTEN = """
import rclpy, threading
from geometry_msgs.msg import PointStamped, PoseStamped, PoseWithCovarianceStamped
rclpy.init()
ear, heard = rclpy.create_node("ear"), {}
kinds = {"/goal_pose": PoseStamped, "/initialpose": PoseWithCovarianceStamped, "/clicked_point": PointStamped}
for topic, kind in kinds.items():
    ear.create_subscription(kind, topic, lambda msg, topic=topic: heard.__setitem__(topic, msg), 1)
threading.Thread(target=rclpy.spin, args=(ear,), daemon=True).start()
def told(topic):
    msg = heard.get(topic)
    if msg is None:
        return None
    if topic == "/clicked_point":
        return [msg.header.frame_id, msg.point.x, msg.point.y, msg.point.z]
    pose = getattr(msg.pose, "pose", msg.pose)
    return [msg.header.frame_id, pose.position.x, pose.position.y, pose.orientation.z, pose.orientation.w]
""".strip()
VIEWER = """
shown = viewer(fixed_frame="map", displays=["Grid", "Pose /goal_pose", "PoseWithCovariance /initialpose", "PointStamped"],
               view={"distance": 9.0, "yaw": -1.2, "pitch": 0.8, "target": [1.0, 0.5, 0.0]})
shown
""".strip()
PIXEL = """([x, y]) => {
    const { camera, dom_element: pane } = document.querySelector('.ck-viewer').viewer.view;
    const place = camera.position.clone().set(x, 0, -y).project(camera), box = pane.getBoundingClientRect();
    return [box.left + (place.x + 1) / 2 * box.width, box.top + (1 - place.y) / 2 * box.height];
}"""


def drag(page, tool, start, end):
    """Press at a place on the floor [m] and let go at another."""
    page.locator(".ck-viewer").get_by_role("button", name=tool).click()
    page.mouse.move(*page.evaluate(PIXEL, start))
    page.mouse.down()
    page.mouse.move(*page.evaluate(PIXEL, end), steps=5)
    page.mouse.up()


def heard(opened, topic):
    """What came on a topic, as soon as it has."""
    opened.page.locator(".ck-viewer .ck-told", has_text=topic).wait_for(timeout=20_000)
    opened.eventually(f"print(told('{topic}') is not None)", "True")
    return json.loads(opened.ask(f"import json; print(json.dumps(told('{topic}')))"))


def test_what_is_dragged_arrives_where_it_was_dragged(notebook, picture):
    opened = notebook(LAB, LISTEN, VIEWER)
    opened.run()
    page = opened.page
    appears(page)
    page.locator(".ck-viewer").scroll_into_view_if_needed()
    for tool, topic, start, end in (
        ("2D Goal Pose", "/goal_pose", [1.0, 2.0], [1.0, 3.0]),
        ("2D Pose Estimate", "/initialpose", [-0.5, -1.0], [-1.5, -1.0]),
    ):
        drag(page, tool, start, end)
        frame, x, y, z, w = heard(opened, topic)
        yaw = math.atan2(end[1] - start[1], end[0] - start[0])
        assert frame == "map" and [x, y] == pytest.approx(start, abs=0.05)
        assert math.cos(2 * math.atan2(z, w) - yaw) == pytest.approx(1.0, abs=0.005)
    drag(page, "Publish Point", [2.0, 0.0], [2.0, 0.0])
    frame, x, y, z = heard(opened, "/clicked_point")
    assert (frame, z) == ("map", 0.0) and [x, y] == pytest.approx([2.0, 0.0], abs=0.05)
    page.wait_for_timeout(1000)  # the arrows are drawn; only the picture waits for them
    picture(page.locator(".ck-viewer"), "viewer_tools")
