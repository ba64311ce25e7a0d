"""The smaller demos of ROS 2: the dummy robot, topic_monitor, logging_demo, intra_process_demo, the message filter."""

import math

import cv2
import numpy
import pytest
import rclpy
from cv_bridge import CvBridge
from nav_msgs.msg import OccupancyGrid
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from sensor_msgs.msg import Image, JointState, LaserScan

from coursekit.nodes.dummy_robot.map_server import SIDE
from coursekit.nodes.intra_process import images
from coursekit.nodes.intra_process.images import HEIGHT, WIDTH
from coursekit.nodes.topic_monitor.statistics import TopicStatistics
from tests.nodes.log import said


@pytest.fixture
def hear(session):
    """hear(type, topic) waits for what is published next."""
    rclpy.init()
    node = rclpy.create_node("ear")

    def take(kind, topic, qos=10):
        got = []
        ear = node.create_subscription(kind, topic, got.append, qos)
        while not got:
            rclpy.spin_once(node)
        node.destroy_subscription(ear)
        return got[0]

    yield take
    node.destroy_node()
    rclpy.shutdown()


def test_the_map_shows_one_obstacle_that_wanders_and_late_listeners_get_it(session, run, hear):
    run("dummy_map_server", "dummy_map_server")
    session.clock.sleep(2.5)
    kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    grid = hear(OccupancyGrid, "map", kept)
    assert (grid.header.frame_id, grid.info.width, grid.info.height) == ("world", SIDE, SIDE)
    assert (grid.info.origin.position.x, grid.info.origin.position.y) == (-5.0, -5.0)
    assert list(grid.data[2:7]) == [-1, 0, 100, 0, -1] and sum(cell != -1 for cell in grid.data) == 3


def test_scan_and_joints_swing(session, run, hear):
    laser = run("dummy_sensors", "dummy_laser")
    run("dummy_sensors", "dummy_joint_states")
    session.clock.sleep(1.01)
    scan, joints = hear(LaserScan, "scan"), hear(JointState, "joint_states")
    assert said(laser) == ["angle inc:\t0.004363", "scan size:\t1081", "scan time increment: \t0.000028"]
    assert scan.header.frame_id == "single_rrbot_hokuyo_link"
    assert len(scan.ranges) == 1081 == round((scan.angle_max - scan.angle_min) / scan.angle_increment) + 1
    assert min(scan.ranges) == max(scan.ranges) == pytest.approx(abs(math.sin(3.2)))
    assert list(joints.name) == ["single_rrbot_joint1", "single_rrbot_joint2"]
    assert joints.position[0] == joints.position[1] and -1 <= joints.position[0] <= 1


@pytest.mark.parametrize("file", ["dummy_robot_bringup.launch.py", "dummy_robot_bringup_launch.py"])
def test_the_dummy_robot_has_frames_from_the_world_to_its_laser(session, ros2, run, file):
    from coursekit.cli.parser import run as run_cli

    words = ["launch", "dummy_robot_bringup", file]
    launch = session.start(lambda: run_cli(words), name="ros2", argv=words)
    session.clock.sleep(1.0)
    assert "At time" in ros2("run", "tf2_ros", "tf2_echo", "world", "single_rrbot_hokuyo_link", seconds=1.5)
    assert "died" not in launch.output


def test_loggers_log_once_and_debug_after_the_eleventh_time(session, run):
    process = run("logging_demo", "logging_demo_main")
    session.clock.sleep(6.7)
    even = "Count is even (expression evaluated to true)"
    assert said(process)[:2] == ["Timer callback called (this will only log once)", "Publishing: 'Current count: 0'"]
    assert said(process)[-7:] == [
        "Publishing: 'Current count: 9'", "Publishing: 'Current count: 10'", "Setting severity threshold to DEBUG",
        "Publishing: 'Current count: 11'", "Publishing: 'Current count: 12'",
        "Count divides into 12 (function evaluated to true)", even,
    ]  # fmt: skip


def test_a_service_sets_the_level_of_a_logger(session, run, ros2):
    process = run("logging_demo", "logging_demo_main")
    session.clock.sleep(0.1)
    call = ("service", "call", "/config_logger", "logging_demo/srv/ConfigLogger")
    assert "success=True" in ros2(*call, "{logger_name: 'logger_usage_demo', level: WARN}")
    assert "success=False" in ros2(*call, "{logger_name: 'logger_usage_demo', level: LOUD}")
    session.clock.sleep(2.0)
    assert said(process) == [
        "Incoming request: logger 'logger_usage_demo', severity 'WARN'",
        "Incoming request: logger 'logger_usage_demo', severity 'LOUD'",
        "Unknown severity 'LOUD'",
    ]


