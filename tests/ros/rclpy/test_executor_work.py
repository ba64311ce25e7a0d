"""No entity is left waiting for the end of a callback that has ended."""

import pytest
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import SingleThreadedExecutor
from std_msgs.msg import Int64

from coursekit.processes.session import Session


class EndsMeanwhile(MutuallyExclusiveCallbackGroup):
    """Its callback in another thread ends after a second one was refused, and before the executor has noted that."""

    def __init__(self):
        super().__init__()
        self.end = lambda: None

    def can_execute(self, entity):
        return self._answer(super().can_execute(entity))

    def beginning_execution(self, entity):
        return self._answer(super().beginning_execution(entity))

    def _answer(self, may):
        if not may:
            self.end()
        return may


class Strict(SingleThreadedExecutor):
    """Asks its own question, too."""

    def can_execute(self, entity):
        return super().can_execute(entity)


@pytest.mark.parametrize("kind", [SingleThreadedExecutor, Strict])
def test_a_callback_that_ends_while_another_is_refused_frees_it(kind):
    with Session(virtual=True).use():
        context = rclpy.context.Context()
        context.init([])
        node = rclpy.create_node("node", context=context)
        executor, group, got = kind(context=context), EndsMeanwhile(), []
        executor.add_node(node)
        busy = node.create_timer(1000.0, lambda: None, group)
        node.create_subscription(Int64, "t", lambda message: got.append(message.data), 10, callback_group=group)
        group.beginning_execution(busy)
        group.end = lambda: executor._ended(busy)
        node.create_publisher(Int64, "t", 10).publish(Int64(data=7))
        for _ in range(3):
            executor.spin_once(timeout_sec=0.1)
        context.shutdown()
    assert got == [7]
