"""turtlesim_node as others see it."""

import math

import pytest
import rclpy
from geometry_msgs.msg import Twist
from rcl_interfaces.msg import ParameterType
from std_srvs.srv import Empty
from turtlesim.msg import Color, Pose
from turtlesim.srv import Kill, SetPen, Spawn, TeleportAbsolute, TeleportRelative

from coursekit.nodes.turtlesim.simulators import simulators
from coursekit.sim.turtle import SIDE
from tests.nodes.friend import Friend


class Driver(Friend):
    """Hears the turtle and drives it."""

    def __init__(self, session):
        super().__init__(session)
        self.poses, self.colours = [], []
        self.node.create_subscription(Pose, "turtle1/pose", self.poses.append, 10)
        self.node.create_subscription(Color, "turtle1/color_sensor", self.colours.append, 10)
        self.cmd_vel = self.node.create_publisher(Twist, "turtle1/cmd_vel", 1)

    def drive(self, linear=0.0, angular=0.0, sideways=0.0):
        twist = Twist()
        twist.linear.x, twist.linear.y, twist.angular.z = linear, sideways, angular
        self.cmd_vel.publish(twist)

    @property
    def pose(self):
        return self.poses[-1]


@pytest.fixture
def sim(run):
    return run("turtlesim", "turtlesim_node")


@pytest.fixture
def friend(session, sim):
    new_friend = Driver(session)
    new_friend.spin(0.1)
    yield new_friend
    rclpy.shutdown(context=new_friend.context)


def test_it_says_what_the_real_one_says(session, sim):
    session.clock.sleep(0.5)
    lines = [line.split("] ", 2)[2] for line in sim.output.splitlines()]
    assert lines == [
        "[turtlesim]: Starting turtlesim with node name /turtlesim",
        "[turtlesim]: Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]",
    ]


def test_ctrl_c_ends_it_and_nobody_draws_it_any_more(session, sim):
    session.clock.sleep(0.5)
    assert [node.full_name for node in simulators.running(session)] == ["/turtlesim"]
    sim.interrupt()
    assert sim.wait(5) == 0
    assert simulators.running(session) == []


def test_a_killed_one_is_not_drawn_either(session, sim):
    session.clock.sleep(0.5)
    sim.kill()
    sim.wait(5)
    assert simulators.running(session) == []


def test_the_node_has_the_real_ones_names(sim, ros2):
    info = ros2("node", "info", "/turtlesim")
    for line in (
        "/turtle1/cmd_vel: geometry_msgs/msg/Twist",
        "/turtle1/pose: turtlesim/msg/Pose",
        "/turtle1/color_sensor: turtlesim/msg/Color",
        "/clear: std_srvs/srv/Empty",
        "/reset: std_srvs/srv/Empty",
        "/kill: turtlesim/srv/Kill",
        "/spawn: turtlesim/srv/Spawn",
        "/turtle1/set_pen: turtlesim/srv/SetPen",
        "/turtle1/teleport_absolute: turtlesim/srv/TeleportAbsolute",
        "/turtle1/teleport_relative: turtlesim/srv/TeleportRelative",
        "/turtle1/rotate_absolute: turtlesim/action/RotateAbsolute",
    ):
        assert f"    {line}\n" in info


def test_poses_come_sixty_two_and_a_half_times_a_second(friend):
    friend.poses.clear()
    friend.spin(2.0)
    assert len(friend.poses) == pytest.approx(125, abs=1)


def test_the_first_pose_is_the_middle_as_a_32_bit_number(friend):
    assert (friend.pose.x, friend.pose.y, friend.pose.theta) == (5.544444561004639, 5.544444561004639, 0.0)
    assert 2 * friend.pose.x == SIDE


def test_a_twist_drives_for_one_second(friend):
    friend.drive(linear=2.0)
    friend.spin(0.5)
    assert friend.pose.linear_velocity == 2.0
    friend.spin(2.0)
    assert friend.pose.linear_velocity == 0.0
    assert friend.pose.x == pytest.approx(SIDE / 2 + 2.0, abs=0.07)


def test_a_zero_twist_stops_within_two_frames(friend):
    friend.drive(linear=2.0)
    friend.spin(0.3)
    friend.drive()
    friend.spin(0.033)
    where = friend.pose.x
    friend.spin(0.5)
    assert friend.pose.x == where


