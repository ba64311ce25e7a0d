"""tf2's programs and the turtles that use it, on the virtual clock."""

import math

import pytest
import rclpy
from geometry_msgs.msg import TransformStamped

from coursekit.nodes.tf2.static_publisher import BadArguments, parse


def circling():
    from tf2_ros import TransformBroadcaster

    rclpy.init()
    node = rclpy.create_node("circling")
    broadcaster = TransformBroadcaster(node)

    def step():
        msg = TransformStamped(child_frame_id="base_link")
        now = node.get_clock().now()
        msg.header.stamp, msg.header.frame_id = now.to_msg(), "odom"
        angle = now.nanoseconds * 1e-9 % 100
        msg.transform.translation.x = math.cos(angle)
        msg.transform.rotation.z, msg.transform.rotation.w = math.sin(angle / 2), math.cos(angle / 2)
        broadcaster.sendTransform(msg)

    node.create_timer(0.1, step)
    rclpy.spin(node)


NEW = ("--x", "0.1", "--yaw", "1.5707963267948966", "--frame-id", "base_link", "--child-frame-id", "laser")


def test_a_static_transform_stays_for_late_listeners(run, session):
    publisher = run("tf2_ros", "static_transform_publisher", *NEW)
    session.clock.sleep(5.0)
    echo = run("tf2_ros", "tf2_echo", "base_link", "laser")
    session.clock.sleep(1.5)
    assert echo.output.splitlines()[-10:-1] == [
        "At time 0.0",
        "- Translation: [0.100, 0.000, 0.000]",
        "- Rotation: in Quaternion [0.000, 0.000, 0.707, 0.707]",
        "- Rotation: in RPY (radian) [0.000, -0.000, 1.571]",
        "- Rotation: in RPY (degree) [0.000, -0.000, 90.000]",
        "- Matrix:",
        "  0.000 -1.000  0.000  0.100",
        "  1.000  0.000  0.000  0.000",
        "  0.000  0.000  1.000  0.000",
    ]
    assert "from 'base_link' to 'laser'" in publisher.output
    publisher.interrupt()
    assert publisher.wait(2.0) == 0


def test_old_arguments_still_work_with_a_warning(run, session):
    publisher = run("tf2_ros", "static_transform_publisher", "1", "2", "3", "0", "0", "0", "map", "odom")
    session.clock.sleep(0.5)
    assert "Old-style arguments are deprecated; see --help for new-style arguments" in publisher.output
    assert "translation: ('1.000000', '2.000000', '3.000000')" in publisher.output


@pytest.mark.parametrize(
    ("words", "text"),
    [
        ([], "Frame id must not be empty"),
        (["--frame-id", "a"], "Child frame id must not be empty"),
        (["--x"], "Not enough arguments for --x"),
        (["--x", "far"], "Failed to parse --x argument as float"),
        (["--qw", "1", "--yaw", "1"], "Cannot specify both quaternion and Euler rotations"),
        (["1", "2"], "Extra unparsed arguments on command-line"),
        ([*"12345678", "--x", "1"], "Cannot specify both new-style (flags) and old-style (arguments)"),
    ],
)
def test_wrong_arguments_are_named(words, text):
    with pytest.raises(BadArguments) as caught:
        parse(words)
    assert str(caught.value) == text


def test_wrong_arguments_end_the_program(run):
    process = run("tf2_ros", "static_transform_publisher", "--x", "1")
    assert process.wait(2.0) == 1
    assert "error parsing command line arguments: Frame id must not be empty" in process.output
    assert "usage: static_transform_publisher" in process.output


def test_a_frame_cannot_be_its_own_parent(run):
    process = run("tf2_ros", "static_transform_publisher", "--frame-id", "a", "--child-frame-id", "a")
    assert process.wait(2.0) == -6
    assert "[ERROR]" in process.output
    assert "cannot publish static transform from 'a' to 'a', exiting" in process.output
    assert "what():  child_frame_id cannot equal frame_id" in process.output
    assert "Traceback" not in process.output


def test_tf2_echo_says_what_it_waits_for(run, session):
    echo = run("tf2_ros", "tf2_echo", "map", "robot")
    session.clock.sleep(0.5)
    assert (
        'Waiting for transform map ->  robot: Invalid frame ID "map" passed to canTransform argument target_frame - '
        "frame does not exist" in echo.output
    )


def test_tf2_echo_without_frames_tells_its_usage(run):
    process = run("tf2_ros", "tf2_echo", "map")
    assert process.wait(2.0) == 255 and "Usage: tf2_echo source_frame target_frame [echo_rate]" in process.output


