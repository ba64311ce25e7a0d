"""Executors and callback groups: two nodes in one process, groups, and a custom executor."""

from concurrent.futures import ThreadPoolExecutor
from threading import Lock
from typing import Any

import rclpy
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup
from rclpy.executors import (
    Executor,
    MultiThreadedExecutor,
    ShutdownException,
    TimeoutException,
)
from rclpy.node import Node
from std_msgs.msg import String

from coursekit.nodes.demo_nodes.listener import Listener as DemoListener
from coursekit.nodes.demo_nodes.talker import Talker
from coursekit.nodes.running import run, spin_to_the_end


class Listener(DemoListener):
    """Logs received messages in quotes."""

    def _heard(self, msg: String) -> None:
        self.get_logger().info(f'I heard: "{msg.data}"')


class CountingNode(Node):
    """Publishes an increasing count on /chatter each time its timers fire."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self._count = 0
        self._publisher = self.create_publisher(String, "chatter", 10)

    def say(self) -> None:
        """Publish and count."""
        msg = String(data=f"Hello World: {self._count}")
        self._count += 1
        self.get_logger().info(f'Publishing: "{msg.data}"')
        self._publisher.publish(msg)


class DoubleTalker(CountingNode):
    """Two timers in one group: their callbacks never run in parallel."""

    def __init__(self) -> None:
        super().__init__("double_talker")
        group = MutuallyExclusiveCallbackGroup()
        self._timers_of_mine = [self.create_timer(period, self.say, callback_group=group) for period in (1.0, 0.5)]


class ThrottledCallbackGroup(CallbackGroup):
    """Permits ten callbacks, and then two a second."""

    MOST = 10

    def __init__(self, node: Node) -> None:
        super().__init__()
        self._tokens = self.MOST
        self._lock = Lock()
        self._timer = node.create_timer(0.5, self._refill)

    def can_execute(self, entity: Any) -> bool:
        """Whether a token is available."""
        return self._tokens > 0

    def beginning_execution(self, entity: Any) -> bool:
        """Take a token; False if there is none."""
        with self._lock:
            if self._tokens == 0:
                return False
            self._tokens -= 1
            return True

    def ending_execution(self, entity: Any) -> None:
        """Do nothing: tokens are not returned."""

    def _refill(self) -> None:
        with self._lock:
            self._tokens = min(self._tokens + 1, self.MOST)


class ThrottledTalker(CountingNode):
    """A timer with ten callbacks a second, whose group permits fewer."""

    def __init__(self) -> None:
        super().__init__("intermittent_talker")
        self._fast = self.create_timer(0.1, self.say, callback_group=ThrottledCallbackGroup(self))


class Estopper(Node):
    """Must never wait: prints messages on /estop."""

    def __init__(self) -> None:
        super().__init__("estopper")
        self._subscription = self.create_subscription(String, "estop", lambda msg: print(f"I heard: [{msg.data}]"), 10)


class PriorityExecutor(Executor):
    """Gives urgent nodes their own threads, and all others one thread."""

    def __init__(self) -> None:
        super().__init__()
        self._urgent_nodes: set[Node] = set()
        self._urgent = ThreadPoolExecutor(max_workers=4)
        self._others = ThreadPoolExecutor(max_workers=1)

    def add_high_priority_node(self, node: Node) -> None:
        """Add an urgent node."""
        self._urgent_nodes.add(node)
        self.add_node(node)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Start one ready callback."""
        try:
            handler, _, node = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except (ShutdownException, TimeoutException):
            return
        (self._urgent if node in self._urgent_nodes else self._others).submit(handler)


def listener(args: list[str] | None = None) -> int:
    """Listen until Ctrl-C."""
    return run(Listener, args)


def talker(args: list[str] | None = None) -> int:
    """Talk until Ctrl-C."""
    return run(Talker, args)


def composed(args: list[str] | None = None) -> int:
    """Talk and listen in one process."""
    rclpy.init(args=args)
    return spin_to_the_end(Talker(), Listener())


def callback_group(args: list[str] | None = None) -> int:
    """Run two timers that exclude each other, and a listener in parallel."""
    rclpy.init(args=args)
    return spin_to_the_end(DoubleTalker(), Listener(), executor=MultiThreadedExecutor(num_threads=4))


def custom_callback_group(args: list[str] | None = None) -> int:
    """Run a throttled timer."""
    return run(ThrottledTalker, args)


def custom_executor(args: list[str] | None = None) -> int:
    """Run an executor with urgent nodes."""
    rclpy.init(args=args)
    executor = PriorityExecutor()
    executor.add_high_priority_node(Estopper())
    return spin_to_the_end(Listener(), Talker(), executor=executor)
