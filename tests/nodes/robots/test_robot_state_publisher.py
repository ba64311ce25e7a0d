"""robot_state_publisher as others see it."""

import math

import pytest
import rclpy
from rcl_interfaces.srv import SetParameters
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

from coursekit.geometry.pose import compose
from coursekit.urdf import load
from coursekit.urdf.kinematics import Kinematics
from tests.nodes.friend import Friend
from tests.urdf.oracle import ROBOTS

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
ROBOT = (ROBOTS / "robot.urdf").read_text()
FOLLOWING = """<robot name="pair"><link name="a"/><link name="b"/><link name="c"/>
<joint name="lead" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="follow" type="continuous"><parent link="a"/><child link="c"/><axis xyz="0 0 1"/>
<mimic joint="lead" multiplier="2" offset="0.1"/></joint></robot>"""


class Joints(Friend):
    """Hears frames and says joint states."""

    def __init__(self, session):
        super().__init__(session)
        self.tf, self.static, self.described = [], [], []
        self.node.create_subscription(TFMessage, "/tf", self.tf.append, 100)
        self.node.create_subscription(TFMessage, "/tf_static", self.static.append, LATCHED)
        self.node.create_subscription(String, "robot_description", self.described.append, LATCHED)
        self.joints = self.node.create_publisher(JointState, "joint_states", 10)

    def say(self, wait=0.02, **positions):
        msg = JointState(name=list(positions), position=[float(value) for value in positions.values()])
        msg.header.stamp = self.node.get_clock().now().to_msg()
        self.joints.publish(msg)
        self.spin(wait)

    def set(self, name, value):
        parameters = [Parameter(name, value=value).to_parameter_msg()]
        return self.ask(SetParameters, "robot_state_publisher/set_parameters", parameters=parameters).results[0]


@pytest.fixture
def friend(session):
    new_friend = Joints(session)
    yield new_friend
    rclpy.shutdown(context=new_friend.context)


@pytest.fixture
def publish(run, tmp_path):
    """publish(text, name=value, ...) starts the node with these parameters."""

    def start(text, **parameters):
        path = tmp_path / "parameters.yaml"
        lines = "".join(f"    {name}: {value}\n" for name, value in parameters.items())
        body = "".join(f"      {line}\n" for line in text.splitlines())
        path.write_text(f"/**:\n  ros__parameters:\n{lines}    robot_description: |\n{body}")
        return run("robot_state_publisher", "robot_state_publisher", "--ros-args", "--params-file", str(path))

    return start


def frames(messages):
    return {transform.child_frame_id: transform for message in messages for transform in message.transforms}


def test_it_says_what_the_real_one_says(session, publish):
    node = publish(ROBOT)
    session.clock.sleep(0.5)
    names = sorted(load(ROBOTS / "robot.urdf").links)
    assert [line.split("] ", 2)[2] for line in node.output.splitlines()] == [
        f"[robot_state_publisher]: got segment {name}" for name in names
    ]
    node.interrupt()
    assert node.wait(5) == 0


def test_fixed_joints_are_static_and_stay_for_late_comers(session, publish, friend):
    publish(ROBOT)
    friend.spin(1.0)
    late = Joints(session)
    late.spin()
    for listener in (friend, late):
        assert sorted(frames(listener.static)) == ["base_link", "head_link"]
        assert frames(listener.static)["base_link"].transform.translation.z == 0.1
        assert listener.described[0].data.startswith("<?xml")
    assert friend.tf == []
    rclpy.shutdown(context=late.context)


def test_moving_joints_are_where_the_kinematics_has_them(publish, friend):
    publish(ROBOT)
    friend.spin()
    friend.say(left_wheel_joint=0.5, right_wheel_joint=-1.0)
    poses = Kinematics(load(ROBOTS / "robot.urdf")).poses({"left_wheel_joint": 0.5, "right_wheel_joint": -1.0})
    assert [transform.child_frame_id for transform in friend.tf[0].transforms] == ["left_wheel_link", "right_wheel_link"]
    for transform in friend.tf[0].transforms:
        t, r = transform.transform.translation, transform.transform.rotation
        composed = compose(poses[transform.header.frame_id], (t.x, t.y, t.z, r.x, r.y, r.z, r.w))
        assert composed == pytest.approx(poses[transform.child_frame_id], abs=1e-12)


def test_a_follower_follows_unless_it_is_told(publish, friend):
    publish(FOLLOWING)
    friend.spin()
    friend.say(lead=0.5)
    assert frames(friend.tf)["c"].transform.rotation.z == pytest.approx(math.sin(1.1 / 2))
    friend.spin(0.1)
    friend.say(lead=0.5, follow=0.0)
    assert frames(friend.tf)["c"].transform.rotation.z == 0.0


