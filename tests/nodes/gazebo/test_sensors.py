"""Sensors of other people's robots: each type of message, cameras' formats, fixed masts."""

import math

import numpy as np
import pytest
from sensor_msgs.msg import CameraInfo, Image, LaserScan, PointCloud, PointCloud2, Range
from sensor_msgs_py.point_cloud2 import read_points

from coursekit.nodes.gazebo.sdf_world import read_entity

RAY = """<sensor name='{0}' type='ray'><update_rate>10</update_rate><ray><scan><horizontal><samples>5</samples>
<min_angle>-0.2</min_angle><max_angle>0.2</max_angle></horizontal></scan><range><min>0.1</min><max>4</max></range></ray>
<plugin name='{0}' filename='libgazebo_ros_ray_sensor.so'>{1}</plugin></sensor>"""
CAMERA = """<sensor name='eye' type='camera'><update_rate>10</update_rate><camera><image><width>64</width><height>48</height>
<format>{0}</format></image><noise><type>gaussian</type><mean>0</mean><stddev>{1}</stddev></noise></camera>
<plugin name='eye' filename='libgazebo_ros_camera.so'/></sensor>"""
MAST = "<model name='mast'><static>true</static><pose>{0}</pose><link name='head'>{1}</link></model>"
WALL = """<model name='wall'><static>1</static><pose>3 0 1 0 0 0</pose><link name='l'><collision name='c'><geometry><box>
<size>1 9 2</size></box></geometry></collision></link></model>"""


@pytest.fixture
def watch(tmp_path, run, friend):
    """watch(body, (kind, topic), ...) runs a world with a wall for half a second: what was heard on each topic last."""

    def watch(body, *topics):
        file = tmp_path / "yard.world"
        file.write_text(f"<sdf version='1.6'><world name='yard'>{WALL}{body}</world></sdf>")
        heard = [friend.hear(kind, topic) for kind, topic in topics]
        watch.server = run("gazebo_ros", "gzserver", str(file))
        friend.spin(0.5)
        return [message[-1] for message in heard]

    return watch


def test_a_ray_sensor_publishes_the_type_that_its_plugin_names(watch):
    types = ("LaserScan", "PointCloud2", "PointCloud", "Range")
    rays = [RAY.format(name.lower(), f"<output_type>sensor_msgs/{name}</output_type>") for name in types]
    kinds = zip((LaserScan, PointCloud2, PointCloud, Range), types, strict=True)
    scan, cloud, old, cone = watch(
        MAST.format("0 0 0.5 0 0 0", "".join(rays)), *((kind, f"/{name.lower()}/out") for kind, name in kinds)
    )
    assert scan.ranges[2] == pytest.approx(2.5) and scan.header.frame_id == "head"
    points = read_points(cloud, ("x", "y", "z"))
    assert points["x"] == pytest.approx(2.5) and points["y"][0] == pytest.approx(-2.5 * math.tan(0.2))
    assert [field.name for field in cloud.fields] == ["x", "y", "z", "intensity"] and cloud.width == 5
    assert old.points[4].y == pytest.approx(2.5 * math.tan(0.2)) and old.channels[0].name == "intensity"
    assert cone.range == pytest.approx(2.5) and cone.field_of_view == pytest.approx(0.4) and cone.max_range == 4.0


def test_a_ray_sensor_that_names_no_type_publishes_clouds_and_says_so(watch):
    (cloud,) = watch(MAST.format("0 0 0.5 0 0 0", RAY.format("lidar", "")), (PointCloud2, "/lidar/out"))
    assert cloud.width == 5 and "has no <output_type>: it publishes sensor_msgs/PointCloud2" in watch.server.output


def test_a_mast_stands_where_its_model_is_even_in_a_wall(watch):
    shape = "<collision name='c'><geometry><cylinder><radius>0.1</radius><length>1</length></cylinder>"
    shape += "</geometry></collision>"
    ray = RAY.format("lidar", "<output_type>sensor_msgs/LaserScan</output_type>")
    (scan,) = watch(MAST.format("3 2 2.5 0 0 1.5707963267948966", shape + ray), (LaserScan, "/lidar/out"))
    assert set(scan.ranges) == {math.inf}, "it looks over the wall, in which it stands"


FORMATS = [("R8G8B8", "rgb8", 192), ("B8G8R8", "bgr8", 192), ("L8", "mono8", 64)]


@pytest.mark.parametrize(("format", "encoding", "step"), FORMATS)
def test_pictures_have_the_format_of_the_camera(watch, format, encoding, step):
    (image,) = watch(MAST.format("0 0 0.5 0 0 0", CAMERA.format(format, 0.0)), (Image, "/eye/image_raw"))
    assert (image.encoding, image.step, len(image.data)) == (encoding, step, 48 * step)


