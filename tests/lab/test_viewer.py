"""The viewer without a browser: what it shows, what it says, what it would send."""

import math
from xml.sax.saxutils import quoteattr

import pytest
from builtin_interfaces.msg import Time
from geometry_msgs.msg import PointStamped, PoseStamped, PoseWithCovarianceStamped
from nav_msgs.msg import Path
from rclpy.qos import DurabilityPolicy, QoSProfile
from rosgraph_msgs.msg import Clock as ClockMessage
from sensor_msgs.msg import LaserScan
from std_msgs.msg import Header

from coursekit.lab.panel import end_panels
from coursekit.lab.viewer import viewer
from coursekit.processes.executables import find
from coursekit.processes.session import Session
from tests.lab.viewer_stage import frame, said, shapes
from tests.urdf.oracle import ROBOTS


def robot(session, name="rdk_x3_robot", *more):
    file = str(ROBOTS / f"{name}.urdf")
    for package, arguments in (("robot_state_publisher", [file, *more]), ("joint_state_publisher", more)):
        session.start_executable(find(package, package), list(arguments), name=package)
    session.clock.sleep(0.5)


def test_bare_it_shows_the_robot_and_its_frames_and_says_the_same_every_time():
    texts = []
    for _ in range(2):
        with Session(virtual=True).use() as session:
            robot(session)
            texts.append(viewer().text())
            end_panels()
    assert texts[0] == texts[1]
    lines = texts[0].splitlines()
    assert lines[0] == "viewer: fixed frame base_footprint (guessed)"
    assert lines[2].startswith("[x] RobotModel /robot_description  Ok") and "13 of 13 links placed" in lines[2]
    assert lines[3].endswith("13 frames")


def test_a_robot_of_one_link_stands_without_frames(session):
    robot(session, "sphere")
    lines = viewer().text().splitlines()
    assert lines[0] == "viewer: fixed frame base_link (guessed)"
    assert lines[3].endswith("sphere_robot: 1 of 1 links placed")


def test_the_notebook_gets_a_widget_a_picture_and_a_text(session):
    panel = viewer(displays=["Grid"])
    bundle = panel._repr_mimebundle_()
    data = bundle[0] if isinstance(bundle, tuple) else bundle
    assert {"application/vnd.jupyter.widget-view+json", "image/png", "text/plain"} <= set(data)
    assert panel.png() == panel.png()


def test_a_missing_frame_is_named_with_what_there_is(session, talker):
    robot(session)
    panel = viewer(fixed_frame="base_lnk", displays=["RobotModel"])
    assert "frame [base_lnk] does not exist. There are: base_footprint" in panel.text().splitlines()[1]
    assert "Did you mean [base_link]?" in panel.status("RobotModel")
    panel.fixed_frame = "base_link"
    session.clock.sleep(0.5)
    assert panel.status("RobotModel").startswith("Ok")


def test_two_trees_are_told_apart(session, talker):
    frame(talker, "map", "a")
    frame(talker, "moon", "b")
    said(talker, LaserScan, "/scan", "b")
    panel = viewer(fixed_frame="map", displays=["LaserScan", "TF"])
    said(talker, LaserScan, "/scan", "b")
    session.clock.sleep(0.1)
    assert "two trees, under [moon] and [map]" in panel.status("LaserScan")
    assert "No transform from [b], [moon] to [map]" in panel.status("TF")


def test_of_messages_that_cannot_be_placed_the_newest_is_explained(session, talker):
    frame(talker, "map", "a")
    panel = viewer(fixed_frame="map", displays=["LaserScan"])
    for name in ("", "moon"):
        said(talker, LaserScan, "/scan", name)
        session.clock.sleep(0.1)
        panel.status("LaserScan")
    assert "frame [moon] does not exist" in panel.status("LaserScan")


