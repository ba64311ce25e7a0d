"""The newer Gazebo's names: the same world, its topics in ROS only where they are bridged."""

from pathlib import Path

import pytest
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import LaserScan
from tf2_msgs.msg import TFMessage

from tests.nodes.gz.conftest import DRIVE, LIDAR, SENSORS

BRIDGE = (
    "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock", "/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist",
    "/odom@nav_msgs/msg/Odometry[ignition.msgs.Odometry", "/scan@sensor_msgs/msg/LaserScan@gz.msgs.LaserScan",
    "/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V",
)  # fmt: skip
SPELLINGS = [
    ("gz-sim-diff-drive-system", "gz::sim::systems::DiffDrive"),
    ("libgz-sim-diff-drive-system.so", "gz::sim::systems::DiffDrive"),
    ("libignition-gazebo-diff-drive-system.so", "ignition::gazebo::systems::DiffDrive"),
    ("ignition-gazebo6-diff-drive-system", "ignition::gazebo::systems::DiffDrive"),
]


@pytest.mark.parametrize("words", SPELLINGS)
def test_a_robot_of_the_newer_gazebo_drives_and_scans_over_the_bridge(gz, run, friend, yard, cart, words):
    gz("sim", "-r", yard())
    run("ros_gz_bridge", "parameter_bridge", *BRIDGE)
    process = run(
        "ros_gz_sim", "create", "-file", cart(DRIVE.format(*words), LIDAR.format("")), "-name", "cart", "-z", "0.1"
    )
    assert process.wait(20) == 0 and "OK creation of entity." in process.output
    clock, odometry, scans, tf = (
        friend.hear(kind, topic)
        for kind, topic in ((Clock, "/clock"), (Odometry, "/odom"), (LaserScan, "/scan"), (TFMessage, "/tf"))
    )
    friend.go(2.0, 0.25)
    assert odometry[-1].pose.pose.position.x == pytest.approx(0.5, abs=0.05)
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("odom", "base_footprint")
    assert tf[-1].transforms[0].child_frame_id == "base_footprint" and clock[-1].clock.sec >= 1
    assert scans[-1].header.frame_id == "cart/base_footprint/lidar", "fixed joints are joined, as sdformat does"
    assert min(scans[-1].ranges) == pytest.approx(1.0, abs=0.1)


def test_nothing_of_gazebo_is_in_ros_until_it_is_bridged(gz, ros2, run, yard, cart):
    gz("sim", "-r", yard())
    run("ros_gz_sim", "create", "-file", cart(DRIVE.format(*SPELLINGS[0])), "-name", "cart").wait(20)
    topics = ros2("topic", "list").split()
    assert not {"/clock", "/odom", "/scan", "/cmd_vel"} & set(topics)
    assert ros2("node", "list").split() == []
    listed = gz("topic", "-l")
    listed.wait(5)
    assert {"/clock", "/odom", "/cmd_vel", "/world/yard/clock"} <= set(listed.output.split())


def test_without_r_the_world_stands_still(gz, friend, run, yard):
    server = gz("sim", yard())
    run("ros_gz_bridge", "parameter_bridge", BRIDGE[0])
    clock = friend.hear(Clock, "/clock")
    friend.spin(1.0)
    assert not clock and "paused" in server.output


def test_a_world_without_the_sensors_system_has_no_scans_and_says_which_line_is_missing(gz, run, friend, yard, cart):
    server = gz("sim", "-r", yard(plugins=""))
    run("ros_gz_bridge", "parameter_bridge", *BRIDGE)
    run("ros_gz_sim", "create", "-file", cart(LIDAR.format(""), DRIVE.format(*SPELLINGS[0])), "-name", "cart").wait(20)
    scans = friend.hear(LaserScan, "/scan")
    friend.spin(1.0)
    assert not scans and "gz-sim-sensors-system" in server.output


def test_the_frame_that_a_sensor_names_is_its_frame_and_the_system_may_be_the_robot_s(gz, run, friend, yard, cart):
    gz("sim", "-r", yard(plugins=""))
    run("ros_gz_bridge", "parameter_bridge", *BRIDGE)
    lidar = LIDAR.format("<gz_frame_id>laser</gz_frame_id>")
    run("ros_gz_sim", "create", "-file", cart(lidar, f"<gazebo>{SENSORS}</gazebo>"), "-name", "cart").wait(20)
    scans = friend.hear(LaserScan, "/scan")
    friend.spin(1.0)
    assert scans[-1].header.frame_id == "laser"


def test_a_system_that_is_not_known_is_told_in_one_line_with_the_known_ones(gz, run, yard, cart):
    server = gz("sim", "-r", yard())
    block = "<gazebo><plugin filename='gz-sim-magic-system' name='gz::sim::systems::Magic'/></gazebo>"
    assert run("ros_gz_sim", "create", "-file", cart(block), "-name", "cart").wait(20) == 0
    line = next(printed for printed in server.output.splitlines() if "magic" in printed)
    assert "gz-sim-diff-drive-system" in line


