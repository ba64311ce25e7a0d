"""Cars by their steering controllers, with hardware that is none and in a world."""

import math

import pytest
from gazebo_msgs.srv import GetEntityState
from geometry_msgs.msg import Twist, TwistStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState
from tf2_msgs.msg import TFMessage

ROLLING = """<joint name='{}'><command_interface name='velocity'/><state_interface name='position'/>
<state_interface name='velocity'/></joint>"""
TURNING = "<joint name='{}'><command_interface name='position'/><state_interface name='position'/></joint>"
LINK = """<link name='{name}_link'><inertial><mass value='0.2'/>
<inertia ixx='1e-3' iyy='1e-3' izz='1e-3' ixy='0' ixz='0' iyz='0'/></inertial>
<collision><origin rpy='1.5708 0 0'/><geometry><cylinder radius='0.1' length='0.04'/></geometry></collision></link>
<joint name='{name}' type='{kind}'><parent link='base_link'/><child link='{name}_link'/><origin xyz='{x} {y} 0.1'/>
<axis xyz='{axis}'/><limit lower='-0.7' upper='0.7' effort='10' velocity='10'/></joint>"""
PLACES = {"rear_right": (0.0, -0.2), "rear_left": (0.0, 0.2), "front_right": (0.6, -0.2), "front_left": (0.6, 0.2)}
CAR = """<robot name='car'><link name='base_link'><inertial><mass value='5'/>
<inertia ixx='0.1' iyy='0.1' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial><collision><origin xyz='0.3 0 0.2'/><geometry>
<box size='0.8 0.3 0.1'/></geometry></collision></link>{links}
<ros2_control name='car' type='system'><hardware><plugin>{plugin}</plugin><param name='calculate_dynamics'>true</param>
</hardware>{joints}</ros2_control>{blocks}</robot>"""
FILE = """controller_manager:
  ros__parameters:
    update_rate: 100
    car: {{type: {kind}}}
    states: {{type: joint_state_broadcaster/JointStateBroadcaster}}
car:
  ros__parameters: {{front_steering: true, wheelbase: 0.6, {more}}}
"""
FOUR = """rear_wheels_names: [rear_right, rear_left], front_wheels_names: [front_right, front_left], front_wheel_track: 0.4,
    rear_wheel_track: 0.4, front_wheels_radius: 0.1, rear_wheels_radius: 0.1"""
ACKERMANN = "ackermann_steering_controller/AckermannSteeringController"


def description(plugin="mock_components/GenericSystem", blocks=""):
    links = joints = ""
    for name, (x, y) in PLACES.items():
        turns = name.startswith("front")
        links += LINK.format(
            name=name, x=x, y=y, kind="revolute" if turns else "continuous", axis="0 0 1" if turns else "0 1 0"
        )
        joints += (TURNING if turns else ROLLING).format(name)
    return CAR.format(links=links, joints=joints, plugin=plugin, blocks=blocks)


@pytest.fixture
def car(managed):
    """car(kind, more) is the process of a manager with a car's controller."""
    return lambda kind, more: managed(description(), FILE.format(kind=kind, more=more))


def drive(friend, msg, topic, seconds=2.0):
    out = friend.node.create_publisher(type(msg), topic, 10)
    twist = getattr(msg, "twist", msg)
    twist.linear.x, twist.angular.z = 0.5, 0.5
    for _ in range(round(seconds / 0.1)):
        out.publish(msg)
        friend.spin(0.1)


def joints(states):
    return dict(zip(states[-1].name, zip(states[-1].position, states[-1].velocity, strict=True), strict=True))


def circled(pose, angle, within):
    """Whether a pose is that of a robot that has gone along a circle of 1 m so far."""
    assert (pose.position.x, pose.position.y) == pytest.approx((math.sin(angle), 1 - math.cos(angle)), abs=within)
    assert 2 * math.atan2(pose.orientation.z, pose.orientation.w) == pytest.approx(angle, abs=within)


