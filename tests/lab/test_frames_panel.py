import pytest
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration

from coursekit.lab.frames_panel import FramesPanel, frames
from coursekit.processes.session import Session


def robot(behind_ns=0):
    from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

    rclpy.init()
    node = rclpy.create_node("robot")
    moving, static = TransformBroadcaster(node), StaticTransformBroadcaster(node)
    fixed = TransformStamped(child_frame_id="laser")
    fixed.header.frame_id = "base"
    fixed.transform.translation.x = 1.0
    static.sendTransform(fixed)

    def step():
        msg = TransformStamped(child_frame_id="base")
        msg.header.frame_id = "odom"
        msg.header.stamp = (node.get_clock().now() - Duration(nanoseconds=behind_ns)).to_msg()
        msg.transform.translation.y = 2.0
        moving.sendTransform(msg)

    node.create_timer(0.1, step)
    rclpy.spin(node)


@pytest.fixture
def session():
    with Session(virtual=True).use() as virtual_session:
        virtual_session.start(robot, name="robot")
        yield virtual_session


TREE = ["frames: 3 frames, 1 tree", "odom", "`-- base  10.0 Hz", "    `-- laser  static"]


def test_frames_listens_and_shows(session):
    assert frames().text().splitlines() == TREE
    assert [node.name for node in session.graph(0).nodes] == ["robot"]  # it leaves nothing behind


def test_the_live_panel_follows_and_tells_where_a_frame_is(session):
    panel = frames(live=True)
    assert isinstance(panel, FramesPanel)
    session.clock.sleep(1.0)
    assert panel.text().splitlines() == TREE
    panel.on_choose({"name": "laser"})
    panel.on_times({"on": True})
    shown = panel.shown()
    assert shown["details"].splitlines()[1:] == [
        "in base: position (1.000, 0.000, 0.000) m, quaternion (0.000, 0.000, 0.000, 1.000)",
        "in odom: position (1.000, 2.000, 0.000) m, quaternion (0.000, 0.000, 0.000, 1.000)",
    ]
    assert "Broadcaster" in shown["svg"]
    panel.close()


def test_simulated_time_is_no_fault_and_silence_is_one():
    with Session(virtual=True).use() as session:
        simulator = session.start(lambda: robot(1_700_000_000_000_000_000), name="robot")
        panel = frames(live=True)
        session.clock.sleep(3.0)
        assert panel.text().splitlines() == TREE
        simulator.interrupt()
        session.clock.sleep(5.0)
        assert "! base: no node has published its pose in odom for 5." in panel.text()
        panel.close()
