"""do_transform_*: what is moved, what is only turned, and covariances."""

import numpy as np
import pytest
import tf2_geometry_msgs as tgm
from geometry_msgs.msg import (
    Point32,
    PointStamped,
    PolygonStamped,
    Pose,
    PoseStamped,
    PoseWithCovarianceStamped,
    Quaternion,
    Transform,
    TransformStamped,
    Vector3Stamped,
    WrenchStamped,
)
from sensor_msgs.msg import PointField
from sensor_msgs_py.point_cloud2 import create_cloud, create_cloud_xyz32, read_points, read_points_numpy
from std_msgs.msg import Header
from tf2_ros import Buffer
from tf2_sensor_msgs import do_transform_cloud, transform_points


def transform(x=1.0, y=2.0, z=3.0, w=1.0):
    msg = TransformStamped(child_frame_id="child")
    msg.header.frame_id = "map"
    t = msg.transform.translation
    t.x, t.y, t.z = x, y, z
    msg.transform.rotation = Quaternion(x=0.0, y=0.0, z=0.0, w=w)
    return msg


def half_turn():
    """Half a turn about x, beside (1, 2, 3)."""
    msg = transform()
    msg.transform.rotation = Quaternion(x=1.0, y=0.0, z=0.0, w=0.0)
    return msg


def xyz(thing):
    return thing.x, thing.y, thing.z


def test_a_point_is_turned_and_moved():
    point = PointStamped()
    point.point.x, point.point.y, point.point.z = 1.0, 2.0, 3.0
    out = tgm.do_transform_point(point, half_turn())
    assert xyz(out.point) == (2.0, 0.0, 0.0) and out.header.frame_id == "map"
    assert xyz(point.point) == (1.0, 2.0, 3.0)


def test_a_vector_is_turned_only_and_the_transform_stays():
    vector, motion = Vector3Stamped(), half_turn()
    vector.vector.y = 1.0
    assert xyz(tgm.do_transform_vector3(vector, motion).vector) == (0.0, -1.0, 0.0)
    assert motion == half_turn()


def pose():
    msg = Pose()
    msg.position.x, msg.position.y, msg.position.z = 1.0, 2.0, 3.0
    msg.orientation = Quaternion(x=1.0, y=0.0, z=0.0, w=0.0)
    return msg


def test_a_pose_is_turned_and_moved_in_all_its_forms():
    expected = ((2.0, 0.0, 0.0), (0.0, 0.0, 0.0), 1.0)

    def told(msg):
        return xyz(msg.position), xyz(msg.orientation), msg.orientation.w

    assert told(tgm.do_transform_pose(pose(), half_turn())) == expected
    stamped = PoseStamped(pose=pose())
    assert told(tgm.do_transform_pose_stamped(stamped, half_turn()).pose) == expected
    assert told(tgm.do_transform_pose(stamped, half_turn()).pose) == expected
    with_covariance = PoseWithCovarianceStamped()
    with_covariance.pose.pose = pose()
    out = tgm.do_transform_pose_with_covariance_stamped(with_covariance, half_turn())
    assert told(out.pose.pose) == expected and out.header.frame_id == "map"


def test_a_covariance_is_turned_block_by_block():
    covariance = np.tile(np.arange(1.0, 7.0), 6)
    rows = [[1.0, -2.0, -3.0, 4.0, -5.0, -6.0], [-1.0, 2.0, 3.0, -4.0, 5.0, 6.0], [-1.0, 2.0, 3.0, -4.0, 5.0, 6.0]]
    assert np.array_equal(tgm.transform_covariance(covariance, half_turn()), np.array(rows * 2).reshape(36))


def test_a_wrench_is_turned_and_a_polygon_moved():
    wrench = WrenchStamped()
    wrench.wrench.force.y = wrench.wrench.torque.z = 1.0
    out = tgm.do_transform_wrench(wrench, half_turn())
    assert xyz(out.wrench.force) == (0.0, -1.0, 0.0) and xyz(out.wrench.torque) == (0.0, 0.0, -1.0)
    polygon = PolygonStamped()
    polygon.polygon.points = [Point32(x=1.0, y=1.0, z=1.0)]
    assert xyz(tgm.do_transform_polygon_stamped(polygon, half_turn()).polygon.points[0]) == (2.0, 1.0, 2.0)


def test_a_quaternion_of_zeros_turns_nothing():
    point = PointStamped()
    assert xyz(tgm.do_transform_point(point, transform(w=0.0)).point) == (1.0, 2.0, 3.0)


def cloud(*columns, extra=()):
    fields = [
        PointField(name=name, offset=4 * place, datatype=PointField.FLOAT32, count=1)
        for place, name in enumerate(("x", "y", "z", *extra))
    ]
    return create_cloud(Header(frame_id="test"), fields, np.array(columns, dtype=np.float32))


def test_points_of_a_cloud_are_transformed():
    points = np.array([[1, 2, 0], [10, 20, 30]], dtype=np.float32)
    original = create_cloud_xyz32(Header(frame_id="test"), points)
    before = bytes(original.data)
    out = do_transform_cloud(original, half_turn())
    assert np.allclose(read_points_numpy(out), [[2, 0, 3], [11, -18, -27]])
    assert out.header.frame_id == "map" and bytes(original.data) == before
    assert np.allclose(transform_points(points, half_turn().transform), [[2, 0, 3], [11, -18, -27]])


def test_other_fields_of_a_cloud_stay():
    out = do_transform_cloud(cloud([1, 2, 3, 9], extra=("intensity",)), half_turn())
    assert read_points(out)["intensity"].tolist() == [9.0] and read_points(out)["x"].tolist() == [2.0]


def test_a_cloud_is_transformed_by_a_buffer():
    buffer = Buffer()
    motion = transform(0.0, 0.0, 100.0, w=1.0)
    motion.header.frame_id = "test"
    buffer.set_transform_static(motion, "me")
    out = buffer.transform(cloud([1, 2, 3]), "child")
    assert out.header.frame_id == "child" and np.allclose(read_points_numpy(out), [[1, 2, -97]])


@pytest.mark.parametrize("kind", [Transform, TransformStamped])
def test_points_take_both_kinds_of_transform(kind):
    assert transform_points([[1.0, 2.0, 3.0]], kind()).tolist() == [[1.0, 2.0, 3.0]]
