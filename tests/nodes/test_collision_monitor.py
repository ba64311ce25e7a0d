"""The collision monitor between a program that drives and the wheels, on the virtual clock."""

import numpy as np
import pytest
from geometry_msgs.msg import Point32, PolygonStamped, TransformStamped, Twist
from nav2_msgs.msg import CollisionMonitorState
from sensor_msgs.msg import LaserScan, PointCloud2, Range
from sensor_msgs_py.point_cloud2 import create_cloud_xyz32
from std_msgs.msg import Header
from tf2_ros import StaticTransformBroadcaster

from tests.nodes.friend import Friend

FILE = """collision_monitor:
  ros__parameters:
    base_frame_id: base_link
    state_topic: state
    stop_pub_timeout: 0.5
    polygons: [Stop, Slow, Near]
    Stop: {type: polygon, points: [0.4, 0.2, 0.4, -0.2, 0.0, -0.2, 0.0, 0.2], action_type: stop, max_points: 2,
      visualize: true, polygon_pub_topic: polygon_stop}
    Slow: {type: circle, radius: 1.0, action_type: slowdown, slowdown_ratio: 0.5, min_points: 3}
    Near: {type: polygon, action_type: approach, time_before_collision: 2.0, simulation_time_step: 0.1, max_points: 2,
      footprint_topic: footprint}
    observation_sources: [scan, camera, sonar]
    scan: {type: scan, topic: /scan}
    camera: {type: pointcloud, topic: /points, min_height: 0.1, max_height: 0.5}
    sonar: {type: range, topic: /sonar, obstacles_angle: 0.1}
"""


class Driver(Friend):
    """Wishes for speeds; what comes out, and what the zones say."""

    def __init__(self, session):
        super().__init__(session)
        frames = [TransformStamped(child_frame_id="base_link"), TransformStamped(child_frame_id="sensor")]
        frames[0].header.frame_id, frames[1].header.frame_id = "odom", "base_link"
        self.tf = StaticTransformBroadcaster(self.node)
        self.tf.sendTransform(frames)
        self.speeds, self.states = self.hear(Twist, "cmd_vel"), self.hear(CollisionMonitorState, "state")

    def see(self, topic, msg):
        msg.header.frame_id, msg.header.stamp = "sensor", self.node.get_clock().now().to_msg()
        self.say(topic, msg)
        self.spin(0.1)

    def scan(self, distance):
        """Five beams ahead that end there."""
        self.see("/scan", LaserScan(angle_min=-0.02, angle_increment=0.01, range_max=9.0, ranges=[distance] * 5))

    def wish(self, ahead, turn=0.0):
        msg = Twist()
        msg.linear.x, msg.angular.z = ahead, turn
        self.speeds.clear()
        self.say("cmd_vel_raw", msg)
        self.spin(0.1)
        return [(round(speed.linear.x, 3), round(speed.angular.z, 3)) for speed in self.speeds]


@pytest.fixture
def start(session, run, ros2, tmp_path):
    """start(text) is a driver and the monitor's process, active if it can be."""

    def make(text=FILE):
        (tmp_path / "monitor.yaml").write_text(text)
        argv = ("--ros-args", "--params-file", str(tmp_path / "monitor.yaml"))
        process = run("nav2_collision_monitor", "collision_monitor", *argv)
        driver = Driver(session)
        driver.spin(0.2)
        for state in ("configure", "activate"):
            ros2("lifecycle", "set", "/collision_monitor", state)
        driver.spin(0.2)
        return driver, process

    return make


def test_speeds_go_through_are_halved_and_are_nothing_as_an_obstacle_comes_near(start):
    driver, process = start()
    assert driver.wish(0.4, 0.2) == [(0.4, 0.2)]
    driver.scan(0.8)
    assert driver.wish(0.4, 0.2) == [(0.2, 0.1)]
    driver.scan(0.3)
    assert driver.wish(0.4) == [(0.0, 0.0)]
    driver.scan(5.0)
    assert driver.wish(0.4) == [(0.4, 0.0)]
    assert [(state.action_type, state.polygon_name) for state in driver.states] == [(2, "Slow"), (1, "Stop"), (0, "")]
    for words in ("Robot to slowdown for 50.000000 percents due to Slow polygon", "Robot to stop due to Stop polygon",
                  "Robot to continue normal operation"):  # fmt: skip
        assert words in process.output


