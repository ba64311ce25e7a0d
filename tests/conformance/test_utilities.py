import pytest
import rclpy
from rclpy.context import Context
from rclpy.topic_endpoint_info import TopicEndpointTypeEnum
from rclpy.utilities import get_default_context, ok, timeout_sec_to_nsec


def test_the_default_context_is_one():
    assert get_default_context() is get_default_context()
    assert rclpy.get_default_context() is get_default_context()


def test_ok_asks_a_context():
    assert not ok(context=Context())


@pytest.mark.parametrize(("seconds", "nanoseconds"), [(0, 0), (1.5, 1_500_000_000), (None, -1), (-3, -1)])
def test_timeouts_in_nanoseconds(seconds, nanoseconds):
    assert timeout_sec_to_nsec(seconds) == nanoseconds


def test_endpoint_types():
    assert [each.name for each in TopicEndpointTypeEnum] == ["INVALID", "PUBLISHER", "SUBSCRIPTION"]


def test_a_node_of_the_default_context():
    rclpy.init()
    try:
        node, calls = rclpy.create_node("n"), []
        node.create_timer(0.01, lambda: calls.append(1))
        for _ in range(200):
            rclpy.spin_once(node, timeout_sec=0.1)
            if calls:
                break
        assert calls
        node.destroy_node()
    finally:
        rclpy.shutdown()


def test_spin_once_of_the_module_leaves_the_node_free():
    rclpy.init()
    try:
        node = rclpy.create_node("n")
        rclpy.spin_once(node, timeout_sec=0)
        assert node not in rclpy.get_global_executor().get_nodes()
        node.destroy_node()
    finally:
        rclpy.shutdown()


def test_enums_show_their_names():
    from rclpy.clock import ClockType
    from rclpy.lifecycle import TransitionCallbackReturn

    assert str(ClockType.ROS_TIME) == "ClockType.ROS_TIME"
    assert str(TransitionCallbackReturn.SUCCESS).endswith(".SUCCESS")


def test_errors_are_runtime_errors():
    from rclpy import _rclpy_pybind11 as native

    for name in ("RCLError", "RMWError", "InvalidHandle", "UnknownROSArgsError", "NodeNameNonExistentError"):
        assert issubclass(getattr(native, name), RuntimeError)
