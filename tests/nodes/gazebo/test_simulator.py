"""The simulator as a user meets it, on the virtual clock."""

import math
from pathlib import Path

import cv2
import numpy as np
import pytest
from gazebo_msgs.msg import EntityState
from gazebo_msgs.srv import DeleteEntity, GetEntityState, GetModelList, SetEntityState, SpawnEntity
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import CameraInfo, Image, Imu, JointState, LaserScan
from std_srvs.srv import Empty
from tf2_msgs.msg import TFMessage

ROBOT = Path(__file__).parents[3] / "robots" / "urdf" / "rdk_x3_robot.urdf"


def when(stamp):
    return stamp.sec * 10**9 + stamp.nanosec


def test_the_course_s_robot_has_all_its_topics_at_exact_rates(run, spawn, friend):
    run("gazebo_ros", "gzserver", "robot_world")
    heard = {
        kind: friend.hear(kind, topic)
        for kind, topic in [
            (LaserScan, "scan"), (Odometry, "odom"), (Imu, "imu"), (JointState, "joint_states"), (Clock, "clock"),
            (TFMessage, "tf"), (Image, "camera/image_raw"), (CameraInfo, "camera/camera_info"),
        ]
    }  # fmt: skip
    assert spawn("-x", "0.5", "-y", "0.5").exit_code == 0
    friend.spin(2.0)
    for kind, rate in {LaserScan: 10, Odometry: 30, Imu: 100, JointState: 30, Image: 30, CameraInfo: 30}.items():
        steps = np.diff([when(msg.header.stamp) for msg in heard[kind]])
        assert len(steps) >= 1.9 * rate and abs(steps - 1e9 / rate).max() <= 1, kind
    assert abs(np.diff([when(msg.clock) for msg in heard[Clock]]) - 1e7).max() == 0
    scan = heard[LaserScan][-1]
    assert (scan.header.frame_id, len(scan.ranges)) == ("laser_link", 360)
    assert scan.ranges[0] == pytest.approx(3.1 - 0.542 - math.sqrt(0.15**2 - 0.1**2), abs=0.05), "the post is ahead"
    assert heard[Imu][-1].linear_acceleration.z == pytest.approx(9.81)
    frame = heard[TFMessage][-1].transforms[0]
    assert (frame.header.frame_id, frame.child_frame_id) == ("odom", "base_footprint")
    image = heard[Image][-1]
    assert (image.height, image.width, image.encoding, image.header.frame_id) == (480, 640, "rgb8", "camera_optical_link")
    assert np.asarray(image.data).std() > 10


def test_a_robot_drives_turns_its_wheels_and_odometry_drifts(run, spawn, friend):
    run("gazebo_ros", "gzserver")
    spawn()
    odometry, joints = friend.hear(Odometry, "odom"), friend.hear(JointState, "joint_states")
    friend.go(4.0, 0.25)
    friend.go(1.0, 0.0)
    true = friend.ask(GetEntityState, "get_entity_state", name="rdk").state.pose.position.x
    assert true == pytest.approx(1.0, abs=0.02)
    assert 0.003 < abs(odometry[-1].pose.pose.position.x - true) < 0.1
    assert joints[-1].position[0] == pytest.approx(1.0 / 0.0375, rel=0.02)
    assert odometry[-1].twist.twist.linear.x == 0.0
    numbers = (odometry[-1].pose.pose.position.x, odometry[-1].pose.pose.orientation.z, joints[-1].position[0])
    assert {type(number) for number in numbers} == {float}, "what prints as a plain number"


def test_services_tell_move_reset_pause_and_delete(run, spawn, friend):
    run("gazebo_ros", "gzserver", "robot_world")
    spawn("-x", "0.5", "-y", "0.5")
    names = friend.ask(GetModelList, "get_model_list").model_names
    assert "crate" in names and names[-1] == "rdk"
    state = EntityState(name="rdk")
    state.pose.position.x, state.pose.orientation.w = 1.0, 1.0
    assert friend.ask(SetEntityState, "set_entity_state", state=state).success
    assert friend.ask(GetEntityState, "get_entity_state", name="rdk", reference_frame="crate").success
    laser = friend.ask(GetEntityState, "get_entity_state", name="rdk::laser_link").state.pose.position
    assert (laser.x, laser.y) == pytest.approx((1.042, 0.0), abs=1e-6)
    assert not friend.ask(GetEntityState, "get_entity_state", name="nobody").success
    scans = friend.hear(LaserScan, "scan")
    friend.ask(Empty, "pause_physics")
    friend.spin(1.0)
    assert len(scans) <= 1
    friend.ask(Empty, "unpause_physics")
    friend.spin(1.0)
    assert len(scans) >= 9
    friend.ask(Empty, "reset_simulation")
    friend.spin(0.5)
    assert when(scans[-1].header.stamp) < 6e8
    place = friend.ask(GetEntityState, "get_entity_state", name="rdk").state.pose.position
    assert (place.x, place.y) == pytest.approx((0.5, 0.5))
    answer = friend.ask(DeleteEntity, "delete_entity", name="rdk")
    assert (answer.success, answer.status_message) == (True, "Successfully deleted entity [rdk]")
    assert friend.ask(DeleteEntity, "delete_entity", name="rdk").status_message == "Entity [rdk] does not exist"
    count = len(scans)
    friend.spin(0.5)
    assert len(scans) == count


