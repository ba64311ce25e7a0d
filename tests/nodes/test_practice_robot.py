"""The driver of the practice robot: limits, the stop without commands, and a clock that is wrong."""

import pytest
import rclpy
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan


@pytest.fixture
def robot(session, run):
    """The driver's process, and what it published last; `drive(forward, seconds)` sends commands ten times a second."""
    process = run("coursekit_robots", "practice_base")
    rclpy.init()
    node = rclpy.create_node("driver")
    out = node.create_publisher(Twist, "cmd_vel", 10)
    last = {}
    node.create_subscription(Odometry, "odom", lambda msg: last.update(odom=msg), 10)
    node.create_subscription(LaserScan, "scan", lambda msg: last.update(scan=msg), 10)

    def drive(forward, seconds):
        for _ in range(round(seconds * 10)):
            if forward is not None:
                twist = Twist()
                twist.linear.x = forward
                out.publish(twist)
            until = session.clock.steady() + 100_000_000
            while session.clock.steady() < until:
                rclpy.spin_once(node, timeout_sec=0.02)
        return last

    drive(None, 0.5)
    yield process, drive, node
    rclpy.shutdown()


def speed(last):
    return last["odom"].twist.twist.linear.x


def test_a_command_that_is_too_fast_is_cut_to_the_limit(robot, ros2):
    process, drive, _ = robot
    assert speed(drive(5.0, 1.0)) == pytest.approx(0.3)
    assert "Too fast: 5.00 m/s, 0.00 rad/s. It is cut to the limits" in process.output
    assert ros2("param", "set", "/base", "max_speed", "0.1") == "Set parameter successful\n"
    assert speed(drive(5.0, 1.0)) == pytest.approx(0.1)


def test_a_limit_beyond_what_the_robot_can_do_is_refused(robot, ros2):
    assert "Setting parameter failed" in ros2("param", "set", "/base", "max_speed", "20.0")


@pytest.mark.parametrize("number", [float("nan"), float("inf")])
def test_a_command_that_is_no_number_is_not_carried_out(robot, number):
    _, drive, _ = robot
    assert speed(drive(number, 0.5)) == 0.0


def test_it_stops_when_no_command_comes(robot):
    process, drive, _ = robot
    assert speed(drive(0.2, 1.0)) == pytest.approx(0.2)
    assert speed(drive(None, 1.0)) == 0.0
    assert process.output.count("No command for 0.5 s: stopped") == 1


def test_a_stop_that_was_commanded_is_not_told_as_silence(robot):
    process, drive, _ = robot
    drive(0.2, 0.5)
    drive(0.0, 0.1)
    drive(None, 1.0)
    assert "stopped" not in process.output


def test_stamps_are_those_of_its_computer_s_clock_also_when_that_is_wrong(robot, ros2, session):
    _, drive, node = robot

    def age():
        stamp = drive(None, 0.5)["scan"].header.stamp
        return node.get_clock().now().nanoseconds * 1e-9 - stamp.sec - stamp.nanosec * 1e-9

    assert 0.0 <= age() < 0.3
    before = drive(0.2, 0.5)["odom"].pose.pose.position.x
    for error in ("3.0", "-3.0"):
        ros2("param", "set", "/base", "clock_error", error)
        assert 0.0 <= age() + float(error) < 0.3
    assert drive(None, 0.1)["odom"].pose.pose.position.x - before < 0.2, "time that did not pass moves nothing"


def test_a_world_that_is_not_there_is_told(session, run):
    process = run("coursekit_robots", "practice_base", "--ros-args", "-p", "world:=nowhere")
    assert process.wait(5) == -6 and "there is no world 'nowhere'" in process.output


def test_the_meter_counts_what_arrives_with_each_quality(session, run, ros2):
    run("coursekit_robots", "practice_meter")
    ros2("topic", "pub", "-t", "3", "-r", "10", "-w", "1", "/meter/reliable", "std_msgs/msg/UInt8MultiArray", "{data: [1]}")
    quality = ("--qos-reliability", "best_effort")
    ros2("topic", "pub", "-1", "-w", "1", *quality, "/meter/best_effort", "std_msgs/msg/UInt8MultiArray", "{data: [1]}")
    assert "best_effort 1, reliable 3" in ros2("service", "call", "/meter/read", "std_srvs/srv/Trigger")