def test_a_monitor_tells_when_topics_come_get_stale_and_go(session, run, ros2):
    monitor = run("topic_monitor", "topic_monitor")
    sensor = run("topic_monitor", "data_publisher", "sensor", "--best-effort")
    run("topic_monitor", "data_publisher", "critical", "--end-after", "8", "--payload-size", "3")
    session.clock.sleep(3.2)
    sensor.kill()
    session.clock.sleep(3.0)
    told = said(monitor)
    assert "Subscribing to topic: /sensor_data_best_effort" in told and "/critical_data: 7" in told
    assert "/critical_data: -1" in told
    statuses = [line for line in told if line.startswith("/sensor_data_best_effort: ") and line[-1].isalpha()]
    assert list(dict.fromkeys(statuses)) == [f"/sensor_data_best_effort: {word}" for word in ("Alive", "Stale")]
    assert "data: 0.0" in ros2("topic", "echo", "--once", "/reception_rate/critical_data")


def test_the_rate_is_the_share_of_what_should_have_come():
    topic = TopicStatistics(window=4, depth=10, period=1.0, latency=1.0, stale=1.5)
    assert (topic.rate(0.0), topic.status(0.0)) == (0.0, "Offline")
    for number in (0, 1, 3, 4, 5):
        topic.heard(number, float(number))
    assert [topic.rate(now) for now in (4.5, 6.0)] == [0.75, 0.75]
    topic.heard(-1, 6.5)
    assert (topic.rate(6.6), topic.status(6.6)) == (0.0, "Offline")


def test_a_publisher_says_at_the_end_that_it_is_the_end(session, run):
    publisher = run("topic_monitor", "data_publisher", "--period", "0.1")
    session.clock.sleep(0.25)
    publisher.interrupt()
    assert publisher.wait(2) == 0
    assert said(publisher)[-4:] == [f'Publishing: "{number}"' for number in (0, 1, 2, -1)]


@pytest.mark.parametrize("demo", ["depth_demo", "fragmentation_demo", "reliability_demo"])
def test_the_demos_of_topic_monitor_publish(ros2, demo):
    output = ros2("launch", "topic_monitor", f"{demo}_launch.py", seconds=0.3)
    assert "died" not in output and output.count('Publishing: "0"') == (2 if demo == "reliability_demo" else 4)


def test_windows_and_periods_that_cannot_be_are_refused(run):
    for words, told in ((["-d"], "/reception_rate/TOPIC"), (["-t", "0"], "greater than 0")):
        process = run("topic_monitor", "topic_monitor", *words)
        assert process.wait(2) == 2 and told in process.output


def test_a_number_goes_from_one_node_to_the_other_and_round(session, run):
    two, cycle = run("intra_process_demo", "two_node_pipeline"), run("intra_process_demo", "cyclic_pipeline")
    session.clock.sleep(2.5)
    shown = [line.split(",")[0] for line in two.output.splitlines()]
    assert shown == [f"{what} message with value: {n}" for n in (0, 1) for what in ("Published", " Received")]
    values = [line.split(":")[1].split(",")[0].strip() for line in cycle.output.splitlines() if "value" in line]
    assert values == ["42", "42", "43", "43", "44", "44"]


def test_within_one_process_the_message_itself_is_handed_on(session, run, ros2):
    two, cycle = run("intra_process_demo", "two_node_pipeline"), run("intra_process_demo", "cyclic_pipeline")
    session.clock.sleep(2.5)
    addresses = [line.rpartition(" ")[2] for line in two.output.splitlines()]
    assert addresses[0] == addresses[1] and addresses[2] == addresses[3]
    assert len({line.rpartition(" ")[2] for line in cycle.output.splitlines() if "address" in line}) == 1
    ros2("topic", "pub", "--once", "/number", "std_msgs/msg/Int32", "data: 70")
    assert " Received message with value: 70, and address: 0x" in two.output


@pytest.fixture
def film(monkeypatch, tmp_path):
    """film(frames) stands for the first camera: a video of so many black frames, or, with 0, none."""
    opened = cv2.VideoCapture

    def show(frames):
        path = str(tmp_path / "film.avi")
        if frames:
            writer = cv2.VideoWriter(path, cv2.VideoWriter.fourcc(*"MJPG"), 30, (WIDTH, HEIGHT))
            for _ in range(frames):
                writer.write(numpy.zeros((HEIGHT, WIDTH, 3), numpy.uint8))
            writer.release()
        monkeypatch.setattr(cv2, "VideoCapture", lambda device: opened(path))

    return show


