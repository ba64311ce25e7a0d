"""joy_node and teleop_node, with a gamepad that is a pipe which speaks the kernel's protocol."""

import os
import struct

import pytest
from geometry_msgs.msg import Twist
from sensor_msgs.msg import Joy

from coursekit.cli.parser import run as run_cli
from coursekit.nodes.joy import device
from tests.needs import posix

pytestmark = posix("gamepads are no files there: `ros2 run joy joy_node` says that it knows none")
BUTTON, AXIS, FIRST = 1, 2, 128


class Pad:
    def __init__(self, folder):
        self.path = folder / "js0"
        os.mkfifo(self.path)
        self._file = os.open(self.path, os.O_RDWR)

    def tell(self, kind, number, value):
        os.write(self._file, struct.pack("=IhBB", 0, value, kind, number))

    def begin(self, axes=2, buttons=11):
        for kind, count in ((AXIS, axes), (BUTTON, buttons)):
            for number in range(count):
                self.tell(kind | FIRST, number, 0)

    def unplug(self):
        os.close(self._file)


@pytest.fixture
def pad(tmp_path, monkeypatch):
    monkeypatch.setattr(device, "INPUTS", tmp_path)
    return lambda: Pad(tmp_path)


def test_without_a_gamepad_it_waits_quietly_until_one_comes_and_after_one_that_goes(friend, run, pad, tmp_path):
    process, heard = run("joy", "joy_node"), friend.hear(Joy, "joy")
    friend.spin(3.0)
    assert not heard and process.output == ""
    gamepad = pad()
    gamepad.begin()
    friend.spin(2.0)
    assert "Opened joystick: js0.  deadzone: 0.050000" in process.output
    assert 15 <= len(heard) <= 41 and (len(heard[-1].axes), len(heard[-1].buttons)) == (2, 11)
    gamepad.unplug()
    gamepad.path.unlink()
    friend.spin(1.0)
    heard.clear()
    friend.spin(1.0)
    assert not heard and process.wait(0.1) is None


def test_axes_are_forward_and_left_positive_without_the_dead_zone(friend, run, pad):
    gamepad = pad()
    gamepad.begin()
    run("joy", "joy_node", "--ros-args", "-p", "deadzone:=0.5", "-p", "autorepeat_rate:=0.0")
    heard = friend.hear(Joy, "joy")
    friend.spin(0.1)
    gamepad.tell(AXIS, 1, -32767)
    gamepad.tell(AXIS, 0, 10000)
    gamepad.tell(BUTTON, 3, 1)
    friend.spin(0.5)
    assert len(heard) == 1 and heard[0].axes.tolist() == [0.0, 1.0] and heard[0].buttons[3] == 1
    assert heard[0].header.frame_id == "joy"


def test_sticky_buttons_stay_down_until_they_are_pressed_again(friend, run, pad):
    gamepad = pad()
    gamepad.begin()
    run("joy", "joy_node", "--ros-args", "-p", "sticky_buttons:=true")
    heard = friend.hear(Joy, "joy")
    states = []
    for value in (1, 0, 1, 0):
        friend.spin(0.2)
        gamepad.tell(BUTTON, 0, value)
        friend.spin(0.2)
        states.append(heard[-1].buttons[0])
    assert states == [1, 1, 0, 0]


def test_wrong_parameters_end_it_as_in_humble(friend, run):
    process = run("joy", "joy_node", "--ros-args", "-p", "deadzone:=1.5")
    assert process.wait(2.0) == -6 and "what():  Deadzone must be between 0.0 and 1.0" in process.output


def test_joy_linux_opens_a_path_and_says_once_that_there_is_none(friend, run, pad, tmp_path):
    path = str(tmp_path / "js0")
    process = run("joy_linux", "joy_linux_node", "--ros-args", "-p", f"dev:={path}", "-p", "deadzone:=0.5")
    heard = friend.hear(Joy, "joy")
    friend.spin(3.0)
    assert process.output.count(f"Couldn't open joystick {path}. Will retry every second.") == 1
    gamepad = pad()
    gamepad.begin()
    friend.spin(1.5)
    assert f"Opened joystick: {path}. deadzone_: 0.500000." in process.output
    gamepad.tell(AXIS, 1, -32767)
    friend.spin(0.5)
    assert heard[-1].axes.tolist() == [0.0, 1.0]


def test_joy_linux_corrects_a_dead_zone_in_the_units_of_old(run, pad):
    process = run("joy_linux", "joy_linux_node", "--ros-args", "-p", "deadzone:=16383.5", "-p", "dev_name:=Wheel")
    process.wait(0.5)
    assert "divided by 32767" in process.output and process.exit_code is None
    assert "Couldn't find a joystick with name containing Wheel." in process.output


def test_gamepads_are_listed(run, pad):
    pad()
    process = run("joy", "joy_enumerate_devices")
    process.wait(2.0)
    assert process.output.splitlines() == ["Joystick Device ID : Joystick Device Name", "-" * 41, " " * 17 + "0 : js0"]


def joy(*down, axes=(0.0, 1.0)):
    return Joy(axes=list(axes), buttons=[int(number in down) for number in range(11)])


def test_a_held_button_drives_another_faster_and_letting_go_stops_once(friend, run):
    options = ["axis_linear.x:=1", "scale_linear.x:=0.5", "scale_linear_turbo.x:=2.0", "axis_angular.yaw:=0",
               "scale_angular.yaw:=0.4", "enable_button:=4", "enable_turbo_button:=5"]  # fmt: skip
    process = run("teleop_twist_joy", "teleop_node", "--ros-args", *(word for option in options for word in ("-p", option)))
    heard = friend.hear(Twist, "cmd_vel")
    friend.spin(0.2)
    assert "[TeleopTwistJoy]: Teleop enable button 4." in process.output
    assert "Linear axis x on 1 at scale 0.500000." in process.output
    for buttons in ((), (4,), (5,), (), ()):
        friend.say("joy", joy(*buttons, axes=(0.5, 1.0)))
        friend.spin(0.05)
    assert [(msg.linear.x, round(msg.angular.z, 3)) for msg in heard] == [(0.0, 0.0), (0.5, 0.2), (2.0, 0.5), (0.0, 0.0)]


def test_without_a_button_it_drives_when_none_is_required(friend, run, ros2):
    run("teleop_twist_joy", "teleop_node", "--ros-args", "-p", "require_enable_button:=false", "-p", "axis_linear.x:=1")
    heard = friend.hear(Twist, "cmd_vel")
    friend.spin(0.2)
    friend.say("joy", joy())
    friend.spin(0.05)
    assert "successful" in ros2("param", "set", "/teleop_twist_joy_node", "scale_linear.x", "0.8")
    friend.say("joy", joy())
    friend.spin(0.05)
    assert [msg.linear.x for msg in heard] == [0.5, 0.8]


def test_the_launch_file_takes_a_configuration_by_its_name(session, friend, ros2, pad):
    words = ["launch", "teleop_twist_joy", "teleop-launch.py", "joy_config:=xbox", "joy_vel:=joy_vel"]
    process = session.start(lambda: run_cli(words), name="ros2", argv=words)
    heard = friend.hear(Twist, "joy_vel")
    friend.spin(3.0)
    friend.say("joy", joy(2))
    friend.spin(0.1)
    assert [msg.linear.x for msg in heard] == [0.7]
    assert "Double value is: 0.3" in ros2("param", "get", "/joy_node", "deadzone")
    process.interrupt()
    process.wait(5.0)
