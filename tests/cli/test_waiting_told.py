"""Commands that wait for a server that never comes say, after a while, what they wait for."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionServer
from std_msgs.msg import String
from std_srvs.srv import Empty

from coursekit.cli.parser import run
from coursekit.processes.session import Session

Command = Callable[..., str]


def serve() -> None:
    rclpy.init()
    node = rclpy.create_node("server")
    node.create_subscription(String, "chatter", lambda msg: None, 1)
    node.create_service(Empty, "clear", lambda request, response: response)
    node.create_service(Empty, "broken", lambda request, response: None)
    ActionServer(node, Fibonacci, "fibonacci", lambda handle: Fibonacci.Result())
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass


@pytest.fixture
def said() -> Iterator[Command]:
    """What a command has said after ten seconds."""
    with Session(virtual=True).use() as session:
        session.start(serve, name="server")
        session.clock.sleep(0.5)

        def carry_out(*words: str) -> str:
            process = session.start(lambda: run(words), name="ros2")
            assert process.wait(10) is None
            process.interrupt()
            process.wait(1)
            return process.output

        yield carry_out


CALL, GOAL = ("service", "call"), ("action", "send_goal")


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ((*CALL, "/cler", "std_srvs/srv/Empty"), "no node offers the service /cler. Did you mean /clear?"),
        ((*CALL, "xyz", "std_srvs/srv/Empty"), "no node offers the service /xyz. There are: /broken, /clear."),
        ((*CALL, "/clear", "std_srvs/srv/Trigger"), "/clear has the type std_srvs/srv/Empty, not std_srvs/srv/Trigger."),
        (
            (*GOAL, "/fibonaci", "example_interfaces/action/Fibonacci", "{}"),
            "no node offers the action /fibonaci. Did you mean /fibonacci?",
        ),
    ],
)
def test_who_is_waited_for_is_told(said: Command, words: tuple[str, ...], says: str) -> None:
    assert f"Still waiting: {says} Ctrl-C ends the waiting" in said(*words)


def test_who_would_listen_is_told(said: Command) -> None:
    told = "Still waiting: no node subscribes to /chater. Did you mean /chatter? Ctrl-C ends the waiting"
    assert told in said("topic", "pub", "-1", "/chater", "std_msgs/msg/String")


def test_a_response_that_does_not_come_is_told_of(said: Command) -> None:
    says = said(*CALL, "/broken", "std_srvs/srv/Empty")
    assert "Still waiting for the response. Nobody offers the service any more: the server's program has ended" in says


def test_where_nothing_is_offered_the_program_is_asked_for() -> None:
    with Session(virtual=True).use() as session:
        process = session.start(lambda: run((*CALL, "/a", "std_srvs/srv/Empty")), name="ros2")
        assert process.wait(10) is None
        assert "no node offers the service /a. There is none: does the program run that offers it?" in process.output
