import pytest

from coursekit.core.qos import BEST_EFFORT, MANUAL_BY_TOPIC, TRANSIENT_LOCAL, Qos
from coursekit.view.graph_facts import take
from coursekit.view.graph_faults import find
from tests.view.graphs import ADD, STRING, TWIST, chatter, empty, node


def serious(graph):
    return [fault for fault in find(take(graph)) if fault.serious]


def test_a_sound_graph_has_no_fault():
    assert find(take(chatter())) == []


@pytest.mark.parametrize(
    ("offer", "wish", "policy"),
    [
        (Qos(reliability=BEST_EFFORT), Qos(), "reliability"),
        (Qos(), Qos(durability=TRANSIENT_LOCAL), "durability"),
        (Qos(), Qos(deadline=10**9), "deadline"),
        (Qos(), Qos(liveliness=MANUAL_BY_TOPIC), "liveliness"),
        (Qos(), Qos(lease=10**9), "lease duration"),
    ],
)
def test_a_policy_that_does_not_match_is_named_with_both_ends_and_a_cure(offer, wish, policy):
    graph = empty()
    node(graph, "/camera", publishes=("/scan",), qos=offer)
    node(graph, "/mapper", hears=("/scan",), qos=wish)
    (fault,) = serious(graph)
    assert policy in fault.text
    assert "/camera offers" in fault.text and "/mapper requests" in fault.text
    assert "/camera" in fault.cure and "/mapper" in fault.cure


def test_every_policy_that_fails_is_named():
    graph = empty()
    node(graph, "/a", publishes=("/t",), qos=Qos(reliability=BEST_EFFORT))
    node(graph, "/b", hears=("/t",), qos=Qos(durability=TRANSIENT_LOCAL))
    assert [fault.text.split(": ")[1].split()[0] for fault in serious(graph)] == ["reliability", "durability"]


def test_a_misspelt_topic_is_told_from_one_that_is_only_unused():
    graph = empty()
    node(graph, "/teleop", publishes=("/cmd_val", "/diary"))
    node(graph, "/robot", hears=("/cmd_vel",))
    (fault,) = serious(graph)
    assert fault.text == "no node publishes /cmd_vel; did you mean /cmd_val?"
    assert "no node subscribes to /diary" in [fault.text for fault in find(take(graph))]


def test_a_topic_of_the_same_last_name_in_another_namespace_is_proposed():
    graph = empty()
    node(graph, "/teleop", publishes=("/cmd_vel",))
    node(graph, "/turtlesim", hears=("/turtle1/cmd_vel",))
    assert serious(graph)[0].text.endswith("did you mean /cmd_vel?")


def test_two_robots_with_topics_of_the_same_last_name_are_no_fault():
    graph = empty()
    node(graph, "/turtlesim", publishes=("/turtle1/pose", "/vera/pose"))
    node(graph, "/mimic", hears=("/turtle1/pose",))
    assert serious(graph) == []


def test_a_publisher_that_has_died_is_missed_by_those_who_still_listen():
    graph = empty()
    talker = node(graph, "/talker", publishes=("/chatter",))
    listener = node(graph, "/listener", hears=("/chatter",))
    talker.close()
    (fault,) = serious(graph)
    assert fault.text == "/talker is gone: no node publishes /chatter any more"
    assert fault.cure == "Start /talker again, and read the last lines of its terminal; /listener waits for it."
    assert (fault.places, fault.ends) == (("/chatter",), (("/listener", "/chatter"),))
    node(graph, "/talker", publishes=("/chatter",))
    assert serious(graph) == []
    listener.close()


def test_a_publisher_that_left_with_its_listeners_or_was_a_command_is_not_missed():
    graph = empty()
    ends = node(graph, "/talker", publishes=("/chatter",)), node(graph, "/listener", hears=("/chatter",))
    for end in ends:
        end.close()
    node(graph, "/listener", hears=("/chatter",))
    node(graph, "/_ros2cli_7", publishes=("/chatter",)).close()
    assert serious(graph) == []


def test_names_that_differ_only_in_numbers_are_meant_as_they_are():
    graph = empty()
    node(graph, "/mimic", publishes=("/turtle2/pose",), hears=("/turtle1/pose",))
    assert serious(graph) == []


def test_two_types_on_a_topic_are_told():
    graph = chatter()
    node(graph, "/odd").subscription("/chatter", TWIST, Qos())
    (fault,) = serious(graph)
    assert "/chatter is used with 2 types" in fault.text
    assert "geometry_msgs/msg/Twist at /odd" in fault.text


def test_two_nodes_of_one_name_are_told():
    graph = chatter()
    node(graph, "/talker")
    assert serious(graph)[0].text == "2 nodes are called /talker"


def test_a_service_that_nobody_serves_is_told_with_its_neighbour():
    graph = empty()
    node(graph, "/server").server("/add_two_ints", ADD, Qos())
    node(graph, "/client").client("/add_two_int", ADD, Qos())
    (fault,) = serious(graph)
    assert fault.text == "no node serves the service /add_two_int; did you mean /add_two_ints?"


def test_hidden_nodes_and_debug_topics_are_left_out_unless_asked_for():
    graph = chatter()
    node(graph, "/_panel", hears=("/chatter",))
    graph.nodes[0].publisher("/rosout", STRING, Qos())
    assert take(graph).nodes == ("/listener", "/talker")
    assert take(graph).topics == ["/chatter"]
    assert take(graph, hidden=True).nodes == ("/_panel", "/listener", "/talker")
    assert take(graph, debug=True).topics == ["/chatter", "/rosout"]
