"""`buffer_server`: a buffer that other nodes query with the action tf2_buffer_server."""

from __future__ import annotations

import sys

import rclpy
from rclpy.duration import Duration
from tf2_ros import Buffer, BufferServer, TransformListener

from coursekit.nodes.running import to_the_end


def main() -> int:
    """Serve until Ctrl-C; the parameter buffer_size is the history in seconds."""
    rclpy.init(args=sys.argv)
    node = rclpy.create_node("tf_buffer")
    seconds = node.declare_parameter("buffer_size", 120.0).value
    buffer = Buffer(Duration(seconds=seconds), node)
    listener = TransformListener(buffer, node)
    server = BufferServer(buffer, node, "tf2_buffer_server")
    with to_the_end(node):
        try:
            rclpy.spin(node)
        finally:
            server.server.destroy()
            listener.unregister()
    return 0
