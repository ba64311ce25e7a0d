"""Publish to callback, by the same code on ours and on the real rclpy; prints JSON (microseconds, median)."""

import array
import json
import statistics
import sys
import time

import rclpy
from rclpy.executors import SingleThreadedExecutor
from sensor_msgs.msg import Image
from std_msgs.msg import String


def latency(nodes: int, msg: object, count: int) -> float:
    """Median time from `publish` to the callback, both ends in one executor that serves `nodes` nodes."""
    executor = SingleThreadedExecutor()
    bench_nodes = [rclpy.create_node(f"bench_{number}") for number in range(nodes)]
    for node in bench_nodes:
        executor.add_node(node)
    times: list[int] = []
    begun = [0]
    publisher = bench_nodes[0].create_publisher(type(msg), "bench", 10)
    bench_nodes[-1].create_subscription(type(msg), "bench", lambda _: times.append(time.perf_counter_ns() - begun[0]), 10)
    while publisher.get_subscription_count() < 1:
        executor.spin_once(timeout_sec=0.1)
    for index in range(count):
        begun[0] = time.perf_counter_ns()
        publisher.publish(msg)
        while len(times) <= index:
            executor.spin_once(timeout_sec=1.0)
    for node in bench_nodes:
        executor.remove_node(node)
        node.destroy_node()
    return statistics.median(times) / 1000


def main() -> None:
    """Measure and print."""
    rclpy.init(args=[])
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 2000
    text = String(data="Hello World: 1")
    image = Image(height=480, width=640, encoding="bgr8", step=1920, data=array.array("B", bytes(640 * 480 * 3)))
    result = {f"string_{nodes}": latency(nodes, text, count) for nodes in (2, 20, 200)}
    result["image"] = latency(2, image, 200)
    print(json.dumps(result))
    rclpy.shutdown()


if __name__ == "__main__":
    main()
