"""ekf_node and ukf_node beside a robot, on the virtual clock."""

import math

import pytest
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import PoseWithCovarianceStamped, Twist
from nav_msgs.msg import Odometry
from rclpy.time import Time
from robot_localization.srv import SetPose, ToggleFilterProcessing
from std_srvs.srv import Empty

from coursekit.cli.parser import run as run_cli
from tests.nodes.robot_localization.conftest import mask

WHEELS = {"odom0": "odom", "odom0_config": mask("vx", "vy", "vyaw"), "two_d_mode": "true"}
BOTH = {**WHEELS, "imu0": "imu", "imu0_config": mask("vyaw")}
CALM = "[" + ", ".join(["0.0005"] * 15) + "]"


@pytest.mark.parametrize("node", ["ekf_node", "ukf_node"])
def test_wheels_and_gyroscope_find_the_way_that_wheels_alone_do_not(robot, start, node):
    start(node, **BOTH, process_noise_covariance=CALM)
    robot.drive(8.0)
    assert math.dist(robot.where()[:2], robot.truth[:2]) < 0.1 < math.dist(robot.wheels[:2], robot.truth[:2]) / 3
    pose = robot.heard[-1].pose.pose
    assert [pose.position.z, pose.orientation.x, pose.orientation.y] == pytest.approx([0, 0, 0], abs=1e-9)


def test_it_speaks_thirty_times_a_second_in_the_frames_of_its_parameters_and_tells_tf_the_same(robot, start):
    start(**BOTH, odom_frame="o", base_link_frame="base_link", transform_time_offset=0.5)
    robot.drive(2.0)
    last = robot.heard[-1]
    assert 55 <= len(robot.heard) <= 60 and (last.header.frame_id, last.child_frame_id) == ("o", "base_link")
    told = robot.buffer.lookup_transform("o", "base_link", Time())
    assert told.transform.translation.x == pytest.approx(last.pose.pose.position.x, abs=0.02)
    ahead = Time.from_msg(told.header.stamp) - Time.from_msg(last.header.stamp)
    assert ahead.nanoseconds * 1e-9 == pytest.approx(0.5, abs=0.05)


def test_without_publish_tf_there_is_no_transform(robot, start):
    start(**BOTH, publish_tf="false")
    robot.drive(0.5)
    assert robot.heard and not robot.buffer.can_transform("odom", "base_link", Time())


def test_in_the_map_it_tells_where_the_odometry_began(robot, start):
    robot.mount("base_link", parent="odom", x=1.0)
    start(pose0="pose", pose0_config=mask("x", "y", "yaw"), two_d_mode="true", world_frame="map")
    for _ in range(20):
        msg = robot.header(PoseWithCovarianceStamped(), "map")
        msg.pose.pose.position.x = 5.0
        robot.out["pose"].publish(msg)
        robot.spin(0.05)
    assert robot.buffer.lookup_transform("map", "odom", Time()).transform.translation.x == pytest.approx(4.0, abs=0.01)


def test_a_sensor_that_sits_askew_is_set_right_by_its_frame(robot, start):
    robot.mount("imu_link", yaw=math.pi / 2)
    start(imu0="imu", imu0_config=mask("yaw", "ax"), two_d_mode="true", publish_acceleration="true")
    for _ in range(30):
        robot.tell_imu(0.0, yaw=0.3 + math.pi / 2, frame="imu_link", x=1.0)
        robot.spin(0.02)
    assert robot.where()[2] == pytest.approx(0.3, abs=0.01)
    assert robot.heard[-1].twist.twist.linear.y > 0.2  # the IMU's x is the robot's y


def test_a_missing_transform_is_told_and_the_message_left_out(robot, start):
    robot.mount("imu_link")
    process = start(imu0="imu", imu0_config=mask("vyaw"))
    robot.tell_imu(1.0, frame="nowhere")
    robot.spin(0.2)
    assert not robot.heard and "A message of imu0 (imu) cannot be used" in process.output and "nowhere" in process.output


def test_a_differential_source_counts_by_its_changes_a_relative_one_from_its_first_pose(robot, start):
    start(odom0="odom", odom0_config=mask("x", "y", "yaw"), odom0_differential="true", two_d_mode="true")
    start("ukf_node", odom0="odom", odom0_config=mask("x", "y", "yaw"), odom0_relative="true", two_d_mode="true")
    for k in range(100):
        robot.tell_odometry(0.0, 0.0, pose=(10.0 + 0.01 * k, -3.0, 0.0))
        robot.spin(0.02)
    ends = [msg.pose.pose.position for msg in robot.heard[-2:]]
    assert all(end.x == pytest.approx(1.0, abs=0.1) and end.y == pytest.approx(0.0, abs=0.05) for end in ends)


