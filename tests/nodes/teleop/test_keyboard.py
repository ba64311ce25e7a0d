"""Keys that drive."""

import pytest
import rclpy
from geometry_msgs.msg import Twist, TwistStamped


@pytest.fixture
def drive(session, run):
    """drive(keys, kind, *arguments) types keys; (velocities told, output)."""

    def type_keys(keys, kind=Twist, *argv):
        context = rclpy.context.Context()
        rclpy.init(context=context)
        node = rclpy.create_node("robot", context=context)
        heard = []
        node.create_subscription(kind, "cmd_vel", heard.append, 100)
        executor = rclpy.executors.SingleThreadedExecutor(context=context)
        executor.add_node(node)
        process = run("teleop_twist_keyboard", "teleop_twist_keyboard", *argv)
        session.clock.sleep(0.1)
        process.write_stdin(keys)
        session.clock.sleep(0.1)
        process.close_stdin()
        process.wait(2)
        for _ in range(len(keys) + 3):
            executor.spin_once(timeout_sec=0.01)
        return heard, process

    return type_keys


def parts(twist):
    return twist.linear.x, twist.linear.y, twist.linear.z, twist.angular.z


def test_keys_mean_what_they_mean_in_ros(drive):
    heard, _ = drive("i,jloum.kIJLUtb")
    assert [parts(twist) for twist in heard[:-1]] == [
        (0.5, 0, 0, 0), (-0.5, 0, 0, 0), (0, 0, 0, 1), (0, 0, 0, -1), (0.5, 0, 0, -1), (0.5, 0, 0, 1), (-0.5, 0, 0, -1),
        (-0.5, 0, 0, 1), (0, 0, 0, 0), (0.5, 0, 0, 0), (0, 0.5, 0, 0), (0, -0.5, 0, 0), (0.5, 0.5, 0, 0), (0, 0, 0.5, 0),
        (0, 0, -0.5, 0),
    ]  # fmt: skip


def test_the_end_stops_the_robot(drive):
    heard, process = drive("i")
    assert parts(heard[-1]) == (0, 0, 0, 0) and process.exit_code == 0


def test_speeds_change_by_a_tenth_and_are_told(drive):
    heard, process = drive("iqwxec")
    assert heard[1].linear.x == pytest.approx(0.55) and heard[2].linear.x == pytest.approx(0.605)
    assert "currently:\tspeed 0.5\tturn 1.0 \n" in process.output and "speed 0.55" in process.output


def test_the_keys_are_shown_again_after_fifteen_changes(drive):
    assert drive("q" * 14)[1].output.count("Moving around:") == 1
    assert drive("q" * 15)[1].output.count("Moving around:") == 2


def test_stamped_messages_have_the_frame_that_was_asked_for(drive):
    heard, _ = drive("i", TwistStamped, "--ros-args", "-p", "stamped:=true", "-p", "frame_id:=base")
    assert heard[0].header.frame_id == "base" and heard[0].twist.linear.x == 0.5 and heard[0].header.stamp.sec


def test_a_frame_without_stamps_is_refused(drive):
    _, process = drive("", Twist, "--ros-args", "-p", "frame_id:=base")
    assert process.exit_code == 1 and "'frame_id' can only be set when 'stamped' is True" in process.output
