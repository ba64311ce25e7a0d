"""The graph: who is matched with whom, and that nothing is shared or lost on the way."""

import pytest
from std_msgs.msg import Float64MultiArray, String
from std_srvs.srv import SetBool

from coursekit.core.graph import Graph
from coursekit.core.qos import BEST_EFFORT, KEEP_ALL, RELIABLE, TRANSIENT_LOCAL, VOLATILE, Qos
from coursekit.core.status import DEADLINE, INCOMPATIBLE, LIVELINESS
from coursekit.core.virtual_clock import VirtualClock


@pytest.fixture
def graph():
    return Graph(VirtualClock())


@pytest.fixture
def node(graph):
    return graph.add_node("node", "/")


def texts(subscription):
    taken = []
    while (entry := subscription.take()) is not None:
        taken.append(entry[0].data)
    return taken


def test_a_message_reaches_every_subscription_as_an_object_of_its_own(node):
    publisher = node.publisher("/t", Float64MultiArray, Qos())
    one, other = (node.subscription("/t", Float64MultiArray, Qos()) for _ in range(2))
    msg = Float64MultiArray(data=[1.0])
    publisher.publish(msg)
    msg.data[0] = 2.0
    first, second = one.take()[0], other.take()[0]
    first.data[0] = 3.0
    assert second.data[0] == 1.0


def test_a_reader_of_a_few_numbers_gets_these_and_no_copy(node):
    lasting = Qos(durability=TRANSIENT_LOCAL)
    publisher = node.publisher("/t", Float64MultiArray, lasting)
    subscription = node.subscription("/t", Float64MultiArray, lasting)
    subscription.reduce = lambda msg: msg.data[0]
    publisher.publish(Float64MultiArray(data=[1.0]))
    assert subscription.take()[0] == 1.0
    publisher.replay(subscription)
    assert subscription.take()[0] == 1.0


def test_the_oldest_message_goes_when_the_queue_is_full(node):
    subscription = node.subscription("/t", String, Qos(depth=2))
    publisher = node.publisher("/t", String, Qos())
    for text in "abc":
        publisher.publish(String(data=text))
    assert texts(subscription) == ["b", "c"]


def test_keep_all_keeps_all(node):
    subscription = node.subscription("/t", String, Qos(history=KEEP_ALL))
    publisher = node.publisher("/t", String, Qos())
    for number in range(5000):
        publisher.publish(String(data=str(number)))
    assert texts(subscription) == [str(number) for number in range(5000)]


def test_a_late_joiner_gets_what_a_transient_local_publisher_keeps(node):
    publisher = node.publisher("/t", String, Qos(depth=2, durability=TRANSIENT_LOCAL))
    for text in "abc":
        publisher.publish(String(data=text))
    late = node.subscription("/t", String, Qos(durability=TRANSIENT_LOCAL))
    volatile = node.subscription("/t", String, Qos(durability=VOLATILE))
    assert texts(late) == ["b", "c"] and texts(volatile) == []


@pytest.mark.parametrize(
    ("offer", "wish", "policy"),
    [
        (Qos(reliability=BEST_EFFORT), Qos(reliability=RELIABLE), 16),
        (Qos(durability=VOLATILE), Qos(durability=TRANSIENT_LOCAL), 2),
        (Qos(deadline=2), Qos(deadline=1), 4),
        (Qos(), Qos(deadline=1), 4),
        (Qos(lease=2), Qos(lease=1), 8),
        (Qos(liveliness=1), Qos(liveliness=3), 8),
        (Qos(), Qos(), None),
        (Qos(reliability=RELIABLE), Qos(reliability=BEST_EFFORT), None),
    ],
)
def test_an_offer_serves_a_request_that_is_not_stricter(node, offer, wish, policy):
    publisher, subscription = node.publisher("/t", String, offer), node.subscription("/t", String, wish)
    publisher.publish(String(data="x"))
    assert (texts(subscription) == ["x"]) == (policy is None)
    for end in (publisher, subscription):
        status = end.status(INCOMPATIBLE)
        assert (status.total, status.last_policy) == ((0, 1) if policy is None else (1, policy))


def test_other_types_on_the_same_topic_are_not_matched(node):
    publisher = node.publisher("/t", Float64MultiArray, Qos())
    subscription = node.subscription("/t", String, Qos())
    publisher.publish(Float64MultiArray())
    assert subscription.take() is None


