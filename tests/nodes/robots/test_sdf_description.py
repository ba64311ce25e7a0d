"""A robot_description in SDF: its frames are published, and its shapes are drawn, as with sdformat_urdf on a robot."""

import math

import pytest
from rclpy.time import Time
from sensor_msgs.msg import JointState
from tf2_ros import Buffer, TransformListener

from coursekit.nodes.gazebo.sdf_description import described
from coursekit.urdf import UrdfError

WHEEL = """<link name='{0}_wheel'><pose>0.5 {1} -0.1 -1.5707963267948966 0 0</pose><inertial><mass>2</mass></inertial>
<visual name='v'><geometry><cylinder><radius>0.3</radius><length>0.1</length></cylinder></geometry></visual></link>
<joint name='{0}_joint' type='revolute'><parent>chassis</parent><child>{0}_wheel</child><axis><xyz>0 0 1</xyz><limit>
<lower>-1.79769e+308</lower><upper>1.79769e+308</upper></limit></axis></joint>"""
CART = """<sdf version='1.8'><model name='cart'><link name='chassis'><pose>-0.2 0 0.2 0 0 0</pose><inertial><mass>1.5</mass>
<inertia><ixx>0.1</ixx><iyy>0.2</iyy><izz>0.3</izz></inertia></inertial><visual name='v'><pose>0 0 0.1 0 0 0</pose>
<geometry><box><size>2 1 0.5</size></box></geometry><material><diffuse>0.5 0.5 1 1</diffuse></material></visual>
<collision name='c'><geometry><box><size>2 1 0.5</size></box></geometry></collision></link>
""" + WHEEL.format("left", 0.6) + WHEEL.format("right", -0.6) + """
<link name='arm'><pose relative_to='lift'>0 0 0 0 0 0</pose></link>
<joint name='lift' type='prismatic'><pose relative_to='chassis'>0 0 1 0 0 0</pose><parent>chassis</parent><child>arm</child>
<axis><xyz>0 0 1</xyz><limit><lower>0</lower><upper>0.4</upper></limit></axis></joint>
<link name='caster'/><joint name='ball' type='ball'><parent>chassis</parent><child>caster</child></joint>
<link name='lidar'><pose relative_to='chassis'>0 0 0.5 0 0 0</pose></link>
<joint name='lidar_joint' type='fixed'><parent>chassis</parent><child>lidar</child></joint>{more}
</model></sdf>"""  # fmt: skip


def test_links_and_joints_are_those_of_the_file():
    robot = described(CART.format(more=""))
    assert robot.root == "chassis" and set(robot.links) == {"chassis", "left_wheel", "right_wheel", "arm", "caster", "lidar"}
    kinds = {name: joint.type for name, joint in robot.joints.items()}
    assert kinds == {"left_joint": "continuous", "right_joint": "continuous", "lift": "prismatic", "ball": "floating",
                     "lidar_joint": "fixed"}  # fmt: skip
    wheel = robot.joints["left_joint"]
    assert wheel.origin.xyz == pytest.approx((0.7, 0.6, -0.3)) and wheel.origin.rpy == pytest.approx((-math.pi / 2, 0, 0))
    assert (robot.joints["lift"].limit.lower, robot.joints["lift"].limit.upper) == (0.0, 0.4)
    (body,) = robot.links["chassis"].visuals
    assert body.geometry.size == (2.0, 1.0, 0.5) and body.origin.xyz == pytest.approx((0, 0, 0.1))
    assert robot.links["chassis"].inertial.mass == 1.5


def test_the_frames_of_a_model_are_published(run, friend, tmp_path):
    (tmp_path / "cart.yaml").write_text("rsp:\n  ros__parameters:\n    robot_description: |-\n" + "\n".join(
        " " * 6 + line for line in CART.format(more="").splitlines()))  # fmt: skip
    words = ("--ros-args", "-r", "__node:=rsp", "--params-file", str(tmp_path / "cart.yaml"))
    node = run("robot_state_publisher", "robot_state_publisher", *words)
    buffer = Buffer()
    TransformListener(buffer, friend.node)
    out = friend.node.create_publisher(JointState, "/joint_states", 10)
    friend.spin(0.5)
    assert node.exit_code is None, node.output
    out.publish(JointState(name=["lift"], position=[0.25]))
    friend.spin(0.5)
    assert buffer.lookup_transform("chassis", "lidar", Time()).transform.translation.z == pytest.approx(0.5)
    assert buffer.lookup_transform("chassis", "arm", Time()).transform.translation.z == pytest.approx(1.25)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("<sdf version='1.8'><world name='w'/></sdf>", "holds no <model>"),
        (CART.format(more="<joint name='j' type='revolute'><parent>nobody</parent><child>arm</child></joint>"), "nobody"),
        (CART.format(more="<joint name='j' type='screwed'><parent>arm</parent><child>lidar</child></joint>"), "screwed"),
        (CART.format(more="<link name='loose'/>"), "Two root links found"),
        (CART.format(more="<include><uri>model://x</uri></include>"), "<include>"),
        ("<sdf version='1.8'", "XML"),
        (CART.format(more="").replace("<upper>0.4", "<upper>nan"), "limit <upper> of 'nan'"),
        (CART.format(more="").replace("<upper>0.4</upper>", "<upper>1</upper><effort>much</effort>"), "of 'much'"),
        (CART.format(more="").replace("<axis><xyz>0 0 1", "<axis><xyz>0 0 up"), "up"),
    ],
)
def test_what_is_no_single_robot_is_told(text, says):
    with pytest.raises(UrdfError) as caught:
        described(text)
    assert says in str(caught.value)


def test_a_urdf_is_read_as_ever():
    assert described("<robot name='ball'><link name='base_link'/></robot>").root == "base_link"
