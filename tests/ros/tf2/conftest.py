"""A session on the virtual clock, with rclpy started in it."""

import pytest
import rclpy

from coursekit.processes.patching import patch_manager
from coursekit.processes.session import Session


@pytest.hookimpl(wrapper=True, trylast=True)
def pytest_runtest_call(item):
    """pytest changes sys.stdout between a fixture and its test; processes keep theirs."""
    patch_manager.renew()
    return (yield)


@pytest.fixture
def session():
    with Session(virtual=True).use() as virtual_session:
        yield virtual_session


@pytest.fixture
def node(session):
    rclpy.init()
    tester = rclpy.create_node("tester")
    yield tester
    tester.destroy_node()
    rclpy.try_shutdown()
