"""Two graphs on the wall clock, joined by a socket: what is in one is in the other, until one hangs up."""

import socket
import threading

import pytest
from example_interfaces.srv import AddTwoInts
from std_msgs.msg import String

from coursekit.core.clock import WallClock
from coursekit.core.graph import Graph
from coursekit.core.qos import TRANSIENT_LOCAL, Qos
from coursekit.joined.link import Link
from coursekit.joined.pipe import Broken


class Pair:
    """Two graphs, and the ways to wait for what happens in them."""

    def __init__(self) -> None:
        self.graphs = Graph(WallClock()), Graph(WallClock())
        self.ended: list[Link] = []

    def join(self) -> tuple[Link, Link]:
        ends, links = socket.socketpair(), {}

        def make(side: int) -> None:
            links[side] = Link(self.graphs[side], ends[side], self.ended.append, calling=side == 0)

        other = threading.Thread(target=make, args=(1,))
        other.start()
        make(0)
        other.join()
        return links[0], links[1]


@pytest.fixture
def pair(monkeypatch):
    """Two sides that wait for each other also where a computer is busy with much else."""
    monkeypatch.setattr("coursekit.joined.link.HELLO_SECONDS", 60.0)
    return Pair()


def until(graph: Graph, holds) -> None:
    """Wait for the graph to be as it should be; the test's own time limit ends a wait in vain."""
    changed = threading.Event()
    graph.watch(changed.set)
    while not holds():
        changed.wait(10.0)
        changed.clear()


class Inbox:
    """A queue that tells when something is put into it."""

    def __init__(self) -> None:
        self.full = threading.Event()

    def put(self, item) -> None:
        self.full.set()

    def take(self, source):
        assert self.full.wait(10.0)
        return source.take()


def test_each_knows_the_others_graph_from_the_first_moment(pair):
    left, right = pair.graphs
    left.add_node("talker", "/").publisher("/chatter", String, Qos())
    right.add_node("server", "/vera").server("/add", AddTwoInts, Qos())
    pair.join()
    assert {node.full_name for node in left.nodes} == {node.full_name for node in right.nodes} == {"/talker", "/vera/server"}
    assert left.topics() == right.topics() and left.services() == right.services()


def test_a_long_introduction_on_both_sides_does_not_block(pair):
    for graph in pair.graphs:
        for number in range(2000):
            graph.add_node(f"n{number}", "/")
    pair.join()
    assert [len(graph.nodes) for graph in pair.graphs] == [4000, 4000]


def test_messages_and_requests_cross(pair):
    left, right = pair.graphs
    publisher = left.add_node("talker", "/").publisher("/chatter", String, Qos())
    client = left.add_node("client", "/").client("/add", AddTwoInts, Qos())
    subscription = right.add_node("listener", "/").subscription("/chatter", String, Qos())
    server = right.add_node("server", "/").server("/add", AddTwoInts, Qos())
    messages, requests, responses = Inbox(), Inbox(), Inbox()
    subscription.attach(messages, None)
    server.attach(requests, None)
    client.attach(responses, None)
    pair.join()
    publisher.publish(String(data="hello"))
    assert messages.take(subscription)[0] == String(data="hello")
    number = client.send(AddTwoInts.Request(a=1, b=2))
    request, request_id = requests.take(server)
    server.respond(request_id, AddTwoInts.Response(sum=request.a + request.b))
    assert responses.take(client) == (number, AddTwoInts.Response(sum=3))


def test_who_comes_late_hears_what_a_latched_topic_keeps(pair):
    left, right = pair.graphs
    latched = Qos(durability=TRANSIENT_LOCAL, depth=1)
    left.add_node("map_server", "/").publisher("/map", String, latched).publish(String(data="map"))
    pair.join()
    late = right.add_node("late", "/").subscription("/map", String, latched)
    inbox = Inbox()
    late.attach(inbox, None)
    assert inbox.take(late)[0] == String(data="map")


def test_nodes_that_come_and_go_do_so_on_both_sides(pair):
    left, right = pair.graphs
    pair.join()
    node = left.add_node("short", "/")
    until(right, lambda: [remote_node.full_name for remote_node in right.nodes] == ["/short"])
    node.close()
    until(right, lambda: not right.nodes)


@pytest.mark.parametrize("orderly", [True, False])
def test_who_hangs_up_takes_its_nodes_along(pair, orderly):
    left, right = pair.graphs
    left.add_node("talker", "/").publisher("/chatter", String, Qos())
    right.add_node("listener", "/").subscription("/chatter", String, Qos())
    link, _ = pair.join()
    if orderly:
        link.flush(10.0)
        link.end()
    else:
        link.peer.shutdown(socket.SHUT_RDWR)  # as when it is killed
    until(right, lambda: [node.full_name for node in right.nodes] == ["/listener"])
    assert right.publishers == {}


def test_who_does_not_answer_is_no_neighbour(monkeypatch):
    monkeypatch.setattr("coursekit.joined.link.HELLO_SECONDS", 0.0)
    ours, theirs = socket.socketpair()
    with theirs, ours, pytest.raises(Broken, match="did not answer"):
        Link(Graph(WallClock()), ours, lambda link: None, calling=True)