def test_each_node_of_the_image_pipeline_signs_the_image(session, run, hear, film):
    film(60)
    run("intra_process_demo", "image_pipeline_with_two_image_view")
    image = CvBridge().imgmsg_to_cv2(hear(Image, "watermarked_image", qos_profile_sensor_data), "bgr8")
    signed = [int((image[row - 15 : row, :, 1] > 128).sum()) for row in (20, 40, 60)]
    assert image.shape == (HEIGHT, WIDTH, 3) and signed[0] > 100 and signed[1] > 100 and signed[2] == 0


def test_one_view_gets_the_camera_s_own_image_the_other_a_copy(session, run, film, monkeypatch):
    signatures = []
    monkeypatch.setattr(images, "_sign", lambda image, msg, row, more="": signatures.append((row, id(msg))))
    film(1)
    run("intra_process_demo", "image_pipeline_with_two_image_view")
    session.clock.sleep(0.3)
    assert [row for row, _ in signatures] == [20, 40, 60, 60]
    camera, watermark, *views = (address for _, address in signatures)
    assert camera == watermark and [view == camera for view in views] == [True, False]


def test_a_pipeline_of_processes_watermarks_what_cam2image_sees(session, run, hear):
    words = ("--ros-args", "-p", "burger_mode:=true", "-p", "frequency:=5.0")
    run("image_tools", "cam2image", *words)
    nodes = [run("intra_process_demo", name) for name in ("watermark_node", "image_view_node")]
    assert hear(Image, "watermarked_image", qos_profile_sensor_data).header.frame_id == "camera_frame"
    session.clock.sleep(0.5)
    for node in nodes:
        node.interrupt()
        assert node.wait(2) == 0


@pytest.mark.parametrize("name", ["camera_node", "image_pipeline_all_in_one"])
def test_without_a_camera_it_is_said_what_stands_in(run, film, name):
    film(0)
    process = run("intra_process_demo", name)
    assert process.wait(5) == -6
    assert "burger_mode:=true" in process.output and "Could not open video stream!" in process.output


def test_a_large_image_comes_through_and_its_latency_is_told(session, run):
    run("quality_of_service_demo_cpp", "message_lost_talker", "-s", "64")
    listeners = [run(f"quality_of_service_demo_{language}", "message_lost_listener") for language in ("cpp", "py")]
    session.clock.sleep(3.5)
    assert said(listeners[0]) == ["I heard an image. Message single trip latency: [0.000000]"]
    assert said(listeners[1]) == ["I heard an Image. Message single trip latency: [0]"]


def test_qos_can_be_overridden_by_parameters_and_too_deep_a_history_is_refused(session, run, ros2):
    rule = "qos_overrides./qos_overrides_chatter.publisher.{}"
    talker = run("quality_of_service_demo_py", "qos_overrides_talker", "--ros-args", "-p", rule.format("depth:=9"))
    listener = run("quality_of_service_demo_py", "qos_overrides_listener")
    session.clock.sleep(1.5)
    assert said(talker) == ['Publishing: "Hello World: 0"'] and said(listener) == ["I heard: [Hello World: 0]"]
    assert ros2("param", "get", "/qos_overrides_talker", rule.format("depth")) == "Integer value is: 9\n"
    refused = run("quality_of_service_demo_cpp", "qos_overrides_talker", "--ros-args", "-p", rule.format("depth:=11"))
    assert refused.wait(2) == -6 and "expected history depth less or equal than 10" in refused.output
    for package in ("cpp", "py"):
        run(f"quality_of_service_demo_{package}", "qos_overrides_listener", "--ros-args", "-r", "__node:=other")
    session.clock.sleep(0.1)
    assert "qos_overrides./qos_overrides_chatter.subscription.durability" in ros2("param", "list", "/other")


def test_points_are_told_in_another_turtles_frame_once_its_frames_are_known(session, run, ros2):
    from coursekit.cli.parser import run as run_cli

    words = ["launch", "turtle_tf2_py", "turtle_tf2_sensor_message.launch.py"]
    session.start(lambda: run_cli(words), name="ros2", argv=words)
    drawer = run("turtle_tf2_cpp", "turtle_tf2_message_filter")
    session.clock.sleep(5.0)
    told = [line for line in said(drawer) if line]
    assert told and all(line.startswith("Point of turtle3 in frame of turtle1: x:") for line in told)


def test_debug_of_a_container_s_loggers_shows_the_core_s_too(session, run, ros2):
    container = run("rclcpp_components", "component_container")
    ros2("component", "load", "/ComponentManager", "composition", "composition::Talker")
    ros2("component", "load", "/ComponentManager", "logging_demo", "logging_demo::LoggerConfig")
    assert "[rcl]: " not in container.output
    ros2("service", "call", "/config_logger", "logging_demo/srv/ConfigLogger", "{logger_name: '', level: DEBUG}")
    session.clock.sleep(1.2)
    assert "[rcl]: Calling timer\n" in container.output, container.output