def test_a_topic_without_messages_says_why(session, talker):
    talker.create_publisher(LaserScan, "/front", 1)
    talker.create_publisher(Path, "/strange", 1)
    panel = viewer(displays=["LaserScan /scan", {"type": "LaserScan", "topic": "/strange", "name": "other"}])
    assert "Nobody publishes /scan. There is: /front" in panel.status("LaserScan")
    assert "/strange has the type nav_msgs/msg/Path, not sensor_msgs/msg/LaserScan" in panel.status("other")


def test_a_message_that_came_before_is_there_for_a_display_that_asks_for_it(session, talker):
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(Path, "/plan", lasting).publish(Path(header=Header(frame_id="map")))
    panel = viewer(fixed_frame="map", displays=["Path /plan"])
    said = panel.status("Path")
    assert "talker keeps its last message on /plan" in said and "set the Durability Policy to Transient Local" in said
    panel.change("Path", durability="Transient Local")
    session.clock.sleep(0.1)
    assert panel.status("Path").startswith("Ok")


def test_robots_are_shown_by_namespace(session):
    for number in (1, 2):
        robot(session, "rdk_x3_robot", "--ros-args", "-r", f"__ns:=/r{number}", "-p", f"frame_prefix:=r{number}/")
    panel = viewer()
    assert panel.displays == ["Grid", "r1", "r2", "TF"]
    for name in ("r1", "r2"):
        links = panel.stage.find(name)
        panel.stage.update()
        assert links.prefix(panel.stage) == f"{name}/"
    assert panel.status("r1").startswith("Ok")
    assert "another tree" in panel.status("TF")


def test_switching_off_empties_and_on_shows_again(session):
    robot(session)
    panel = viewer(displays=["RobotModel", "TF"])
    assert shapes(panel, "RobotModel")
    panel.switch("RobotModel", False)
    assert not shapes(panel, "RobotModel") and "[ ] RobotModel /robot_description  Off" in panel.text()
    panel.switch("RobotModel", True)
    session.clock.sleep(0.1)
    assert shapes(panel, "RobotModel")


def test_the_tools_publish_in_the_fixed_frame(session, talker):
    heard = []
    kinds = ((PoseStamped, "/goal_pose"), (PoseWithCovarianceStamped, "/initialpose"), (PointStamped, "/clicked_point"))
    for kind, topic in kinds:
        talker.create_subscription(kind, topic, heard.append, 1)
    panel = viewer(fixed_frame="map", displays=["Grid"])
    panel._hear(panel, {"type": "tool", "tool": "goal", "x": 1.0, "y": 2.0, "yaw": math.pi}, [])
    panel.pose_estimate(1, 2, math.pi / 2)
    panel.publish_point(1, 2)
    panel._hear(panel, {"type": "tool", "tool": "goal", "x": "far", "y": 2.0}, [])
    session.clock.sleep(0.1)
    goal, estimate, point = heard
    assert goal.header.frame_id == "map" and goal.pose.orientation.z == pytest.approx(1.0)
    assert estimate.pose.covariance[0] == 0.25 and estimate.pose.covariance[35] == pytest.approx(0.0685389)
    assert (point.point.x, point.point.y) == (1.0, 2.0)


def test_a_goal_is_of_the_simulation_s_time_while_there_is_one(session, talker):
    goals = []
    talker.create_subscription(PoseStamped, "/goal_pose", goals.append, 1)
    panel = viewer(fixed_frame="map", displays=["Grid"])
    clock = talker.create_publisher(ClockMessage, "/clock", 10)
    for step in range(30):
        clock.publish(ClockMessage(clock=Time(sec=7, nanosec=step)))
        session.clock.sleep(0.1)
    panel.goal_pose(1, 2)
    talker.destroy_publisher(clock)
    session.clock.sleep(1.5)
    panel.goal_pose(1, 2)
    session.clock.sleep(0.1)
    simulated, real = (goal.header.stamp.sec for goal in goals)
    assert simulated == 7 and real == session.clock.now() // 1_000_000_000


