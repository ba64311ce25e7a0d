"""Parameters as rclpy has them."""

from __future__ import annotations

from typing import Any

import yaml
from launch.launch_context import LaunchContext

from ..parameter_descriptions import Parameter
from ..parameters_type import EvaluatedParameters


def to_parameters_list(
    context: LaunchContext, node_name: str | None, namespace: str | None, evaluated_parameters: EvaluatedParameters
) -> list[Any]:
    """Return evaluated parameters as rclpy.parameter.Parameter objects, in order: of two with one name the later holds.

    Files are read with their wildcards and node names, as a node reads them.
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
    """Return a value as YAML on one line, as a `-p name:=value` takes it.

    >>> yaml_inline((1, 2)), yaml_inline('1'), yaml_inline(True)
    ('[1, 2]', "'1'", 'true')
    """
    plain = list(value) if isinstance(value, tuple) else value
    text = yaml.safe_dump(plain, default_flow_style=True, width=float("inf"))
    return text.removesuffix("\n").removesuffix("\n...")
