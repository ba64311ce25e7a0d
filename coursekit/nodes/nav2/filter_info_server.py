"""`ros2 run nav2_map_server costmap_filter_info_server`: tells costmap filters which mask to use, and how."""

from __future__ import annotations

from typing import Any

from nav2_msgs.msg import CostmapFilterInfo
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn

from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.running import Server, run

_SERVER: dict[str, Any] = {
    "filter_info_topic": "costmap_filter_info", "type": 0, "mask_topic": "filter_mask", "base": 0.0, "multiplier": 1.0,
}  # fmt: skip


class FilterInfoServer(Server):
    """Publishes one latched CostmapFilterInfo while active."""

    def __init__(self) -> None:
        super().__init__("costmap_filter_info_server")
        declare(self, _SERVER)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the topic; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring")
        try:
            given = declare(self, _SERVER)
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._out = self.create_lifecycle_publisher(CostmapFilterInfo, given["filter_info_topic"], MAP_QOS)
        self._msg = CostmapFilterInfo(
            type=given["type"], filter_mask_topic=given["mask_topic"], base=given["base"], multiplier=given["multiplier"]
        )
        self._msg.header.frame_id, self._msg.header.stamp = "map", self.get_clock().now().to_msg()
        return super().on_configure(state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Publish the message."""
        answer = super().on_activate(state)
        self._out.publish(self._msg)
        return answer

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Destroy the publisher."""
        self.destroy_lifecycle_publisher(self._out)
        return super().on_cleanup(state)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(FilterInfoServer, args)
