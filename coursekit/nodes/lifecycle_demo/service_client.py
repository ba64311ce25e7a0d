"""Takes the lifecycle talker through its states, ten seconds each."""

import time
from typing import Any

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState, GetState

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import to_the_end

MANAGED = "lc_talker"
PATIENCE = 3.0  # seconds for each response; the talker needs two to activate
TRANSITIONS = (
    Transition.TRANSITION_CONFIGURE,
    Transition.TRANSITION_ACTIVATE,
    Transition.TRANSITION_DEACTIVATE,
    Transition.TRANSITION_ACTIVATE,
    Transition.TRANSITION_DEACTIVATE,
    Transition.TRANSITION_CLEANUP,
    Transition.TRANSITION_UNCONFIGURED_SHUTDOWN,
)


class LifecycleServiceClient(CppNode):
    """Requests the talker's state and transitions."""

    def __init__(self) -> None:
        super().__init__("lc_client")
        self._get_state = self.create_client(GetState, f"{MANAGED}/get_state")
        self._change_state = self.create_client(ChangeState, f"{MANAGED}/change_state")

    def _ask(self, client: Any, request: Any) -> Any:
        if not client.wait_for_service(PATIENCE):
            self.get_logger().error(f"Service {client.srv_name} is not available.")
            return None
        future = client.call_async(request)
        rclpy.spin_until_future_complete(self, future, timeout_sec=PATIENCE)
        if not future.done():
            self.get_logger().error(f"Server time out while getting current state for node {MANAGED}")
            return None
        return future.result()

    def tell_state(self) -> bool:
        """Log the talker's state. Returns whether it responded."""
        answer = self._ask(self._get_state, GetState.Request())
        if answer is None:
            return False
        self.get_logger().info(f"Node {MANAGED} has current state {answer.current_state.label}.")
        return True

    def change(self, transition: int) -> bool:
        """Request a transition. Returns whether it succeeded."""
        answer = self._ask(self._change_state, ChangeState.Request(transition=Transition(id=transition)))
        if answer is None:
            return False
        if answer.success:
            self.get_logger().info(f"Transition {transition} successfully triggered.")
        else:
            self.get_logger().warning(f"Failed to trigger transition {transition}")
        return bool(answer.success)


def main(args: list[str] | None = None) -> int:
    """Request all transitions; stop at the first that fails."""
    rclpy.init(args=args)
    node = LifecycleServiceClient()
    with to_the_end(node):
        for number, transition in enumerate(TRANSITIONS):
            if number:
                time.sleep(10.0)
            if not (node.change(transition) and node.tell_state()):
                break
    return 0
