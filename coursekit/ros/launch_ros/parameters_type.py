"""The type of a node's parameters."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Union

from launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.substitution import Substitution

from .parameter_descriptions import Parameter, ParameterFile, ParameterValue

if TYPE_CHECKING:
    from .parameter_descriptions import EvaluatedParameterValue

SomeParameterFile = SomeSubstitutionsType | pathlib.Path | ParameterFile
SomeParameterName = Sequence[Substitution | str]
SomeParameterValue = ParameterValue | SomeSubstitutionsType | Sequence[Any] | float | int | str | bool | bytes
SomeParametersDict = Mapping[Any, Any]
SomeParameters = Sequence[SomeParameterFile | Parameter | Mapping[Any, Any]]
Parameters = Sequence[ParameterFile | Parameter | Mapping[Any, Any]]
ParametersDict = dict[tuple[Substitution, ...], Any]
EvaluatedParameters = Sequence[Union[pathlib.Path, Parameter, "dict[str, EvaluatedParameterValue]"]]

SomeParameterFile_types_tuple = (*SomeSubstitutionsType_types_tuple, os.PathLike, ParameterFile)