def test_a_message_older_than_its_lifespan_is_not_taken(graph, node):
    subscription = node.subscription("/t", String, Qos())
    publisher = node.publisher("/t", String, Qos(lifespan=10**9))
    publisher.publish(String(data="old"))
    graph.clock.sleep(2)
    publisher.publish(String(data="new"))
    assert texts(subscription) == ["new"]


def test_a_missed_deadline_is_counted_on_both_sides(graph, node):
    publisher = node.publisher("/t", String, Qos(deadline=10**8))
    subscription = node.subscription("/t", String, Qos(deadline=10**8))
    publisher.status(DEADLINE), subscription.status(DEADLINE)
    for _ in range(10):
        publisher.publish(String())
        graph.clock.sleep(0.05)
    assert (publisher.status(DEADLINE).total, subscription.status(DEADLINE).total) == (0, 0)
    graph.clock.sleep(0.35)
    assert publisher.status(DEADLINE).total >= 3 and subscription.status(DEADLINE).total >= 3


def test_a_publisher_that_does_not_assert_its_liveliness_is_lost_and_found_again(graph, node):
    qos = Qos(liveliness=3, lease=10**8)
    publisher, subscription = node.publisher("/t", String, qos), node.subscription("/t", String, qos)
    publisher.assert_liveliness()
    graph.clock.sleep(0.05)
    alive = subscription.status(LIVELINESS)
    assert (alive.total, alive.not_alive) == (1, 0)
    graph.clock.sleep(0.2)
    assert (alive.total, alive.not_alive, publisher.status(LIVELINESS).total) == (0, 1, 1)
    publisher.publish(String())
    assert (alive.total, alive.not_alive) == (1, 0)


def test_a_missed_deadline_is_no_sign_of_life_and_a_sign_of_life_keeps_no_deadline(graph, node):
    qos = Qos(deadline=10**8, liveliness=3, lease=3 * 10**8)
    publisher = node.publisher("/t", String, qos)
    publisher.status(DEADLINE), publisher.status(LIVELINESS)
    for _ in range(5):
        publisher.assert_liveliness()
        graph.clock.sleep(0.09)
    assert (publisher.status(DEADLINE).total, publisher.status(LIVELINESS).total) == (4, 0)
    graph.clock.sleep(0.5)
    assert publisher.status(LIVELINESS).total == 1


def test_a_request_is_answered_to_the_client_that_asked(node):
    server = node.server("/s", SetBool, Qos())
    one, other = (node.client("/s", SetBool, Qos()) for _ in range(2))
    assert (one.send(SetBool.Request(data=True)), other.send(SetBool.Request())) == (1, 1)
    for _ in range(2):
        request, header = server.take()
        server.respond(header, SetBool.Response(success=request.data))
    assert (one.take()[1].success, other.take()[1].success) == (True, False)


def test_names_and_types_are_sorted_and_ends_with_the_last_endpoint(graph, node):
    first = node.publisher("/b", String, Qos())
    node.subscription("/a", Float64MultiArray, Qos())
    assert graph.topics() == [("/a", ["std_msgs/msg/Float64MultiArray"]), ("/b", ["std_msgs/msg/String"])]
    first.close()
    assert graph.topics() == [("/a", ["std_msgs/msg/Float64MultiArray"])]
    node.close()
    assert graph.topics() == [] and graph.nodes == []


def test_watchers_are_told_of_every_change(graph):
    seen = []
    watcher = lambda: seen.append(graph.version)  # noqa: E731
    graph.watch(watcher)
    node = graph.add_node("n", "/")
    node.publisher("/t", String, Qos())
    graph.unwatch(watcher)
    node.close()
    assert len(seen) == 2


def test_a_listener_is_told_of_all_that_comes_before_it_is_taken(node, graph):
    told = []
    subscription, server = node.subscription("/t", String, Qos()), node.server("/s", SetBool, Qos())
    client = node.client("/s", SetBool, Qos())
    subscription.listener = lambda entry: told.append(entry[0].data)
    server.listener = lambda request: told.append(request.data)
    client.listener = lambda response: told.append(response.success)
    subscription.status(INCOMPATIBLE).listener = told.append
    node.publisher("/t", String, Qos()).publish(String(data="news"))
    client.send(SetBool.Request(data=True))
    server.respond(server.take()[1], SetBool.Response(success=True))
    node.publisher("/t", String, Qos(reliability=BEST_EFFORT))
    assert told == ["news", True, True, 1]
    assert texts(subscription) == ["news"]
