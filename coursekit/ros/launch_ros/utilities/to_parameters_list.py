"""Conversion of parameters to rclpy's form."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import yaml
from launch.launch_context import LaunchContext

from coursekit.files import read_text

from ..parameter_descriptions import Parameter
from ..parameters_type import EvaluatedParameters
from .evaluate_parameters import evaluate_parameter_dict
from .normalize_parameters import normalize_parameter_dict


def to_parameters_list(
    context: LaunchContext, node_name: str | None, namespace: str | None, evaluated_parameters: EvaluatedParameters
) -> list[Any]:
    """Return evaluated parameters as rclpy.parameter.Parameter objects, in order; of equal names the last one applies.

    Files are read as a node reads them, with their wildcards and node names. A file without `ros__parameters` has
    only names and values, and applies to every node.

    Raises:
        RuntimeError: if a file is no parameter file.
    """
    import rclpy.parameter

    values: list[tuple[str, Any]] = []
    for parameter in evaluated_parameters:
        if isinstance(parameter, Parameter):
            values.append(parameter.evaluate(context))
        elif isinstance(parameter, dict):
            values += parameter.items()
        else:
            full_name = f"{(namespace or '').rstrip('/')}/{node_name or ''}"
            values += _values_in_file(context, str(parameter), full_name).items()
    return [
        rclpy.parameter.Parameter(name, value=list(value) if isinstance(value, tuple) else value)
        for name, value in values
    ]


def _values_in_file(context: LaunchContext, path: str, full_name: str) -> Mapping[str, Any]:
    from coursekit.rcl.arguments import RosArgumentsError, parse_ros_arguments

    try:
        tree = yaml.safe_load(read_text(path))
    except (OSError, ValueError, yaml.YAMLError):
        tree = None  # the reader of node names says what is wrong
    if isinstance(tree, dict) and not _has_node_names(tree):
        return evaluate_parameter_dict(context, normalize_parameter_dict(tree))
    try:
        return parse_ros_arguments(["--ros-args", "--params-file", path]).parameters_for(full_name)
    except RosArgumentsError as error:
        raise RuntimeError(f"invalid yaml file {path}, error: {error}") from error


def _has_node_names(tree: Mapping[str, Any]) -> bool:
    return "ros__parameters" in tree or any(_has_node_names(part) for part in tree.values() if isinstance(part, dict))


def yaml_inline(value: Any) -> str:
    """Return a value as one line of YAML, as `-p name:=value` requires.

    >>> yaml_inline((1, 2)), yaml_inline('1'), yaml_inline(True)
    ('[1, 2]', "'1'", 'true')
    """
    plain = list(value) if isinstance(value, tuple) else value
    text = yaml.safe_dump(plain, default_flow_style=True, width=float("inf"))
    return text.removesuffix("\n").removesuffix("\n...")
