"""navsat_transform_node: places of the Earth in a robot's world, on the virtual clock."""

import math

import pytest
from geographic_msgs.msg import GeoPoint, GeoPose
from geometry_msgs.msg import Point, Quaternion
from nav_msgs.msg import Odometry
from rclpy.time import Time
from robot_localization.srv import FromLL, SetDatum, SetUTMZone, ToLL
from sensor_msgs.msg import NavSatFix

from coursekit.sim.spherical_coordinates import SphericalCoordinates
from tests.nodes.robot_localization.conftest import TICK, rolled

HOME = (48.0, 11.0, 500.0)
NODE = "navsat_transform_node"


class Outdoors:
    """The robot drives on the Earth: its odometry/filtered says where it is, its receiver sits 0.5 m ahead."""

    def __init__(self, robot, heading=0.0):
        self.robot, self.globe = robot, SphericalCoordinates(*HOME, heading=heading)
        self.poses, self.fixes = [], []
        node = robot.node
        self.odometry = node.create_publisher(Odometry, "odometry/filtered", 10)
        self.gps = node.create_publisher(NavSatFix, "gps/fix", 10)
        node.create_subscription(Odometry, "odometry/gps", self.poses.append, 10)
        node.create_subscription(NavSatFix, "gps/filtered", self.fixes.append, 10)
        robot.mount("gps", x=0.5)

    def drive(self, seconds, status=0, yaw=0.0):
        robot = self.robot
        for _ in range(round(seconds / TICK)):
            robot.truth = x, y, turned = rolled(robot.truth, 0.5, 0.2)
            msg = robot.header(Odometry(child_frame_id="base_link"), "odom")
            msg.pose.pose.position.x, msg.pose.pose.position.y = x, y
            msg.pose.pose.orientation.z, msg.pose.pose.orientation.w = math.sin(turned / 2), math.cos(turned / 2)
            self.odometry.publish(msg)
            robot.mount("base_link", parent="odom", x=x, yaw=turned)
            fix = robot.header(NavSatFix(), "gps")
            fix.status.status = status
            there = (x + 0.5 * math.cos(turned), y + 0.5 * math.sin(turned))
            fix.latitude, fix.longitude, fix.altitude = self.globe.fix(*there)
            fix.position_covariance = [0.04, 0.0, 0.0, 0.0, 0.01, 0.0, 0.0, 0.0, 0.09]
            self.gps.publish(fix)
            robot.tell_imu(0.2, yaw + turned)
            robot.spin(TICK)


@pytest.fixture
def outdoors(robot):
    return Outdoors(robot)


@pytest.mark.parametrize("local", ["true", "false"])
def test_places_become_points_of_the_world_and_points_places(outdoors, start, robot, local):
    start(NODE, use_local_cartesian=local, zero_altitude="true")
    outdoors.drive(1.0)
    latitude, longitude, altitude = outdoors.globe.fix(30.0, -20.0)
    place = GeoPoint(latitude=latitude, longitude=longitude, altitude=altitude)
    point = robot.ask(FromLL, "fromLL", ll_point=place).map_point
    assert (point.x, point.y) == pytest.approx((30.0, -20.0), abs=0.03) and point.z == 0.0
    back = robot.ask(ToLL, "toLL", map_point=Point(x=30.0, y=-20.0, z=0.0)).ll_point
    assert (back.latitude, back.longitude) == pytest.approx((latitude, longitude), abs=4e-7)


def test_a_fix_says_where_the_robot_is_not_where_its_receiver_is(robot, start):
    outdoors = Outdoors(robot)
    start(NODE, frequency=30.0)
    for _ in range(40):
        robot.truth = (1.0, 2.0, 0.0)
        outdoors.drive(TICK)
    last = outdoors.poses[-1]
    assert last.header.frame_id == "odom"
    assert (last.pose.pose.position.x, last.pose.pose.position.y) == pytest.approx((1.0, 2.0), abs=0.05)
    assert last.pose.covariance[0] == pytest.approx(0.04, abs=1e-3)
    assert last.pose.covariance[7] == pytest.approx(0.01, abs=1e-3) and last.pose.covariance[35] == 0.0
    fix = outdoors.fixes[-1]
    assert (fix.latitude, fix.longitude) == pytest.approx(outdoors.globe.fix(1.0, 2.0)[:2], abs=5e-7)


def test_the_heading_counts_and_what_the_parameters_add_to_it(robot, start):
    outdoors = Outdoors(robot, heading=90.0)  # the world's x axis points north; the IMU says so, but for 0.3
    start(NODE, yaw_offset=0.2, magnetic_declination_radians=0.1)
    outdoors.drive(1.0, yaw=math.pi / 2 - 0.3)
    latitude, longitude, altitude = outdoors.globe.fix(25.0, 10.0)
    place = GeoPoint(latitude=latitude, longitude=longitude, altitude=altitude)
    point = robot.ask(FromLL, "fromLL", ll_point=place).map_point
    assert (point.x, point.y) == pytest.approx((25.0, 10.0), abs=0.05)


def test_with_a_datum_the_world_begins_there(outdoors, start, robot):
    """Whatever the first fix was; odometry gives no heading then."""
    start(NODE, wait_for_datum="true", datum=f"[{HOME[0]}, {HOME[1]}, 0.0]", broadcast_cartesian_transform="true")
    outdoors.drive(0.5)
    origin = robot.ask(FromLL, "fromLL", ll_point=GeoPoint(latitude=HOME[0], longitude=HOME[1])).map_point
    assert (origin.x, origin.y) == pytest.approx((0.0, 0.0), abs=1e-6)
    assert outdoors.robot.buffer.can_transform("odom", "utm", Time())
    pose = GeoPose(position=GeoPoint(latitude=HOME[0] + 0.001, longitude=HOME[1]), orientation=Quaternion(w=1.0))
    robot.ask(SetDatum, "datum", geo_pose=pose)
    outdoors.drive(0.5)
    moved = robot.ask(FromLL, "fromLL", ll_point=GeoPoint(latitude=HOME[0], longitude=HOME[1])).map_point
    assert moved.y == pytest.approx(-111.2, abs=0.3) and abs(moved.x) < 0.5


def test_before_anything_is_known_it_says_so(robot, start):
    process = start(NODE)
    assert robot.ask(FromLL, "fromLL", ll_point=GeoPoint(latitude=1.0)).map_point == Point()
    assert robot.ask(ToLL, "toLL", map_point=Point(x=1.0)).ll_point == GeoPoint()
    assert process.output.count("No transform available (yet)") == 2
    assert [robot.ask(SetUTMZone, "setUTMZone", utm_zone=zone).status for zone in ("x", "32U")] == [False, True]


def test_without_a_fix_nothing_is_told(outdoors, start):
    start(NODE)
    outdoors.drive(1.0, status=-1)
    assert outdoors.poses == outdoors.fixes == []


def test_the_delay_is_waited_for(outdoors, start):
    start(NODE, delay=2.0)
    outdoors.drive(1.5)
    assert not outdoors.poses
    outdoors.drive(1.5)
    assert outdoors.poses