def test_a_camera_s_noise_is_in_its_pictures(watch):
    (image,) = watch(MAST.format("0 0 0.5 0 0 0", CAMERA.format("L8", 0.04)), (Image, "/eye/image_raw"))
    rows = np.asarray(image.data, float).reshape(48, 64)
    assert 0.02 < np.median(np.abs(rows[2, :-1] - rows[2, 1:])) / 255 < 0.1


def test_what_a_plugin_cannot_do_here_is_listed():
    drive = """<model name='m'><link name='l'/><joint name='a' type='revolute'/><joint name='b' type='revolute'/>
    <plugin name='d' filename='libgazebo_ros_diff_drive.so'><left_joint>a</left_joint><right_joint>b</right_joint>
    <publish_wheel_tf>true</publish_wheel_tf></plugin></model>"""
    notes = read_entity(f"<sdf version='1.6'>{drive}</sdf>").notes
    assert any("wheels' tf" in note for note in notes)
    notes = read_entity(f"<sdf version='1.6'>{MAST.format('0 0 0 0 0 0', CAMERA.format('BAYER_RGGB8', 0))}</sdf>").notes
    assert any("BAYER_RGGB8" in note for note in notes)


def test_a_depth_camera_measures_what_it_sees(watch):
    camera = CAMERA.format("R8G8B8", 0.0).replace("type='camera'", "type='depth'").replace(
        "<plugin name='eye' filename='libgazebo_ros_camera.so'/>",
        "<plugin name='eye' filename='libgazebo_ros_camera.so'><camera_name>kinect</camera_name><max_depth>2.6</max_depth>"
        "<frame_name>eye_optical</frame_name></plugin>",
    )
    image, depth, info, cloud = watch(
        MAST.format("0 0 0.5 0 0 0", camera), (Image, "/kinect/image_raw"), (Image, "/kinect/depth/image_raw"),
        (CameraInfo, "/kinect/depth/camera_info"), (PointCloud2, "/kinect/points"),
    )  # fmt: skip
    rows = np.frombuffer(depth.data, np.float32).reshape(48, 64)
    assert (depth.encoding, depth.header.frame_id, image.encoding) == ("32FC1", "eye_optical", "rgb8")
    assert rows[23, 32] == pytest.approx(2.5) and rows[47, 32] == pytest.approx(0.5 * info.k[0] / 23.5, rel=0.05)
    assert np.isnan(rows[0, 0]) or rows[0, 0] == pytest.approx(2.5)
    points = read_points(cloud, ("x", "y", "z")).reshape(48, 64)
    assert points["z"][23, 40] == pytest.approx(2.5)
    assert points["x"][23, 40] == pytest.approx(2.5 * 8.5 / info.k[0], rel=1e-3)
    assert (cloud.height, cloud.width, cloud.point_step) == (48, 64, 32)


@pytest.mark.parametrize(
    ("material", "wanted"),
    [
        ("<script><uri>file://media</uri><name>Gazebo/RedBright</name></script>", (255, 0, 0)),
        ("<ambient>0 0 0 1</ambient><diffuse>0 0.2 1 1</diffuse>", (0, 51, 255)),
        ("<diffuse>none at all</diffuse>", (224, 219, 204)),
    ],
)
def test_a_camera_sees_a_model_s_colour(watch, material, wanted):
    look = f"<visual name='v'><geometry><box><size>1 9 2</size></box></geometry><material>{material}</material></visual>"
    body = MAST.format("0 0 0.5 0 0 0", CAMERA.format("R8G8B8", 0.0))
    front = WALL.replace("name='wall'", "name='front'").replace("3 0 1 0 0 0", "2 0 1 0 0 0")
    (image,) = watch(body + front.replace("</link>", look + "</link>"), (Image, "/eye/image_raw"))
    seen = np.asarray(image.data, float).reshape(48, 64, 3)[20, 30]
    assert seen / seen.max() == pytest.approx(np.array(wanted) / max(wanted), abs=0.05)


def test_two_eyes_of_one_sensor_publish_their_own_pictures():
    camera = """<camera name='{}'><pose>0 {} 0 0 0 0</pose><horizontal_fov>1.3</horizontal_fov><image><width>64</width>
    <height>48</height></image></camera>"""
    sensor = "<sensor name='stereo' type='multicamera'>{}<plugin name='eyes' filename='{}'><ros>"
    sensor += "<namespace>/r1</namespace></ros><frame_name>optical</frame_name></plugin></sensor>"
    cameras = camera.format("left", 0) + camera.format("right", -0.07)
    sensor = sensor.format(cameras, "libgazebo_ros_camera.so")
    left, right = read_entity(f"<sdf version='1.6'><model name='m'><link name='l'>{sensor}</link></model></sdf>").devices
    assert (left.topic, right.topic) == ("/r1/stereo/left/image_raw", "/r1/stereo/right/image_raw")
    assert left.info_topic == "/r1/stereo/left/camera_info" and (left.width, left.frame) == (64, "optical")
    assert right.pose[1, 3] - left.pose[1, 3] == pytest.approx(-0.07)
    assert type(left).__name__ == "CameraDevice"
