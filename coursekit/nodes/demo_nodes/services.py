"""The service `add_two_ints`, and several clients."""

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.node import Node
from rclpy.task import Future

from coursekit.nodes.cpp_node import CppNode, as_cpp
from coursekit.nodes.demo_nodes.spinning import spin_demo
from coursekit.nodes.running import run


class AddTwoIntsServer(Node):
    """Adds two integers."""

    def __init__(self) -> None:
        super().__init__("add_two_ints_server")
        self._service = self.create_service(AddTwoInts, "add_two_ints", self._add)

    def _add(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        self.get_logger().info(f"Incoming request\na: {request.a} b: {request.b}")
        return response


def server(args: list[str] | None = None) -> None:
    """Serve until Ctrl-C."""
    spin_demo(AddTwoIntsServer, args)


def server_cpp(args: list[str] | None = None) -> int:
    """Serve as demo_nodes_cpp's server does."""
    return run(as_cpp(AddTwoIntsServer), args)


def client(args: list[str] | None = None) -> None:
    """Send one request and print the sum."""
    rclpy.init(args=args)
    node = rclpy.create_node("add_two_ints_client")
    asking = node.create_client(AddTwoInts, "add_two_ints")
    while not asking.wait_for_service(timeout_sec=1.0):
        print("service not available, waiting again...")
    future = asking.call_async(AddTwoInts.Request(a=2, b=3))
    rclpy.spin_until_future_complete(node, future)
    if future.result() is not None:
        node.get_logger().info(f"Result of add_two_ints: {future.result().sum}")
    else:
        node.get_logger().error(f"Exception while calling service: {future.exception()!r}")
    node.destroy_node()
    rclpy.shutdown()


def client_async(args: list[str] | None = None) -> None:
    """Send one request and do other work until the response arrives."""
    rclpy.init(args=args)
    node = rclpy.create_node("add_two_ints_client")
    asking = node.create_client(AddTwoInts, "add_two_ints")
    while not asking.wait_for_service(timeout_sec=1.0):
        node.get_logger().info("service not available, waiting again...")
    future = asking.call_async(AddTwoInts.Request(a=2, b=3))
    while rclpy.ok():
        rclpy.spin_once(node)
        if future.done():
            node.get_logger().info(f"Result of add_two_ints: {future.result().sum}")
            break
    node.destroy_node()
    rclpy.shutdown()


class AskingNode(CppNode):
    """Sends one request as soon as there is a server, and ends with the response."""

    def __init__(self) -> None:
        super().__init__("add_two_ints_client")
        self._asking = self.create_client(AddTwoInts, "add_two_ints")
        self._timer = self.create_timer(0.0, self._ask)

    def _ask(self) -> None:
        self._timer.cancel()
        while not self._asking.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("service not available, waiting again...")
        self._asking.call_async(AddTwoInts.Request(a=2, b=3)).add_done_callback(self._answered)

    def _answered(self, future: Future) -> None:
        self.get_logger().info(f"Result of add_two_ints: {future.result().sum}")
        rclpy.shutdown()


def client_cpp(args: list[str] | None = None) -> int:
    """Send one request as demo_nodes_cpp's clients do."""
    return run(AskingNode, args)
