"""Listens to the lifecycle talker and its state changes."""

from lifecycle_msgs.msg import TransitionEvent
from std_msgs.msg import String

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import run


class LifecycleListener(CppNode):
    """Logs messages on /lifecycle_chatter and the talker's transitions."""

    def __init__(self) -> None:
        super().__init__("lc_listener")
        self._data = self.create_subscription(String, "lifecycle_chatter", self._heard, 10)
        self._changes = self.create_subscription(TransitionEvent, "/lc_talker/transition_event", self._changed, 10)

    def _heard(self, msg: String) -> None:
        self.get_logger().info(f"data_callback: {msg.data}")

    def _changed(self, msg: TransitionEvent) -> None:
        self.get_logger().info(
            f"notify callback: Transition from state {msg.start_state.label} to {msg.goal_state.label}"
        )


def main(args: list[str] | None = None) -> int:
    """Listen until Ctrl-C."""
    return run(LifecycleListener, args)
