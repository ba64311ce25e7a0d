"""sensor_msgs_py.point_cloud2: clouds as numpy arrays."""

import numpy as np
import pytest
from sensor_msgs.msg import PointField
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header

POINTS = np.array([[0.0, 1.0, 2.0], [3.0, np.nan, 5.0], [6.0, 7.0, 8.0]], dtype=np.float32)


@pytest.fixture
def cloud():
    return point_cloud2.create_cloud_xyz32(Header(frame_id="lidar"), POINTS)


def test_a_cloud_has_the_layout_of_its_fields(cloud):
    assert (cloud.height, cloud.width, cloud.point_step, cloud.row_step) == (1, 3, 12, 36)
    assert [(f.name, f.offset, f.datatype, f.count) for f in cloud.fields] == [
        ("x", 0, PointField.FLOAT32, 1),
        ("y", 4, PointField.FLOAT32, 1),
        ("z", 8, PointField.FLOAT32, 1),
    ]


def test_points_come_back(cloud):
    assert np.array_equal(point_cloud2.read_points_numpy(cloud), POINTS, equal_nan=True)
    assert point_cloud2.read_points(cloud)["z"].tolist() == [2.0, 5.0, 8.0]


def test_nan_points_can_be_skipped_and_fields_and_points_chosen(cloud):
    assert len(point_cloud2.read_points(cloud, skip_nans=True)) == 2
    assert point_cloud2.read_points_numpy(cloud, ["z", "x"], uvs=[2]).tolist() == [[8.0, 6.0]]
    assert point_cloud2.read_points_list(cloud, ["x"])[2].x == 6.0


def test_fields_of_different_types_are_possible():
    fields = [
        PointField(name="x", offset=0, datatype=PointField.FLOAT64, count=1),
        PointField(name="id", offset=8, datatype=PointField.UINT16, count=2),
    ]
    dtype = point_cloud2.dtype_from_fields(fields)
    points = np.array([(1.5, 2, 3)], dtype=dtype)
    again = point_cloud2.read_points(point_cloud2.create_cloud(Header(), fields, points))
    assert again.dtype.names == ("x", "id_0", "id_1") and again[0].tolist() == (1.5, 2, 3)


def test_a_wrong_argument_is_refused(cloud):
    with pytest.raises(AssertionError, match="not a sensor_msgs"):
        point_cloud2.read_points("cloud")
    with pytest.raises(AssertionError):
        point_cloud2.read_points(cloud, ["w"])


def test_fields_of_one_type_are_read_as_numbers_beside_others():
    fields = [
        PointField(name="x", offset=0, datatype=PointField.FLOAT32, count=1),
        PointField(name="id", offset=4, datatype=PointField.UINT8, count=1),
    ]
    cloud = point_cloud2.create_cloud(Header(), fields, np.array([(1.5, 2)], dtype=point_cloud2.dtype_from_fields(fields)))
    assert point_cloud2.read_points_numpy(cloud, ["x"]).tolist() == [[1.5]]
    with pytest.raises(AssertionError, match="same datatype"):
        point_cloud2.read_points_numpy(cloud)


def test_a_cube_of_numbers_is_an_organized_cloud(cloud):
    cube = np.arange(18, dtype=np.float32).reshape(2, 3, 3)
    organized = point_cloud2.create_cloud_xyz32(Header(), cube)
    assert (organized.height, organized.width, organized.row_step) == (3, 2, 24)
    assert np.array_equal(point_cloud2.read_points_numpy(organized), cube.reshape(-1, 3))


def test_longer_records_stay_long_unless_a_step_says_otherwise(cloud):
    layout = {"names": ["x", "y", "z"], "formats": ["f4"] * 3, "offsets": [0, 4, 8], "itemsize": 20}
    records = np.array([(1.0, 2.0, 3.0)], dtype=np.dtype(layout))
    assert point_cloud2.create_cloud(Header(), cloud.fields, records).point_step == 20
    assert point_cloud2.create_cloud(Header(), cloud.fields, records, 20).point_step == 20
    with pytest.raises(AssertionError):
        point_cloud2.create_cloud(Header(), cloud.fields, records, 12)
