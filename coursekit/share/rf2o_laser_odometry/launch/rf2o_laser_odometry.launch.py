"""Odometry from the scans of /scan, on /odom_rf2o."""

from launch import LaunchDescription
from launch_ros.actions import Node

PARAMETERS = {
    "laser_scan_topic": "/scan",
    "odom_topic": "/odom_rf2o",
    "publish_tf": True,
    "base_frame_id": "base_link",
    "odom_frame_id": "odom",
    "init_pose_from_topic": "",
    "freq": 20.0,
}


def generate_launch_description():
    """Return the node."""
    return LaunchDescription(
        [
            Node(
                package="rf2o_laser_odometry",
                executable="rf2o_laser_odometry_node",
                name="rf2o_laser_odometry",
                output="screen",
                parameters=[PARAMETERS],
            ),
        ]
    )
