"""joint_state_publisher as others see it."""

import math

import pytest
import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from coursekit.nodes.robots.joint_model import Options, followers, read
from coursekit.urdf import UrdfError
from tests.urdf.oracle import ROBOTS

LIMIT = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'


def arm(*joints):
    """A robot with joints one after the other: (name, type, inner)."""
    text = '<robot name="arm"><link name="l0"/>'
    for number, (name, type_, inner) in enumerate(joints, 1):
        text += (
            f'<link name="l{number}"/><joint name="{name}" type="{type_}"><parent link="l{number - 1}"/>'
            f'<child link="l{number}"/><axis xyz="0 0 1"/>{inner}</joint>'
        )
    return text + "</robot>"


PAIR = arm(("lead", "continuous", ""), ("follow", "continuous", '<mimic joint="lead" multiplier="2" offset="0.5"/>'))


@pytest.fixture
def heard(session):
    """All joint states that were published."""
    context = rclpy.context.Context()
    rclpy.init(context=context)
    node = rclpy.create_node("friend", context=context)
    messages = []
    node.create_subscription(JointState, "joint_states", messages.append, 10)
    messages_node = node
    executor = rclpy.executors.SingleThreadedExecutor(context=context)
    executor.add_node(node)

    def listen(seconds=1.0):
        until = session.clock.steady() + round(seconds * 1e9)
        while session.clock.steady() < until:
            executor.spin_once(timeout_sec=0.01)
        return messages

    listen.node = messages_node
    yield listen
    rclpy.shutdown(context=context)


@pytest.fixture
def start(run, tmp_path):
    """start(description, "delta:=0.1", ...) runs the node."""

    def start_(text, *parameters):
        path = tmp_path / "robot.urdf"
        path.write_text(text)
        words = [word for parameter in parameters for word in ("-p", parameter)]
        return run("joint_state_publisher", "joint_state_publisher", str(path), "--ros-args", *words)

    return start_


def test_every_moving_joint_is_published_ten_times_a_second(run, heard):
    run("joint_state_publisher", "joint_state_publisher", str(ROBOTS / "rdk_x3_robot.urdf"))
    messages = heard(2.0)
    assert 18 <= len(messages) <= 20
    assert messages[0].name == [f"{side}_{place}_joint" for side in ("left", "right") for place in ("front", "back")]
    assert list(messages[0].position) == [0.0] * 4
    assert not messages[0].velocity and not messages[0].effort


def test_the_rate_is_a_parameter(start, heard):
    start(PAIR, "rate:=50")
    assert 48 <= len(heard(1.0)) <= 50


def test_the_description_comes_from_the_topic(session, run, heard):
    node = run("joint_state_publisher", "joint_state_publisher")
    assert heard(0.5) == []
    assert "Waiting for robot_description to be published on the robot_description topic..." in node.output
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    publisher = heard.node.create_publisher(String, "robot_description", latched)
    publisher.publish(String(data=PAIR))
    assert heard(0.5)[-1].name == ["lead", "follow"]
    publisher.publish(String(data="<robot/>"))
    heard(0.5)
    assert "No name given for the robot." in node.output
    assert heard(0.5)[-1].name == ["lead", "follow"]


def test_a_follower_follows(start, heard):
    start(PAIR, "zeros.lead:=0.25")
    assert list(heard()[-1].position) == [0.25, 1.0]


def test_mimic_tags_can_be_ignored(start, heard):
    start(PAIR, "zeros.lead:=0.25", "use_mimic_tags:=false")
    assert list(heard()[-1].position) == [0.25, 0.0]


def test_dependent_joints_come_from_parameters(start, heard):
    joints = arm(("a", "continuous", ""), ("b", "continuous", ""), ("c", "continuous", ""))
    start(
        joints,
        "zeros.a:=1.0",
        "dependent_joints.b.parent:=a",
        "dependent_joints.b.factor:=0.5",
        "dependent_joints.c.parent:=b",
        "dependent_joints.c.offset:=0.25",
    )
    assert list(heard()[-1].position) == [1.0, 0.5, 0.75]


def test_the_zero_is_within_the_limits(start, heard):
    start(arm(("a", "revolute", LIMIT.format(1, 2)), ("b", "revolute", LIMIT.format(-1, 2))))
    assert list(heard()[-1].position) == [1.5, 0.0]


@pytest.mark.parametrize(("smallest", "middle"), [("true", 1.25), ("false", 1.5)])
def test_soft_limits_are_the_smaller_ones(start, heard, smallest, middle):
    soft = '<safety_controller k_velocity="1" soft_lower_limit="0.5" soft_upper_limit="1.5"/>'
    start(arm(("a", "revolute", LIMIT.format(1, 2) + soft)), f"use_smallest_joint_limits:={smallest}")
    assert list(heard()[-1].position) == [middle]


