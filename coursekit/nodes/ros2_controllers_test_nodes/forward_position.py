"""`ros2 run ros2_controllers_test_nodes publisher_forward_position_controller`: positions in turn, one set at a time."""

from __future__ import annotations

from typing import Any

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node
from std_msgs.msg import Float64MultiArray

from coursekit.nodes.running import run


class PublisherForwardPosition(Node):
    """Publishes the goals in its parameters, one each `wait_sec_between_publish` seconds.

    Exception for a goal without values.
    """

    def __init__(self) -> None:
        super().__init__("publisher_forward_position_controller")
        topic = self.declare_parameter("publish_topic", "/position_commands").value
        period = self.declare_parameter("wait_sec_between_publish", 5).value
        names = self.declare_parameter("goal_names", ["pos1", "pos2"]).value
        self._goals = [self._goal(name) for name in names]
        self._next = 0
        self.get_logger().info(f'Publishing {len(names)} goals on topic "{topic}" every {period} s')
        self._out = self.create_publisher(Float64MultiArray, topic, 1)
        self.create_timer(period, self._send)

    def _goal(self, name: str) -> list[float]:
        values: Any = self.declare_parameter(name, descriptor=ParameterDescriptor(dynamic_typing=True)).value
        if not values:
            raise Exception(f'Values for goal "{name}" not set!')
        return [float(value) for value in values]

    def _send(self) -> None:
        msg = Float64MultiArray(data=self._goals[self._next])
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self._out.publish(msg)
        self._next = (self._next + 1) % len(self._goals)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(PublisherForwardPosition, args)
