"""`view_frames`: listen for five seconds, then write the tree of frames as PDF and for Graphviz."""

from __future__ import annotations

import argparse
import sys
import time
from typing import TYPE_CHECKING, Any

import rclpy
import yaml
from rclpy.utilities import remove_ros_args
from tf2_msgs.srv import FrameGraph
from tf2_ros import Buffer, TransformListener
from tf2_ros.transform_listener import DEFAULT_STATIC_TF_TOPIC, DEFAULT_TF_TOPIC

from coursekit.processes.current_process import program_folder
from coursekit.processes.session import current

from .frame_tree import FrameTree

if TYPE_CHECKING:
    from rclpy.node import Node


def generate_dot(data: dict[str, Any], recorded_time: tuple[int, int]) -> str:
    """Return the tree in Graphviz's language, from the response of the service tf2_frames."""
    if not data:
        return 'digraph G { "No tf data received" }'
    lines = ["digraph G {"]
    for name, facts in data.items():
        label = (
            f" Broadcaster: {facts['broadcaster']}\\nAverage rate: {facts['rate']}\\n"
            f"Buffer length: {facts['buffer_length']}\\nMost recent transform: {facts['most_recent_transform']}\\n"
            f"Oldest transform: {facts['oldest_transform']}\\n"
        )
        lines.append(f'"{facts["parent"]}" -> "{name}"[label="{label}"];')
    root = next((facts["parent"] for facts in data.values() if facts["parent"] not in data), next(iter(data)))
    recorded = recorded_time[0] + recorded_time[1] / 1e9
    lines += [
        "edge [style=invis];",
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";',
        f'"Recorded at time: {recorded}"[ shape=plaintext ] ;',
        f'}}->"{root}";',
        "}",
    ]
    return "\n".join(lines)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Draws the tree of the frames that are broadcast")
    parser.add_argument("--wait-time", "-t", type=float, default=5.0, help="seconds to listen before drawing")
    parser.add_argument("-o", "--output", help="name of the files, without ending")
    parser.add_argument("--tf_topic", default=DEFAULT_TF_TOPIC, help="topic of transforms that change")
    parser.add_argument("--tf_static_topic", default=DEFAULT_STATIC_TF_TOPIC, help="topic of those that do not")
    return parser.parse_args(remove_ros_args(sys.argv)[1:])


def main() -> int:
    """Listen, request the frames from its own service, write the files."""
    rclpy.init(args=sys.argv)
    args = _arguments()
    node = rclpy.create_node("view_frames")
    buffer = Buffer(node=node)
    topics = {"tf_topic": args.tf_topic, "tf_static_topic": args.tf_static_topic}
    listener = TransformListener(buffer, node, spin_thread=False, **topics)
    log = node.get_logger()
    try:
        log.info(f"Listening to tf data for {args.wait_time} seconds...")
        clock = current().clock
        end = clock.steady() + round(args.wait_time * 1e9)
        while clock.steady() < end:
            rclpy.spin_once(node, timeout_sec=0.1)
        log.info("Generating graph...")
        answer = _ask(node)
        log.info(f"Result:{answer}")
        _write(node, buffer, answer, args.output or f"frames_{_date()}")
    except KeyboardInterrupt:
        return 1
    finally:
        listener.unregister()
        node.destroy_node()
        rclpy.try_shutdown()
    return 0


def _date() -> str:
    return time.strftime("%Y-%m-%d_%H.%M.%S", time.localtime(current().clock.now() // 1_000_000_000))


def _ask(node: Node) -> Any:
    client = node.create_client(FrameGraph, "tf2_frames")
    while not client.wait_for_service(timeout_sec=1.0):
        node.get_logger().info("service not available, waiting again...")
    future = client.call_async(FrameGraph.Request())
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def _write(node: Node, buffer: Buffer, answer: Any, name: str) -> None:
    now = node.get_clock().now()
    node.get_logger().info(f"Exporting graph in {name}.pdf file...")
    dot = generate_dot(yaml.safe_load(answer.frame_yaml) or {}, now.seconds_nanoseconds())
    folder = program_folder()
    (folder / f"{name}.gv").write_text(dot, encoding="utf-8")
    (folder / f"{name}.pdf").write_bytes(FrameTree(buffer._frames, now.nanoseconds, details=True).pdf())
