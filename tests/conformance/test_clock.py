import threading
import time

import pytest
from rclpy.clock import Clock, ClockType, JumpThreshold, ROSClock
from rclpy.duration import Duration
from rclpy.exceptions import NotInitializedException
from rclpy.parameter import Parameter
from rclpy.time import Time
from rosgraph_msgs.msg import Clock as ClockMsg

STEADY, SYSTEM, ROS = ClockType.STEADY_TIME, ClockType.SYSTEM_TIME, ClockType.ROS_TIME


def test_the_clock_types():
    assert Clock().clock_type == SYSTEM
    assert Clock(clock_type=STEADY).clock_type == STEADY
    ros = Clock(clock_type=ROS)
    assert isinstance(ros, ROSClock)
    assert ROSClock().clock_type == ROS


@pytest.mark.parametrize("kind", ["STEADY_TIME", None])
def test_what_is_no_clock_type_is_refused(kind):
    with pytest.raises(TypeError):
        Clock(clock_type=kind)


@pytest.mark.parametrize("kind", [STEADY, SYSTEM, ROS])
def test_time_goes_on(kind):
    clock = Clock(clock_type=kind)
    first = clock.now()
    assert isinstance(first, Time)
    assert first.clock_type == kind
    assert clock.now() >= first


def test_system_time_counts_from_1970():
    now = Clock(clock_type=SYSTEM).now().nanoseconds
    assert abs(now - time.time_ns()) < 10 * 10**9


def test_simulated_time_starts_at_zero_and_is_set():
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    assert clock.ros_time_is_active
    assert clock.now() == Time(clock_type=ROS)
    clock.set_ros_time_override(Time(seconds=5, clock_type=ROS))
    assert clock.now() == Time(seconds=5, clock_type=ROS)
    clock._set_ros_time_is_active(False)
    assert clock.now() > Time(seconds=5, clock_type=ROS)


def test_use_sim_time_follows_clock(world):
    node = world.node("n", parameter_overrides=[Parameter("use_sim_time", value=True)])
    publisher = world.node("clock").create_publisher(ClockMsg, "/clock", 10)
    assert node.get_clock().ros_time_is_active
    assert node.get_clock().now().nanoseconds == 0
    message = ClockMsg()
    message.clock.sec = 42

    def told():
        publisher.publish(message)
        return node.get_clock().now().nanoseconds == 42 * 10**9

    world.spin_until(told)


def test_use_sim_time_can_be_switched(world):
    node = world.node("n")
    assert not node.get_clock().ros_time_is_active
    assert node.set_parameters([Parameter("use_sim_time", value=True)])[0].successful
    assert node.get_clock().ros_time_is_active
    assert node.set_parameters([Parameter("use_sim_time", value=False)])[0].successful
    assert not node.get_clock().ros_time_is_active


def jumps_of(clock, threshold):
    pre, post = [], []
    handler = clock.create_jump_callback(
        threshold, pre_callback=lambda: pre.append(1), post_callback=post.append
    )
    return pre, post, handler


def threshold(forward=1.0, backward=-1.0, change=True):
    return JumpThreshold(
        min_forward=Duration(seconds=forward), min_backward=Duration(seconds=backward), on_clock_change=change
    )


def test_a_change_of_clock_is_a_jump():
    clock = ROSClock()
    pre, post, _handler = jumps_of(clock, threshold())
    clock._set_ros_time_is_active(True)
    assert (len(pre), len(post)) == (1, 1)


def test_the_change_itself_has_no_length():
    clock = ROSClock()
    clock.set_ros_time_override(Time(seconds=10, clock_type=ROS))
    _pre, post, _handler = jumps_of(clock, threshold())
    clock._set_ros_time_is_active(True)
    clock._set_ros_time_is_active(False)
    assert [jump.delta for jump in post] == [Duration(), Duration()]


def test_a_long_step_forward_is_a_jump():
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    clock.set_ros_time_override(Time(seconds=10, clock_type=ROS))
    pre, post, _handler = jumps_of(clock, threshold(change=False))
    clock.set_ros_time_override(Time(seconds=10.5, clock_type=ROS))
    assert post == []
    clock.set_ros_time_override(Time(seconds=20, clock_type=ROS))
    assert (len(pre), len(post)) == (1, 1)
    assert post[0].delta == Duration(seconds=9.5)


def test_a_step_backward_is_a_jump():
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    clock.set_ros_time_override(Time(seconds=10, clock_type=ROS))
    _pre, post, _handler = jumps_of(clock, threshold(change=False))
    clock.set_ros_time_override(Time(seconds=9.5, clock_type=ROS))
    assert post == []
    clock.set_ros_time_override(Time(seconds=5, clock_type=ROS))
    assert len(post) == 1


def test_an_unregistered_callback_is_silent():
    clock = ROSClock()
    _pre, post, handler = jumps_of(clock, threshold())
    handler.unregister()
    clock._set_ros_time_is_active(True)
    assert post == []


@pytest.mark.parametrize("forward, backward", [(-1.0, -1.0), (1.0, 1.0)])
def test_a_threshold_has_a_direction(forward, backward):
    with pytest.raises(ValueError):
        threshold(forward, backward)


def test_sleeping_until_a_time(world):
    clock = Clock(clock_type=STEADY)
    start = clock.now()
    assert clock.sleep_until(start + Duration(seconds=0.1), context=world.context)
    assert clock.now() - start >= Duration(seconds=0.1)


@pytest.mark.parametrize("kind", [STEADY, SYSTEM, ROS])
def test_sleeping_for_a_while(world, kind):
    clock = Clock(clock_type=kind)
    start = clock.now()
    assert clock.sleep_for(Duration(seconds=0.05), context=world.context)
    assert clock.now() - start >= Duration(seconds=0.05)


def test_a_time_of_another_clock_is_refused(world):
    with pytest.raises(ValueError):
        Clock(clock_type=STEADY).sleep_until(Time(seconds=1, clock_type=SYSTEM), context=world.context)


def test_sleeping_needs_a_context():
    from rclpy.context import Context

    with pytest.raises(NotInitializedException):
        Clock().sleep_for(Duration(seconds=0.1), context=Context())


def test_sleep_ends_when_the_context_does(world):
    threading.Timer(0.1, world.context.shutdown).start()
    clock = Clock(clock_type=STEADY)
    start = time.monotonic()
    assert not clock.sleep_for(Duration(seconds=20), context=world.context)
    assert time.monotonic() - start < 10


def test_sleep_ends_when_time_becomes_simulated(world):
    clock = ROSClock()
    threading.Timer(0.1, lambda: clock._set_ros_time_is_active(True)).start()
    start = time.monotonic()
    assert not clock.sleep_for(Duration(seconds=20), context=world.context)
    assert time.monotonic() - start < 10


def test_simulated_sleep_waits_for_simulated_time(world):
    clock = ROSClock()
    clock._set_ros_time_is_active(True)
    clock.set_ros_time_override(Time(seconds=1, clock_type=ROS))
    slept = []
    thread = threading.Thread(
        target=lambda: slept.append(clock.sleep_for(Duration(seconds=10), context=world.context)), daemon=True
    )
    thread.start()
    end = time.monotonic() + 5
    while not slept and time.monotonic() < end:
        clock.set_ros_time_override(clock.now() + Duration(seconds=1))
        thread.join(timeout=0.02)
    assert slept == [True]
