"""Normalizes the many forms of parameters, before substitutions are performed."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

import yaml
from launch.some_substitutions_type import SomeSubstitutionsType_types_tuple
from launch.substitution import Substitution
from launch.substitutions import TextSubstitution
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions

from ..parameter_descriptions import Parameter, ParameterFile, ParameterValue
from ..parameters_type import Parameters, ParametersDict, SomeParameters, SomeParametersDict

SCALARS = (float, int, str, bool)


def normalize_parameters(parameters: SomeParameters) -> Parameters:
    """Return files as ParameterFile and mappings with tuples of substitutions as names.

    Raises:
        TypeError: if `parameters` is not a list, or contains anything else.
    """
    if isinstance(parameters, str) or not isinstance(parameters, Sequence):
        raise TypeError(f"Expecting list of parameters, got {parameters}")
    return tuple(_normalize_one(parameter) for parameter in parameters)


def _normalize_one(parameter: Any) -> Any:
    if isinstance(parameter, Mapping):
        return normalize_parameter_dict(parameter)
    if isinstance(parameter, (Parameter, ParameterFile)):
        return parameter
    ensure_argument_type(parameter, (*SomeSubstitutionsType_types_tuple, os.PathLike), "parameters")
    return ParameterFile(parameter)


def normalize_parameter_dict(
    parameters: SomeParametersDict, *, _prefix: Sequence[Substitution] | None = None
) -> ParametersDict:
    """Return a flat mapping: names joined by dots, lists of one type, text in quotes.

    Text in the launch file stays text, even if it looks like another type. The text of substitutions is
    read by YAML's rules later. Integers among floats become floats.

    Raises:
        TypeError: for values that cannot be parameters.
    """
    if not isinstance(parameters, Mapping):
        raise TypeError("expected dict")
    normalized: ParametersDict = {}
    for name, value in parameters.items():
        parts = normalize_to_list_of_substitutions(name)
        if _prefix:
            parts = [*_prefix, TextSubstitution(text="."), *parts]
        if isinstance(value, Mapping):
            normalized.update(normalize_parameter_dict(value, _prefix=parts))
        else:
            normalized[tuple(parts)] = _normalize_value(value)
    return normalized


def _normalize_value(value: Any) -> Any:
    if isinstance(value, str):
        return tuple(normalize_to_list_of_substitutions(yaml.dump(value)))
    if isinstance(value, Substitution):
        return (value,)
    if isinstance(value, (float, bool, int, bytes, ParameterValue)):
        return value
    if isinstance(value, Sequence):
        return _normalize_list(value)
    raise TypeError(f"Unexpected type for parameter value {value!r}")


def _normalize_list(values: Sequence[Any]) -> tuple[Any, ...]:
    for value in values:
        ensure_argument_type(value, (*SCALARS, *SomeSubstitutionsType_types_tuple), "subvalue")
    kinds = {Substitution if isinstance(value, Substitution) else type(value) for value in values}
    if kinds in ({int}, {bool}):
        return tuple(values)
    if kinds in ({float}, {int, float}):
        return tuple(float(value) for value in values)
    if Substitution in kinds and kinds <= {str, Substitution}:
        return tuple(normalize_to_list_of_substitutions(values))
    quoted = [yaml.dump(value) if isinstance(value, SCALARS) else value for value in values]
    return tuple(normalize_to_list_of_substitutions(value) for value in quoted)
