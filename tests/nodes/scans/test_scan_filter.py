"""Scans wait for their transforms."""

import pytest
import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from sensor_msgs.msg import LaserScan

from coursekit.nodes.scanning.scan_filter import ScanFilter, WakingBuffer
from coursekit.processes.session import Session


@pytest.fixture
def node():
    with Session(virtual=True).use():
        rclpy.init()
        yield Node("listener")
        rclpy.shutdown()


def test_several_wait_on_one_buffer(node):
    buffer, heard = WakingBuffer(node=node), []
    ways = [lambda _scan: heard.append("slam"), lambda _scan: heard.append("costmap")]
    filters = [ScanFilter(node, buffer, "odom", 5, way) for way in ways]
    scan = LaserScan()
    scan.header.frame_id = "laser"
    for scan_filter in filters:
        scan_filter.add(scan)
    assert heard == []
    transform = TransformStamped(child_frame_id="laser")
    transform.header.frame_id = "odom"
    buffer.set_transform_static(transform, "test")
    assert heard == ["slam", "costmap"]
