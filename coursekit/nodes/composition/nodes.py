"""Talker, listener, server and client of the composition demo."""

import rclpy
from example_interfaces.srv import AddTwoInts

from coursekit.nodes.cpp_node import CppNode, as_cpp
from coursekit.nodes.demo_nodes.listener import Listener
from coursekit.nodes.demo_nodes.talker import Talker
from coursekit.nodes.running import run, spin_to_the_end


class Server(CppNode):
    """Adds two numbers."""

    def __init__(self) -> None:
        super().__init__("Server")
        self._service = self.create_service(AddTwoInts, "add_two_ints", self._add)

    def _add(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        self.get_logger().info(f"Incoming request: [a: {request.a}, b: {request.b}]")
        response.sum = request.a + request.b
        return response


class Client(CppNode):
    """Requests 2 + 3 every two seconds."""

    def __init__(self) -> None:
        super().__init__("Client")
        self._asking = self.create_client(AddTwoInts, "add_two_ints")
        self._timer = self.create_timer(2.0, self._ask)

    def _ask(self) -> None:
        if not self._asking.wait_for_service(timeout_sec=1.0):
            self.get_logger().info("Service not available after waiting")
            return
        future = self._asking.call_async(AddTwoInts.Request(a=2, b=3))
        future.add_done_callback(lambda done: self.get_logger().info(f"Got result: [{done.result().sum}]"))


def talker(args: list[str] | None = None) -> int:
    """The talker, which counts from 1."""
    return run(lambda: as_cpp(Talker)(1, "'"), args)


def listener(args: list[str] | None = None) -> int:
    """The listener."""
    return run(as_cpp(Listener), args)


def server(args: list[str] | None = None) -> int:
    """The server."""
    return run(Server, args)


def client(args: list[str] | None = None) -> int:
    """The client."""
    return run(Client, args)


def all_in_one(args: list[str] | None = None) -> int:
    """All four in one process, until Ctrl-C."""
    rclpy.init(args=args)
    return spin_to_the_end(as_cpp(Talker)(1, "'"), as_cpp(Listener)(), Server(), Client())
