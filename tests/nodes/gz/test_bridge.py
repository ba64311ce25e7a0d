"""The bridge: which way messages go, when they go at all, and what it says of what it cannot bridge."""

import pytest
import rclpy
from geometry_msgs.msg import PoseArray, PoseStamped, TwistStamped
from rclpy.qos import DurabilityPolicy, QoSProfile
from ros_gz_interfaces.srv import ControlWorld
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Image
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from coursekit.nodes.gz.bridge_config import of_file, of_word
from coursekit.nodes.gz.bridge_types import carried_by
from coursekit.nodes.gz.transport import gz_domain

CHATTER = "/chatter@std_msgs/msg/String{}gz.msgs.StringMsg"


class Gazebo:
    """A node in Gazebo's own graph."""

    def __init__(self):
        self.context = rclpy.context.Context()
        self.context.init([], domain_id=gz_domain())
        self.node = rclpy.create_node("gazebo", context=self.context)
        self.executor = rclpy.executors.SingleThreadedExecutor(context=self.context)
        self.executor.add_node(self.node)

    def hear(self, kind, topic):
        heard = []
        self.node.create_subscription(kind, topic, heard.append, 10)
        return heard

    def spin(self):
        for _ in range(20):
            self.executor.spin_once(timeout_sec=0.0)


@pytest.fixture
def gazebo(session):
    return Gazebo()


@pytest.mark.parametrize(("sign", "in_ros", "in_gazebo"), [("[", 1, 0), ("]", 0, 1), ("@", 1, 1)])
def test_messages_go_the_way_that_the_sign_says_and_never_in_circles(run, friend, gazebo, sign, in_ros, in_gazebo):
    run("ros_gz_bridge", "parameter_bridge", CHATTER.format(sign))
    here, there = friend.hear(String, "/chatter"), gazebo.hear(String, "/chatter")
    friend.spin(0.5)
    gazebo.node.create_publisher(String, "/chatter", 10).publish(String(data="from gazebo"))
    friend.spin(0.5)
    assert [msg.data for msg in here] == ["from gazebo"] * in_ros
    here.clear()
    gazebo.spin()
    there.clear()
    friend.node.create_publisher(String, "/chatter", 10).publish(String(data="from ros"))
    friend.spin(0.5)
    gazebo.spin()
    assert [msg.data for msg in there] == ["from ros"] * in_gazebo
    assert [msg.data for msg in here] == ["from ros"], "only its own"


def test_a_lazy_bridge_listens_only_while_somebody_wants_it(run, friend, gazebo, tmp_path):
    file = tmp_path / "bridge.yaml"
    types = "ros_type_name: std_msgs/msg/String, gz_type_name: gz.msgs.StringMsg"
    file.write_text(f"- {{topic_name: chatter, {types}, lazy: true, direction: GZ_TO_ROS}}\n")
    node = run("ros_gz_bridge", "parameter_bridge", "--ros-args", "-p", f"config_file:={file}")
    friend.spin(2.0)
    assert gazebo.node.count_subscribers("/chatter") == 0 and "(Lazy 1)" in node.output
    friend.hear(String, "/chatter")
    friend.spin(2.0)
    assert gazebo.node.count_subscribers("/chatter") == 1


def test_types_that_are_no_pair_are_told_with_those_that_are(run, friend):
    words = "/a@std_msgs/msg/String@gz.msgs.Twist", "/b@nobody/msg/No@gz.msgs.Clock"
    node = run("ros_gz_bridge", "parameter_bridge", *words)
    friend.spin(1.0)
    assert "Failed to create a bridge for topic [/a]" in node.output
    assert "geometry_msgs/msg/Twist" in node.output and "rosgraph_msgs/msg/Clock" in node.output
    assert "Traceback" not in node.output and node.state == "running"


def test_words_that_are_no_bridge_end_with_the_usage(run):
    for words in (["/chatter"], ["@std_msgs/msg/String@gz.msgs.StringMsg"], ["/a@std_msgs/msg/String@"]):
        node = run("ros_gz_bridge", "parameter_bridge", *words)
        assert node.wait(5) == 255 and "parameter_bridge <topic@ROS2_type@gz_type>" in node.output


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("a: 1", "top level must be a YAML sequence"),
        ("", "file empty"),
        ("- [", "Could not parse config"),
        ("- 3", "entry must be a YAML map"),
        ("- {topic_name: a}", "both ros_type_name and gz_type_name must be set"),
        ("- {topic_name: a, gz_topic_name: b, ros_type_name: x, gz_type_name: y}", "mutually exclusive"),
        ("- {topic_name: a, ros_type_name: x, gz_type_name: y, direction: UP}", "invalid direction [UP]"),
        ("- {topic_name: a, ros_type_name: x, gz_type_name: y, publisher_queue: [1]}", "whole numbers"),
    ],
)
def test_a_file_with_faults_is_told_line_by_line(tmp_path, text, says):
    (tmp_path / "bridge.yaml").write_text(text)
    bridges, faults = of_file(str(tmp_path / "bridge.yaml"))
    assert not bridges and says in faults[0]


def test_a_file_names_one_topic_or_both(tmp_path):
    rows = ("topic_name: a", "ros_topic_name: a", "gz_topic_name: a", "ros_topic_name: a, gz_topic_name: b")
    (tmp_path / "b.yaml").write_text("".join(f"- {{{row}, ros_type_name: x, gz_type_name: y}}\n" for row in rows))
    bridges, faults = of_file(str(tmp_path / "b.yaml"))
    assert [(bridge.ros_topic, bridge.gz_topic) for bridge in bridges] == [("a", "a")] * 3 + [("a", "b")] and not faults


