"""velocity_smoother between a program that drives and the wheels, on the virtual clock."""

import pytest
import rclpy
from geometry_msgs.msg import Twist

PARAMETERS = ("max_velocity:=[0.5, 0.0, 1.0]", "max_accel:=[1.0, 0.0, 2.0]", "max_decel:=[-2.0, 0.0, -2.0]")


@pytest.fixture
def driver(session, run, ros2):
    """driver(forward, seconds) wishes for a speed again and again; what came out meanwhile."""
    run(
        "nav2_velocity_smoother",
        "velocity_smoother",
        "--ros-args",
        *(word for parameter in PARAMETERS for word in ("-p", parameter)),
    )
    session.clock.sleep(0.1)
    for state in ("configure", "activate"):
        assert "successful" in ros2("lifecycle", "set", "/velocity_smoother", state)
    context = rclpy.context.Context()
    rclpy.init(context=context)
    node = rclpy.create_node("driver", context=context)
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)
    heard: list[float] = []
    node.create_subscription(Twist, "cmd_vel_smoothed", lambda msg: heard.append(round(msg.linear.x, 3)), 50)
    wishes = node.create_publisher(Twist, "cmd_vel", 1)

    def drive(forward, seconds):
        heard.clear()
        for _ in range(round(seconds / 0.1)):
            if forward is not None:
                msg = Twist()
                msg.linear.x = forward
                wishes.publish(msg)
            until = session.clock.steady() + 10**8
            while session.clock.steady() < until:
                executor.spin_once(timeout_sec=0.01)
        return list(heard)

    yield drive
    rclpy.shutdown(context=context)


def test_speeds_grow_and_fall_no_faster_than_allowed_and_stay_in_their_bounds(driver):
    faster = driver(0.9, 1.0)
    assert faster[:4] == [0.05, 0.1, 0.15, 0.2] and faster[-1] == 0.5
    slower = driver(0.0, 0.5)
    assert slower[:3] == [0.4, 0.3, 0.2] and slower[-1] == 0.0


def test_silence_stops_the_robot_and_then_the_smoother_is_silent(driver):
    driver(0.3, 1.0)
    assert driver(None, 2.0)[-1] == 0.0
    assert driver(None, 1.0) == []


def test_a_number_that_is_none_is_ignored_and_parameters_can_be_set_while_it_runs(driver, ros2):
    driver(0.3, 1.0)
    assert set(driver(float("nan"), 0.5)) == {0.3}
    assert "Set parameter successful" in ros2("param", "set", "/velocity_smoother", "max_velocity", "[0.1, 0.0, 1.0]")
    assert driver(0.9, 1.0)[-1] == 0.1
    refused = ros2("param", "set", "/velocity_smoother", "max_accel", "[-1.0, 0.0, 1.0]")
    assert "Negative values set of acceleration" in refused
    assert driver(0.9, 0.5)[-1] == 0.1