def test_only_a_holonomic_turtle_moves_sideways(friend, ros2):
    friend.drive(sideways=1.0)
    friend.spin(0.5)
    assert friend.pose.y == pytest.approx(SIDE / 2)
    ros2("param", "set", "/turtlesim", "holonomic", "true")
    friend.drive(sideways=1.0)
    friend.spin(0.5)
    assert friend.pose.y > SIDE / 2 + 0.3


def test_a_wall_is_reported_with_y_downwards(friend, sim):
    friend.ask(TeleportAbsolute, "turtle1/teleport_absolute", x=5.0, y=11.0, theta=math.pi / 2)
    friend.drive(linear=8.0)
    friend.spin(0.2)
    assert "[WARN]" in sim.output
    assert "Oh no! I hit the wall! (Clamping from [x=5.000000, y=-0.039111])" in sim.output
    assert friend.pose.y == pytest.approx(SIDE)


def test_spawn_gives_a_free_name_and_takes_a_wish(friend, sim):
    assert friend.ask(Spawn, "spawn", x=1.0, y=2.0).name == "turtle2"
    assert friend.ask(Spawn, "spawn", x=1.0, y=2.0, theta=0.5, name="leo").name == "leo"
    assert "Spawning turtle [leo] at x=[1.000000], y=[2.000000], theta=[0.500000]" in sim.output
    assert friend.ask(Spawn, "spawn", name="leo").name == ""
    assert "[ERROR]" in sim.output and "A turtle named [leo] already exists" in sim.output


def test_a_name_that_is_no_topic_is_refused_and_the_simulator_lives(friend, sim):
    assert friend.ask(Spawn, "spawn", name="my turtle").name == ""
    assert "must be good for topics" in sim.output
    assert sim.exit_code is None


def test_kill_takes_the_turtle_and_its_names_away(friend, sim, ros2):
    friend.ask(Spawn, "spawn", x=1.0, y=1.0, name="leo")
    assert "/leo/pose" in ros2("topic", "list")
    friend.ask(Kill, "kill", name="leo")
    assert "/leo" not in ros2("topic", "list") + ros2("service", "list")
    friend.ask(Kill, "kill", name="leo")
    assert "Tried to kill turtle [leo], which does not exist" in sim.output


def test_reset_puts_everything_back(friend, sim):
    friend.ask(Spawn, "spawn", x=1.0, y=1.0)
    friend.drive(linear=1.0)
    friend.spin(0.5)
    friend.ask(Empty, "reset")
    friend.spin(0.2)
    assert "Resetting turtlesim." in sim.output
    assert friend.pose.x == 5.544444561004639
    assert friend.ask(Spawn, "spawn").name == "turtle2"


def test_the_colour_sensor_sees_the_pen_and_clear_wipes_it(friend, session, sim):
    assert friend.colours[-1] == Color(r=255, g=255, b=255)
    friend.ask(SetPen, "turtle1/set_pen", r=255, width=5)
    friend.drive(linear=1.0)
    friend.spin(1.5)
    assert friend.colours[-1] == Color(r=255, g=0, b=0)
    friend.ask(Empty, "clear")
    friend.spin(0.1)
    assert "Clearing turtlesim." in sim.output
    assert friend.colours[-1] == Color(r=255, g=255, b=255)


def test_teleports_are_relative_to_the_heading_or_absolute(friend):
    friend.ask(TeleportAbsolute, "turtle1/teleport_absolute", x=1.0, y=2.0, theta=0.0)
    friend.ask(TeleportRelative, "turtle1/teleport_relative", linear=3.0, angular=math.pi / 2)
    friend.spin(0.1)
    assert (friend.pose.x, friend.pose.y) == pytest.approx((1.0, 5.0), abs=1e-5)
    assert friend.pose.theta == pytest.approx(math.pi / 2)


def test_the_background_has_ranges_and_descriptions(friend, ros2):
    described = ros2("param", "describe", "/turtlesim", "background_r")
    assert "Description: Red channel of the background color" in described
    assert "Min value: 0" in described and "Max value: 255" in described and "Step: 1" in described
    assert "Integer value is: 86" in ros2("param", "get", "/turtlesim", "background_g")
    assert "Setting parameter failed" in ros2("param", "set", "/turtlesim", "background_b", "256")
    assert ParameterType.PARAMETER_INTEGER == 2