def test_delta_moves_to_and_fro_and_round(start, heard):
    start(arm(("fro", "revolute", LIMIT.format(-1, 1)), ("round", "continuous", "")), "delta:=0.5")
    messages = heard(2.0)
    assert [message.position[0] for message in messages[:8]] == [0.5, 1.0, 1.0, 0.5, 0.0, -0.5, -1.0, -1.0]
    positions = [message.position[1] for message in messages]
    assert -math.pi in positions and max(positions) <= math.pi


def test_velocities_and_efforts_are_published_when_asked(start, heard):
    start(PAIR, "publish_default_velocities:=true", "publish_default_efforts:=true")
    message = heard()[-1]
    assert list(message.velocity) == list(message.effort) == [0.0, 0.0]


def test_sources_move_joints(start, heard):
    start(PAIR, "source_list:=[arm_states]")
    heard(0.2)
    heard.node.create_publisher(JointState, "arm_states", 10).publish(
        JointState(name=["lead", "other"], position=[0.75, 3.0], velocity=[0.5, 0.0])
    )
    message = heard(0.5)[-1]
    assert list(message.position) == [0.75, 2.0]
    assert list(message.velocity) == [0.5, 1.0]


@pytest.mark.parametrize("text", ["<robot", '<robot name="r"/>'])
def test_a_bad_file_ends_it_with_the_reason(start, text):
    node = start(text)
    assert node.wait(5) == 1
    assert "robot_description:1" in node.output


@pytest.mark.parametrize(
    ("parameters", "words"),
    [
        ({"head": "x"}, "Invalid dependent_joint name 'head'"),
        ({"head.colour": "x"}, "allowed values are 'parent', 'factor', 'offset'"),
        ({"head.factor": 1.0}, "All dependent_joints must at least have a parent"),
    ],
)
def test_wrong_dependent_joints_are_refused(parameters, words):
    with pytest.raises(ValueError, match=words):
        followers(parameters)


def test_joints_that_depend_on_each_other_end_it(start):
    joints = arm(("a", "continuous", ""), ("b", "continuous", ""))
    node = start(joints, "dependent_joints.a.parent:=b", "dependent_joints.b.parent:=a")
    assert node.wait(5) == 1
    assert "Found an infinite recursive mimic chain" in node.output


SDF = """<sdf version="1.8"><model name="arm">
<joint name="j1" type="revolute"><axis><limit><lower>{least}</lower><upper>1</upper></limit></axis></joint>
<joint name="j2" type="fixed"/><joint name="j3" type="continuous"/></model></sdf>"""
COLLADA = """<COLLADA version="1.5.0"><library_kinematics_models><kinematics_model><technique_common>
<joint name="j1"><revolute><limits><min>{least}</min><max>180</max></limits></revolute></joint>
<joint name="j2"><revolute><limits><min>9</min><max>9</max></limits></revolute></joint>
</technique_common></kinematics_model></library_kinematics_models></COLLADA>"""


@pytest.mark.parametrize(
    "text, expected",
    [
        (SDF, {"j1": (-1.0, 1.0), "j3": (-math.pi, math.pi)}),
        (COLLADA, {"j1": (pytest.approx(math.radians(-1)), pytest.approx(math.pi))}),
    ],
)
def test_sdf_and_collada_have_joints_too(text, expected):
    model = read(text.format(least=-1), Options({}, {}))
    assert {name: (joint.least, joint.greatest) for name, joint in model.free.items()} == expected
    assert model.names == list(expected)


@pytest.mark.parametrize("text, tag", [(SDF, "lower"), (COLLADA, "min")])
@pytest.mark.parametrize("wrong", ["foo", "nan", ""])
def test_limits_that_are_no_numbers_are_told(text, tag, wrong):
    with pytest.raises(UrdfError, match=f'"{tag}" limit must be a float for joint "j1"'):
        read(text.format(least=wrong), Options({}, {}))


def test_the_module_of_its_package_shows_the_joints_as_dictionaries(session, tmp_path):
    from joint_state_publisher.joint_state_publisher import JointStatePublisher

    file = tmp_path / "arm.urdf"
    file.write_text(arm(("a", "revolute", LIMIT.format(-1, 2)), ("b", "continuous", '<mimic joint="a" multiplier="2"/>')))
    rclpy.init()
    node = JointStatePublisher(file)
    assert node.joint_list == ["a", "b"] and list(node.dependent_joints) == ["b"]
    assert dict(node.free_joints["a"]) == {"min": -1.0, "max": 2.0, "zero": 0.0, "position": 0.0}
    node.free_joints["a"]["position"] = 0.5
    node.free_joints["a"]["velocity"] = 0.1
    heard = []
    node.create_subscription(JointState, "joint_states", heard.append, 1)
    while not heard:
        rclpy.spin_once(node)
    assert (list(heard[0].position), list(heard[0].velocity)) == ([0.5, 1.0], [0.1, 0.2])
    with pytest.raises(KeyError):
        node.free_joints["a"]["effort"]
    with pytest.raises(KeyError):
        node.free_joints["a"]["colour"] = "red"
    node.destroy_node()
    rclpy.shutdown()
