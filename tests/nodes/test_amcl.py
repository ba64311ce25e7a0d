"""amcl on the virtual clock: with a map server and a robot that drives through a building."""

from __future__ import annotations

import pytest
from geometry_msgs.msg import PoseWithCovarianceStamped
from nav2_msgs.msg import ParticleCloud
from rclpy.qos import qos_profile_sensor_data
from std_srvs.srv import Empty

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import save_map
from coursekit.nodes.nav2.amcl_messages import POSE_QOS
from coursekit.nodes.scanning.planar import plane, to_pose
from coursekit.processes.executables import find
from coursekit.processes.session import Session
from tests.slam.building import drawn
from tests.slam.robot import WALLS, Robot

BEGIN = Pose2D(3.0, 5.0, 0.0)


def at(pose: Pose2D) -> tuple[str, ...]:
    """Parameters that start amcl somewhere."""
    given = ["-p", "set_initial_pose:=true"]
    for axis, value in zip(("x", "y", "yaw"), pose, strict=True):
        given += ["-p", f"initial_pose.{axis}:={value}"]
    return tuple(given)


@pytest.fixture
def robot(session):
    new_robot = Robot(session)
    yield new_robot
    new_robot.close()


@pytest.fixture
def amcl(run, session, tmp_path):
    """amcl(parameters...) starts it with a map of the office, both brought up by the lifecycle manager."""
    house = save_map(tmp_path / "house", drawn(WALLS))[0]

    def start(*argv):
        run("nav2_map_server", "map_server", "--ros-args", "-p", f"yaml_filename:={house}")
        process = run("nav2_amcl", "amcl", "--ros-args", *argv)
        run(
            "nav2_lifecycle_manager", "lifecycle_manager", "--ros-args",
            "-p", "node_names:=[map_server, amcl]", "-p", "autostart:=true",
        )  # fmt: skip
        session.clock.sleep(1.0)
        return process

    return start


def tell_pose(robot: Robot, pose: Pose2D, frame: str = "map") -> None:
    publisher = robot.node.create_publisher(PoseWithCovarianceStamped, "initialpose", 1)
    msg = PoseWithCovarianceStamped()
    msg.header.frame_id, msg.pose.pose = frame, to_pose(pose)
    msg.pose.covariance[0] = msg.pose.covariance[7] = 0.25
    msg.pose.covariance[35] = 0.07
    publisher.publish(msg)
    robot.spin(0.1)


def test_a_robot_is_followed_from_a_wrong_start(amcl, robot):
    process = amcl(*at(Pose2D(3.4, 4.7, 0.2)))
    poses, clouds = [], []
    robot.node.create_subscription(PoseWithCovarianceStamped, "amcl_pose", poses.append, POSE_QOS)
    robot.node.create_subscription(ParticleCloud, "particle_cloud", clouds.append, qos_profile_sensor_data)
    end = robot.go([(3.0, 5.0), (9.0, 5.0), (9.0, 4.4)])
    assert "Received a" in process.output and "Setting pose (" in process.output
    assert robot.where_is(end) < 0.25
    estimate = plane(poses[-1].pose.pose.position, poses[-1].pose.pose.orientation)
    assert estimate.distance(end) < 0.3 and poses[-1].header.frame_id == "map"
    assert 0 < poses[-1].pose.covariance[0] < 0.25 and poses[-1].pose.covariance[35] > 0
    assert 500 <= len(clouds[-1].particles) <= 2000
    assert sum(particle.weight for particle in clouds[-1].particles) == pytest.approx(1.0, abs=0.01)
    process.interrupt()
    assert process.wait(5.0) == 0


def test_without_a_start_it_asks_for_one_and_takes_it(amcl, robot):
    process = amcl()
    robot.tell(BEGIN)
    assert "AMCL cannot publish a pose or update the transform. Please set the initial pose..." in process.output
    assert not robot.buffer.can_transform_core("map", "odom", robot.node.get_clock().now())[0]
    tell_pose(robot, BEGIN, frame="odom")
    assert 'Ignoring initial pose in frame "odom"; initial poses must be in the global frame, "map"' in process.output
    tell_pose(robot, Pose2D(3.3, 4.8, 0.1))
    end = robot.go([(3.0, 5.0), (7.0, 5.0)])
    assert robot.where_is(end) < 0.25


def test_a_robot_anywhere_in_the_building_is_found(amcl, robot):
    amcl()
    robot.ask(Empty, "reinitialize_global_localization")
    end = robot.go([(14.0, 11.0), (3.0, 11.0), (3.0, 6.0)])
    assert robot.where_is(end) < 0.3


def test_a_standing_robot_is_weighed_only_on_request(amcl, robot):
    amcl(*at(BEGIN))
    poses = []
    robot.node.create_subscription(PoseWithCovarianceStamped, "amcl_pose", poses.append, POSE_QOS)
    for _ in range(5):
        robot.tell(BEGIN)
    assert len(poses) == 1
    robot.ask(Empty, "request_nomotion_update")
    for _ in range(3):
        robot.tell(BEGIN)
    assert len(poses) == 2


def test_tf_broadcast_can_be_switched_off(amcl, robot):
    amcl(*at(BEGIN), "-p", "tf_broadcast:=false")
    robot.tell(BEGIN)
    robot.tell(BEGIN)
    assert not robot.buffer.all_frames_as_yaml().count("map")


@pytest.mark.parametrize(
    ("parameter", "says"),
    [
        ("max_particles:=10", "min_particles 500, max_particles 10: 0 < min <= max"),
        ("robot_model_type:=tank", "unknown robot_model_type 'tank': use one of nav2_amcl::DifferentialMotionModel"),
        ("alpha1:=many", "alpha1 should be a number, for example 0.2, not 'many'"),
    ],
)
def test_parameters_that_cannot_work_stop_the_configuration(amcl, session, parameter, says):
    process = amcl("-p", parameter)
    assert says in process.output and process.state == "running"


def test_parameters_set_while_it_runs_are_obeyed_or_refused(amcl, robot, ros2):
    amcl(*at(BEGIN))
    poses = []
    robot.node.create_subscription(PoseWithCovarianceStamped, "amcl_pose", poses.append, POSE_QOS)
    assert "successful" in ros2("param", "set", "/amcl", "update_min_d", "5.0")
    assert "successful" in ros2("param", "set", "/amcl", "update_min_a", "5.0")
    robot.go([(3.0, 5.0), (7.0, 5.0)])
    assert len(poses) == 1
    assert "0 < min <= max" in ros2("param", "set", "/amcl", "max_particles", "10")


def test_two_runs_are_the_same(tmp_path):
    first, second = (whole_run(tmp_path) for _ in range(2))
    assert first == second and first.distance(Pose2D(5.0, 5.0, 0.0)) < 0.5


def whole_run(folder) -> Pose2D:
    """Where tf has the robot after a short drive in a session of its own."""
    house = save_map(folder / "house", drawn(WALLS))[0]
    with Session(virtual=True).use() as session:
        for package, executable, *argv in (
            ("nav2_map_server", "map_server", "-p", f"yaml_filename:={house}"),
            ("nav2_amcl", "amcl", *at(Pose2D(3.4, 4.7, 0.2))),
            ("nav2_lifecycle_manager", "lifecycle_manager", "-p", "node_names:=[map_server, amcl]", "-p", "autostart:=true"),
        ):
            session.start_executable(find(package, executable), ["--ros-args", *argv], name=executable)
        session.clock.sleep(1.0)
        robot = Robot(session)
        robot.go([(3.0, 5.0), (5.0, 5.0)])
        here = robot.where()
        robot.close()
    return here
