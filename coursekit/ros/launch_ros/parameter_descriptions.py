"""Descriptions of parameters, parameter values, and parameter files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import yaml
from launch.frontend.parse_substitution import parse_substitution
from launch.launch_context import LaunchContext
from launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.substitutions import SubstitutionFailure
from launch.temporary_files import temporary_files
from launch.utilities import (
    ensure_argument_type,
    normalize_to_list_of_substitutions,
    perform_substitutions,
)
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution

EvaluatedParameterValue = str | int | float | bool | bytes | list[str] | list[int] | list[float] | list[bool]


class ParameterValue:
    """A parameter's value with its required type, for example `value_type=str`.

    Without a type, the text of a substitution is read by YAML's rules.
    """

    def __init__(self, value: Any, *, value_type: Any = None) -> None:
        if isinstance(value, str) and value_type not in (None, str):
            raise TypeError(
                f"the text '{value}' was given for a parameter of type '{value_type}'; write the value without quotes"
            )
        self.__value = normalize_typed_substitution(value, value_type)
        self.__value_type = value_type
        self.__evaluated: Any = None

    @property
    def value(self) -> Any:
        """The value; it may contain substitutions until it is evaluated."""
        return self.__value if self.__evaluated is None else self.__evaluated

    @property
    def value_type(self) -> Any:
        """The required type; None if YAML's rules decide."""
        return self.__value_type

    def evaluate(self, context: LaunchContext) -> EvaluatedParameterValue:
        """Return the value in `context`."""
        self.__evaluated = perform_typed_substitution(context, self.__value, self.__value_type)
        value: EvaluatedParameterValue = self.__evaluated
        return value

    def __str__(self) -> str:
        return f"launch_ros.description.ParameterValue(value={self.value}, value_type={self.value_type})"


class Parameter:
    """One parameter, with name and value."""

    def __init__(self, name: SomeSubstitutionsType, value: Any, *, value_type: Any = None) -> None:
        ensure_argument_type(name, SomeSubstitutionsType_types_tuple, "name")
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = ParameterValue(value, value_type=value_type)
        self.__evaluated_name: str | None = None

    @property
    def name(self) -> Any:
        """The name, or its substitutions until it is evaluated."""
        return self.__name if self.__evaluated_name is None else self.__evaluated_name

    @property
    def value(self) -> Any:
        """The value; it may contain substitutions until it is evaluated."""
        return self.__value.value

    @property
    def value_type(self) -> Any:
        """The required type of the value; None if YAML's rules decide."""
        return self.__value.value_type

    def evaluate(self, context: LaunchContext) -> tuple[str, EvaluatedParameterValue]:
        """Return name and value in `context`."""
        self.__evaluated_name = perform_substitutions(context, self.__name)
        return self.__evaluated_name, self.__value.evaluate(context)

    def __str__(self) -> str:
        return (
            f"launch_ros.description.Parameter"
            f"(name={self.name}, value={self.value}, value_type={self.value_type})"
        )


class ParameterFile:
    """A parameter file; with `allow_substs` its text may contain substitutions such as `$(var name)`."""

    def __init__(
        self,
        param_file: SomeSubstitutionsType | os.PathLike[str] | bytes,
        *,
        allow_substs: bool | SomeSubstitutionsType = False,
    ) -> None:
        ensure_argument_type(
            param_file,
            (*SomeSubstitutionsType_types_tuple, os.PathLike, bytes),
            "param_file",
            "ParameterFile()",
        )
        if isinstance(param_file, (os.PathLike, bytes)):
            param_file = os.fsdecode(param_file)
        self.__param_file = normalize_to_list_of_substitutions(param_file)
        self.__allow_substs = normalize_typed_substitution(allow_substs, bool)
        self.__evaluated: Path | None = None
        self.__is_copy = False

    @property
    def param_file(self) -> Any:
        """The path, or its substitutions until it is evaluated."""
        return self.__param_file if self.__evaluated is None else self.__evaluated

    @property
    def allow_substs(self) -> Any:
        """Whether the text may contain substitutions."""
        return self.__allow_substs

    def evaluate(self, context: LaunchContext) -> Path:
        """Return the path; with `allow_substs`, that of a copy in which the substitutions have been performed.

        Raises:
            SubstitutionFailure: if the file, or the copy, is not YAML.
        """
        if self.__evaluated is None:
            path = Path(perform_substitutions(context, self.__param_file))
            if perform_typed_substitution(context, self.__allow_substs, bool):
                path = _substituted(context, path)
                self.__is_copy = True
            self.__evaluated = path
        return self.__evaluated

    def cleanup(self) -> None:
        """Delete the copy that `evaluate` created, and forget its path."""
        if self.__is_copy and self.__evaluated is not None:
            self.__evaluated.unlink(missing_ok=True)
            self.__evaluated, self.__is_copy = None, False

    def __str__(self) -> str:
        return (
            f"launch_ros.description.ParameterFile"
            f"(param_file={self.param_file}, allow_substs={self.allow_substs})"
        )


def _substituted(context: LaunchContext, path: Path) -> Path:
    """Write a copy of a parameter file in which all substitutions have been performed."""
    text = yaml.safe_dump(
        _yaml(path.read_text(encoding="utf-8"), f"{path} is not a valid yaml file"), sort_keys=False
    )
    performed = perform_substitutions(context, parse_substitution(text))
    _yaml(performed, f"{path} is not a valid yaml file after its substitutions were performed")
    copy = Path(temporary_files.new_path("launch_params_"))
    copy.write_text(performed, encoding="utf-8")
    return copy


def _yaml(text: str, complaint: str) -> Any:
    try:
        return yaml.safe_load(text)
    except yaml.YAMLError as error:
        raise SubstitutionFailure(f"{complaint}: {error}") from error
