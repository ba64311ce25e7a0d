"""`ros2 run nav2_util lifecycle_bringup NODE...`: configures and activates lifecycle nodes, one after the other."""

from __future__ import annotations

import sys

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
from rclpy.node import Node
from rclpy.utilities import remove_ros_args

from coursekit.nodes.running import terminate, to_the_end

_SECONDS, _TRIES = 10.0, 4
_USAGE = """Invalid command line.

This command will take a set of unconfigured lifecycle nodes through the
CONFIGURED to the ACTIVATED state
The nodes are brought up in the order listed on the command line

Usage:
 > lifecycle_startup <node name> ...
"""


def main(args: list[str] | None = None) -> int:
    """Bring the named nodes up. What a transition answers does not count, as in nav2: the node itself tells of it."""
    names = remove_ros_args(sys.argv if args is None else args)[1:]
    if not names:
        sys.stderr.write(_USAGE)
        return 1
    rclpy.init(args=args)
    with to_the_end():
        for name in names:
            fault = _bring_up(name)
            if fault:
                return terminate(fault)
    return 0


def _bring_up(name: str) -> str:
    """Configure and activate one node. Returns what went wrong, or an empty text."""
    node = rclpy.create_node(f"{name.strip('/').replace('/', '_')}_lifecycle_client", use_global_arguments=False)
    client = node.create_client(ChangeState, f"{name}/change_state")
    for transition in (Transition.TRANSITION_CONFIGURE, Transition.TRANSITION_ACTIVATE):
        if not any(_change(node, client, transition) for _ in range(_TRIES)):
            return (
                f"change_state service is not available! No lifecycle node '{name}' answers; "
                "`ros2 lifecycle nodes` lists those that run"
            )
    node.destroy_node()
    return ""


def _change(node: Node, client: rclpy.client.Client, transition: int) -> bool:
    """Ask for a transition; whether an answer came in time."""
    if not client.wait_for_service(_SECONDS):
        return False
    future = client.call_async(ChangeState.Request(transition=Transition(id=transition)))
    rclpy.spin_until_future_complete(node, future, timeout_sec=_SECONDS)
    return future.done()
