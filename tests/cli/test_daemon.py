"""`ros2 daemon`: it runs until it is stopped; one that was started anew is a node, which only `-a` shows."""

import pytest

from coursekit.cli.parser import run
from coursekit.processes.session import Session


@pytest.fixture
def ask():
    with Session(virtual=True).use() as session:

        def command(*words: str) -> str:
            process = session.start(lambda: run(words), name="ros2")
            process.wait()
            return process.output

        yield command


def test_it_is_stopped_and_started(ask):
    said = [ask("daemon", verb) for verb in ("status", "start", "stop", "status", "stop", "start", "status")]
    assert said == [
        "The daemon is running\n",
        "The daemon is already running\n",
        "The daemon has been stopped\n",
        "The daemon is not running\n",
        "The daemon is not running\n",
        "The daemon has been started\n",
        "The daemon is running\n",
    ]


def test_one_that_was_started_is_a_hidden_node_with_ends_of_its_own(ask):
    assert ask("topic", "list") == "" == ask("node", "list", "-a")
    ask("daemon", "stop")
    ask("daemon", "start")
    assert ask("node", "list") == "" and ask("node", "list", "-a").startswith("/_ros2cli_daemon_0_")
    assert ask("topic", "list", "-v").splitlines()[:3] == [
        "Published topics:",
        " * /parameter_events [rcl_interfaces/msg/ParameterEvent] 1 publisher",
        " * /rosout [rcl_interfaces/msg/Log] 1 publisher",
    ]
