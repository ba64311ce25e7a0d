"""Nodes that set, list and get their own parameters, through the services that other nodes would use."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.running import to_the_end

if TYPE_CHECKING:
    from rclpy.task import Future

_TYPES = {
    Parameter.Type.INTEGER: "integer",
    Parameter.Type.DOUBLE: "double",
    Parameter.Type.BOOL_ARRAY: "bool_array",
    Parameter.Type.BYTE_ARRAY: "byte_array",
}
_COMMON: dict[str, Any] = {"foo": 2, "bar": "hello", "baz": 1.45, "foobar": True}


def in_cpp(value: Any) -> str:
    """Format a parameter's value like rclcpp.

    >>> [in_cpp(value) for value in (2, 1.45, True, [True, False], [b"\\xff"])]
    ['2', '1.450000', 'true', '[true, false]', '[0xff]']
    """
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(in_cpp(item) for item in value)}]"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, bytes):
        return f"0x{value.hex()}"
    return f"{value:f}" if isinstance(value, float) else str(value)


class Asking:
    """Declares parameters on a node, and calls the node's own parameter services."""

    def __init__(self, name: str, wanted: dict[str, Any]) -> None:
        self.node = CppNode(name)
        self.wanted = [Parameter(key, value=value) for key, value in wanted.items()]
        for parameter in self.wanted:
            self.node.declare_parameter(parameter.name, parameter.type_)
        self.client = AsyncParameterClient(self.node, name)

    def answer(self, future: Future) -> Any:
        """Spin until the response arrives, and return it."""
        rclpy.spin_until_future_complete(self.node, future)
        return future.result()

    def set(self) -> None:
        """Set the parameters; report rejected ones."""
        for result in self.answer(self.client.set_parameters(self.wanted)).results:
            if not result.successful:
                self.node.get_logger().error(f"Failed to set parameter: {result.reason}")


def _list(name: str, args: list[str] | None) -> int:
    rclpy.init(args=args)
    asking = Asking(name, {**_COMMON, "foo.first": 8, "foo.second": 42})
    log = asking.node.get_logger()
    with to_the_end(asking.node):
        log.info("Setting parameters...")
        asking.set()
        log.info("Listing parameters...")
        listed = asking.answer(asking.client.list_parameters(["foo", "bar"], 10)).result
        lines = ["", "Parameter names:", *(f" {parameter}" for parameter in sorted(listed.names))]
        log.info("\n".join([*lines, "Parameter prefixes:", *(f" {prefix}" for prefix in listed.prefixes)]))
    return 0


def _set_and_get(name: str, args: list[str] | None) -> int:
    rclpy.init(args=args)
    asking = Asking(name, {**_COMMON, "foobarbaz": [True, False], "toto": [b"\xff", b"\x7f"]})
    with to_the_end(asking.node):
        asking.set()
        told = ""
        for parameter in asking.node.get_parameters(["foo", "baz", "foobarbaz", "toto"]):
            told += (
                f"\nParameter name: {parameter.name}\nParameter value ({_TYPES[parameter.type_]}): {in_cpp(parameter.value)}"
            )
        asking.node.get_logger().info(told)
    return 0


def list_parameters(args: list[str] | None = None) -> int:
    """Set some parameters, and list those below foo and bar. The node's name is misspelt as in C++."""
    return _list("list_paramters", args)


def list_parameters_async(args: list[str] | None = None) -> int:
    """Do the same under the asynchronous name."""
    return _list("list_parameters_async", args)


def set_and_get(args: list[str] | None = None) -> int:
    """Set some parameters, and log four of them."""
    return _set_and_get("set_and_get_parameters", args)


def set_and_get_async(args: list[str] | None = None) -> int:
    """Do the same under the asynchronous name."""
    return _set_and_get("set_and_get_parameters_async", args)