def test_the_browser_gets_batches_and_nothing_while_it_draws(session, monkeypatch):
    robot(session)
    panel = viewer(displays=["RobotModel", "TF"])
    sent = []
    monkeypatch.setattr(panel, "send", lambda message, buffers=None: sent.append(message))
    session.clock.sleep(1.0)
    assert not sent, "no page, no messages"
    panel._hear(panel, {"type": "open"}, [])
    session.clock.sleep(1.0)
    scenes = [message for message in sent if message["type"] == "scene"]
    assert len(scenes) == 1 and scenes[0]["whole"] and scenes[0]["view"]
    panel.stage.fix("laser_link")
    session.clock.sleep(1.0)
    assert len([message for message in sent if message["type"] == "scene"]) == 1, "the page has not drawn the first"
    panel._hear(panel, {"type": "drawn", "n": 1}, [])
    session.clock.sleep(1.0)
    assert len([message for message in sent if message["type"] == "scene"]) == 2
    panel._hear(panel, {"type": "open"}, [])
    session.clock.sleep(0.1)
    assert sent[-1]["whole"] or sent[-2]["whole"], "a page that was loaded again gets all"


def test_it_is_saved_and_read_again(session, tmp_path):
    panel = viewer(fixed_frame="odom", displays=["Grid", "LaserScan /front"])
    panel.switch("Grid", False)
    panel.save(tmp_path / "mine.yaml")
    assert viewer(tmp_path / "mine.yaml").text() == panel.text()


def test_a_bad_description_is_told(session, talker):
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(String, "/robot_description", lasting).publish(String(data="<robot name='x'>"))
    assert viewer(displays=["RobotModel"]).status("RobotModel").startswith("Error: URDF:")


def test_a_mesh_without_its_texture_is_drawn_plain_and_told_in_one_line(session, talker, tmp_path):
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    from tests.urdf.test_mesh_files import DAE, PLAIN

    (tmp_path / "crate.dae").write_text(DAE.format(texture="../materials/textures/none.png", emission=PLAIN))
    crate = quoteattr(f"file://{tmp_path}/crate.dae")
    geometry = f"<geometry><mesh filename={crate}/></geometry>"
    text = f"<robot name='x'><link name='base'><visual>{geometry}</visual></link></robot>"
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(String, "/robot_description", lasting).publish(String(data=text))
    frame(talker, "map", "base")
    panel = viewer(fixed_frame="map", displays=["RobotModel"])
    status = panel.status("RobotModel")
    assert "texture '../materials/textures/none.png' is not found" in status and status.startswith("Warn")
    assert shapes(panel, "RobotModel")


def test_a_missing_mesh_of_visuals_that_are_not_shown_is_no_fault(session, talker):
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from std_msgs.msg import String

    lost, ball = "<geometry><mesh filename='file:///lost.stl'/></geometry>", "<geometry><sphere radius='1'/></geometry>"
    text = f"<robot name='x'><link name='base'><visual>{lost}</visual><collision>{ball}</collision></link></robot>"
    lasting = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    talker.create_publisher(String, "/robot_description", lasting).publish(String(data=text))
    frame(talker, "map", "base")
    panel = viewer(fixed_frame="map", displays=["RobotModel"])
    panel.stage.change(panel.stage.find("RobotModel"), {"visual_enabled": False, "collision_enabled": True})
    assert panel.status("RobotModel").startswith("Ok")


def test_a_topic_that_cannot_be_is_told_and_may_be_mended(session, talker):
    panel = viewer(fixed_frame="map", displays=["LaserScan /front scan"])
    panel._hear(panel, {"type": "topic", "row": "1", "topic": "/front-scan"}, [])
    assert "Error subscribing: Invalid topic name" in panel.status("LaserScan")
    panel._hear(panel, {"type": "topic", "row": "1", "topic": "/front"}, [])
    said(talker, LaserScan, "/front", ranges=[1.0], range_max=5.0)
    session.clock.sleep(0.1)
    assert panel.status("LaserScan").startswith("Ok")