def test_what_is_too_far_off_is_rejected(robot, start):
    start(pose0="pose", pose0_config=mask("x", "y"), pose0_rejection_threshold="3.0", two_d_mode="true")
    for x in [0.0] * 10 + [50.0] + [0.0] * 3:
        msg = robot.header(PoseWithCovarianceStamped(), "odom")
        msg.pose.pose.position.x, msg.pose.covariance = x, [0.01] * 36
        robot.out["pose"].publish(msg)
        robot.spin(0.05)
        assert not robot.heard or robot.where()[0] < 0.5


def test_gravity_is_taken_away_where_the_source_says_so(robot, start):
    start(imu0="imu", imu0_config=mask("roll", "pitch", "ax", "ay", "az"), imu0_remove_gravitational_acceleration="true")
    for _ in range(50):
        robot.tell_imu(0.0, z=9.80665)
        robot.spin(0.02)
    assert abs(robot.heard[-1].twist.twist.linear.z) < 0.01


def test_set_pose_moves_the_estimate_and_what_was_before_is_ignored(robot, start):
    start(**BOTH)
    robot.drive(0.5)
    msg = robot.header(PoseWithCovarianceStamped(), "odom")
    msg.pose.pose.position.x, msg.pose.pose.orientation.w = 7.0, 1.0
    robot.ask(SetPose, "set_pose", pose=msg)
    robot.spin(0.1)
    assert robot.where()[0] == pytest.approx(7.0, abs=0.1)


def test_it_can_begin_disabled_and_be_toggled(robot, start):
    process = start(**BOTH, disabled_at_startup="true")
    robot.drive(0.3)
    assert not robot.heard and "Filter is disabled. To enable it call the /enable service" in process.output
    robot.ask(Empty, "enable")
    robot.drive(0.3)
    assert robot.heard
    assert robot.ask(ToggleFilterProcessing, "toggle", on=False).status is True
    assert robot.ask(ToggleFilterProcessing, "toggle", on=False).status is False
    before = robot.where()
    robot.drive(0.5)
    assert robot.where() == pytest.approx(before, abs=0.02)


def test_commands_are_foreseen_where_use_control_says_so(robot, start):
    ones = "[5.0, 0.0, 0.0, 0.0, 0.0, 5.0]"
    start(**WHEELS, use_control="true", control_config="[true, false, false, false, false, true]", control_timeout="0.5",
          acceleration_limits=ones, acceleration_gains=ones, predict_to_current_time="true")  # fmt: skip
    robot.tell_odometry(0.0, 0.0)
    commands = robot.node.create_publisher(Twist, "cmd_vel", 1)
    msg = Twist()
    msg.linear.x = 1.0
    for _ in range(10):
        commands.publish(msg)
        robot.spin(0.1)
    assert robot.heard[-1].twist.twist.linear.x > 0.5


def test_its_health_is_told_where_print_diagnostics_says_so(robot, start):
    told: list[DiagnosticArray] = []
    robot.node.create_subscription(DiagnosticArray, "/diagnostics", told.append, 50)
    start(**BOTH, print_diagnostics="true")
    robot.drive(3.0)
    states = {status.name: status.message for status in told[-1].status}
    assert "functioning properly" in states["ekf_filter_node: Filter diagnostic updater"]
    assert states["ekf_filter_node: odometry/filtered topic status"] == "Desired frequency met"
    robot.tell_imu(0.0, frame="nowhere")
    robot.drive(1.0)
    assert any(value.key == "imu0_transform" for array in told for status in array.status for value in status.values)


def test_messages_of_time_zero_are_no_complaint_while_a_simulation_begins(robot, start):
    process = start(**WHEELS, use_sim_time="true")
    robot.out["odom"].publish(Odometry(child_frame_id="base_link"))
    robot.spin(0.2)
    assert process.output == "" and not robot.heard


def test_wrong_parameters_end_the_node_with_what_to_give_instead(robot, start):
    process = start(odom0="odom", odom0_config="[true, false]")
    assert process.wait(2.0) and "odom0_config has 2 values: give 15" in process.output


def test_the_launch_file_reads_the_file_of_parameters(session, ros2):
    process = session.start(lambda: run_cli(["launch", "robot_localization", "ekf.launch.py"]), name="ros2")
    session.clock.sleep(2.0)
    assert "String value is: example/odom" in ros2("param", "get", "/ekf_filter_node", "odom0")
    assert "/example/imu" in ros2("topic", "list")
    process.interrupt()
    process.wait(5.0)
