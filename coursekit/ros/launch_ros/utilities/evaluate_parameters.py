"""Performs the substitutions in normalized parameters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import yaml
from launch.launch_context import LaunchContext
from launch.substitution import Substitution
from launch.utilities import ensure_argument_type, perform_substitutions

from ..parameter_descriptions import EvaluatedParameterValue, ParameterFile, ParameterValue
from ..parameters_type import EvaluatedParameters, Parameters, ParametersDict

SCALARS = (bool, int, float, str)
ADVICE = (
    "If the parameter is meant to be a string, try wrapping it in "
    "launch_ros.parameter_descriptions.ParameterValue(value, value_type=str)"
)


def evaluate_parameters(context: LaunchContext, parameters: Parameters) -> EvaluatedParameters:
    """Return paths for files and plain mappings for the rest."""
    evaluated: list[Any] = []
    for parameter in parameters:
        if isinstance(parameter, ParameterFile):
            evaluated.append(parameter.evaluate(context))
        elif isinstance(parameter, Mapping):
            evaluated.append(evaluate_parameter_dict(context, parameter))  # type: ignore[arg-type]
        else:
            evaluated.append(parameter)
    return tuple(evaluated)


def evaluate_parameter_dict(
    context: LaunchContext, parameters: ParametersDict
) -> dict[str, EvaluatedParameterValue]:
    """Return names and values; the text of substitutions is read by YAML's rules.

    Raises:
        TypeError: if a value cannot be a parameter, or if a list contains several types.
    """
    if not isinstance(parameters, Mapping):
        raise TypeError("expected dict")
    evaluated = {}
    for parts, value in parameters.items():
        if not isinstance(parts, tuple):
            raise TypeError(f"Expecting tuple of substitutions got {parts!r}")
        name = perform_substitutions(context, parts)
        evaluated[name] = _evaluate(context, name, value)
    return evaluated


def _evaluate(context: LaunchContext, name: str, value: Any) -> Any:
    if isinstance(value, ParameterValue):
        return value.evaluate(context)
    if not isinstance(value, tuple):
        ensure_argument_type(value, (float, int, str, bool, bytes), "value")
        return value
    if value and isinstance(value[0], Substitution):
        return _read(name, perform_substitutions(context, value))
    if value and isinstance(value[0], Sequence) and not isinstance(value[0], str):
        return _uniform(name, [yaml.safe_load(perform_substitutions(context, item)) for item in value])
    if not value:
        raise TypeError(f"given unnormalized parameters {name!r}, {value!r}: an empty list has no type")
    return value


def _read(name: str, text: str) -> Any:
    """Return a text's value by YAML's rules: a scalar, or a tuple of one type."""
    try:
        value = yaml.safe_load(text or "''")
    except yaml.YAMLError as error:
        raise TypeError(f"Unable to parse the value of parameter {name} as yaml. {ADVICE}") from error
    if isinstance(value, (*SCALARS, bytes)):
        return value
    if isinstance(value, list):
        return _uniform(name, value)
    raise TypeError(
        "Allowed value types are bytes, bool, int, float, str, Sequence[bool], Sequence[int], "
        f'Sequence[float], Sequence[str]. Got {type(value)} for "{name}". {ADVICE}'
    )


def _uniform(name: str, values: list[Any]) -> tuple[Any, ...]:
    kind = type(values[0]) if values else None
    if kind not in SCALARS or not all(type(value) is kind for value in values):
        raise TypeError(
            "Expected a non-empty sequence, with items of uniform type. Allowed sequence item types are "
            f'bool, int, float, str. Got inconsistent input for "{name}"'
        )
    return tuple(values)
