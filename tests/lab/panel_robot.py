"""A robot for panels to look at, and a browser that looks."""

from collections.abc import Iterator
from contextlib import contextmanager

import rclpy
from example_interfaces.srv import AddTwoInts
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

from coursekit.lab.panel import end_panels
from coursekit.processes.session import Session


class Robot(Node):
    """Publishes, serves, logs and has parameters."""

    def __init__(self):
        super().__init__("robot")
        self.count = 0
        self.publisher = self.create_publisher(String, "news", 10)
        self.create_timer(0.5, self.publish)
        self.create_service(AddTwoInts, "add", self.add)
        limits = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=1)])
        self.declare_parameter("speed", 3, limits)
        self.declare_parameter("names", ["a", "b"])
        self.declare_parameter("serial", "X1", ParameterDescriptor(read_only=True))
        self.add_on_set_parameters_callback(self.judge)

    def publish(self):
        self.count += 1
        self.publisher.publish(String(data=f"news {self.count}"))
        self.get_logger().info(f"sent {self.count}")
        if self.count == 2:
            self.get_logger().warning("two is enough")

    def add(self, request, response):
        response.sum = request.a + request.b
        return response

    def judge(self, parameters):
        bad = any(parameter.name == "names" and not parameter.value for parameter in parameters)
        return SetParametersResult(successful=not bad, reason="names must not be empty" if bad else "")


def main():
    rclpy.init()
    try:
        rclpy.spin(Robot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


@contextmanager
def robot_running() -> Iterator[Session]:
    """A virtual session with the robot in it."""
    with Session(virtual=True).use() as virtual_session:
        virtual_session.start(main, name="robot")
        virtual_session.clock.sleep(0.1)
        yield virtual_session
        end_panels()


def heard_by_browser(panel, monkeypatch):
    """What the panel sends from now on."""
    sent = []
    monkeypatch.setattr(panel, "send", lambda message, buffers=None: sent.append(message))
    return sent


def says(panel, **message):
    panel._hear(panel, message, [])
