"""twist_mux and twist_stamper on the virtual clock."""

import pytest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import Twist, TwistStamped
from std_msgs.msg import Bool
from visualization_msgs.msg import Marker

from coursekit.cli.parser import run as run_cli

PARAMETERS = """
twist_mux:
  ros__parameters:
    topics:
      navigation: {topic: nav_vel, timeout: 0.5, priority: 10}
      joystick: {topic: joy_vel, timeout: 0.5, priority: 100}
    locks:
      pause: {topic: pause, timeout: 0.0, priority: 50}
"""


def forward(speed):
    msg = Twist()
    msg.linear.x = speed
    return msg


@pytest.fixture
def mux(run, friend, tmp_path):
    def start(text=PARAMETERS):
        file = tmp_path / "mux.yaml"
        file.write_text(text)
        process = run("twist_mux", "twist_mux", "--ros-args", "--params-file", str(file))
        friend.out = friend.hear(Twist, "cmd_vel_out")
        friend.spin(0.2)
        return process

    return start


def drive(friend, seconds=0.5, **speeds):
    """Say speeds ten times a second; which came out."""
    friend.out.clear()
    for _ in range(round(seconds / 0.1)):
        for topic, speed in speeds.items():
            friend.say(topic, forward(speed))
        friend.spin(0.1)
    return {msg.linear.x for msg in friend.out}


def test_the_highest_that_speaks_drives_and_silence_gives_the_wheel_back(friend, mux):
    mux()
    assert drive(friend, nav_vel=0.1) == {0.1}
    assert drive(friend, joy_vel=0.9) == {0.9}
    assert drive(friend, nav_vel=0.1, joy_vel=0.9) == {0.9}
    friend.spin(0.6)
    assert drive(friend, nav_vel=0.1) == {0.1}


def test_a_lock_stops_those_below_it_and_only_those(friend, mux):
    mux()
    friend.say("pause", Bool(data=True))
    friend.spin(0.1)
    assert drive(friend, nav_vel=0.1) == set() and drive(friend, joy_vel=0.9) == {0.9}
    friend.spin(0.6)
    friend.say("pause", Bool(data=False))
    friend.spin(0.1)
    assert drive(friend, nav_vel=0.1) == {0.1}


def test_a_lock_with_a_timeout_that_is_silent_locks(friend, mux):
    mux(PARAMETERS.replace("topic: pause, timeout: 0.0", "topic: pause, timeout: 0.3"))
    assert drive(friend, nav_vel=0.1) == set()
    friend.say("pause", Bool(data=False))
    friend.spin(0.01)
    assert drive(friend, seconds=0.2, nav_vel=0.1) == {0.1}


def test_a_topic_without_priority_is_told(friend, mux):
    process = mux("twist_mux:\n  ros__parameters:\n    topics:\n      joystick: {topic: joy_vel, timeout: 0.5}\n")
    assert "Error parsing params: joystick has no priority" in process.output


def test_it_tells_who_is_masked(friend, mux):
    told = friend.hear(DiagnosticArray, "/diagnostics")
    mux()
    drive(friend, seconds=1.5, nav_vel=0.1)
    values = {value.key: value.value for value in told[-1].status[0].values}
    assert told[-1].status[0].name == "twist_mux: Twist mux status" and values["lock pause"].startswith(" free")
    assert values["velocity navigation"].startswith(" unmasked") and values["velocity joystick"].startswith(" masked")


def test_the_launch_file_starts_mux_and_marker_with_the_remapped_output(session, friend):
    out, arrows = friend.hear(Twist, "/diff_cont/cmd_vel_unstamped"), friend.hear(Marker, "/marker")
    words = ["launch", "twist_mux", "twist_mux_launch.py", "cmd_vel_out:=diff_cont/cmd_vel_unstamped"]
    process = session.start(lambda: run_cli(words), name="ros2", argv=words)
    friend.spin(3.0)
    friend.say("key_vel", forward(0.3))
    friend.spin(0.2)
    assert [msg.linear.x for msg in out] == [0.3] and arrows[0].points[1].x == 0.3, process.output
    process.interrupt()
    process.wait(5.0)


def test_velocities_get_a_stamp_and_lose_it(friend, run):
    names = ("-r", "cmd_vel_in:=a", "-r", "cmd_vel_out:=b")
    run("twist_stamper", "twist_stamper", "--ros-args", "-p", "frame_id:=base", *names)
    run("twist_stamper", "twist_unstamper", "--ros-args", "-r", "cmd_vel_in:=b", "-r", "cmd_vel_out:=c")
    stamped, plain = friend.hear(TwistStamped, "b"), friend.hear(Twist, "c")
    friend.spin(0.2)
    friend.say("a", forward(0.7))
    friend.spin(0.1)
    assert stamped[0].header.frame_id == "base" and stamped[0].header.stamp.sec > 0
    assert [msg.linear.x for msg in plain] == [0.7]


def test_the_arrow_shows_velocities_with_a_stamp_where_that_is_asked_for(run, friend):
    run("twist_mux", "twist_marker", "--ros-args", "-p", "use_stamped:=true")
    arrows = friend.hear(Marker, "marker")
    friend.spin(0.1)
    friend.say("twist", TwistStamped(twist=forward(0.5)))
    friend.spin(0.1)
    assert [(arrow.points[1].x, arrow.points[1].y, arrow.points[1].z) for arrow in arrows] == [(0.5, 0.0, 2.0)]