@pytest.mark.parametrize("position", ["false", "true"])
def test_a_car_goes_around_a_circle_with_each_wheel_on_its_own(car, run, friend, position):
    car(ACKERMANN, f"{FOUR}, position_feedback: {position}")
    assert run("controller_manager", "spawner", "car", "states").wait(20) == 0
    odometry, tf = friend.hear(Odometry, "/car/odometry"), friend.hear(TFMessage, "/car/tf_odometry")
    states = friend.hear(JointState, "/joint_states")
    drive(friend, TwistStamped(), "/car/reference")
    circled(odometry[-1].pose.pose, 1.0, 0.06)
    now = joints(states)
    assert now["front_right"][0] == pytest.approx(math.atan(0.6 / 1.2), abs=1e-6)
    assert now["front_left"][0] == pytest.approx(math.atan(0.6 / 0.8), abs=1e-6)
    assert (now["rear_right"][1], now["rear_left"][1]) == pytest.approx((6.0, 4.0))
    assert (odometry[-1].header.frame_id, odometry[-1].child_frame_id) == ("odom", "base_link")
    assert tf[-1].transforms[0].child_frame_id == "base_link"
    friend.spin(1.5)
    now = joints(states)
    assert now["rear_right"][1] == 0.0 and now["front_right"][0] > 0.4, "without commands it stops, its wheels turned"


@pytest.mark.parametrize(
    ("kind", "more"),
    [
        ("tricycle_steering_controller/TricycleSteeringController",
         "rear_wheels_names: [rear_right, rear_left], front_wheels_names: [front_left], wheel_track: 0.4, "
         "front_wheels_radius: 0.1, rear_wheels_radius: 0.1"),
        ("bicycle_steering_controller/BicycleSteeringController",
         "rear_wheels_names: [rear_left], front_wheels_names: [front_left], front_wheel_radius: 0.1, "
         "rear_wheel_radius: 0.1, open_loop: true"),
    ],
)  # fmt: skip
def test_other_axles_go_around_the_same_circle(car, run, friend, kind, more):
    car(kind, more + ", use_stamped_vel: false")
    assert run("controller_manager", "spawner", "car").wait(20) == 0
    odometry = friend.hear(Odometry, "/car/odometry")
    drive(friend, Twist(), "/car/reference_unstamped")
    circled(odometry[-1].pose.pose, 1.0, 0.06)


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("[rear_right, rear_left]", "[rear_left]", "rear_wheels_names has 1 names; name two joints, the right one first"),
        ("rear_wheels_radius: 0.1", "rear_wheels_radius: 0.0", "rear_wheels_radius must be more than 0"),
    ],
)
def test_a_car_that_cannot_be_is_told(car, run, old, new, says):
    manager = car(ACKERMANN, FOUR.replace(old, new))
    assert run("controller_manager", "spawner", "car").wait(20) == 1
    assert says in manager.output


def test_a_car_drives_in_a_world(run, friend, tmp_path):
    blocks = "<gazebo><plugin name='c' filename='libgazebo_ros2_control.so'><parameters>{}</parameters></plugin></gazebo>"
    (tmp_path / "car.yaml").write_text(FILE.format(kind=ACKERMANN, more=FOUR))
    urdf = description("gazebo_ros2_control/GazeboSystem", blocks.format(tmp_path / "car.yaml"))
    (tmp_path / "car.urdf").write_text(urdf)
    run("gazebo_ros", "gzserver")
    run("gazebo_ros", "spawn_entity.py", "-file", str(tmp_path / "car.urdf"), "-entity", "car").wait(30)
    assert run("controller_manager", "spawner", "car").wait(20) == 0
    odometry = friend.hear(Odometry, "/car/odometry")
    drive(friend, TwistStamped(), "/car/reference")
    circled(friend.ask(GetEntityState, "/get_entity_state", name="car").state.pose, 1.0, 0.15)
    circled(odometry[-1].pose.pose, 1.0, 0.15)
