"""`ros2 run depthimage_to_laserscan depthimage_to_laserscan_node`: the middle rows of a depth image as a scan."""

from __future__ import annotations

import numpy as np
from cv_bridge import CvBridge, CvBridgeError
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CameraInfo, Image, LaserScan

from coursekit.nav.scans.making import angles_of_image, floats, of_depth
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run

_DEFAULTS = {
    "scan_time": 0.033, "range_min": 0.45, "range_max": 10.0, "scan_height": 1, "output_frame": "camera_depth_frame",
}  # fmt: skip


class DepthImageToLaserScan(Node):
    """`depth` and `depth_camera_info` in, `scan` out."""

    def __init__(self) -> None:
        super().__init__("depthimage_to_laserscan")
        self._given = declare(self, _DEFAULTS)
        self._info: CameraInfo | None = None
        self._bridge = CvBridge()
        self._out = self.create_publisher(LaserScan, "scan", 10)
        self.create_subscription(CameraInfo, "depth_camera_info", self._take_info, qos_profile_sensor_data)
        self.create_subscription(Image, "depth", self._hear, qos_profile_sensor_data)

    def _take_info(self, msg: CameraInfo) -> None:
        self._info = msg

    def _hear(self, msg: Image) -> None:
        if self._info is None:
            self.get_logger().info("No camera info, skipping point cloud squash", throttle_duration_sec=5.0)
            return
        try:
            self._out.publish(self._scan(msg, self._info))
        except (CvBridgeError, ValueError) as fault:
            self.get_logger().error(f"Could not convert depth image to laserscan: {fault}", throttle_duration_sec=1.0)

    def _scan(self, msg: Image, info: CameraInfo) -> LaserScan:
        given, (fx, cx, cy) = self._given, (info.k[0], info.k[2], info.k[5])
        if msg.encoding not in ("16UC1", "mono16", "32FC1"):
            raise ValueError(f"Depth image has unsupported encoding: {msg.encoding}")
        if not fx > 0 or msg.width < 2:
            raise ValueError(f"the camera's focal length is {fx} and the image {msg.width} wide: check depth_camera_info")
        if not 0 < given["scan_height"] <= msg.height:
            raise ValueError(f"scan_height ( {given['scan_height']} pixels) is too large for the image height.")
        depth = np.asarray(self._bridge.imgmsg_to_cv2(msg), float)
        metres = depth if msg.encoding == "32FC1" else np.where(depth > 0, depth * 1e-3, np.nan)
        limits = (given["range_min"], given["range_max"])
        scan = LaserScan(header=msg.header, scan_time=given["scan_time"], range_min=limits[0], range_max=limits[1])
        scan.header.frame_id = given["output_frame"]
        scan.angle_min, scan.angle_max, scan.angle_increment = angles_of_image(msg.width, fx, cx)
        scan.ranges = floats(of_depth(metres, fx, cx, given["scan_height"], cy, limits))
        return scan


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(DepthImageToLaserScan, args)
