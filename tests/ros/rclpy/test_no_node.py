"""What is no node is refused by executors, and leaves them as they were."""

import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node

from coursekit.processes.session import Session


class Unfinished(Node):
    def __init__(self):
        pass  # its base was forgotten


@pytest.mark.parametrize(
    ("thing", "error", "says"),
    [
        (Unfinished, TypeError, r"Unfinished is a class.*make one of it, as in rclpy.spin\(Unfinished\(\)\)"),
        (Unfinished(), AttributeError, "'Unfinished' object has no attribute"),
        (None, AttributeError, "'NoneType' object has no attribute 'executor'"),
    ],
)
def test_what_is_no_node_is_refused_and_forgotten(thing, error, says):
    with Session(virtual=True).use():
        rclpy.init()
        executor = SingleThreadedExecutor()
        with pytest.raises(error, match=says):
            rclpy.spin(thing, executor)
        assert executor.get_nodes() == []
        assert executor.shutdown()
        rclpy.shutdown()
        assert not rclpy.ok()
