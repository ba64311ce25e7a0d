"""Transforms of point clouds; importing this package registers PointCloud2 with tf2_ros."""

from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import PointCloud2, PointField

from tf2_sensor_msgs.tf2_sensor_msgs import do_transform_cloud, from_msg_msg, to_msg_msg, transform_points

__all__ = [
    "PointCloud2",
    "PointField",
    "TransformStamped",
    "do_transform_cloud",
    "from_msg_msg",
    "to_msg_msg",
    "transform_points",
]
