import asyncio
import threading
import time

import pytest
import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import (
    ExternalShutdownException,
    MultiThreadedExecutor,
    ShutdownException,
    SingleThreadedExecutor,
)
from rclpy.task import Future

EXECUTORS = [SingleThreadedExecutor, MultiThreadedExecutor]


@pytest.fixture(params=EXECUTORS)
def either(request, make_world):
    return make_world(executor_class=request.param)


def test_spin_once_without_time_returns_at_once(either):
    either.node()
    before = time.monotonic()
    either.executor.spin_once(timeout_sec=0)
    assert time.monotonic() - before < 1.0


def test_spin_once_waits_as_long_as_told(either):
    either.node("n", start_parameter_services=False)
    before = time.monotonic()
    either.executor.spin_once(timeout_sec=0.2)
    assert 0.19 < time.monotonic() - before < 3.0


def test_spin_once_runs_one_callback(world):
    node, calls = world.node(), []
    guards = [node.create_guard_condition(lambda name=name: calls.append(name)) for name in "ab"]
    for guard in guards:
        guard.trigger()
    world.spin_until(lambda: len(calls) >= 1)
    assert len(calls) == 1
    world.spin_until(lambda: len(calls) == 2)
    assert sorted(calls) == ["a", "b"]


def test_a_node_is_added_once(either):
    node = either.node(spin=False)
    assert either.executor.add_node(node)
    assert not either.executor.add_node(node)
    assert either.executor.get_nodes() == [node]
    assert node.executor is either.executor


def test_a_removed_node_is_not_spun(world):
    node, calls = world.node(), []
    guard = node.create_guard_condition(lambda: calls.append(1))
    world.executor.remove_node(node)
    assert world.executor.get_nodes() == []
    guard.trigger()
    world.spin_for(0.1)
    assert calls == []


def test_a_node_moves_to_its_newest_executor(make_world):
    world = make_world()
    other = SingleThreadedExecutor(context=world.context)
    node = world.node()
    other.add_node(node)
    assert node.executor is other
    assert node not in world.executor.get_nodes()
    other.shutdown()


def test_adding_a_node_wakes_a_blocked_spin(world):
    node, calls = world.node(spin=False), []
    node.create_timer(0.01, lambda: calls.append(1))
    threading.Timer(0.1, lambda: world.executor.add_node(node)).start()
    end = time.monotonic() + 8
    while not calls and time.monotonic() < end:
        world.executor.spin_once(timeout_sec=4.0)
    assert calls
    assert time.monotonic() < end - 3


def test_adding_an_entity_wakes_a_blocked_spin(world):
    node, calls = world.node(), []
    threading.Timer(0.1, lambda: node.create_timer(0.01, lambda: calls.append(1))).start()
    end = time.monotonic() + 8
    while not calls and time.monotonic() < end:
        world.executor.spin_once(timeout_sec=4.0)
    assert calls
    assert time.monotonic() < end - 3


def test_an_exception_leaves_spin(either):
    def fail():
        raise KeyError("from the callback")

    either.node().create_timer(0.01, fail)
    with pytest.raises(KeyError, match="from the callback"):
        either.spin_for(3.0)


def test_a_context_that_ends_ends_spin(world):
    world.node()
    threading.Timer(0.1, world.context.shutdown).start()
    with pytest.raises(ExternalShutdownException):
        while True:
            world.executor.spin_once(timeout_sec=5.0)


def test_spin_ends_with_the_executor(world):
    world.node()
    thread = threading.Thread(target=world.executor.spin, daemon=True)
    thread.start()
    assert world.executor.shutdown(timeout_sec=5.0)
    thread.join(timeout=5.0)
    assert not thread.is_alive()


def test_spinning_until_a_future_is_done(either):
    node, future = either.node(), Future()
    node.create_timer(0.05, lambda: future.set_result("done") if not future.done() else None)
    either.executor.spin_until_future_complete(future, timeout_sec=5.0)
    assert future.result() == "done"


def test_spinning_until_a_future_gives_up(either):
    either.node()
    future = Future()
    before = time.monotonic()
    either.executor.spin_until_future_complete(future, timeout_sec=0.2)
    assert 0.1 < time.monotonic() - before < 3.0
    assert not future.done()


