"""A server with a different sum: only a client that calls it gets its result."""

from __future__ import annotations

from example_interfaces.srv import AddTwoInts
from rclpy.node import Node

from coursekit.nodes.running import run


class OddAdder(Node):
    """Responds with a + b plus `more`, a number that cannot be requested."""

    def __init__(self) -> None:
        super().__init__("odd_adder", start_parameter_services=False)
        self._more = int(self.declare_parameter("more", 1).value)
        self._service = self.create_service(AddTwoInts, "add_two_ints", self._answer)

    def _answer(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b + self._more
        self.get_logger().info(f"asked for {request.a} and {request.b}")
        return response


def main(args: list[str] | None = None) -> int:
    """Serve until Ctrl-C."""
    return run(OddAdder, args)
