"""Within a context a topic or service has one type, whoever comes first."""

import pytest
from rclpy.action import ActionClient, ActionServer
from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy
from std_msgs.msg import Empty, String
from std_srvs.srv import SetBool, Trigger
from test_msgs.action import Fibonacci, NestedMessage

TOPIC = r"create_{}\(\) called for existing topic name rt/t with incompatible type std_msgs::msg::dds_::Empty_"
SERVICE = r"create_{}\(\) called for existing request topic name rq/sRequest with incompatible type std_srvs::srv::dds_::Set"


@pytest.mark.parametrize("second", ["publisher", "subscription"])
@pytest.mark.parametrize("first", ["publisher", "subscription"])
@pytest.mark.parametrize("same_node", [True, False])
def test_a_topic_has_the_type_of_its_first_end(world, first, second, same_node):
    make = {
        "publisher": lambda node, kind: node.create_publisher(kind, "t", 1),
        "subscription": lambda node, kind: node.create_subscription(kind, "t", print, 1),
    }
    node = world.node()
    end = make[first](node, String)
    other = node if same_node else world.node("other")
    with pytest.raises(_rclpy.RCLError, match=f"Failed to create {second}: {TOPIC.format(second)}"):
        make[second](other, Empty)
    make[second](other, String)
    assert end.handle is not None


def test_once_its_ends_are_gone_it_may_have_another(world):
    node = world.node()
    publisher = node.create_publisher(String, "t", 1)
    node.destroy_publisher(publisher)
    node.create_publisher(Empty, "t", 1)


@pytest.mark.parametrize("second", ["service", "client"])
@pytest.mark.parametrize("first", ["service", "client"])
def test_a_service_has_the_type_of_its_first_end(world, first, second):
    make = {
        "service": lambda kind: world.node().create_service(kind, "s", print),
        "client": lambda kind: world.node("caller").create_client(kind, "s"),
    }
    end = make[first](Trigger)
    with pytest.raises(_rclpy.RCLError, match=f"failed to create {second}: {SERVICE.format(second)}"):
        make[second](SetBool)
    assert end is not None


@pytest.mark.parametrize("second", ["client", "server"])
def test_so_has_an_action(world, second):
    server = ActionServer(world.node(), Fibonacci, "turn", lambda goal: Fibonacci.Result())
    other = world.node("other")
    why = f"Failed to create action {second}: .* incompatible type test_msgs::action::dds_::NestedMessage_SendGoal_Request_"
    with pytest.raises(ValueError, match=why):
        ActionClient(other, NestedMessage, "turn") if second == "client" else ActionServer(other, NestedMessage, "turn", id)
    server.destroy()