def test_a_zero_timeout_does_not_block(either):
    either.node()
    before = time.monotonic()
    either.executor.spin_until_future_complete(Future(), timeout_sec=0)
    assert time.monotonic() - before < 1.0


def test_a_done_future_needs_no_spin(either):
    future = Future()
    future.set_result(1)
    either.executor.spin_until_future_complete(future)


def test_two_nodes_share_an_executor(world):
    calls = []
    for name in ("one", "two"):
        world.node(name).create_timer(0.01, lambda name=name: calls.append(name))
    world.spin_until(lambda: {"one", "two"} <= set(calls))


def test_rclpy_spin_once_takes_an_executor(world):
    node, calls = world.node(spin=False), []
    node.create_timer(0.01, lambda: calls.append(1))
    end = time.monotonic() + 5
    while not calls and time.monotonic() < end:
        rclpy.spin_once(node, executor=world.executor, timeout_sec=0.1)
    assert calls


@pytest.mark.parametrize("threads", [1, 4])
def test_as_many_callbacks_run_at_once_as_there_are_threads(make_world, threads):
    world = make_world(executor_class=lambda context: MultiThreadedExecutor(threads, context=context))
    lock, running, peaks = threading.Lock(), set(), [0]

    def work():
        with lock:
            running.add(me := object())
            peaks.append(len(running))
        threading.Event().wait(0.05)
        with lock:
            running.discard(me)

    world.node().create_timer(0.01, work, callback_group=ReentrantCallbackGroup())
    world.spin_until(lambda: len(peaks) > 12)
    assert max(peaks) == threads


def test_destroying_a_node_while_spinning_is_fine(world):
    node, keeper = world.node("goes"), world.node("stays")
    calls = []
    node.create_timer(0.01, lambda: calls.append(1))
    world.spin_until(lambda: calls)
    node.destroy_node()
    world.spin_for(0.1)
    assert keeper.get_name() == "stays"


def test_an_entity_may_be_destroyed_in_its_own_callback(world):
    node, calls = world.node(), []

    def once():
        calls.append(1)
        node.destroy_timer(timer)

    timer = node.create_timer(0.01, once)
    world.spin_until(lambda: calls)
    world.spin_for(0.1)
    assert calls == [1]


def resumable(steps):
    async def coroutine():
        steps.append(1)
        await asyncio.sleep(0)
        steps.append(2)

    return coroutine


def test_a_coroutine_goes_on_in_the_next_spin(world):
    node, steps = world.node(start_parameter_services=False), []
    guard = node.create_guard_condition(resumable(steps))
    guard.trigger()
    world.executor.spin_once(timeout_sec=1.0)
    assert steps == [1]
    world.executor.spin_once(timeout_sec=0)
    assert steps == [1, 2]


def test_who_awaits_a_task_goes_on_when_it_is_done(world):
    world.node(start_parameter_services=False)

    async def first():
        return "first"

    first_task = world.executor.create_task(first)

    async def second():
        return await first_task + " and second"

    two = world.executor.create_task(second)
    world.executor.spin_once(timeout_sec=0)
    world.executor.spin_once(timeout_sec=0)
    assert first_task.done()
    world.executor.spin_once(timeout_sec=1)
    assert two.result() == "first and second"


def test_an_executor_may_be_shut_down_by_its_own_callback(world):
    node, called = world.node(), threading.Event()

    def stop():
        world.executor.shutdown()
        called.set()

    node.create_timer(0.05, stop)
    thread = threading.Thread(target=world.executor.spin, daemon=True)
    thread.start()
    assert called.wait(5.0)
    thread.join(timeout=5.0)
    assert not thread.is_alive()


def test_ready_callbacks_can_be_generated(either):
    ready = either.executor._wait_for_ready_callbacks()
    either.executor.shutdown()
    with pytest.raises(ShutdownException):
        next(ready)


def test_a_removed_node_still_gives_its_executor_tasks(world):
    node, done = world.node(), []
    world.executor.remove_node(node)
    assert node.executor is world.executor
    node.executor.create_task(lambda: done.append(1))
    world.executor.add_node(node)
    world.spin_until(lambda: done)