def test_tf2_monitor_tells_delay_and_rate(run, session):
    session.start(circling, name="circling")
    run("tf2_ros", "static_transform_publisher", *NEW)
    monitor = run("tf2_ros", "tf2_monitor", "odom", "laser")
    session.clock.sleep(13.0)
    assert "Waiting for transform chain to become available between odom and laser ." in monitor.output
    assert "RESULTS: for odom to laser\nChain is: odom -> base_link -> laser\nNet delay     avg = " in monitor.output
    assert "Frame: base_link, published by <no authority available>, Average Delay: " in monitor.output
    assert "Node: <no authority available> 10." in monitor.output


def test_view_frames_writes_pdf_and_gv(session, tmp_path):
    from coursekit.processes.executables import find

    session.start(circling, name="circling")
    path = find("tf2_tools", "view_frames")
    viewer = session.start_executable(path, name="view_frames", cwd=tmp_path)
    assert viewer.wait(10.0) == 0
    names = sorted(file.name for file in tmp_path.iterdir())
    assert [name[:7] + name[26:] for name in names] == ["frames_.gv", "frames_.pdf"]
    assert '"odom" -> "base_link"[label=" Broadcaster: default_authority' in (tmp_path / names[0]).read_text()
    assert (tmp_path / names[1]).read_bytes().startswith(b"%PDF")
    assert "Listening to tf data for 5.0 seconds..." in viewer.output


def test_a_buffer_server_answers_clients(run, session):
    answers = []

    def ask():
        from threading import Thread

        from rclpy.duration import Duration
        from rclpy.time import Time
        from tf2_ros import BufferClient, LookupException

        rclpy.init()
        node = rclpy.create_node("asker")
        Thread(target=rclpy.spin, args=(node,), daemon=True).start()
        client = BufferClient(node, "tf2_buffer_server")
        assert client.action_client.wait_for_server(5.0)
        transform = client.lookup_transform("base_link", "laser", Time(), Duration(seconds=2.0))
        answers.append(transform.transform.translation.x)
        answers.append(client.can_transform("base_link", "laser", Time()))
        tight = BufferClient(node, "tf2_buffer_server", timeout_padding=0.0)
        try:
            tight.lookup_transform("base_link", "nowhere", Time(), Duration(seconds=0.5))
        except LookupException as error:
            answers.append(str(error))
        full = client.lookup_transform_full("laser", Time(), "base_link", Time(), "laser")
        answers.append(round(full.transform.translation.y, 6))
        rclpy.shutdown()

    run("tf2_ros", "buffer_server")
    asker = session.start(ask, name="asker")
    session.clock.sleep(0.5)
    run("tf2_ros", "static_transform_publisher", *NEW)
    assert asker.wait(20.0) == 0, asker.output
    assert answers == [0.1, True, '"nowhere" passed to lookupTransform argument source_frame does not exist. ', 0.1]


def test_turtle2_follows_turtle1(ros2, session):
    from coursekit.cli.parser import run as run_cli

    session.start(lambda: run_cli(["launch", "turtle_tf2_py", "turtle_tf2_demo.launch.py"]), name="ros2")
    session.clock.sleep(20.0)
    one = ros2("topic", "echo", "/turtle1/pose", "--once")
    two = ros2("topic", "echo", "/turtle2/pose", "--once")
    place = [[float(line.split(":")[1]) for line in text.splitlines()[:2]] for text in (one, two)]
    assert math.dist(*place) < 0.2


def test_a_static_turtle_takes_seven_words(run, session):
    process = run("turtle_tf2_py", "static_turtle_tf2_broadcaster", "mystaticturtle", *"001000")
    echo = run("tf2_ros", "tf2_echo", "world", "mystaticturtle")
    session.clock.sleep(1.5)
    assert "- Translation: [0.000, 0.000, 1.000]" in echo.output
    process.interrupt()
    assert run("turtle_tf2_py", "static_turtle_tf2_broadcaster", "world").wait(1.0) == 1


def test_points_with_time_and_frame_are_taken_into_another_turtles_frame(ros2, session):
    from coursekit.cli.parser import run as run_cli

    session.start(lambda: run_cli(["launch", "turtle_tf2_py", "turtle_tf2_sensor_message.launch.py"]), name="ros2")
    session.clock.sleep(5.0)
    point = ros2("topic", "echo", "/turtle3/turtle_point_stamped", "--once")
    assert "frame_id: world" in point
    echoed = ros2("topic", "echo", "/turtle3/pose", "--once").splitlines()
    session.clock.sleep(1.0)
    assert ros2("topic", "echo", "/turtle3/pose", "--once").splitlines()[:2] != echoed[:2], "it goes round"