def test_a_second_model_of_a_name_is_refused_or_renamed(gz, run, yard, cart):
    gz("sim", "-r", yard())
    file = Path(cart(DRIVE.format(*SPELLINGS[0]))).as_posix()  # a backslash would need another one
    words = ("ros_gz_sim", "create", "-file", file, "-name", "cart")
    assert run(*words).wait(20) == 0
    assert run(*words, "-x", "-3").wait(20) == 1
    assert run(*words, "-x", "-3", "-allow_renaming", "true").wait(20) == 0


def test_the_window_alone_is_no_second_world(gz, run, friend, yard):
    gz("sim", "-r", "-s", yard())
    window = gz("sim", "-g")
    friend.spin(1.0)
    assert window.state == "running" and "viewer()" in window.output
    listed = gz("service", "-l")
    listed.wait(5)
    assert {word.split("/")[2] for word in listed.output.split()} == {"yard"}
    window.interrupt()
    assert window.wait(5) is not None


def test_the_world_is_steered_by_what_people_type(gz, run, friend, yard, cart):
    def done(*words):
        process = gz(*words)
        return process.wait(5), process.output

    server = gz("sim", yard())
    friend.spin(0.5)
    asked = "/world/yard/control", "--reqtype", "gz.msgs.WorldControl", "--reptype", "gz.msgs.Boolean", "--timeout", "1000"
    assert f"gz service -s {' '.join(asked)} --req 'pause: false'" in server.output
    assert done("service", "-s", *asked, "--req", "pause: false") == (0, "data: true\n\n")
    file = Path(cart(DRIVE.format(*SPELLINGS[0]))).as_posix()  # a backslash would need another one
    types = "--reqtype", "ignition.msgs.EntityFactory", "--reptype", "ignition.msgs.Boolean"
    text = f'sdf_filename: "{file}", name: "cart" pose {{position: {{x: -1}}}}'
    assert done("service", "-s", "/world/yard/create", *types, "-r", text) == (0, "data: true\n\n")
    run("ros_gz_bridge", "parameter_bridge", *BRIDGE)
    odometry = friend.hear(Odometry, "/odom")
    assert done("topic", "-t", "/cmd_vel", "-m", "gz.msgs.Twist", "-p", "linear: {x: 0.25}, angular: {z: 0.0}") == (0, "")
    friend.spin(2.0)
    assert odometry[-1].pose.pose.position.x == pytest.approx(0.5, abs=0.1)
    types = "--reqtype", "gz.msgs.Pose", "--reptype", "gz.msgs.Boolean"
    assert done("service", "-s", "/world/yard/set_pose", *types, "--req", 'name: "cart" position {y: 3}')[0] == 0
    types = "--reqtype", "gz.msgs.Entity", "--reptype", "gz.msgs.Boolean"
    for name, gone in (("nobody", "false"), ("cart", "true")):
        text = f'name: "{name}" type: MODEL'
        assert done("service", "-s", "/world/yard/remove", *types, "--req", text) == (0, f"data: {gone}\n\n")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("topic", "-t", "a", "-m", "gz.msgs.Twist", "-p", "linear: {w: 1}"), 'Twist.linear" has no field named "w"'),
        (("topic", "-t", "a", "-m", "gz.msgs.Twist", "-p", "linear: 1"), "write linear: {x: ...}"),
        (("topic", "-t", "a", "-m", "gz.msgs.Twist", "-p", "linear: {x: 1"), "1:13: this is not"),
        (("topic", "-t", "a", "-m", "gz.msgs.Double", "-p", "data: fast"), "a text stands in quotes"),
        (("topic", "-t", "a", "-m", "gz.msgs.Boolean", "-p", 'data: "false"'), "texts stand in quotes, and nothing else"),
        (("topic", "-t", "a", "-m", "gz.msgs.StringMsg", "-p", "data: 2"), "texts stand in quotes, and nothing else"),
        (("topic", "-t", "a", "-m", "Twist", "-p", ""), "There is no type 'Twist' here. There are: gz.msgs.Altimeter"),
        (("service", "-s", "/world/yard/control", "--reqtype", "gz.msgs.Empty"), "takes --reqtype gz.msgs.WorldControl"),
        (("service", "-s", "/world/yard/create_multiple"), "There are: /world/yard/control, /world/yard/create"),
    ],
)  # fmt: skip
def test_what_gazebo_cannot_take_is_told(gz, yard, friend, words, says):
    gz("sim", "-r", yard())
    friend.spin(0.5)
    process = gz(*words)
    assert process.wait(5) == 255 and says in process.output
