"""A lifecycle talker: it publishes only while active."""

import time

from rclpy.lifecycle import Node, State, TransitionCallbackReturn
from std_msgs.msg import String

from coursekit.nodes.running import run


class LifecycleTalker(Node):
    """Publishes a greeting on /lifecycle_chatter every second; messages are only sent while it is active."""

    def __init__(self, name: str = "lc_talker") -> None:
        super().__init__(name)
        self._count = 0

    def _say(self) -> None:
        self._count += 1
        msg = String(data=f"Lifecycle HelloWorld #{self._count}")
        if self._publisher.is_activated:
            self.get_logger().info(f"Lifecycle publisher is active. Publishing: [{msg.data}]")
        else:
            self.get_logger().info("Lifecycle publisher is currently inactive. Messages are not published.")
        self._publisher.publish(msg)

    def on_configure(self, state: State) -> TransitionCallbackReturn:
        """Create the publisher and the timer."""
        self._publisher = self.create_lifecycle_publisher(String, "lifecycle_chatter", 10)
        self._timer = self.create_timer(1.0, self._say)
        self.get_logger().info("on_configure() is called.")
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: State) -> TransitionCallbackReturn:
        """Activate the publisher; the two-second sleep stands for work that takes time."""
        self.get_logger().info("on_activate() is called.")
        time.sleep(2.0)
        return super().on_activate(state)

    def on_deactivate(self, state: State) -> TransitionCallbackReturn:
        """Deactivate the publisher."""
        self.get_logger().info("on_deactivate() is called.")
        return super().on_deactivate(state)

    def on_cleanup(self, state: State) -> TransitionCallbackReturn:
        """Destroy the publisher and the timer."""
        self._take_away()
        self.get_logger().info("on cleanup is called.")
        return TransitionCallbackReturn.SUCCESS

    def on_shutdown(self, state: State) -> TransitionCallbackReturn:
        """Destroy them, if they exist, and shut down."""
        if state.label != "unconfigured":
            self._take_away()
        self.get_logger().info(f"on shutdown is called from state {state.label}.")
        return TransitionCallbackReturn.SUCCESS

    def _take_away(self) -> None:
        self.destroy_timer(self._timer)
        self.destroy_lifecycle_publisher(self._publisher)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(LifecycleTalker, args)
