"""Two graphs stay equal, whatever comes and goes on either side, and nonsense is refused."""

import pytest
from example_interfaces.srv import AddTwoInts
from hypothesis import given
from hypothesis import strategies as st
from std_msgs.msg import Int32, String

from coursekit.core.graph import Graph
from coursekit.core.qos import BEST_EFFORT, TRANSIENT_LOCAL, Qos
from coursekit.core.virtual_clock import VirtualClock
from coursekit.joined.mirror import Mirror


@pytest.fixture
def sides():
    graphs = [Graph(VirtualClock()), Graph(VirtualClock())]
    return [*graphs, *(Mirror(graph) for graph in graphs)]


def meet(one, other):
    """Let both say what they have to say until neither has."""
    while True:
        events, body = one.collect()
        assert other.apply(events, body) == []
        one, other = other, one
        if not events:
            events, body = one.collect()
            if not events:
                return
            other.apply(events, body)


def test_both_see_the_same_graph(sides):
    left, right, ours, theirs = sides
    talker, listener = left.add_node("talker", "/"), right.add_node("listener", "/vera")
    talker.publisher("/chatter", String, Qos(depth=3))
    listener.subscription("/chatter", String, Qos(reliability=BEST_EFFORT))
    listener.server("/add", AddTwoInts, Qos())
    meet(ours, theirs)
    assert [node.full_name for node in left.nodes] == ["/talker", "/vera/listener"]
    assert left.topics() == right.topics() and left.services() == right.services() == [("/add", [AddTwoInts._TYPE_NAME])]
    listener.close()
    meet(ours, theirs)
    assert [node.full_name for node in left.nodes] == ["/talker"] == [node.full_name for node in right.nodes]
    assert left.services() == [] and left.publishers["/chatter"][0].targets == ()


def test_messages_cross_once_to_each_subscription(sides):
    left, right, ours, theirs = sides
    publisher = left.add_node("talker", "/").publisher("/chatter", String, Qos())
    heard = [right.add_node(name, "/").subscription("/chatter", String, Qos()) for name in ("a", "b")]
    deaf = right.add_node("c", "/").subscription("/chatter", Int32, Qos())
    meet(ours, theirs)
    publisher.publish(String(data="hello"))
    meet(ours, theirs)
    assert [subscription.take()[0] for subscription in heard] == [String(data="hello")] * 2
    assert not deaf.queue and not heard[0].queue


def test_who_comes_late_hears_what_a_latched_topic_keeps(sides):
    left, right, ours, theirs = sides
    latched = Qos(durability=TRANSIENT_LOCAL, depth=1)
    publisher = left.add_node("map_server", "/").publisher("/map", String, latched)
    publisher.publish(String(data="old"))
    publisher.publish(String(data="new"))
    meet(ours, theirs)
    late = right.add_node("late", "/").subscription("/map", String, latched)
    meet(ours, theirs)
    assert late.take()[0] == String(data="new") and late.take() is None


def test_requests_and_responses_find_their_way(sides):
    left, right, ours, theirs = sides
    server = left.add_node("server", "/").server("/add", AddTwoInts, Qos())
    clients = [right.add_node(name, "/").client("/add", AddTwoInts, Qos()) for name in ("a", "b")]
    meet(ours, theirs)
    assert clients[0].server_is_ready()
    numbers = [client.send(AddTwoInts.Request(a=1, b=place)) for place, client in enumerate(clients)]
    meet(ours, theirs)
    for _ in clients:
        request, number = server.take()
        server.respond(number, AddTwoInts.Response(sum=request.a + request.b))
    meet(ours, theirs)
    wanted = [(number, AddTwoInts.Response(sum=place + 1)) for place, number in enumerate(numbers)]
    assert [client.take() for client in clients] == wanted


WORD = st.sampled_from(["node", "endpoint", "gone", "message", "request", "response", "publisher", "subscription", "server",
                        "client", "/chatter", "std_msgs/msg/String", "other"])  # fmt: skip
LEAF = WORD | st.integers(-1, 8) | st.none() | st.floats()
ANY = st.recursive(LEAF, lambda inner: st.lists(inner, max_size=8), max_leaves=12)
EVENT = st.lists(ANY, min_size=1, max_size=7) | st.builds(
    lambda number, kind: ["endpoint", number, kind, 1, "/chatter", "std_msgs/msg/String", [1, 10, 1, 1, 0, 0, 1, 0]],
    st.integers(0, 8),
    st.sampled_from(["publisher", "subscription", "server", "client"]),
)


@given(st.lists(EVENT, max_size=12), st.binary(max_size=40))
def test_nonsense_is_refused_and_breaks_nothing(events, body):
    graph = Graph(VirtualClock())
    mirror = Mirror(graph)
    own = graph.add_node("own", "/").publisher("/chatter", String, Qos())
    mirror.collect()
    mirror.apply([["node", 1, "other", "/"]], b"")
    try:
        mirror.apply(events, body)
    except Exception as refused:
        assert isinstance(refused, (LookupError, TypeError, ValueError, AttributeError, OverflowError)), refused
    own.publish(String(data="still here"))
    assert own in graph.publishers["/chatter"]
