import pytest
from rclpy.executors import SingleThreadedExecutor
from rclpy.lifecycle import LifecycleNode
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import SetBool


@pytest.mark.parametrize(
    ("method", "message"),
    [
        (Node.create_subscription, r"Node\.create_subscription\(\) missing 5 required"),
        (Node.create_timer, r"Node\.create_timer\(\) missing 3 required"),
        (Node.declare_parameter, r"Node\.declare_parameter\(\) missing 2 required"),
        (Node.set_parameters, r"Node\.set_parameters\(\) missing 2 required"),
        (Node.count_publishers, r"Node\.count_publishers\(\) missing 2 required"),
        (Node.get_name, r"Node\.get_name\(\) missing 1 required"),
        (LifecycleNode.create_client, r"Node\.create_client\(\) missing 3 required"),
        (SingleThreadedExecutor.create_task, r"Executor\.create_task\(\) missing 2 required"),
    ],
)
def test_errors_name_a_method_after_its_class(method, message):
    with pytest.raises(TypeError, match=f"^{message}"):
        method()


@pytest.mark.parametrize("kind", [String, SetBool.Request, SetBool])
def test_errors_name_an_interface_after_itself(kind):
    with pytest.raises(TypeError, match=rf"^{kind.__name__}\.__init__\(\) takes 1 positional argument but 2 were given"):
        kind(True)
