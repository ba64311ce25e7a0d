"""Buffers that wait, listeners, broadcasters and futures, on the virtual clock."""

from threading import Thread

import pytest
import rclpy
import tf2_ros
from geometry_msgs.msg import PointStamped, TransformStamped
from rclpy.duration import Duration
from rclpy.executors import SingleThreadedExecutor
from rclpy.time import Time
from tf2_msgs.srv import FrameGraph
from tf2_ros import Buffer, LookupException, StaticTransformBroadcaster, TransformBroadcaster, TransformListener

from coursekit.processes.session import Session


def stamped(parent, child, time, x=42.0):
    msg = TransformStamped(child_frame_id=child)
    msg.header.frame_id, msg.header.stamp = parent, time.to_msg()
    msg.transform.translation.x, msg.transform.translation.y = x, -3.14
    return msg


def spin_until(node, condition, seconds=2.0):
    end = node.get_clock().now() + Duration(seconds=seconds)
    while not condition() and node.get_clock().now() < end:
        rclpy.spin_once(node, timeout_sec=0.05)
    return condition()


def test_a_broadcast_transform_is_heard(node):
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    sent = stamped("foo", "bar", Time(seconds=1))
    TransformBroadcaster(node).sendTransform(sent)
    assert spin_until(node, lambda: buffer.can_transform("foo", "bar", Time(seconds=1)))
    assert buffer.lookup_transform("foo", "bar", sent.header.stamp) == sent
    listener.unregister()


def test_several_transforms_go_in_one_message(node):
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    TransformBroadcaster(node).sendTransform([stamped("a", "b", Time(seconds=1)), stamped("b", "c", Time(seconds=1))])
    rclpy.spin_once(node, timeout_sec=1.0)
    assert buffer.lookup_transform("a", "c", Time()).transform.translation.x == 84.0
    listener.unregister()


def test_a_late_listener_gets_every_static_transform(node):
    broadcaster = StaticTransformBroadcaster(node)
    broadcaster.sendTransform(stamped("foo", "bar", Time(seconds=1)))
    broadcaster.sendTransform((stamped("foo", "qux", Time(seconds=1)), stamped("foo", "bar", Time(seconds=1), 7.0)))
    buffer = Buffer()
    listener = TransformListener(buffer, node)
    assert spin_until(node, lambda: buffer.can_transform("bar", "qux", Time()))
    assert buffer.lookup_transform("foo", "bar", Time(seconds=9)).transform.translation.x == 7.0
    listener.unregister()


def test_a_static_listener_does_not_hear_what_moves(node):
    buffer = Buffer()
    listener = tf2_ros.StaticTransformListener(buffer, node)
    TransformBroadcaster(node).sendTransform(stamped("a", "b", Time(seconds=1)))
    StaticTransformBroadcaster(node).sendTransform(stamped("a", "c", Time(seconds=1)))
    assert spin_until(node, lambda: buffer.can_transform("a", "c", Time()))
    assert not buffer.can_transform("a", "b", Time())
    listener.unregister()


def test_a_listener_may_spin_by_itself(node):
    buffer = Buffer()
    listener = TransformListener(buffer, node, spin_thread=True)
    StaticTransformBroadcaster(node).sendTransform(stamped("a", "b", Time(seconds=1)))
    transform = buffer.lookup_transform("a", "b", Time(), timeout=Duration(seconds=1.0))
    assert transform.transform.translation.x == 42.0
    listener.unregister()


def test_a_lookup_waits_no_longer_than_its_timeout(node, session):
    buffer = Buffer(node=node)
    begun = session.clock.steady()
    with pytest.raises(LookupException):
        buffer.lookup_transform("a", "b", Time(), timeout=Duration(seconds=1.5))
    assert session.clock.steady() - begun == 1_500_000_000
    assert not buffer.can_transform("a", "b", Time(), Duration(seconds=0.5))
    assert session.clock.steady() - begun == 2_000_000_000


def test_a_lookup_wakes_when_the_transform_comes(node, session):
    buffer = Buffer()

    def later():
        session.clock.sleep(0.3)
        buffer.set_transform(stamped("a", "b", Time(seconds=1)), "me")

    Thread(target=later).start()
    begun = session.clock.steady()
    assert buffer.can_transform("a", "b", Time(), timeout=Duration(seconds=5.0))
    assert session.clock.steady() - begun == 300_000_000


