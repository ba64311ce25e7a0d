"""The messages of navsat_transform_node."""

from __future__ import annotations

import numpy as np
from geometry_msgs.msg import Point
from nav_msgs.msg import Odometry
from sensor_msgs.msg import NavSatFix, NavSatStatus

from coursekit.geometry.pose import inverse
from coursekit.nodes.robot_localization.datum import Bridge
from coursekit.nodes.robot_localization.geometry import square, turned, turning


def odometry(where: Point, fix: NavSatFix, bridge: Bridge, frame: str) -> Odometry:
    """A fix as a position in the world, with the receiver's covariance."""
    msg, sure = Odometry(), np.zeros((6, 6))
    msg.header.frame_id, msg.header.stamp = frame, fix.header.stamp
    msg.pose.pose.position = where
    sure[:3, :3] = turned(square(fix.position_covariance), turning(bridge.pose))
    msg.pose.covariance = sure.ravel()
    return msg


def filtered(heard: Odometry, bridge: Bridge) -> NavSatFix:
    """The filter's estimate of the robot's position on the Earth."""
    where, msg = heard.pose.pose.position, NavSatFix()
    msg.latitude, msg.longitude, msg.altitude = bridge.to_earth((where.x, where.y, where.z))
    back = turning(inverse(bridge.pose))
    msg.position_covariance = turned(square(heard.pose.covariance)[:3, :3], back).ravel()
    msg.position_covariance_type = NavSatFix.COVARIANCE_TYPE_KNOWN
    msg.status.status = NavSatStatus.STATUS_GBAS_FIX
    msg.header.frame_id, msg.header.stamp = "gps", heard.header.stamp
    return msg