@pytest.mark.parametrize(("parameters", "least", "most"), [({}, 18, 22), ({"publish_frequency": 5.0}, 4, 6)])
def test_frames_come_no_more_often_than_asked(publish, friend, parameters, least, most):
    publish(ROBOT, **parameters)
    friend.spin()
    for _ in range(100):
        friend.say(0.01, left_wheel_joint=0.5)
    assert least <= len(friend.tf) <= most


def test_old_stamps_are_ignored_unless_asked_not_to_be(publish, friend):
    publish(ROBOT)
    friend.spin()
    friend.say(left_wheel_joint=0.5)
    old = JointState(name=["left_wheel_joint"], position=[1.0])
    old.header.stamp.sec = 1
    friend.joints.publish(old)
    friend.spin()
    assert len(friend.tf) == 1
    assert friend.set("ignore_timestamp", True).successful
    friend.joints.publish(old)
    friend.spin()
    assert len(friend.tf) == 2 and friend.tf[1].transforms[0].header.stamp.sec == 1


def test_the_prefix_is_before_every_frame(publish, friend):
    publish(ROBOT, frame_prefix="robot1/")
    friend.spin()
    friend.say(left_wheel_joint=0.5)
    transform_by_frame = frames(friend.static + friend.tf)
    assert sorted(transform_by_frame) == ["robot1/base_link", "robot1/head_link", "robot1/left_wheel_link"]
    assert all(transform.header.frame_id.startswith("robot1/") for transform in transform_by_frame.values())


def test_without_static_frames_fixed_joints_are_repeated(publish, friend):
    publish(ROBOT, use_tf_static="false")
    friend.spin(1.0)
    assert friend.static == []
    assert len(friend.tf) >= 19 and "base_link" in frames(friend.tf)


def test_a_new_description_takes_its_place(publish, friend):
    publish(ROBOT)
    friend.spin()
    assert friend.set("robot_description", FOLLOWING).successful
    friend.spin()
    assert friend.described[-1].data == FOLLOWING
    friend.say(lead=0.5)
    assert sorted(frames(friend.tf)) == ["b", "c"]


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("robot_description", "<robot/>", "Failed to parse new URDF"),
        ("robot_description", "", "Empty URDF is not allowed"),
        ("publish_frequency", 2000.0, "publish_frequency must be between 0 and 1000"),
    ],
)
def test_a_bad_value_is_refused_with_its_reason(publish, friend, name, value, reason):
    node = publish(ROBOT)
    friend.spin()
    result = friend.set(name, value)
    assert not result.successful and reason in result.reason
    friend.say(left_wheel_joint=0.5)
    assert node.exit_code is None and friend.tf


def test_joint_states_without_positions_are_ignored(publish, friend):
    node = publish(ROBOT)
    friend.spin()
    friend.joints.publish(JointState(name=["left_wheel_joint"]))
    friend.joints.publish(JointState(name=["left_wheel_joint"], position=[1.0, 2.0]))
    friend.spin()
    assert friend.tf == []
    assert "position member was empty" in node.output
    assert "ignored an invalid JointState message" in node.output


@pytest.mark.parametrize("name", ["rdk_x3_robot.urdf", "r2d2.urdf.xacro"])
def test_a_file_can_be_named_instead(session, run, friend, name):
    node = run("robot_state_publisher", "robot_state_publisher", str(ROBOTS / name))
    friend.spin(0.5)
    assert "Assuming argument is name of URDF file" in node.output
    assert "base_link" in frames(friend.static)


def test_a_bad_description_ends_it_as_it_ends_the_real_one(session, publish):
    node = publish('<robot name="r"><link name="a"/><link name="b"/></robot>')
    assert node.wait(5) == -6
    assert node.output.splitlines() == [
        "Error:   Failed to find root link: Two root links found: [a] and [b]",
        '         at robot_description:1 in <link name="b">',
        '         All links but one are the child of a joint: add a joint with <child link="b"/>.',
        "Failed to parse robot description using: urdf_xml_parser/URDFXMLParser",
        "terminate called after throwing an instance of 'std::runtime_error'",
        "  what():  Unable to initialize urdf::model from robot description",
    ]


def test_without_a_description_it_ends(run):
    node = run("robot_state_publisher", "robot_state_publisher")
    assert node.wait(5) == -6
    assert "robot_description parameter must not be empty" in node.output
