"""twist_mux's joystick_relay.py: steps of speed, and who has priority."""

from pathlib import Path

import pytest
from ament_index_python.packages import get_package_share_directory
from geometry_msgs.msg import Twist
from rclpy.action import ActionClient
from std_msgs.msg import Bool
from twist_mux_msgs.action import JoyPriority, JoyTurbo

STEPS = {"steps": 4, "linear_forward_min": 0.2, "linear_forward_max": 0.8, "linear_backward_min": 0.1,
         "linear_backward_max": 0.4, "angular_min": 0.5, "angular_max": 2.0}  # fmt: skip


@pytest.fixture
def relay(run, friend):
    def start(**turbo):
        words = [word for name, value in turbo.items() for word in ("-p", f"turbo.{name}:={value}")]
        process = run("twist_mux", "joystick_relay.py", "--ros-args", *words)
        friend.out, friend.kept = friend.hear(Twist, "joy_vel_out"), friend.hear(Bool, "joy_priority")
        friend.spin(0.2)
        return process

    return start


def deflect(friend, x=0.0, z=0.0):
    """What comes out for a gamepad's deflections: the speeds along x and about z."""
    friend.out.clear()
    asked = Twist()
    asked.linear.x, asked.angular.z = x, z
    friend.say("joy_vel_in", asked)
    friend.spin(0.2)
    return [(round(twist.linear.x, 6), round(twist.angular.z, 6)) for twist in friend.out]


def do(friend, name, kind=JoyTurbo):
    client = ActionClient(friend.node, kind, name)
    assert client.wait_for_server(timeout_sec=2.0)
    sent = client.send_goal_async(kind.Goal())
    friend.executor.spin_until_future_complete(sent, timeout_sec=2.0)
    done = sent.result().get_result_async()
    friend.executor.spin_until_future_complete(done, timeout_sec=2.0)
    assert done.result().status == 4  # succeeded


def test_steps_scale_forward_backward_and_turning(relay, friend):
    relay(**STEPS)
    assert deflect(friend, 1.0, -1.0) == [(0.4, -1.0)] and deflect(friend, -0.5) == [(-0.1, 0.0)]
    do(friend, "joy_turbo_increase")
    assert deflect(friend, 1.0, 1.0) == [(0.6, 1.5)]
    do(friend, "joy_turbo_angular_decrease")
    assert deflect(friend, 1.0, 1.0) == [(0.6, 1.0)]
    for _ in range(5):
        do(friend, "joy_turbo_decrease")
    assert deflect(friend, 1.0, 1.0) == [(0.2, 0.5)]
    do(friend, "joy_turbo_reset")
    assert deflect(friend, 1.0) == [(0.4, 0.0)]


def test_without_priority_nothing_passes_and_taking_it_stops_the_robot(relay, friend):
    relay()
    do(friend, "joy_priority_action", JoyPriority)
    assert deflect(friend, 1.0) == []
    friend.out.clear()
    do(friend, "joy_priority_action", JoyPriority)
    friend.spin(0.2)
    assert [twist.linear.x for twist in friend.out] == [0.0]
    assert [message.data for message in friend.kept][-2:] == [False, True]


def test_what_no_gamepad_says_stops_and_is_told(relay, friend):
    process = relay()
    assert deflect(friend, 1.5) == [(0.0, 0.0)] and "not in [-1, 1] range" in process.output


@pytest.mark.parametrize(("name", "value", "told"), [("steps", 0, "turbo.steps is 0"), ("angular_min", -1.0, "angular_min")])
def test_speeds_that_are_none_end_it(relay, name, value, told):
    process = relay(**{name: value})
    assert process.wait(5) != 0 and told in process.output


def test_a_first_step_outside_falls_back(relay, friend):
    process = relay(**STEPS, init_step=9)
    assert "Falling back to default 2" in process.output and deflect(friend, 1.0) == [(0.4, 0.0)]


def test_with_priority_the_muxs_lock_lets_only_the_gamepad_drive(relay, run, friend):
    """The lock joy_priority of twist_mux_locks.yaml has the priority of the joystick."""
    config = Path(get_package_share_directory("twist_mux")) / "config"
    files = [word for name in ("locks", "topics") for word in ("--params-file", str(config / f"twist_mux_{name}.yaml"))]
    run("twist_mux", "twist_mux", "--ros-args", *files, "-r", "joy_vel:=joy_vel_out")
    relay()
    out, navigation = friend.hear(Twist, "cmd_vel_out"), Twist()
    navigation.linear.x = 0.1
    for speed in (1.0, 0.1):
        friend.say("nav_vel", navigation)
        deflect(friend, 1.0)
        assert [twist.linear.x for twist in out] == [speed]
        out.clear()
        friend.spin(1.0)
        do(friend, "joy_priority_action", JoyPriority)
        out.clear()
