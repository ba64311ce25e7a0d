"""A robot with GPS as people launch it: the example of two filters, unchanged, in a world of Gazebo in Edinburgh."""

import math
from pathlib import Path

import pytest
from geometry_msgs.msg import Point, PointStamped, Twist
from nav_msgs.msg import Odometry
from rclpy.time import Time
from sensor_msgs.msg import NavSatFix
from tf2_geometry_msgs import do_transform_point

from coursekit.cli.parser import run as run_cli
from coursekit.nav.utm import Utm
from coursekit.nodes.gazebo.simulators import simulators
from coursekit.sim.spherical_coordinates import SphericalCoordinates

HOME = (55.944831, -3.186998, 80.0)
HEADING = math.degrees(math.pi / 2 + 0.0429351)  # where the example's yaw_offset and declination have x point to, from east
GLOBE = SphericalCoordinates(*HOME, heading=HEADING)
WORLD = f"""<sdf version="1.6"><world name="park"><spherical_coordinates><surface_model>EARTH_WGS84</surface_model>
<latitude_deg>{HOME[0]}</latitude_deg><longitude_deg>{HOME[1]}</longitude_deg><elevation>{HOME[2]}</elevation>
<heading_deg>{180 - HEADING}</heading_deg></spherical_coordinates>
<model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal>
<size>200 200</size></plane></geometry></collision></link></model></world></sdf>"""
RECEIVER = """<link name="gps"/><joint name="g" type="fixed"><parent link="base_link"/><child link="gps"/>
<origin xyz="0.3 0 0.2"/></joint><gazebo reference="gps"><sensor name="gps" type="gps"><update_rate>5</update_rate><gps>
<position_sensing><horizontal><noise type="gaussian"><mean>0</mean><stddev>0.3</stddev></noise></horizontal>
</position_sensing></gps><plugin name="r" filename="libgazebo_ros_gps_sensor.so"><ros>
<remapping>~/out:=gps/fix</remapping></ros></plugin></sensor></gazebo></robot>"""


@pytest.fixture
def car(tmp_path):
    """The differential drive, with a receiver."""
    text = Path(__file__).with_name("diff_drive.urdf").read_text()
    text = text.replace("~/out:=imu<", "~/out:=imu/data<")
    (tmp_path / "car.urdf").write_text(text.replace("</robot>", RECEIVER))
    return tmp_path / "car.urdf"


@pytest.fixture
def park(session, run, robot, car, tmp_path):
    """The world with the robot in it, its frames, and the example's three nodes; gives the simulated robot."""
    (tmp_path / "park.world").write_text(WORLD)
    run("gazebo_ros", "gzserver", str(tmp_path / "park.world"))
    assert run("gazebo_ros", "spawn_entity.py", "-file", str(car), "-entity", "car").wait(20) == 0
    run("robot_state_publisher", "robot_state_publisher", str(car))
    argv = ["launch", "robot_localization", "dual_ekf_navsat_example.launch.py"]
    session.start(lambda: run_cli(argv), name="ros2", argv=argv[:1])
    return simulators.running(session)[0].simulation.robots["car"]


@pytest.fixture
def worn(robot):
    """Wheels that are smaller than the odometry believes: it counts a tenth too much."""
    out = robot.node.create_publisher(Odometry, "odometry/wheel", 10)

    def pass_on(msg):
        msg.twist.twist.linear.x *= 1.1
        msg.twist.covariance[0] = msg.twist.covariance[7] = 0.01
        out.publish(msg)

    robot.node.create_subscription(Odometry, "odom", pass_on, 10)


@pytest.fixture
def drive(robot, park, worn):
    """drive() goes round a bend of 30 m, as seen by the filters, the receiver's and the filter's fixes."""
    heard = {"odometry/local": [], "odometry/global": [], "odometry/gps": []}
    for name, into in heard.items():
        robot.node.create_subscription(Odometry, name, into.append, 50)
    heard["gps/filtered"] = []
    robot.node.create_subscription(NavSatFix, "gps/filtered", heard["gps/filtered"].append, 50)
    wheel = robot.node.create_publisher(Twist, "cmd_vel", 10)

    def go():
        robot.spin(5.0)
        for turn in (0.0, 0.1, 0.0):
            msg = Twist()
            msg.linear.x, msg.angular.z = 0.8, turn
            wheel.publish(msg)
            robot.spin(12.0)
        return {name: messages[-1] for name, messages in heard.items()}

    return go


def away(msg, place):
    return math.hypot(msg.pose.pose.position.x - place.x, msg.pose.pose.position.y - place.y)


@pytest.mark.slow
def test_with_gps_the_robot_knows_where_it_is_though_its_wheels_do_not(drive, park, robot):
    last, place = drive(), park.place
    assert math.hypot(place.x, place.y) > 20.0
    assert away(last["odometry/local"], place) > 2.0
    assert away(last["odometry/global"], place) < 0.5
    fix = last["gps/filtered"]
    seen = GLOBE.place(fix.latitude, fix.longitude, HOME[2])
    assert math.hypot(seen[0] - place.x, seen[1] - place.y) < 0.8  # the world begins at the first fix: 0.3 m count twice
    in_map = do_transform_point(in_utm(place), robot.buffer.lookup_transform("map", "utm", Time()))
    assert math.hypot(in_map.point.x - place.x, in_map.point.y - place.y) < 0.8


def in_utm(place):
    """Where that is in the zone of Edinburgh, in metres."""
    latitude, longitude, _ = GLOBE.fix(place.x, place.y)
    east, north = Utm.named("30V").plane(latitude, longitude)
    return PointStamped(point=Point(x=east, y=north, z=HOME[2]))


def test_what_navsat_transform_is_launched_with_is_taken(session, robot, ros2):
    argv = ["launch", "robot_localization", "navsat_transform.launch.py"]
    session.start(lambda: run_cli(argv), name="ros2", argv=argv[:1])
    robot.spin(2.0)
    assert "Double value is: 3.0" in ros2("param", "get", "navsat_transform_node", "delay")
    topics = ros2("node", "info", "/navsat_transform_node")
    assert all(name in topics for name in ("/imu: sensor_msgs", "/gps/fix: sensor_msgs", "/odometry/gps: nav_msgs"))