def test_words_of_all_forms():
    bridge = of_word("/ros@std_msgs/msg/String[gz.msgs.StringMsg@/gz")
    assert (bridge.ros_topic, bridge.gz_topic, bridge.direction) == ("/ros", "/gz", "GZ_TO_ROS")
    assert of_word("/world/w/control@ros_gz_interfaces/srv/ControlWorld").is_service
    assert carried_by("std_msgs/String", "gz.msgs.StringMsg") == "std_msgs/msg/String"


def test_poses_become_what_ros_asks_for(gz, run, friend, yard):
    gz("sim", "-r", yard())
    kinds = ("tf2_msgs/msg/TFMessage", "geometry_msgs/msg/PoseArray")
    words = [f"/world/yard/pose/info@{kind}[gz.msgs.Pose_V" for kind in kinds]
    run("ros_gz_bridge", "parameter_bridge", words[0], "--ros-args", "-r", "/world/yard/pose/info:=/tf_truth")
    run("ros_gz_bridge", "parameter_bridge", words[1], "--ros-args", "-r", "/world/yard/pose/info:=/poses")
    tf, poses = friend.hear(TFMessage, "/tf_truth"), friend.hear(PoseArray, "/poses")
    friend.spin(1.0)
    assert tf[-1].transforms[0].child_frame_id == "post"
    assert poses[-1].poses[0].position.x == pytest.approx(2.0)


def test_a_world_is_paused_and_let_go_on_by_a_service_from_ros(gz, run, friend, yard):
    gz("sim", "-r", yard())
    run("ros_gz_bridge", "parameter_bridge", "/world/yard/control@ros_gz_interfaces/srv/ControlWorld",
        "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock")  # fmt: skip
    friend.spin(0.5)
    request = ControlWorld.Request()
    request.world_control.pause = True
    assert friend.ask(ControlWorld, "/world/yard/control", world_control=request.world_control).success
    clock = friend.hear(Clock, "/clock")
    friend.spin(1.0)
    assert not clock
    request.world_control.pause = False
    assert friend.ask(ControlWorld, "/world/yard/control", world_control=request.world_control).success
    friend.spin(1.0)
    assert clock


def test_a_stamped_command_and_a_plain_pose_are_converted():
    from coursekit.nodes.gz.bridge_types import PAIRS, conversion

    for row in PAIRS.values():
        for kind in row[1:]:
            assert conversion(row[0], kind) is not None, (row[0], kind)
    converted = conversion("geometry_msgs/msg/TwistStamped", "geometry_msgs/msg/Twist")(TwistStamped())
    assert type(converted).__name__ == "Twist"
    assert type(conversion("geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/Pose")(PoseStamped())).__name__ == "Pose"


def test_the_quality_of_a_topic_in_ros_is_overridden_by_parameters(run, friend, gazebo):
    """As launch files do for /tf_static: who comes late still hears it."""
    words = "/tf_static@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V", "--ros-args"
    run("ros_gz_bridge", "parameter_bridge", *words, "-p", "qos_overrides./tf_static.publisher.durability:=transient_local")
    friend.spin(0.5)
    gazebo.node.create_publisher(TFMessage, "/tf_static", 10).publish(TFMessage())
    friend.spin(0.5)
    late = []
    latched = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    friend.node.create_subscription(TFMessage, "/tf_static", late.append, latched)
    friend.spin(0.5)
    assert late
    profile = friend.node.get_publishers_info_by_topic("/tf_static")[0].qos_profile
    assert profile.durability == DurabilityPolicy.TRANSIENT_LOCAL and profile.reliability.name == "RELIABLE"


def test_frames_and_times_are_overridden_on_the_way_into_ros_only(run, friend, gazebo):
    words = "/eye@sensor_msgs/msg/Image@gz.msgs.Image", "--ros-args", "-p", "override_frame_id:=eye_optical"
    run("ros_gz_bridge", "parameter_bridge", *words, "-p", "override_timestamps_with_wall_time:=true")
    here, there = friend.hear(Image, "/eye"), gazebo.hear(Image, "/eye")
    friend.spin(0.5)
    sent = Image()
    sent.header.frame_id = "cart/eye"
    gazebo.node.create_publisher(Image, "/eye", 10).publish(sent)
    friend.spin(0.5)
    assert here[0].header.frame_id == "eye_optical" and here[0].header.stamp.sec > 0
    gazebo.spin()
    there.clear()
    friend.node.create_publisher(Image, "/eye", 10).publish(sent)
    friend.spin(0.5)
    gazebo.spin()
    assert there[0].header == sent.header


def test_a_file_may_name_services(tmp_path):
    row = "- service_name: /world/w/control\n  ros_type_name: ros_gz_interfaces/srv/ControlWorld\n"
    (tmp_path / "b.yaml").write_text(row + "  gz_req_type_name: gz.msgs.WorldControl\n  gz_rep_type_name: gz.msgs.Boolean\n")
    (bridge,), faults = of_file(str(tmp_path / "b.yaml"))
    assert (bridge.ros_topic, bridge.is_service, faults) == ("/world/w/control", True, [])
    (tmp_path / "b.yaml").write_text("- service_name: /x\n  ros_type_name: std_msgs/msg/String\n")
    assert of_file(str(tmp_path / "b.yaml"))[1] == ["Could not parse entry: service_name needs a ros_type_name with /srv/"]
