"""rqt's windows: nodes whose window a notebook shows, and plots of what is published."""

import pytest
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Float64
from turtlesim.msg import Pose

from coursekit.nodes.rqt.curves import Curves, numbers, part, paths
from coursekit.nodes.rqt.plot import Plot
from coursekit.nodes.rqt.rqt import INSTEAD
from coursekit.nodes.rqt.windows import windows
from coursekit.view import highgui
from coursekit.view.graph_facts import take


@pytest.fixture
def seen():
    """What a notebook hears: (kind, whether it runs)."""
    heard = []
    listener = lambda window: heard.append((window.kind, window.running)) or True  # noqa: E731
    windows.watch(listener)
    yield heard
    windows.unwatch(listener)


@pytest.mark.parametrize("kind", list(INSTEAD))
def test_a_notebook_hears_of_a_window_s_start_and_end(kind, seen, run, session):
    window = run(kind, kind)
    session.clock.sleep(0.5)
    names = [node.name for node in session.graph(0).nodes]
    assert seen == [(kind, True)] and [name for name in names if name.startswith("rqt_gui_py_node_")]
    window.interrupt()
    assert window.wait(2.0) == 0 and seen == [(kind, True), (kind, False)]


@pytest.mark.parametrize("kind", INSTEAD)
def test_without_a_notebook_the_commands_are_named(kind, run):
    window = run(kind, kind)
    assert window.wait(2.0) == 1 and f"No notebook shows this window. Here: {INSTEAD[kind]}." in window.output


def test_robot_steering_takes_its_topic_and_speeds(run, session):
    heard = []
    listener = lambda window: heard.append(window) or True  # noqa: E731
    windows.watch(listener)
    run("rqt_robot_steering", "rqt_robot_steering", "--ros-args", "-p", "default_topic:=/go", "-p", "default_vx_max:=2.2")
    session.clock.sleep(0.5)
    windows.unwatch(listener)
    assert (heard[0].topic, heard[0].speeds) == ("/go", (2.2, 3.0))


def test_the_graph_shows_rqt_s_own_nodes_only_when_asked(run, session):
    run("demo_nodes_py", "talker")
    watching = lambda window: True  # noqa: E731
    windows.watch(watching)
    run("rqt_graph", "rqt_graph")
    session.clock.sleep(0.5)
    windows.unwatch(watching)
    assert take(session.graph(0)).nodes == ("/talker",)
    assert len(take(session.graph(0), debug=True).nodes) == 2


@pytest.fixture
def sources(session):
    """A node that publishes a number and a pose ten times a second."""
    rclpy.init()
    node = Node("sources")
    speed, pose = node.create_publisher(Float64, "/speed", 10), node.create_publisher(Pose, "/turtle1/pose", 10)
    count = iter(range(10_000))

    def publish():
        at = float(next(count))
        speed.publish(Float64(data=at))
        pose.publish(Pose(x=at, y=2 * at))

    node.create_timer(0.1, publish)
    session.spawn(rclpy.spin, node)
    yield node
    rclpy.shutdown()


def test_numbers_of_topics_are_kept_by_their_paths(session, sources):
    plot = Plot(Curves(["/speed/data", "/turtle1/pose/x", "turtle1/pose/y", "/turtle1/pose/nothing", "/not/there"]))
    session.spawn(rclpy.spin, plot, None)
    session.clock.sleep(3.0)
    assert set(plot.curves.curves) == {"/speed/data", "/turtle1/pose/x", "/turtle1/pose/y"}
    for (when, x), (_, y) in zip(*(plot.curves.curves[f"/turtle1/pose/{axis}"].newer(0) for axis in "xy"), strict=False):
        assert y == 2 * x and 0 <= when <= 3.5
    plot.destroy_node()


def test_a_window_shows_them_until_the_end(session, sources, run):
    window = run("rqt_plot", "rqt_plot", "/turtle1/pose")
    session.clock.sleep(1.0)
    ((title, picture),) = highgui.desk().windows.items()
    before = picture.image
    session.clock.sleep(2.0)
    after = highgui.desk().windows[title].image
    assert title == f"rqt_plot_{window.pid}"
    assert before.shape == after.shape == (360, 720, 3) and (before != after).any()
    window.interrupt()
    assert window.wait(2.0) == 0 and not highgui.desk().windows


def test_without_a_path_it_says_how(run, session):
    window = run("rqt_plot", "rqt_plot")
    assert window.wait(2.0) == 1 and "rqt_plot /turtle1/pose/x:y" in window.output


def test_paths_and_parts():
    assert paths(["/a/b/x:y;", ";", "c/d"]) == ["/a/b/x", "/a/b/y", "/c/d"]
    pose = Pose(x=1.0)
    assert dict(numbers(pose, "/p")) == {f"/p/{field}": float(field == "x") for field in pose.get_fields_and_field_types()}
    assert part(pose, "x") == 1.0 and part(pose, "z/z") is None and part(pose, "") is pose
    state = JointState(position=[4.0, 5.0])
    assert part(state, "position[1]") == 5.0 and part(state, "position[7]") is None and part(state, "position[x]") is None
