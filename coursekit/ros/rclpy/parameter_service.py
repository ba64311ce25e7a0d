"""The six services through which other nodes access a node's parameters. In ROS 2: rclpy.parameter_service."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import SetParametersResult
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

from rclpy.exceptions import ParameterNotDeclaredException, ParameterUninitializedException
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.qos import qos_profile_parameters

if TYPE_CHECKING:
    from rclpy.node import Node

TOPIC_SEPARATOR_STRING = "/"


class ParameterService:
    """Serves the parameters of one node, under `~/describe_parameters`, `~/get_parameters`, and so on."""

    def __init__(self, node: Node) -> None:
        self._node = weakref.ref(node)
        self.services = [
            node.create_service(type_, f"~/{name}", callback, qos_profile=qos_profile_parameters)
            for type_, name, callback in self._offers()
        ]

    def _offers(self) -> list[tuple[Any, str, Callable[[Any, Any], Any]]]:
        return [
            (DescribeParameters, "describe_parameters", self._describe),
            (GetParameters, "get_parameters", self._get),
            (GetParameterTypes, "get_parameter_types", self._types),
            (ListParameters, "list_parameters", self._list),
            (SetParameters, "set_parameters", self._set),
            (SetParametersAtomically, "set_parameters_atomically", self._set_atomically),
        ]

    @property
    def node(self) -> Any:
        """The node; ReferenceError if it no longer exists."""
        node = self._node()
        if node is None:
            raise ReferenceError("the node of this parameter service is gone")
        return node

    def _describe(
        self, request: DescribeParameters.Request, response: DescribeParameters.Response
    ) -> DescribeParameters.Response:
        try:
            response.descriptors = self.node.describe_parameters(request.names)
        except ParameterNotDeclaredException:
            response.descriptors = []
        return response

    def _get(self, request: GetParameters.Request, response: GetParameters.Response) -> GetParameters.Response:
        try:
            parameters = self.node.get_parameters(request.names)
            response.values = [parameter.get_parameter_value() for parameter in parameters]
        except (ParameterNotDeclaredException, ParameterUninitializedException):
            response.values = []
        return response

    def _types(self, request: GetParameterTypes.Request, response: GetParameterTypes.Response) -> GetParameterTypes.Response:
        try:
            response.types = self.node.get_parameter_types(request.names)
        except ParameterNotDeclaredException:
            response.types = []
        return response

    def _list(self, request: ListParameters.Request, response: ListParameters.Response) -> ListParameters.Response:
        names = [
            name for name in self.node._rclpy_listed_names() if is_listed(name, list(request.prefixes), request.depth)
        ]
        response.result.names = names
        prefixes = [name.rpartition(PARAMETER_SEPARATOR_STRING)[0] for name in names]
        response.result.prefixes = list(dict.fromkeys(prefix for prefix in prefixes if prefix))
        return response

    def _set(self, request: SetParameters.Request, response: SetParameters.Response) -> SetParameters.Response:
        for message in request.parameters:
            response.results.append(self._apply(self.node.set_parameters_atomically, [message]))
        return response

    def _set_atomically(
        self, request: SetParametersAtomically.Request, response: SetParametersAtomically.Response
    ) -> SetParametersAtomically.Response:
        response.result = self._apply(self.node.set_parameters_atomically, request.parameters, together=True)
        return response

    def _apply(self, setter: Callable[[list[Parameter]], Any], messages: Any, together: bool = False) -> Any:
        try:
            return setter([Parameter.from_parameter_msg(message) for message in messages])
        except (ParameterNotDeclaredException, ValueError) as error:
            return SetParametersResult(successful=False, reason=self.node._rclpy_reason(error, together))


def is_listed(name: str, prefixes: list[str], depth: int) -> bool:
    """Return whether ListParameters lists the parameter; depth 0 means no limit.

    >>> is_listed("b.c.d", ["b"], 1), is_listed("b.c", ["b"], 1), is_listed("a", [], 1)
    (False, True, True)
    """
    dot = PARAMETER_SEPARATOR_STRING
    if not prefixes:
        return depth == 0 or name.count(dot) < depth
    return any(
        name == prefix
        or (name.startswith(prefix + dot) and (depth == 0 or name[len(prefix) :].count(dot) <= depth))
        for prefix in prefixes
        if prefix
    )
