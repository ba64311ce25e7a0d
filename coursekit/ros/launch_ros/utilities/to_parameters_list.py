"""Conversion of parameters to rclpy's form."""

from __future__ import annotations

from typing import Any

import yaml
from launch.launch_context import LaunchContext

from ..parameter_descriptions import Parameter
from ..parameters_type import EvaluatedParameters


def to_parameters_list(
    context: LaunchContext, node_name: str | None, namespace: str | None, evaluated_parameters: EvaluatedParameters
) -> list[Any]:
    """Return evaluated parameters as rclpy.parameter.Parameter objects, in order; of equal names the last one applies.

    Files are read as a node reads them, with their wildcards and node names.
    """
    import rclpy.parameter

    values: list[tuple[str, Any]] = []
    for parameter in evaluated_parameters:
        if isinstance(parameter, Parameter):
            values.append(parameter.evaluate(context))
        elif isinstance(parameter, dict):
            values += parameter.items()
        else:
            from coursekit.rcl.arguments import parse_ros_arguments

            full_name = f"{(namespace or '').rstrip('/')}/{node_name or ''}"
            arguments = parse_ros_arguments(["--ros-args", "--params-file", str(parameter)])
            values += arguments.parameters_for(full_name).items()
    return [
        rclpy.parameter.Parameter(name, value=list(value) if isinstance(value, tuple) else value)
        for name, value in values
    ]


def yaml_inline(value: Any) -> str:
    """Return a value as one line of YAML, as `-p name:=value` requires.

    >>> yaml_inline((1, 2)), yaml_inline('1'), yaml_inline(True)
    ('[1, 2]', "'1'", 'true')
    """
    plain = list(value) if isinstance(value, tuple) else value
    text = yaml.safe_dump(plain, default_flow_style=True, width=float("inf"))
    return text.removesuffix("\n").removesuffix("\n...")
