"""`ros2 run twist_mux twist_marker`: a velocity as an arrow."""

from __future__ import annotations

from geometry_msgs.msg import Point, Twist, TwistStamped
from rclpy.node import Node
from visualization_msgs.msg import Marker

from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.running import run


class TwistMarker(Node):
    """Subscribes to `twist` and publishes an arrow above the robot on `marker`."""

    def __init__(self) -> None:
        super().__init__("twist_marker")
        given = declare(self, {"frame_id": "base_footprint", "scale": 1.0, "use_stamped": False, "vertical_position": 2.0})
        self._frame, self._scale, self._height = given["frame_id"], given["scale"], given["vertical_position"]
        self._out = self.create_publisher(Marker, "marker", 1)
        if given["use_stamped"]:
            self.create_subscription(TwistStamped, "twist", lambda msg: self._hear(msg.twist), 1)
        else:
            self.create_subscription(Twist, "twist", self._hear, 1)

    def _hear(self, msg: Twist) -> None:
        arrow = Marker(type=Marker.ARROW, action=Marker.MODIFY, frame_locked=True)
        arrow.header.frame_id, arrow.header.stamp = self._frame, self.get_clock().now().to_msg()
        arrow.pose.orientation.w = 1.0
        arrow.scale.x, arrow.scale.y = 0.05 * self._scale, 2 * 0.05 * self._scale
        arrow.color.a = arrow.color.r = 1.0
        tip = Point(x=self._scale * msg.linear.x, y=self._scale * msg.angular.z, z=self._height)
        arrow.points = [Point(z=self._height), tip]
        self._out.publish(arrow)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(TwistMarker, args)
