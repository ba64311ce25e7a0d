import contextlib
import threading
import time

import pytest
import rclpy
from rclpy.exceptions import ROSInterruptException
from rclpy.executors import ExternalShutdownException


@pytest.fixture
def spinning(world):
    def spin():
        with contextlib.suppress(ExternalShutdownException):
            world.executor.spin()

    thread = threading.Thread(target=spin, daemon=True)
    node = world.node()
    thread.start()
    yield world, node
    world.executor.shutdown(timeout_sec=0)
    if world.context.ok():
        rclpy.shutdown(context=world.context)
    thread.join(timeout=5)


def test_a_rate_sleeps_in_step(spinning):
    _, node = spinning
    rate = node.create_rate(20.0)
    start = time.monotonic()
    for _ in range(5):
        rate.sleep()
    assert 0.15 < time.monotonic() - start < 1.5


def test_a_rate_can_be_destroyed(spinning):
    _, node = spinning
    rate = node.create_rate(10.0)
    assert node.destroy_rate(rate)


def test_destroying_a_rate_wakes_the_sleeper(spinning):
    _, node = spinning
    rate = node.create_rate(0.01)
    threading.Timer(0.1, lambda: node.destroy_rate(rate)).start()
    start = time.monotonic()
    try:
        rate.sleep()
    except ROSInterruptException:
        pass
    assert time.monotonic() - start < 10


def test_shutdown_interrupts_the_sleeper(spinning):
    world, node = spinning
    rate = node.create_rate(0.01)
    threading.Timer(0.1, lambda: rclpy.shutdown(context=world.context)).start()
    with pytest.raises(ROSInterruptException):
        rate.sleep()


def test_a_rate_after_shutdown_is_interrupted(spinning):
    world, node = spinning
    rate = node.create_rate(10.0)
    rclpy.shutdown(context=world.context)
    with pytest.raises(ROSInterruptException):
        rate.sleep()


def test_a_frequency_is_positive(world):
    with pytest.raises(ValueError):
        world.node().create_rate(0.0)


def test_a_loop_may_spin_and_sleep_by_turns(world):
    node = world.node()
    rate = node.create_rate(50.0)
    for _ in range(3):
        rclpy.spin_once(node, executor=world.executor)
        rate.sleep()