def test_a_robot_that_stands_is_told_so_for_a_while_only(start):
    driver, _ = start()
    driver.scan(0.3)
    assert driver.wish(0.4) == [(0.0, 0.0)]
    driver.spin(0.6)
    driver.scan(0.3)
    assert driver.wish(0.4) == []


def test_the_footprint_slows_the_robot_so_that_it_stays_seconds_away(start):
    driver, process = start()
    square = [Point32(x=x, y=y) for x, y in ((0.2, 0.2), (0.2, -0.2), (-0.2, -0.2), (-0.2, 0.2))]
    msg = PolygonStamped()
    msg.header.frame_id, msg.polygon.points = "odom", square
    driver.say("footprint", msg)
    driver.scan(1.21)
    assert driver.wish(0.5) == [(0.5, 0.0)]  # it would be there after more than two seconds
    assert driver.wish(1.0) == [(0.55, 0.0)]
    assert "Robot to approach for 1.100000 seconds away from collision" in process.output


def test_clouds_and_sonars_count_within_their_limits_and_what_is_old_does_not(start):
    driver, process = start()
    header = Header()
    driver.see("/points", create_cloud_xyz32(header, [[0.3, y, z] for y in (0.0, 0.01, 0.02) for z in (0.0, 0.9)]))
    assert driver.wish(0.4) == [(0.4, 0.0)]
    driver.see("/points", create_cloud_xyz32(header, [[0.3, y, 0.2] for y in (0.0, 0.01, 0.02)]))
    assert driver.wish(0.4) == [(0.0, 0.0)]
    driver.see("/points", PointCloud2())
    driver.see("/sonar", Range(field_of_view=0.4, min_range=0.1, max_range=2.0, range=0.7))
    assert driver.wish(0.4) == [(0.2, 0.0)]
    driver.spin(3.0)
    assert driver.wish(0.4) == [(0.4, 0.0)]
    assert "[sonar]: Latest source and current collision monitor node timestamps differ on" in process.output
    assert "[camera]: Failed to get its points" in process.output


def test_zones_are_shown_and_switched_off_while_it_runs(start, ros2):
    driver, _ = start()
    shown = driver.hear(PolygonStamped, "polygon_stop")
    driver.scan(0.3)
    assert driver.wish(0.4) == [(0.0, 0.0)]
    first = shown[0].polygon.points[0]
    assert np.allclose((first.x, first.y), (0.4, 0.2))
    assert shown[0].header.frame_id == "base_link"
    for name in ("Stop", "Slow"):
        assert "successful" in ros2("param", "set", "/collision_monitor", f"{name}.enabled", "false")
    driver.scan(0.3)
    assert driver.wish(0.4) == [(0.4, 0.0)]


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("polygons: [Stop, Slow, Near]", "polygons: ['']", "Polygon has incorrect points description"),
        ("    polygons: [Stop, Slow, Near]\n", "", "polygons is empty: nothing would be watched"),
        ("radius: 1.0", "radius: 0.0", "[Slow]: a circle needs its radius"),
        ("action_type: stop", "action_type: halt", "[Stop]: Unknown action type: halt. Write one of stop, slowdown"),
        ("[0.4, 0.2, 0.4, -0.2, 0.0, -0.2, 0.0, 0.2]", "'[[0.4, 0.2], [0.4, -0.2], [0.0, 0.0]]'", "is newer than Humble"),
        ("type: range", "type: radar", "[sonar]: Unknown source type: radar. Write one of scan, pointcloud, range"),
    ],
)
def test_what_cannot_work_is_told_when_it_is_configured(start, old, new, says):
    assert old in FILE
    _, process = start(FILE.replace(old, new))
    assert says in process.output
