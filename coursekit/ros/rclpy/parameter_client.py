"""Another node's parameters, through its six services. In ROS 2: rclpy.parameter_client."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Parameter as ParameterMsg
from rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)

from coursekit.processes import session
from rclpy.parameter import Parameter, parameter_dict_from_yaml_file
from rclpy.qos import QoSProfile, qos_profile_services_default
from rclpy.task import Future

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node

Done = Callable[[Future], None]


class AsyncParameterClient:
    """Gets and sets the parameters of the node `remote_node_name`; every response is a Future.

    The `callback` of each method, when given, is called with that future once it is done.

    >>> other = rclpy.create_node("other")
    >>> speed = other.declare_parameter("speed", 0.5)
    >>> client = AsyncParameterClient(node, "other")
    >>> future = client.get_parameters(["speed"])
    >>> executor = rclpy.executors.SingleThreadedExecutor()
    >>> executor.add_node(node), executor.add_node(other)
    (True, True)
    >>> executor.spin_until_future_complete(future)
    >>> future.result().values[0].double_value
    0.5
    """

    def __init__(
        self,
        node: Node,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        self.node = node
        self.remote_node_name = remote_node_name

        def client(type_: Any, name: str) -> Any:
            full = f"{remote_node_name}/{name}"
            return node.create_client(type_, full, qos_profile=qos_profile, callback_group=callback_group)

        self._get_parameter_client = client(GetParameters, "get_parameters")
        self._list_parameter_client = client(ListParameters, "list_parameters")
        self._set_parameter_client = client(SetParameters, "set_parameters")
        self._get_parameter_types_client = client(GetParameterTypes, "get_parameter_types")
        self._describe_parameters_client = client(DescribeParameters, "describe_parameters")
        self._set_parameters_atomically_client = client(SetParametersAtomically, "set_parameters_atomically")

    @property
    def _clients(self) -> list[Any]:
        return [
            self._list_parameter_client,
            self._set_parameter_client,
            self._get_parameter_client,
            self._get_parameter_types_client,
            self._describe_parameters_client,
            self._set_parameters_atomically_client,
        ]

    def services_are_ready(self) -> bool:
        """Return whether all six services are available."""
        return all(client.service_is_ready() for client in self._clients)

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Wait for all six services; False if `timeout_sec` seconds passed."""
        clock = session.current().clock
        end = None if timeout_sec is None else clock.steady() + int(timeout_sec * 1e9)
        for client in self._clients:
            left = None if end is None else max(0.0, (end - clock.steady()) / 1e9)
            if not client.wait_for_service(left):
                return False
        return True

    def list_parameters(
        self, prefixes: list[str] | None = None, depth: int | None = None, callback: Done | None = None
    ) -> Future:
        """Request the names below `prefixes`, `depth` levels deep (0 is all)."""
        request = ListParameters.Request(prefixes=prefixes or [], depth=depth or 0)
        return _ask(self._list_parameter_client, request, callback)

    def get_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Request values."""
        return _ask(self._get_parameter_client, GetParameters.Request(names=names), callback)

    def get_parameter_types(self, names: list[str], callback: Done | None = None) -> Future:
        """Request types."""
        return _ask(self._get_parameter_types_client, GetParameterTypes.Request(names=names), callback)

    def describe_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Request descriptors."""
        return _ask(self._describe_parameters_client, DescribeParameters.Request(names=names), callback)

    def set_parameters(
        self, parameters: Sequence[Parameter | ParameterMsg], callback: Done | None = None
    ) -> Future:
        """Set each parameter separately."""
        request = SetParameters.Request(parameters=_messages(parameters))
        return _ask(self._set_parameter_client, request, callback)

    def set_parameters_atomically(
        self, parameters: Sequence[Parameter | ParameterMsg], callback: Done | None = None
    ) -> Future:
        """Set all parameters or none."""
        request = SetParametersAtomically.Request(parameters=_messages(parameters))
        return _ask(self._set_parameters_atomically_client, request, callback)

    def delete_parameters(self, names: list[str], callback: Done | None = None) -> Future:
        """Set each to NOT_SET, which undeclares it if the node allows that."""
        request = SetParameters.Request(parameters=[ParameterMsg(name=name) for name in names])
        return _ask(self._set_parameter_client, request, callback)

    def load_parameter_file(
        self, parameter_file: str, use_wildcard: bool = False, callback: Done | None = None
    ) -> Future:
        """Set the parameters in a YAML file, each separately; the file's node names do not matter."""
        read = parameter_dict_from_yaml_file(parameter_file, use_wildcard)
        return self.set_parameters(list(read.values()), callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: Done | None = None
    ) -> Future:
        """Set the parameters in a YAML file, all or none; the file's node names do not matter."""
        read = parameter_dict_from_yaml_file(parameter_file, use_wildcard)
        return self.set_parameters_atomically(list(read.values()), callback)


def _ask(client: Any, request: Any, callback: Done | None) -> Future:
    future = client.call_async(request)
    if callback is not None:
        future.add_done_callback(callback)
    return future


def _messages(parameters: Sequence[Parameter | ParameterMsg]) -> list[ParameterMsg]:
    return [
        parameter.to_parameter_msg() if isinstance(parameter, Parameter) else parameter
        for parameter in parameters
    ]