def test_what_cannot_be_spawned_is_told_and_the_session_goes_on(run, spawn, friend, tmp_path):
    run("gazebo_ros", "gzserver", "robot_world")
    wall = spawn("-x", "5.0", "-y", "0.0")
    assert wall.exit_code == 1 and "'room' is in the way" in wall.output and "Spawn service failed. Exiting." in wall.output
    assert spawn("-x", "0.5", "-y", "0.5").exit_code == 0
    twice = spawn("-x", "0.5", "-y", "2.0")
    assert twice.exit_code == 1 and "Entity [rdk] already exists." in twice.output
    broken = tmp_path / "broken.urdf"
    broken.write_text("<robot name='r'><link")
    assert "Invalid XML" in spawn(file=broken, name="b").output
    assert "does not exist" in spawn(file=tmp_path / "none.urdf", name="n").output
    assert spawn("-x", "abc").exit_code == 2
    lost = friend.ask(SpawnEntity, "spawn_entity", name="z", xml=ROBOT.read_text(), reference_frame="nowhere")
    assert not lost.success and "Reference frame [nowhere] not found" in lost.status_message
    assert friend.ask(GetEntityState, "get_entity_state", name="rdk").success


def test_two_robots_in_namespaces_have_their_own_topics(run, spawn, friend):
    run("gazebo_ros", "gzserver")
    spawn("-robot_namespace", "one", name="one")
    spawn("-robot_namespace", "two", "-y", "1.0", name="two")
    friend.go(2.0, 0.3, topic="/two/cmd_vel")
    places = [friend.ask(GetEntityState, "get_entity_state", name=name).state.pose.position.x for name in ("one", "two")]
    assert places[0] == pytest.approx(0.0, abs=1e-6) and places[1] > 0.4
    assert {"/one/scan", "/two/scan", "/two/odom"} <= {name for name, _ in friend.node.get_topic_names_and_types()}


def test_a_world_that_is_none_is_told_with_its_cure(run):
    process = run("gazebo_ros", "gzserver", "robot_wrld")
    assert process.wait(5) == 255 and "Did you mean 'robot_world'?" in process.output


def test_the_virtual_camera_sees_the_simulated_world(run, spawn, friend):
    from coursekit.view.capture import VirtualCapture

    camera = VirtualCapture(0)
    alone = camera.read()[1]
    run("gazebo_ros", "gzserver", "robot_world")
    spawn("-x", "0.5", "-y", "0.5")
    seen = camera.read()[1]
    assert seen.shape == alone.shape and abs(seen.astype(int) - alone).mean() > 10
    yellow = cv2.inRange(cv2.cvtColor(seen, cv2.COLOR_BGR2HSV), (20, 150, 100), (32, 255, 255))
    assert 200 < np.argwhere(yellow)[:, 1].mean() < 440, "the striped post is ahead"


def test_two_runs_say_the_same(run, spawn, friend):
    scans = friend.hear(LaserScan, "scan")
    ends = []
    for _ in range(2):
        server = run("gazebo_ros", "gzserver", "robot_world")
        spawn("-x", "0.5", "-y", "0.5")
        scans.clear()
        friend.go(2.0, 0.3, 0.4)
        ends.append([list(scan.ranges) for scan in scans[:15]])
        server.interrupt()
        server.wait(5)
    assert ends[0] == ends[1]


def test_the_launch_file_starts_a_world(ros2):
    output = ros2("launch", "gazebo_ros", "gazebo.launch.py", "world:=office", seconds=1.0)
    assert "World 'office'" in output


def test_a_robot_is_spawned_from_its_description_on_a_topic_into_a_map(run, friend, tmp_path):
    cells = np.full((40, 40), 254, np.uint8)
    cells[:, 30:] = 0
    cv2.imwrite(str(tmp_path / "hall.pgm"), cells)
    (tmp_path / "hall.yaml").write_text(
        "image: hall.pgm\nresolution: 0.1\norigin: [-2.0, -2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"
    )
    run("gazebo_ros", "gzserver", str(tmp_path / "hall.yaml"))
    run("robot_state_publisher", "robot_state_publisher", str(ROBOT))
    process = run("gazebo_ros", "spawn_entity.py", "-topic", "robot_description", "-entity", "rdk", "-Y", "0.0")
    assert process.wait(5) == 0 and "Loading entity published on topic robot_description" in process.output
    scans = friend.hear(LaserScan, "scan")
    friend.spin(0.5)
    assert scans[-1].ranges[0] == pytest.approx(1.0 - 0.042, abs=0.05)
