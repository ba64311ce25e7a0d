"""A buffer that lets messages lie until it is asked knows what one knows that hears each at once."""

import pytest
import rclpy
from geometry_msgs.msg import TransformStamped
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

from coursekit.processes.session import Session
from coursekit.view.frame_listening import listen_to_frames


@pytest.fixture
def session():
    with Session(virtual=True).use() as session:
        rclpy.init(args=[])
        yield session
        rclpy.try_shutdown()


@pytest.fixture
def listening(session):
    """A lazy buffer and one that hears at once, with their node in an execution context of its own."""
    node = rclpy.create_node("listener")
    session.spawn(lambda: rclpy.spin(node))
    session.clock.sleep(0.1)
    return listen_to_frames(node), listen_to_frames(node, lambda: None)


def moved(child, x, now):
    msg = TransformStamped(child_frame_id=child)
    msg.header.frame_id, msg.header.stamp = "map", now.to_msg()
    msg.transform.translation.x = x
    return msg


def test_what_nobody_asks_about_for_long_is_thinned_and_what_can_be_asked_stays(session, listening):
    lazy, eager = listening
    node = rclpy.create_node("robot")
    frames, fixed = TransformBroadcaster(node), StaticTransformBroadcaster(node)
    fixed.sendTransform(moved("floor", 1.0, node.get_clock().now()))
    frames.sendTransform(moved("seen_once", 2.0, node.get_clock().now()))
    for step in range(300):
        frames.sendTransform(moved("robot", step / 10, node.get_clock().now()))
        session.clock.sleep(0.1)
    lying = max(len(core.queue) for core, _ in lazy._unheard)
    assert 100 <= lying < 110, "ten seconds lie there, no more"
    lazy.catch_up()
    now = session.clock.now()
    assert set(lazy.frames) == set(eager.frames) == {"map", "floor", "seen_once", "robot"}
    assert lazy.lookup("map", "seen_once").pose == eager.lookup("map", "seen_once").pose
    for age in (1.0, 5.03, 9.87):
        then = now - round(age * 1e9)
        assert lazy.lookup("floor", "robot", then) == eager.lookup("floor", "robot", then)
    assert lazy.now(now) == eager.now(now)


def test_a_broadcaster_of_long_ago_still_tells_the_time(session, listening):
    lazy, eager = listening
    node = rclpy.create_node("robot")
    TransformBroadcaster(node).sendTransform(moved("robot", 1.0, node.get_clock().now()))
    session.clock.sleep(30.0)
    lazy.catch_up()
    assert lazy.now(session.clock.now()) == eager.now(session.clock.now())
    assert lazy.lookup("map", "robot").pose[0] == 1.0
