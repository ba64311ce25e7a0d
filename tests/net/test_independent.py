"""A second opinion on the wire format: zenoh-ros2-sdk, written by others after rmw_zenoh, meets a side of ours."""

import subprocess
from pathlib import Path

import pytest
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

from coursekit.core.qos import Qos

from .sides import Inbox

INDEPENDENT = Path(__file__).parents[2] / ".venv-sdk" / "bin" / "python"
ROBOT = Path(__file__).parents[1] / "fixtures" / "net" / "independent_robot.py"
HUMBLE = "TypeHashNotSupported"

pytestmark = [
    pytest.mark.timeout(120),
    pytest.mark.skipif(not INDEPENDENT.exists(), reason="no .venv-sdk: python3 -m venv .venv-sdk, and zenoh-ros2-sdk in it"),
]


@pytest.fixture(params=[HUMBLE, ""], ids=["Humble's hash", "newer hashes"])
def robot(request, side):
    """A side of ours that sees the robot's four ends."""
    ours = side()
    port = side.address.rpartition(":")[2]
    child = subprocess.Popen(
        [INDEPENDENT, ROBOT, port, request.param], stdin=subprocess.PIPE, stdout=subprocess.PIPE, encoding="utf-8"
    )
    try:
        assert child.stdout.readline() == "there\n"
        ours.until(lambda: {"/echoer", "/hearer", "/adder", "/asker"} <= set(ours.names()))
        yield ours
    finally:
        child.kill()
        child.communicate()


def talk(ours):
    """A publisher that the robot hears, and what it says in answer."""
    node = ours.graph.add_node("talker", "/")
    all_twenty = Qos(depth=20)
    words, echo = node.publisher("/words", String, all_twenty), Inbox(node.subscription("/echo", String, all_twenty))
    ours.until(lambda: len(words.targets) == 1 and echo.source in ours.graph.publishers["/echo"][0].targets)
    ours.link.settle()
    return words, echo


def test_messages_go_both_ways_in_order(robot):
    words, echo = talk(robot)
    for number in range(20):
        words.publish(String(data=f"ñ {number}"))
    assert [echo.take()[0].data for _ in range(20)] == [f"heard ñ {number}" for number in range(20)]


def test_it_answers_our_requests(robot):
    client = robot.graph.add_node("client", "/").client("/add", AddTwoInts, Qos())
    robot.until(client.server_is_ready)
    got = Inbox(client)
    client.send(AddTwoInts.Request(a=2, b=3))
    assert got.take()[1].sum == 5


def test_we_answer_its_requests(robot):
    server = Inbox(robot.graph.add_node("server", "/").server("/multiply", AddTwoInts, Qos()))
    words, echo = talk(robot)
    robot.link.settle()
    words.publish(String(data="ask"))
    request, request_id = server.take()
    server.source.respond(request_id, AddTwoInts.Response(sum=request.a * request.b))
    assert echo.take()[0].data == "product 42"


def test_its_types_and_qualities_are_read(robot):
    [publisher] = robot.graph.publishers["/echo"]
    assert publisher.type_name == "std_msgs/msg/String" and publisher.node.remote
    assert (publisher.qos.depth, publisher.qos.reliability) == (Qos(depth=10).depth, Qos().reliability)
