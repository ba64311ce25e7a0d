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


class Generous(SingleThreadedExecutor):
    """Says yes to everything; the group still has its say."""

    def can_execute(self, entity):
        return True


@pytest.mark.timeout(20)
def test_what_its_group_refuses_waits_also_where_the_executor_would_begin_it():
    with Session(virtual=True).use() as session:
        context = rclpy.context.Context()
        context.init([])
        node = rclpy.create_node("node", context=context)
        executor, group, got = Generous(context=context), MutuallyExclusiveCallbackGroup(), []
        executor.add_node(node)
        busy = node.create_timer(1000.0, lambda: None, group)
        node.create_subscription(Int64, "t", lambda message: got.append(message.data), 10, callback_group=group)
        group.beginning_execution(busy)
        node.create_publisher(Int64, "t", 10).publish(Int64(data=7))
        began = session.clock.steady()
        executor.spin_once(timeout_sec=0.5)
        assert got == [] and session.clock.steady() - began == 500_000_000
        executor._ended(busy)
        executor.spin_once(timeout_sec=0.5)
        context.shutdown()
    assert got == [7]
