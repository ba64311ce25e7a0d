import threading
import time

import pytest
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from std_msgs.msg import String
from std_srvs.srv import Trigger


class Overlap:
    """Counts how many callbacks run at the same time."""

    def __init__(self):
        self.running = self.most = self.calls = 0
        self.lock = threading.Lock()

    def __call__(self):
        with self.lock:
            self.running += 1
            self.calls += 1
            self.most = max(self.most, self.running)
        time.sleep(0.05)
        with self.lock:
            self.running -= 1


@pytest.fixture
def threads(make_world):
    return make_world(executor_class=lambda context: MultiThreadedExecutor(4, context=context))


def test_mutually_exclusive_callbacks_run_one_by_one(threads):
    node, overlap, group = threads.node(), Overlap(), MutuallyExclusiveCallbackGroup()
    for _ in range(3):
        node.create_timer(0.01, overlap, callback_group=group)
    threads.spin_until(lambda: overlap.calls >= 6)
    assert overlap.most == 1


def test_the_default_group_is_mutually_exclusive(threads):
    node, overlap = threads.node(), Overlap()
    for _ in range(3):
        node.create_timer(0.01, overlap)
    threads.spin_until(lambda: overlap.calls >= 6)
    assert overlap.most == 1
    assert isinstance(node.default_callback_group, MutuallyExclusiveCallbackGroup)


def test_reentrant_callbacks_run_side_by_side(threads):
    node, overlap, group = threads.node(), Overlap(), ReentrantCallbackGroup()
    for _ in range(3):
        node.create_timer(0.01, overlap, callback_group=group)
    threads.spin_until(lambda: overlap.most >= 2)


def test_groups_do_not_block_each_other(threads):
    node, overlap = threads.node(), Overlap()
    for _ in range(3):
        node.create_timer(0.01, overlap, callback_group=MutuallyExclusiveCallbackGroup())
    threads.spin_until(lambda: overlap.most >= 2)


def test_a_call_in_a_callback_works_with_another_group(threads):
    node, answers = threads.node(), []

    def answer(request, response):
        response.success = True
        return response

    node.create_service(Trigger, "go", answer, callback_group=MutuallyExclusiveCallbackGroup())
    client = node.create_client(Trigger, "go", callback_group=MutuallyExclusiveCallbackGroup())
    assert client.wait_for_service(timeout_sec=5.0)
    timer = node.create_timer(0.01, lambda: (timer.cancel(), answers.append(client.call(Trigger.Request()))))
    threads.spin_until(lambda: answers)
    assert answers[0].success


@pytest.mark.parametrize("kind", [MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup])
def test_entities_belong_to_their_group(world, kind):
    node, group = world.node(), kind()
    timer = node.create_timer(1.0, lambda: None, callback_group=group)
    subscription = node.create_subscription(String, "t", lambda m: None, 10, callback_group=group)
    client = node.create_client(Trigger, "go", callback_group=group)
    guard = node.create_guard_condition(lambda: None, callback_group=group)
    for entity in (timer, subscription, client, guard):
        assert group.has_entity(entity)
        assert entity.callback_group is group
    assert not group.has_entity(node.create_timer(1.0, lambda: None))


class Entity:
    """Something that a group can hold."""


def group_of(kind):
    group, one, two = kind(), Entity(), Entity()
    group.add_entity(one)
    group.add_entity(two)
    return group, one, two


def test_a_mutually_exclusive_group_runs_one_entity():
    group, one, two = group_of(MutuallyExclusiveCallbackGroup)
    assert group.can_execute(one)
    assert group.beginning_execution(one)
    assert not group.can_execute(two)
    assert not group.beginning_execution(two)
    group.ending_execution(one)
    assert group.can_execute(two)


def test_a_reentrant_group_runs_all():
    group, one, _two = group_of(ReentrantCallbackGroup)
    assert group.beginning_execution(one)
    assert group.can_execute(one)
    assert group.beginning_execution(one)
    group.ending_execution(one)


def test_every_node_has_its_own_default_group(world):
    assert world.node("a").default_callback_group is not world.node("b").default_callback_group
