"""`ros2 run image_transport republish IN [OUT]`: republishes images from topic `in` on `out` in other transports."""

from __future__ import annotations

import sys
from typing import Any

import rclpy
from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from sensor_msgs.msg import Image

from coursekit.nodes.images.transport import JPEG_QUALITY, PNG_LEVEL, TRANSPORTS, compress, decompress, topic_of
from coursekit.nodes.running import spin_to_the_end

USAGE = "Usage: republish IN_TRANSPORT [OUT_TRANSPORT] --ros-args -r in:=TOPIC -r out:=TOPIC (raw, compressed)"


class Republisher(Node):
    """Subscribes to one transport of `in` and publishes one of `out`, or all of them."""

    def __init__(self, source: str, target: str | None) -> None:
        super().__init__("image_republisher")
        self._outputs = {
            transport: self.create_publisher(TRANSPORTS[transport], topic_of("out", transport), 1)
            for transport in TRANSPORTS
            if target in (None, transport)
        }
        base = self.resolve_topic_name("out").strip("/").replace("/", ".")
        self._format = self.declare_parameter(f"{base}.format", "jpeg")
        self._quality = self.declare_parameter(f"{base}.jpeg_quality", JPEG_QUALITY)
        self._level = self.declare_parameter(f"{base}.png_level", PNG_LEVEL)
        self.create_subscription(TRANSPORTS[source], topic_of("in", source), self._pass, 1)

    def _pass(self, msg: Any) -> None:
        raw = msg if isinstance(msg, Image) else None
        for transport, publisher in self._outputs.items():
            if isinstance(msg, TRANSPORTS[transport]):
                publisher.publish(msg)
            elif transport == "raw":
                publisher.publish(decompress(msg))
            elif raw is not None:
                publisher.publish(compress(raw, *self._options()))

    def _options(self) -> tuple[str, int, int]:
        return tuple(self.get_parameter(parameter.name).value for parameter in (self._format, self._quality, self._level))


def main(args: list[str] | None = None) -> int:
    """Republish until Ctrl-C."""
    wanted = remove_ros_args(sys.argv if args is None else args)[1:]
    if not 1 <= len(wanted) <= 2 or any(transport not in TRANSPORTS for transport in wanted):
        print(USAGE, file=sys.stderr)
        return 1
    rclpy.init(args=args)
    node = Republisher(wanted[0], wanted[1] if len(wanted) > 1 else None)
    return spin_to_the_end(node)


def list_transports() -> None:
    """Print the available transports."""
    print("Declared transports:")
    for name in sorted(TRANSPORTS):
        print(f"image_transport/{name}")
    print("\nDetails:\n----------")
    for name, type_ in sorted(TRANSPORTS.items()):
        print(f'"image_transport/{name}"\n - Provided by package: image_transport')
        print(f" - Publishes {type_._TYPE_NAME} on {topic_of('<image topic>', name)}")
