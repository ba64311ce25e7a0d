"""Nodes run as processes of a session on the virtual clock."""

import pytest
import rclpy

from coursekit.processes.executables import find
from coursekit.processes.patching import patch_manager
from coursekit.processes.session import Session
from tests.nodes.friend import Friend


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
def friend(session):
    """A node beside the ones under test."""
    new_friend = Friend(session)
    yield new_friend
    rclpy.shutdown(context=new_friend.context)


@pytest.fixture
def run(session):
    """run("turtlesim", "mimic", "--ros-args", ...) starts an executable of the underlay."""

    def start(package, executable, *argv):
        return session.start_executable(find(package, executable), argv, name=executable)

    return start


@pytest.fixture
def ros2(session):
    """ros2("topic", "list") runs a command to its end; its output without the log's stamps."""
    from coursekit.cli.parser import run as run_cli

    def command(*argv, seconds=5.0):
        process = session.start(lambda: run_cli(list(argv)), name="ros2", argv=argv)
        if process.wait(seconds) is None:
            process.interrupt()
            process.wait(2.0)
        return process.output

    return command
