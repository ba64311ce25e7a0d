import threading
import time


def test_a_trigger_calls_back(world):
    calls = []
    guard = world.node().create_guard_condition(lambda: calls.append(True))
    world.executor.spin_once(timeout_sec=0)
    assert calls == []
    guard.trigger()
    world.spin_until(lambda: calls)


def test_several_triggers_before_a_spin_are_one(world):
    calls = []
    guard = world.node().create_guard_condition(lambda: calls.append(True))
    guard.trigger()
    guard.trigger()
    world.spin_until(lambda: calls)
    world.spin_for(0.1)
    assert calls == [True]


def test_it_can_be_triggered_again(world):
    calls = []
    guard = world.node().create_guard_condition(lambda: calls.append(True))
    for count in (1, 2, 3):
        guard.trigger()
        world.spin_until(lambda count=count: len(calls) == count)


def test_a_trigger_from_another_thread_wakes_a_spin(world):
    calls = []
    guard = world.node().create_guard_condition(lambda: calls.append(True))
    threading.Timer(0.1, guard.trigger).start()
    before = time.monotonic()
    while not calls and time.monotonic() - before < 5:
        world.executor.spin_once(timeout_sec=5.0)
    assert time.monotonic() - before < 3


def test_a_guard_condition_can_be_destroyed(world):
    node = world.node()
    guard = node.create_guard_condition(lambda: None)
    assert guard in list(node.guards)
    assert node.destroy_guard_condition(guard)
    assert not node.destroy_guard_condition(guard)


def test_a_coroutine_may_be_the_callback(world):
    calls = []

    async def callback():
        calls.append(True)

    guard = world.node().create_guard_condition(callback)
    guard.trigger()
    world.spin_until(lambda: calls)
