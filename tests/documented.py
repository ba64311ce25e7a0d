"""Examples in docstrings of ROS packages have a `node`, as their readers have in a notebook."""

from pathlib import Path

import pytest
from _pytest.doctest import DoctestItem

ROS = Path(__file__).parents[1] / "coursekit" / "ros"


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item):
    """Run an example with a node in a session of its own, on the virtual clock."""
    if not isinstance(item, DoctestItem) or ROS not in item.path.parents or not _uses_node(item):
        return (yield)
    import rclpy  # not before conftest.py has chosen the sessions' folder

    from coursekit.processes.session import Session

    with Session(virtual=True).use():
        rclpy.init()
        item.dtest.globs |= {"rclpy": rclpy, "node": rclpy.create_node("robot")}
        try:
            return (yield)
        finally:
            rclpy.try_shutdown()


def _uses_node(item):
    return any("node" in example.source.lower() for example in item.dtest.examples)
