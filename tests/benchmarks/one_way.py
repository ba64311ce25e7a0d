"""`hear KIND COUNT` or `say KIND COUNT`: one end of a topic, by the same code on ours and on the real rclpy.

Both ends are processes of one computer, whose monotonic clock they share. `hear` prints how long messages took [µs, median].
"""

import array
import json
import statistics
import sys
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor
from sensor_msgs.msg import Image
from std_msgs.msg import String

RATES = {"string": 200.0, "image": 30.0}
"""Messages a second."""
LIMIT_S = 60.0


def made(kind: str) -> object:
    """A message as the course sends them."""
    if kind == "string":
        return String()
    return Image(height=480, width=640, encoding="bgr8", step=1920, data=array.array("B", bytes(640 * 480 * 3)))


def stamp(msg: object, time_ns: int) -> None:
    """Write the time into the message."""
    if isinstance(msg, String):
        msg.data = str(time_ns)
    else:
        msg.header.frame_id = str(time_ns)


def hear(kind: str, count: int) -> float:
    """The median of `count` messages."""
    node, times = rclpy.create_node("ears"), []

    def take(msg: object) -> None:
        now = time.monotonic_ns()
        times.append(now - int(msg.data if isinstance(msg, String) else msg.header.frame_id))

    node.create_subscription(type(made(kind)), "bench", take, 10)
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    give_up = time.monotonic() + LIMIT_S
    while len(times) < count and time.monotonic() < give_up:
        executor.spin_once(timeout_sec=1.0)
    return statistics.median(times[len(times) // 4 :]) / 1000  # the first ones find each other


def say(kind: str, count: int) -> None:
    """Publish until somebody has heard enough and is gone."""
    node, msg = rclpy.create_node("mouth"), made(kind)
    publisher = node.create_publisher(type(msg), "bench", 10)
    give_up = time.monotonic() + LIMIT_S
    while publisher.get_subscription_count() < 1 and time.monotonic() < give_up:
        time.sleep(0.05)
    while publisher.get_subscription_count() and time.monotonic() < give_up:
        stamp(msg, time.monotonic_ns())
        publisher.publish(msg)
        time.sleep(1 / RATES[kind])


def main() -> None:
    """Be one end."""
    role, kind, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
    rclpy.init(args=[])
    if role == "hear":
        print(json.dumps(hear(kind, count)), flush=True)
    else:
        say(kind, count)
    rclpy.shutdown()


if __name__ == "__main__":
    main()
