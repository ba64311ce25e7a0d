"""A node's parameters, read and set with its services."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Parameter, ParameterValue
from rcl_interfaces.srv import DescribeParameters, GetParameters, ListParameters, SetParameters
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, parameter_dict_from_yaml_file
from rclpy.parameter import get_parameter_value as _from_text
from ros2cli.helpers import call_service
from ros2cli.node.direct import DirectNode

from coursekit.cli import param_text

if TYPE_CHECKING:
    from argparse import Namespace


def get_value(*, parameter_value: ParameterValue) -> Any:
    """The plain value of a ParameterValue, lists for arrays; None when it is not set.

    >>> get_value(parameter_value=get_parameter_value(string_value="[1, 2]"))
    [1, 2]
    """
    value = param_text.labelled(parameter_value)[1]
    return list(value) if value is not None and parameter_value.type > 4 else value


def get_parameter_value(*, string_value: str) -> ParameterValue:
    """The value of a text, with its type inferred as in YAML."""
    return _from_text(string_value)


def get_parameter_type_string(parameter_type: int) -> str:
    """The name of a parameter type.

    >>> get_parameter_type_string(2)
    'integer'
    """
    return param_text.type_name(parameter_type)


def parse_parameter_dict(*, namespace: str, parameter_dict: dict[str, Any]) -> list[Parameter]:
    """The parameters of a tree of values, the levels of their names joined by dots.

    >>> [one.name for one in parse_parameter_dict(namespace="", parameter_dict={"a": {"b": 1}, "c": 2})]
    ['a.b', 'c']
    """
    parameters: list[Parameter] = []
    for name, value in parameter_dict.items():
        full_name = namespace + name
        if isinstance(value, dict):
            parameters += parse_parameter_dict(namespace=full_name + PARAMETER_SEPARATOR_STRING, parameter_dict=value)
        else:
            parameters.append(Parameter(name=full_name, value=get_parameter_value(string_value=str(value))))
    return parameters


def _call(node: Any, kind: Any, name: str, request: Any) -> Any:
    return call_service(node, kind, name, request, absent="Wait for service timed out")


def call_describe_parameters(*, node: Any, node_name: str, parameter_names: list[str] | None = None) -> Any:
    """The response of a node's describe_parameters; raises RuntimeError if there is none."""
    request = DescribeParameters.Request(names=parameter_names or [])
    return _call(node, DescribeParameters, f"{node_name}/describe_parameters", request)


def call_get_parameters(*, node: Any, node_name: str, parameter_names: list[str]) -> Any:
    """The response of a node's get_parameters; raises RuntimeError if there is none."""
    return _call(node, GetParameters, f"{node_name}/get_parameters", GetParameters.Request(names=parameter_names))


def call_set_parameters(*, node: Any, node_name: str, parameters: list[Parameter]) -> Any:
    """The response of a node's set_parameters; raises RuntimeError if there is none."""
    return _call(node, SetParameters, f"{node_name}/set_parameters", SetParameters.Request(parameters=parameters))


def call_list_parameters(*, node: Any, node_name: str, prefix: str | None = None) -> list[str]:
    """The names of a node's parameters; raises RuntimeError if the node does not respond."""
    request = ListParameters.Request(prefixes=[prefix] if prefix else [])
    return list(_call(node, ListParameters, f"{node_name}/list_parameters", request).result.names)


def load_parameter_dict(*, node: Any, node_name: str, parameter_dict: dict[str, Any]) -> None:
    """Set a tree of values, and print the result of each."""
    parameters = parse_parameter_dict(namespace="", parameter_dict=parameter_dict)
    _set_and_tell(node, node_name, parameters)


def load_parameter_file(*, node: Any, node_name: str, parameter_file: str, use_wildcard: bool) -> None:
    """Set the values of a file for the node, and print the result of each."""
    parameters = parameter_dict_from_yaml_file(parameter_file, use_wildcard, target_nodes=[node_name])
    _set_and_tell(node, node_name, list(parameters.values()))


def _set_and_tell(node: Any, node_name: str, parameters: list[Parameter]) -> None:
    response = call_set_parameters(node=node, node_name=node_name, parameters=parameters)
    for parameter, result in zip(parameters, response.results, strict=True):
        text = f"Set parameter {parameter.name} {'successful' if result.successful else 'failed'}"
        text += f": {result.reason}" if result.reason else ""
        print(text, file=sys.stdout if result.successful else sys.stderr)


class ParameterNameCompleter:
    """Names of the parameters of the node on the command line, for argcomplete."""

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The names that begin with `prefix`."""
        with DirectNode(parsed_args) as node:
            names = call_list_parameters(node=node, node_name=parsed_args.node_name)
        return [name for name in names if name.startswith(prefix or "")]
