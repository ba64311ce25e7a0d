"""Functions of rclpy's C module, which programs take from rclpy.impl.implementation_singleton."""

import pytest
from rclpy.impl.implementation_singleton import rclpy_implementation as native
from std_msgs.msg import String
from std_srvs.srv import Trigger


@pytest.fixture
def node(make_world):
    world = make_world(args=["--ros-args", "-r", "chatter:=talk", "-r", "stop:=halt"])
    return world.node("robot", namespace="/lab")


@pytest.mark.parametrize(
    ("name", "result"), [("/lab/chatter", "/lab/talk"), ("/lab/pose", "/lab/pose"), ("chatter", "chatter")]
)
def test_a_full_name_is_remapped(node, name, result):
    with node.handle:
        assert native.rclpy_remap_topic_name(node.handle, name) == result


@pytest.mark.parametrize(
    ("name", "only_expand", "is_service", "result"),
    [
        ("chatter", False, False, "/lab/talk"),
        ("chatter", True, False, "/lab/chatter"),
        ("stop", False, True, "/lab/halt"),
        ("~/pose", False, False, "/lab/robot/pose"),
    ],
)
def test_a_name_is_resolved(node, name, only_expand, is_service, result):
    assert native.rclpy_resolve_name(node.handle, name, only_expand, is_service) == result


def test_a_bad_name_is_not_resolved(node):
    with pytest.raises(native.RCLError, match="failed to resolve name: .*topic name must not contain"):
        native.rclpy_resolve_name(node.handle, "a b", False, False)


def test_the_graph_is_asked(node):
    node.create_publisher(String, "pose", 1)
    node.create_subscription(String, "goal", print, 1)
    node.create_service(Trigger, "reset", lambda request, response: response)
    node.create_client(Trigger, "wake")
    handle, place = node.handle, ("robot", "/lab")
    assert ("/lab/pose", ["std_msgs/msg/String"]) in native.rclpy_get_topic_names_and_types(handle, False)
    assert ("/lab/reset", ["std_srvs/srv/Trigger"]) in native.rclpy_get_service_names_and_types(handle)
    assert "/lab/pose" in dict(native.rclpy_get_publisher_names_and_types_by_node(handle, False, *place))
    assert "/lab/goal" in dict(native.rclpy_get_subscriber_names_and_types_by_node(handle, False, *place))
    assert "/lab/reset" in dict(native.rclpy_get_service_names_and_types_by_node(handle, *place))
    assert "/lab/wake" in dict(native.rclpy_get_client_names_and_types_by_node(handle, *place))
    with pytest.raises(native.NodeNameNonExistentError):
        native.rclpy_get_client_names_and_types_by_node(handle, "nobody", "/lab")


def test_names_are_expanded_and_checked():
    assert native.rclpy_expand_topic_name("~/x", "robot", "/lab") == "/lab/robot/x"
    assert native.rclpy_get_validation_error_for_topic_name("pose") is None
    assert native.rclpy_get_validation_error_for_topic_name("a b")[1] == 1
    assert native.rclpy_get_validation_error_for_full_topic_name("pose")[1] == 0
    assert native.rclpy_get_validation_error_for_namespace("lab")[1] == 0
    assert native.rclpy_get_validation_error_for_node_name("a/b")[1] == 1


def test_messages_become_bytes_and_bytes_messages():
    data = native.rclpy_serialize(String(data="hi"), String)
    assert native.rclpy_deserialize(data, String) == String(data="hi")


def test_words_of_the_process():
    assert native.rclpy_remove_ros_args(["x", "a", "--ros-args", "-r", "a:=b", "--", "c"]) == ["x", "a", "c"]
    assert native.rclpy_get_rmw_implementation_identifier().startswith("rmw_")
    assert isinstance(native.rclpy_logging_get_logging_directory(), str)
