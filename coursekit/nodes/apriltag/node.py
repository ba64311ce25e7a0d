"""`ros2 run apriltag_ros apriltag_node`, also AprilTagNode: publishes the tags of image_rect on detections and tf.

`detector.threads`, `decimate`, `sharpening` and `debug` belong to the AprilTag library and change nothing here: OpenCV
looks for the tags in the whole image.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from apriltag_msgs.msg import AprilTagDetection, AprilTagDetectionArray, Point
from cv_bridge import CvBridge, CvBridgeError
from geometry_msgs.msg import TransformStamped
from message_filters import Subscriber, TimeSynchronizer
from rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_sensor_data
from scipy.spatial.transform import Rotation
from sensor_msgs.msg import CameraInfo, CompressedImage, Image
from tf2_ros import TransformBroadcaster

from coursekit.nodes.apriltag.detector import Detector, Tag
from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.images.transport import decompress, topic_of
from coursekit.nodes.running import run

_FIXED: dict[str, Any] = {"image_transport": "raw", "family": "36h11", "size": 1.0, "pose_estimation_method": "pnp"}
_LISTS = ("tag.ids", "tag.frames", "tag.sizes")
_CHANGEABLE: dict[str, Any] = {
    "detector.threads": 1, "detector.decimate": 2.0, "detector.blur": 0.0, "detector.refine": True,
    "detector.sharpening": 0.25, "detector.debug": False, "max_hamming": 0, "profile": False,
}  # fmt: skip


class AprilTagNode(CppNode):
    """With tag.ids and tag.frames, only those are published. ValueError for parameters that do not fit together."""

    def __init__(self) -> None:
        super().__init__("apriltag")
        fixed = ParameterDescriptor(read_only=True)
        lists = ParameterDescriptor(read_only=True, dynamic_typing=True)
        self._given = {name: self.declare_parameter(name, default, fixed).value for name, default in _FIXED.items()}
        ids, frames, sizes = (list(self.declare_parameter(name, [], lists).value) for name in _LISTS)
        for what, given in (("frames", frames), ("sizes", sizes)):
            if given and len(given) != len(ids):
                raise ValueError(f"Number of tag ids ({len(ids)}) and {what} ({len(given)}) mismatch!")
        self._frames, self._sizes = dict(zip(ids, frames, strict=False)), dict(zip(ids, sizes, strict=False))
        self._given |= {name: self.declare_parameter(name, default).value for name, default in _CHANGEABLE.items()}
        self.add_on_set_parameters_callback(self._change)
        self._detector = Detector(self._given["family"])
        self._bridge, self._broadcaster = CvBridge(), TransformBroadcaster(self)
        self._out = self.create_publisher(AprilTagDetectionArray, "detections", 1)
        transport = self._given["image_transport"]
        kind = Image if transport == "raw" else CompressedImage
        inputs = ((kind, topic_of("image_rect", transport)), (CameraInfo, "camera_info"))
        filters = [
            Subscriber(self, message_type, topic, qos_profile=qos_profile_sensor_data) for message_type, topic in inputs
        ]
        self._together = TimeSynchronizer(filters, 10)
        self._together.registerCallback(self._look)

    def _change(self, parameters: list[Parameter]) -> SetParametersResult:
        self._given |= {parameter.name: parameter.value for parameter in parameters}
        return SetParametersResult(successful=True)

    def _look(self, image: Any, info: CameraInfo) -> None:
        try:
            grey = self._bridge.imgmsg_to_cv2(image if isinstance(image, Image) else decompress(image), "mono8")
        except CvBridgeError as fault:
            self.get_logger().error(f"cv_bridge exception: {fault}", throttle_duration_sec=5.0)
            return
        given = self._given
        tags = self._detector.find(
            grey, most=given["max_hamming"], blur=given["detector.blur"], refine=given["detector.refine"]
        )
        tags = [tag for tag in tags if not self._frames or tag.id in self._frames]
        family = f"tag{given['family']}"
        self._out.publish(AprilTagDetectionArray(header=image.header, detections=[_detection(tag, family) for tag in tags]))
        camera = np.asarray(info.p, float).reshape(3, 4)[:, :3]
        if camera[0, 0] > 0:
            self._broadcaster.sendTransform([self._transform(tag, family, camera, image.header) for tag in tags])

    def _transform(self, tag: Tag, family: str, camera: np.ndarray, header: Any) -> TransformStamped:
        turn, place = tag.pose(self._sizes.get(tag.id, self._given["size"]), camera)
        msg = TransformStamped(header=header, child_frame_id=self._frames.get(tag.id, f"{family}:{tag.id}"))
        at, q = msg.transform.translation, msg.transform.rotation
        at.x, at.y, at.z = map(float, place)
        q.x, q.y, q.z, q.w = map(float, Rotation.from_rotvec(turn).as_quat())
        return msg


def _detection(tag: Tag, family: str) -> AprilTagDetection:
    msg = AprilTagDetection(family=family, id=tag.id, hamming=tag.hamming, decision_margin=tag.margin)
    msg.centre.x, msg.centre.y = map(float, tag.centre)
    msg.corners = [Point(x=float(x), y=float(y)) for x, y in tag.corners]
    msg.homography = tag.homography.ravel()
    return msg


def main(args: list[str] | None = None) -> int:
    """Look for tags until Ctrl-C."""
    return run(AprilTagNode, args, refuses=(ValueError,))
