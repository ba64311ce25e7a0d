import re

import pytest
from rclpy._rclpy_pybind11 import NodeNameNonExistentError, RCLError
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Int64, String
from std_srvs.srv import Trigger


@pytest.fixture
def node(world):
    return world.node("n", namespace="/ns")


def test_topics_are_listed_with_their_types(world, node):
    node.create_publisher(String, "chatter", 10)
    node.create_subscription(Int64, "count", lambda m: None, 10)
    world.spin_until(lambda: {"/ns/chatter", "/ns/count"} <= dict(node.get_topic_names_and_types()).keys())
    topics = dict(node.get_topic_names_and_types())
    assert topics["/ns/chatter"] == ["std_msgs/msg/String"]
    assert topics["/ns/count"] == ["std_msgs/msg/Int64"]


def test_services_are_listed_with_their_types(world, node):
    node.create_service(Trigger, "go", lambda q, r: r)
    world.spin_until(lambda: "/ns/go" in dict(node.get_service_names_and_types()))
    assert dict(node.get_service_names_and_types())["/ns/go"] == ["std_srvs/srv/Trigger"]


def test_nodes_are_listed(world, node):
    other = world.node("other")
    world.spin_until(lambda: {"n", "other"} <= set(node.get_node_names()))
    assert ("n", "/ns") in other.get_node_names_and_namespaces()
    assert ("other", "/", "/") in other.get_node_names_and_namespaces_with_enclaves()


def test_what_a_node_does_is_told(world, node):
    node.create_publisher(String, "out", 10)
    node.create_subscription(String, "in", lambda m: None, 10)
    node.create_service(Trigger, "serve", lambda q, r: r)
    node.create_client(Trigger, "ask")
    asker = world.node("asker")
    world.spin_until(lambda: ("n", "/ns") in asker.get_node_names_and_namespaces())
    told = lambda question: dict(getattr(asker, question)("n", "/ns"))  # noqa: E731
    world.spin_until(lambda: "/ns/ask" in told("get_client_names_and_types_by_node"))
    assert told("get_publisher_names_and_types_by_node")["/ns/out"] == ["std_msgs/msg/String"]
    assert told("get_subscriber_names_and_types_by_node")["/ns/in"] == ["std_msgs/msg/String"]
    assert told("get_service_names_and_types_by_node")["/ns/serve"] == ["std_srvs/srv/Trigger"]
    assert told("get_client_names_and_types_by_node")["/ns/ask"] == ["std_srvs/srv/Trigger"]


@pytest.mark.parametrize(
    "question",
    [
        "get_publisher_names_and_types_by_node",
        "get_subscriber_names_and_types_by_node",
        "get_service_names_and_types_by_node",
        "get_client_names_and_types_by_node",
    ],
)
def test_a_node_that_is_not_there_is_refused(node, question):
    with pytest.raises(NodeNameNonExistentError):
        getattr(node, question)("absent", "/")


def test_publishers_and_subscriptions_are_counted(world, node):
    assert node.count_publishers("chatter") == node.count_subscribers("chatter") == 0
    node.create_publisher(String, "chatter", 10)
    node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda m: None, 10)
    world.spin_until(lambda: node.count_publishers("chatter") == 2)
    world.spin_until(lambda: node.count_subscribers("/ns/chatter") == 1)


@pytest.mark.parametrize("question", ["count_publishers", "count_subscribers"])
def test_a_bad_name_is_not_counted(node, question):
    with pytest.raises(ValueError, match="is invalid"):
        getattr(node, question)("42")
    with pytest.raises(TypeError):
        getattr(node, question)(42)


def test_endpoints_tell_all_about_themselves(world, node):
    qos = QoSProfile(
        depth=5, reliability=ReliabilityPolicy.BEST_EFFORT, durability=DurabilityPolicy.TRANSIENT_LOCAL
    )
    node.create_publisher(String, "chatter", qos)
    world.spin_until(lambda: node.get_publishers_info_by_topic("/ns/chatter"))
    (info,) = node.get_publishers_info_by_topic("/ns/chatter")
    assert (info.node_name, info.node_namespace, info.topic_type) == ("n", "/ns", "std_msgs/msg/String")
    assert info.endpoint_type.name == "PUBLISHER"
    assert info.qos_profile.reliability == ReliabilityPolicy.BEST_EFFORT
    assert info.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL
    assert len(info.endpoint_gid) >= 16
    assert "Node name: n" in str(info)


def test_subscriptions_tell_too(world, node):
    node.create_subscription(String, "chatter", lambda m: None, 10)
    world.spin_until(lambda: node.get_subscriptions_info_by_topic("/ns/chatter"))
    (info,) = node.get_subscriptions_info_by_topic("/ns/chatter")
    assert info.endpoint_type.name == "SUBSCRIPTION"
    assert node.get_publishers_info_by_topic("/ns/chatter") == []


def test_a_destroyed_publisher_leaves_the_graph(world, node):
    publisher = node.create_publisher(String, "chatter", 10)
    world.spin_until(lambda: node.count_publishers("chatter") == 1)
    node.destroy_publisher(publisher)
    world.spin_until(lambda: node.count_publishers("chatter") == 0)


def test_hidden_topics_are_in_the_graph(world, node):
    node.create_publisher(String, "_hidden", 10)
    world.spin_until(lambda: "/ns/_hidden" in dict(node.get_topic_names_and_types()))


def test_every_node_has_parameter_events_and_rosout(world, node):
    topics = dict(node.get_publisher_names_and_types_by_node("n", "/ns"))
    assert topics["/parameter_events"] == ["rcl_interfaces/msg/ParameterEvent"]
    assert topics["/rosout"] == ["rcl_interfaces/msg/Log"]


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("bad?", "topic name must not contain characters other than"), ("1bad", "topic name token must not start with"),
        ("a//b", "topic name must not contain repeated '/'"), ("{ns}//x", "topic name must not contain repeated '/'"),
        ("{x}", "unknown substitution: {x}"), ("a/", "topic name must not end with a forward slash"),
    ],
)  # fmt: skip
def test_a_bad_name_is_not_resolved(world, name, why):
    for resolve in (world.node().resolve_topic_name, world.node("other").resolve_service_name):
        with pytest.raises(RCLError, match="failed to resolve name: " + re.escape(why)):
            resolve(name)


def test_what_is_not_the_node_s_is_not_destroyed(world):
    assert not world.node().destroy_publisher("none")


def test_a_destroyed_node_stays_with_its_executor(world):
    node = world.node()
    node.destroy_node()
    assert world.executor.get_nodes() == [node]
