"""Transforms of many points at once."""

from __future__ import annotations

from typing import Any

import numpy as np
from geometry_msgs.msg import Transform, TransformStamped
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py.point_cloud2 import create_cloud, read_points
from tf2_geometry_msgs.tf2_geometry_msgs import _numbers, from_msg_msg, to_msg_msg
from tf2_ros import ConvertRegistration, TransformRegistration

from coursekit.geometry.pose import matrix


def transform_points(point_cloud: Any, transform: Transform | TransformStamped) -> np.ndarray[Any, Any]:
    """Transform points given as rows of x, y, z (n x 3)."""
    motion = transform.transform if isinstance(transform, TransformStamped) else transform
    homogeneous = np.array(matrix(_numbers(motion.translation, motion.rotation)))
    return np.asarray(point_cloud) @ homogeneous[:3, :3].T + homogeneous[:3, 3]


def do_transform_cloud(cloud: PointCloud2, transform: Transform | TransformStamped) -> PointCloud2:
    """The cloud in the transform's frame; other fields than x, y and z are unchanged."""
    points = read_points(cloud).copy()
    places = np.stack([points[axis] for axis in "xyz"], axis=-1)
    for axis, column in zip("xyz", transform_points(places, transform).T, strict=True):
        points[axis] = column
    header = transform.header if isinstance(transform, TransformStamped) else cloud.header
    result = create_cloud(header, cloud.fields, points, point_step=cloud.point_step)
    result.height, result.width, result.row_step = cloud.height, cloud.width, cloud.row_step
    result.is_dense, result.is_bigendian = cloud.is_dense, result.is_bigendian
    return result


TransformRegistration().add(PointCloud2, do_transform_cloud)
ConvertRegistration().add_to_msg(PointCloud2, to_msg_msg)
ConvertRegistration().add_from_msg(PointCloud2, from_msg_msg)
