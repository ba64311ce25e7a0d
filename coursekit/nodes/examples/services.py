"""A minimal service and several clients."""

import sys

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.node import Node

from coursekit.nodes.cpp_node import as_cpp
from coursekit.nodes.running import run, to_the_end


class MinimalService(Node):
    """Adds two numbers."""

    def __init__(self, told: str = "Incoming request\na: {a} b: {b}") -> None:
        super().__init__("minimal_service")
        self._told = told
        self._service = self.create_service(AddTwoInts, "add_two_ints", self._add)

    def _add(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        self.get_logger().info(self._told.format(a=request.a, b=request.b))
        return response


def service(args: list[str] | None = None) -> int:
    """Serve until Ctrl-C."""
    return run(MinimalService, args)


def service_cpp(args: list[str] | None = None) -> int:
    """Serve as the C++ example does."""
    return run(lambda: as_cpp(MinimalService)("request: {a} + {b}"), args)


def _ask(name: str, request: AddTwoInts.Request, waiting: str, told: str) -> int:
    node = rclpy.create_node(name)
    with to_the_end(node):
        asking = node.create_client(AddTwoInts, "add_two_ints")
        while not asking.wait_for_service(timeout_sec=1.0):
            node.get_logger().info(waiting)
        future = asking.call_async(request)
        rclpy.spin_until_future_complete(node, future)
        total = future.result().sum
        node.get_logger().info(told.format(a=request.a, b=request.b, sum=total))
    return 0


_WAITING = "service not available, waiting again..."
_TOLD = "Result of add_two_ints: for {a} + {b} = {sum}"


def client(args: list[str] | None = None) -> int:
    """Request 41 + 1."""
    rclpy.init(args=args)
    return _ask("minimal_client", AddTwoInts.Request(a=41, b=1), _WAITING, _TOLD)


def client_async(args: list[str] | None = None) -> int:
    """Request 41 + 1, under the name of the asynchronous example."""
    rclpy.init(args=args)
    return _ask("minimal_client_async", AddTwoInts.Request(a=41, b=1), _WAITING, _TOLD)


def client_async_member_function(args: list[str] | None = None) -> int:
    """Request the sum of two numbers from the command line."""
    rclpy.init(args=args)
    request = AddTwoInts.Request(a=int(sys.argv[1]), b=int(sys.argv[2]))
    return _ask("minimal_client_async", request, _WAITING, _TOLD)


def client_cpp(args: list[str] | None = None) -> int:
    """Request 41 + 1 as the C++ example does."""
    rclpy.init(args=args)
    request = AddTwoInts.Request(a=41, b=1)
    return _ask("minimal_client", request, "waiting for service to appear...", "result of {a} + {b} = {sum}")


class CallingTimer(Node):
    """Sends a request in a timer's callback, and awaits the response there: both need a reentrant group."""

    def __init__(self) -> None:
        super().__init__("minimal_client")
        group = ReentrantCallbackGroup()
        self.answered = False
        self.asking = self.create_client(AddTwoInts, "add_two_ints", callback_group=group)
        self._group = group

    def begin(self) -> None:
        """Schedule the request in half a second."""
        self._timer = self.create_timer(0.5, self._ask, callback_group=self._group)

    async def _ask(self) -> None:
        self._timer.cancel()
        try:
            response = await self.asking.call_async(AddTwoInts.Request(a=41, b=1))
            self.get_logger().info(_TOLD.format(a=41, b=1, sum=response.sum))
        finally:
            self.answered = True


def client_async_callback(args: list[str] | None = None) -> int:
    """Send a request from a timer."""
    rclpy.init(args=args)
    node = CallingTimer()
    with to_the_end(node):
        while not node.asking.wait_for_service(timeout_sec=1.0):
            node.get_logger().info(_WAITING)
        node.begin()
        while rclpy.ok() and not node.answered:
            rclpy.spin_once(node)
    return 0
