"""Costmaps that take in clouds, as those of depth cameras, and ranges, as those of sonars, on the virtual clock."""

import numpy as np
import pytest
from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import OccupancyGrid
from sensor_msgs.msg import LaserScan, PointCloud2, Range
from sensor_msgs_py.point_cloud2 import create_cloud_xyz32
from std_msgs.msg import Header
from tf2_ros import StaticTransformBroadcaster

from coursekit.nodes.nav2.map_message import MAP_QOS
from tests.nodes.friend import Friend

PARAMETERS = """local_costmap:
  local_costmap:
    ros__parameters:
      global_frame: odom
      robot_base_frame: base_link
      rolling_window: true
      width: 4
      height: 4
      resolution: 0.1
      robot_radius: 0.1
      plugins: [voxel_layer]
      voxel_layer:
        plugin: nav2_costmap_2d::VoxelLayer
        observation_sources: camera
        camera: {topic: /camera/points, data_type: PointCloud2, marking: true, clearing: true, %s}
"""


RANGES = """      plugins: [sonars]
      sonars: {plugin: nav2_costmap_2d::RangeSensorLayer, topics: [/sonar], clear_on_max_reading: %s}
"""


@pytest.fixture
def costmap(session, run, ros2, tmp_path):
    """costmap(text, topic, *messages) are the obstacles (x, y) of one that took in messages in turn, and its log."""

    def look(text, topic, *messages):
        file = tmp_path / "costmap.yaml"
        file.write_text(text)
        process = run("nav2_controller", "controller_server", "--ros-args", "--params-file", str(file))
        friend = Friend(session)
        mount(friend)
        for state in ("configure", "activate"):
            assert "successful" in ros2("lifecycle", "set", "/controller_server", state), process.output
        heard = []
        friend.node.create_subscription(OccupancyGrid, "/local_costmap/costmap", heard.append, MAP_QOS)
        friend.spin(0.5)
        for msg in messages:
            msg.header.frame_id, msg.header.stamp = "camera", friend.node.get_clock().now().to_msg()
            friend.say(topic, msg)
            friend.spin(2.0)
        assert heard and friend.node.count_subscribers(topic) == 1
        return obstacles(heard[-1]), process.output

    return look


@pytest.fixture
def seen(costmap):
    """seen(heights, *clouds) are the obstacles (x, y) of a costmap that took in clouds of points in turn, and its log."""

    def look(heights, *clouds):
        cloud_messages = (create_cloud_xyz32(Header(), points) for points in clouds)
        return costmap(PARAMETERS % heights, "/camera/points", *cloud_messages)

    return look


def mount(friend):
    """A robot at the origin, with a camera 0.5 m up that looks along x; its points are in the camera's own frame."""
    frames = [TransformStamped(child_frame_id="base_link"), TransformStamped(child_frame_id="camera")]
    frames[0].header.frame_id, frames[1].header.frame_id = "odom", "base_link"
    frames[1].transform.translation.z = 0.5
    friend.tf = StaticTransformBroadcaster(friend.node)
    friend.tf.sendTransform(frames)
    friend.spin(0.2)


def obstacles(grid):
    cells = np.array(grid.data).reshape(grid.info.height, grid.info.width)
    rows, columns = np.nonzero(cells == 100)
    left, low = grid.info.origin.position.x, grid.info.origin.position.y
    middles = ((left + (c + 0.5) * 0.1, low + (r + 0.5) * 0.1) for r, c in zip(rows, columns, strict=True))
    return sorted((round(x, 2), round(y, 2)) for x, y in middles)


def test_points_between_the_heights_are_obstacles_the_floor_and_the_ceiling_are_none(seen):
    cloud = [[1.05, 0.05, 0.0], [0.75, 0.05, -0.5], [0.55, 0.05, 2.0], [1.05, 0.35, np.nan]]
    assert seen("min_obstacle_height: 0.1, max_obstacle_height: 2.0", cloud)[0] == [(1.05, 0.05)]


def test_what_has_gone_is_cleared_by_points_behind_it(seen):
    clouds = [[1.05, 0.05, 0.0]], [[1.55, 0.07, 0.1]]
    assert seen("max_obstacle_height: 2.0", *clouds)[0] == [(1.55, 0.05)]


def test_without_a_greatest_height_nothing_is_an_obstacle_and_that_is_told(seen):
    marked_cells, said = seen("marking: true", [[1.05, 0.05, 0.0]])
    assert (
        marked_cells == [] and "voxel_layer.camera.max_obstacle_height is 0.0" in said and "max_obstacle_height: 2.0" in said
    )


def test_a_cloud_without_coordinates_is_told_once(session, seen, run, monkeypatch):
    from tests.nodes import test_costmap_sensors

    monkeypatch.setattr(test_costmap_sensors, "create_cloud_xyz32", lambda header, points: PointCloud2(header=header))
    marked_cells, said = seen("max_obstacle_height: 2.0", [[1.0, 0.0, 0.0]], [[1.0, 0.0, 0.0]])
    assert marked_cells == [] and said.count("A cloud of /camera/points cannot be used") == 1


SCANS = PARAMETERS.replace("PointCloud2", "LaserScan").replace("/camera/points", "/scan")
SCAN = LaserScan(ranges=[1.02], range_max=5.0)


def test_scans_count_between_the_heights(costmap):
    assert costmap(SCANS % "max_obstacle_height: 2.0", "/scan", SCAN)[0] == [(1.05, 0.05)]


def test_scans_of_a_laser_above_the_greatest_height_do_not_count_and_that_is_told_once(costmap):
    marked_cells, said = costmap(SCANS % "max_obstacle_height: 0.4", "/scan", SCAN, SCAN)
    assert marked_cells == [] and said.count("the laser is 0.50 m above odom") == 1 and "max_obstacle_height: 2.0" in said


def test_a_sonar_s_cone_ends_at_an_obstacle(costmap):
    text = PARAMETERS[: PARAMETERS.index("      plugins")] + RANGES
    sonar = {"field_of_view": 0.2, "min_range": 0.1, "max_range": 2.0}
    near, far = Range(range=1.05, **sonar), Range(range=2.0, **sonar)
    marked_cells, _ = costmap(text % "false", "/sonar", near, far)
    assert marked_cells == [(1.05, -0.15), (1.05, -0.05), (1.05, 0.05), (1.05, 0.15)]


def test_a_sonar_that_hears_nothing_clears_where_that_is_wanted(costmap):
    text = PARAMETERS[: PARAMETERS.index("      plugins")] + RANGES
    sonar = {"field_of_view": 0.2, "min_range": 0.1, "max_range": 2.0}
    assert costmap(text % "true", "/sonar", Range(range=1.05, **sonar), Range(range=2.0, **sonar))[0] == []
