"""Waves as a point cloud, for the viewer."""

import numpy
from rclpy.node import Node
from sensor_msgs.msg import PointCloud2, PointField
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header

from coursekit.nodes.running import run

_FIELDS = [
    PointField(name=name, offset=4 * at, datatype=PointField.FLOAT32, count=1)
    for at, name in enumerate(("x", "y", "z", "intensity"))
]


class PointCloudPublisher(Node):
    """Publishes 100 by 100 points of a wave [m] on /test_cloud, 30 times a second, in the frame map."""

    def __init__(self) -> None:
        super().__init__("pc_publisher")
        self._count = 0
        self._plane = numpy.meshgrid(numpy.linspace(-2, 2, 100), numpy.linspace(-2, 2, 100))
        self._publisher = self.create_publisher(PointCloud2, "test_cloud", 10)
        self._timer = self.create_timer(1 / 30, self._publish)

    def _publish(self) -> None:
        x, y = self._plane
        z = 0.5 * numpy.sin(2 * x - self._count / 10.0) * numpy.sin(2 * y)
        points = numpy.array([x, y, z, z]).reshape(4, -1).T
        header = Header(stamp=self.get_clock().now().to_msg(), frame_id="map")
        self._publisher.publish(point_cloud2.create_cloud(header, _FIELDS, points))
        self._count += 1


def main(args: list[str] | None = None) -> int:
    """Publish until Ctrl-C."""
    return run(PointCloudPublisher, args)