def test_a_timeout_follows_simulated_time(node, session):
    from rclpy.parameter import Parameter
    from rosgraph_msgs.msg import Clock

    node.set_parameters([Parameter("use_sim_time", value=True)])
    publisher = node.create_publisher(Clock, "/clock", 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    thread = Thread(target=executor.spin, daemon=True)
    thread.start()

    def ticks():
        for tick in range(100):  # simulated time runs at half the speed
            publisher.publish(Clock(clock=Time(seconds=1 + tick * 0.05).to_msg()))
            session.clock.sleep(0.1)

    Thread(target=ticks, daemon=True).start()
    session.clock.sleep(0.05)
    begun = session.clock.steady()
    assert not Buffer(node=node).can_transform("a", "b", Time(), timeout=Duration(seconds=1.0))
    assert 1.9 < (session.clock.steady() - begun) * 1e-9 < 2.2
    executor.shutdown(0)


def test_the_reason_can_be_asked_for(node):
    can, why = Buffer().can_transform("a", "b", Time(), return_debug_tuple=True)
    assert not can and "frame does not exist" in why


def test_a_coroutine_waits_for_its_transform():
    buffer, time = Buffer(), Time(seconds=3)
    coroutine = buffer.lookup_transform_async("foo", "bar", time)
    coroutine.send(None)
    buffer.set_transform(stamped("foo", "bar", time), "unittest")
    with pytest.raises(StopIteration) as stop:
        coroutine.send(None)
    assert stop.value.value == stamped("foo", "bar", time)
    full = buffer.lookup_transform_full_async("foo", time, "bar", time, "foo")
    with pytest.raises(StopIteration) as stop:
        full.send(None)
    assert stop.value.value == stamped("foo", "bar", time)


def test_a_future_becomes_true_and_is_forgotten():
    buffer = Buffer()
    waiting = buffer.wait_for_transform_async("foo", "bar", Time())
    full = buffer.wait_for_transform_full_async("foo", Time(), "bar", Time(), "foo")
    assert not waiting.done() and len(buffer._new_data_callbacks) == 2
    buffer.set_transform_static(stamped("foo", "bar", Time()), "unittest")
    assert waiting.result() is True and full.result() is True and buffer._new_data_callbacks == []
    assert buffer.wait_for_transform_async("foo", "bar", Time()).done()


def test_a_cancelled_future_is_forgotten():
    buffer = Buffer()
    buffer.wait_for_transform_async("foo", "bar", Time()).cancel()
    assert buffer._new_data_callbacks == []


def test_a_node_waits_in_a_coroutine_of_its_own(node):
    buffer, transforms = Buffer(), []
    listener = TransformListener(buffer, node)

    async def look():
        transforms.append(await buffer.lookup_transform_async("a", "b", Time()))

    executor = SingleThreadedExecutor()
    executor.add_node(node)
    task = executor.create_task(look)
    TransformBroadcaster(node).sendTransform(stamped("a", "b", Time(seconds=1)))
    executor.spin_until_future_complete(task, timeout_sec=2.0)
    assert transforms[0].transform.translation.x == 42.0
    listener.unregister()


def test_the_service_tells_the_frames(node):
    buffer = Buffer(node=node)
    buffer.set_transform(stamped("foo", "bar", Time(seconds=1)), "me")
    client = node.create_client(FrameGraph, "tf2_frames")
    future = client.call_async(FrameGraph.Request())
    rclpy.spin_until_future_complete(node, future, timeout_sec=2.0)
    assert "parent: 'foo'" in future.result().frame_yaml


def test_transform_needs_a_registered_type():
    with pytest.raises(tf2_ros.TypeException, match="is not loaded or supported"):
        Buffer().transform(TransformStamped(), "a")
    interface = tf2_ros.BufferInterface()
    with pytest.raises(tf2_ros.NotImplementedException, match="CanTransform or LookupTransform not implemented"):
        interface.lookup_transform("a", "b", Time())


def test_transform_takes_a_message_to_another_frame():
    import tf2_geometry_msgs  # noqa: F401

    buffer = Buffer()
    buffer.set_transform_static(stamped("map", "robot", Time(), 1.0), "me")
    point = PointStamped()
    point.header.frame_id = "robot"
    point.point.x = 1.0
    moved = buffer.transform(point, "map", new_type=PointStamped)
    assert (moved.header.frame_id, moved.point.x, moved.point.y) == ("map", 2.0, -3.14)
    assert buffer.transform_full(point, "map", Time(), "map").point.x == 2.0


def test_another_time_empties_the_buffer_but_for_static_frames(node, session):
    from rclpy.parameter import Parameter
    from rosgraph_msgs.msg import Clock

    buffer = Buffer(node=node)
    node.set_parameters([Parameter("use_sim_time", value=True)])
    publisher = node.create_publisher(Clock, "/clock", 10)

    def now(seconds):
        publisher.publish(Clock(clock=Time(seconds=seconds).to_msg()))
        assert spin_until(node, lambda: node.get_clock().now().nanoseconds == seconds * 10**9, 1e9)

    now(50)
    buffer.set_transform(stamped("a", "b", Time(seconds=1)), "me")
    buffer.set_transform_static(stamped("b", "c", Time(seconds=1)), "me")
    now(51)
    assert buffer.can_transform("a", "c", Time())
    now(10)
    assert not buffer.can_transform("a", "b", Time())
    assert buffer.can_transform("b", "c", Time())


@pytest.mark.parametrize(
    ("module", "names"),
    [
        ("tf2_ros", "TransformStamped TFMessage Duration Time Node QoSProfile FrameGraph LookupTransform TF2Error"),
        ("tf2_geometry_msgs", "PointStamped PoseStamped Pose TransformStamped Vector3Stamped WrenchStamped"),
        ("tf2_sensor_msgs", "PointCloud2 PointField TransformStamped"),
    ],
)
def test_the_names_that_tutorials_take_from_them_are_there(module, names):
    import importlib

    loaded_module = importlib.import_module(module)
    assert [name for name in names.split() if not hasattr(loaded_module, name)] == []


def test_a_destroyed_buffer_client_leaves_the_graph():
    with Session(virtual=True).use() as session:
        context = rclpy.context.Context()
        rclpy.init(context=context)
        node = rclpy.create_node("asker", context=context)
        before = session.graph(0).services()
        client = tf2_ros.BufferClient(node, "lookup_transform")
        assert session.graph(0).services() != before
        client.destroy()
        assert session.graph(0).services() == before
        rclpy.shutdown(context=context)
