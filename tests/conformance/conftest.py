"""What the conformance tests share. They run on coursekit and, unchanged, on the real rclpy."""

from __future__ import annotations

import gc
import itertools
import os
import sys
import time
from pathlib import Path

import pytest
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode

sys.path.append(str(Path(__file__).parent))  # for action_setup, whatever pytest's import mode

IS_REAL = "coursekit" not in rclpy.__file__

if IS_REAL:  # keep to this machine and this run, and check fields as Humble always does
    os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
    os.environ.setdefault("ROS_DOMAIN_ID", str(1 + os.getpid() % 100))
    os.environ.setdefault("ROS_PYTHON_CHECK_FIELDS", "1")


_DOMAINS = itertools.cycle(range(1, 101))
"""Linux has ports for so many."""


def pytest_configure(config):
    config.addinivalue_line("markers", "humble_only(reason): behaviour that later ROS versions changed")


def pytest_collection_modifyitems(items):
    for item in items:
        mark = item.get_closest_marker("humble_only")
        if mark is not None and IS_REAL:
            reason = mark.args[0] if mark.args else "Humble differs from the ROS version installed here"
            item.add_marker(pytest.mark.skip(reason=reason))


def wait_until(step, condition, timeout):
    end = time.monotonic() + timeout
    while time.monotonic() < end:
        if condition():
            return True
        step()
    return bool(condition())


class World:
    """A context of its own, an executor, and the nodes that a test makes.

    Its domain is its own, too: the real middleware deadlocks now and then where one context comes while another goes.
    """

    def __init__(self, executor_class=SingleThreadedExecutor, args=None):
        self.context = Context()
        rclpy.init(context=self.context, args=args, domain_id=next(_DOMAINS))
        self.executor = executor_class(context=self.context)
        self.nodes = []

    def node(self, name="node", *, spin=True, node_class=None, **kwargs):
        make = node_class or rclpy.create_node
        node = make(name, context=self.context, **kwargs)
        self.nodes.append(node)
        if spin:
            self.executor.add_node(node)
        return node

    def spin_until(self, condition, timeout=8.0):
        step = lambda: self.executor.spin_once(timeout_sec=0.05)  # noqa: E731
        assert wait_until(step, condition, timeout), "it did not happen in time"

    def spin_for(self, seconds):
        wait_until(lambda: self.executor.spin_once(timeout_sec=0.02), lambda: False, seconds)

    def result(self, future, timeout=8.0):
        self.executor.spin_until_future_complete(future, timeout_sec=timeout)
        assert future.done(), "no answer in time"
        return future.result()

    def matched(self, publisher, count=1):
        self.spin_until(lambda: publisher.get_subscription_count() >= count)

    def close(self):
        if self.context.ok():
            self.executor.shutdown(timeout_sec=0)
            for node in self.nodes:
                node.destroy_node()
            rclpy.shutdown(context=self.context)
        self._collect()

    def _collect(self):
        """Free the managed nodes: the real rclpy keeps the services of a destroyed one until it is collected."""
        managed = any(isinstance(node, LifecycleNode) for node in self.nodes)
        self.nodes.clear()
        if managed:
            gc.collect()


@pytest.fixture
def world():
    world = World()
    yield world
    world.close()


@pytest.fixture
def make_world():
    worlds = []

    def make(*args, **kwargs):
        worlds.append(World(*args, **kwargs))
        return worlds[-1]

    yield make
    for world in worlds:
        world.close()


@pytest.fixture
def setup(world):
    """setup(execute, ...) makes an action server and its client."""
    from action_setup import Setup

    setups = []

    def make(execute, **options):
        setups.append(Setup(world, execute, **options))
        return setups[-1]

    yield make
    for each in setups:
        each.close()
