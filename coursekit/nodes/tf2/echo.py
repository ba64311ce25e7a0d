"""`tf2_echo`: print a transform periodically."""

from __future__ import annotations

import math
import sys

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.executors import ExternalShutdownException
from rclpy.time import Time
from rclpy.utilities import remove_ros_args
from tf2_ros import Buffer, TransformException, TransformListener
from tf_transformations import euler_from_quaternion

from coursekit.geometry.pose import matrix
from coursekit.processes.session import current
from coursekit.tf.errors import seconds_text

USAGE = """\
Usage: tf2_echo source_frame target_frame [echo_rate] [precision]

Prints the transform from source_frame to target_frame: it takes data in target_frame into source_frame.
Default echo rate is 1 if echo_rate is not given.
Default precision is 3 digits after the point."""


def described(found: TransformStamped, precision: int = 3) -> str:
    """A transform as tf2_echo prints it."""

    def numbers(*values: float) -> str:
        return "[" + ", ".join(f"{value:.{precision}f}" for value in values) + "]"

    t, q, stamp = found.transform.translation, found.transform.rotation, found.header.stamp
    angles = euler_from_quaternion((q.x, q.y, q.z, q.w))
    rows = matrix((t.x, t.y, t.z, q.x, q.y, q.z, q.w))
    lines = [
        f"At time {stamp.sec}.{stamp.nanosec}",
        f"- Translation: {numbers(t.x, t.y, t.z)}",
        f"- Rotation: in Quaternion {numbers(q.x, q.y, q.z, q.w)}",
        f"- Rotation: in RPY (radian) {numbers(*angles)}",
        f"- Rotation: in RPY (degree) {numbers(*(math.degrees(angle) for angle in angles))}",
        "- Matrix:",
        *("".join(f"{value:{precision + 4}.{precision}f}" for value in row) for row in rows),
    ]
    return "\n".join(lines)


def main() -> int:
    """Print until Ctrl-C."""
    rclpy.init(args=sys.argv)
    args = remove_ros_args(sys.argv)[1:]
    if not 2 <= len(args) <= 4:
        print(USAGE)
        return 255
    node = rclpy.create_node("tf2_echo")
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node, spin_thread=True)
    try:
        _echo(node, buffer, *args)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        listener.unregister()
        rclpy.try_shutdown()
    return 0


def _echo(node: rclpy.node.Node, buffer: Buffer, source: str, target: str, rate: str = "1", precision: str = "3") -> None:
    clock, period = current().clock, 1.0 / float(rate)
    while rclpy.ok():
        can, why = buffer.can_transform_core(source, target, Time())
        if can:
            break
        node.get_logger().info(f"Waiting for transform {source} ->  {target}: {why}", throttle_duration_sec=1.0)
        clock.sleep(period)
    while rclpy.ok():
        try:
            print(described(buffer.lookup_transform(source, target, Time()), int(precision)), flush=True)
        except TransformException as error:
            now = seconds_text(node.get_clock().now().nanoseconds)
            frames = buffer.all_frames_as_string()
            print(f"Failure at {now}\nException thrown:{error}\nThe current list of frames is:\n{frames}", flush=True)
        clock.sleep(period)
