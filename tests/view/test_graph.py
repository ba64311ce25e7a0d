import xml.etree.ElementTree as ElementTree

import pytest

from coursekit.core.qos import BEST_EFFORT, Qos
from coursekit.view.graph import GraphPicture
from coursekit.view.graph_text import details
from tests.view.graphs import ADD, chatter, empty, node


def shown(picture):
    return {
        part.get("data-name")
        for part in ElementTree.fromstring(picture.svg()).iter()
        if part.get("data-name")
    }


def test_the_text_has_a_line_for_each_topic():
    assert GraphPicture(chatter()).text().splitlines() == [
        "graph: 2 nodes, 1 topic",
        "nodes: /listener, /talker",
        "topic /chatter [std_msgs/msg/String]: /talker -> /listener",
    ]


def test_the_views_show_more_and_more():
    graph = chatter()
    node(graph, "/sensor", publishes=("/unheard",))
    nodes = {"/talker", "/listener", "/sensor"}
    assert shown(GraphPicture(graph, "nodes")) == nodes | {"/chatter"}  # the label of the line
    assert shown(GraphPicture(graph, "active")) == nodes | {"/chatter"}
    assert shown(GraphPicture(graph, "all")) == nodes | {"/chatter", "/unheard"}


def test_services_are_shown_on_demand():
    graph = chatter()
    node(graph, "/server").server("/add", ADD, Qos())
    assert "/add" not in shown(GraphPicture(graph))
    assert "/add" in shown(GraphPicture(graph, services=True))
    assert "service /add" in GraphPicture(graph, services=True).text()


def test_actions_are_shown_as_one_thing():
    from coursekit.interfaces import load

    graph = chatter()
    goals = load("example_interfaces/action/Fibonacci").Impl.SendGoalService
    node(graph, "/server").server("/fibonacci/_action/send_goal", goals, Qos())
    node(graph, "/client").client("/fibonacci/_action/send_goal", goals, Qos())
    text = GraphPicture(graph, actions=True).text()
    assert "action /fibonacci [example_interfaces/action/Fibonacci]: /client -> /server" in text


def test_a_fault_is_numbered_in_the_picture_and_told_with_its_cure():
    graph = empty()
    node(graph, "/camera", publishes=("/scan",), qos=Qos(reliability=BEST_EFFORT))
    node(graph, "/mapper", hears=("/scan",))
    picture = GraphPicture(graph)
    assert (
        "! /scan: reliability" in picture.text() and "cure: Let /mapper ask for BEST_EFFORT" in picture.text()
    )
    assert "ck-badge" in picture.svg() and "ck-broken" in picture.svg()


def test_the_same_graph_made_in_another_order_has_the_same_picture():
    other = empty()
    node(other, "/listener", hears=("/chatter",))
    node(other, "/talker", publishes=("/chatter",))
    assert GraphPicture(other).svg() == GraphPicture(chatter()).svg()


def test_a_notebook_stores_text_and_a_png_but_no_svg():
    data, metadata = GraphPicture(chatter())._repr_mimebundle_()
    assert set(data) == {"text/plain", "image/png"}
    assert data["image/png"].startswith(b"\x89PNG") and metadata["image/png"]["width"] > 100


def test_an_empty_graph_is_a_picture_too():
    assert "empty" in GraphPicture(empty()).svg()


def test_a_view_that_does_not_exist_names_those_that_do():
    with pytest.raises(ValueError, match="nodes, active, all"):
        GraphPicture(empty(), "everything")


def test_details_of_a_topic_give_the_quality_of_both_ends():
    text = details(chatter(), "/chatter")
    assert text.count("Reliability: RELIABLE") == 2 and "Publisher count: 1\n  /talker" in text


def test_details_of_a_node_list_what_it_has():
    assert "  Publishers:\n    /chatter: std_msgs/msg/String" in details(chatter(), "/talker")


def test_details_of_what_is_gone_say_so():
    assert "not in the graph" in details(chatter(), "/nothing")
