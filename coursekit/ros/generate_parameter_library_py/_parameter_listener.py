"""What the modules that generate_parameter_module() writes have in common."""

from __future__ import annotations

import copy
import itertools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.clock import Clock
from rclpy.exceptions import InvalidParameterValueException
from rclpy.logging import get_logger
from rclpy.node import Node
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.time import Time


class ParameterStruct:
    """The parameters below a name; those below __map_NAMES are entries, one for each value of the parameter NAMES."""

    Entry: type[ParameterStruct]

    def add_entry(self, name: str) -> ParameterStruct:
        """Return the entry of this name, with default values if it is new."""
        if not hasattr(self, name):
            setattr(self, name, self.Entry())
        return self.get_entry(name)

    def get_entry(self, name: str) -> ParameterStruct:
        """Return the entry of this name."""
        entry: ParameterStruct = getattr(self, name)
        return entry


class ParameterSet(ParameterStruct):
    """All parameters of a file."""

    def __init__(self) -> None:
        self.stamp_ = Time()  # when one of them was set


@dataclass(frozen=True)
class Described:
    """One parameter of a file, or one for each entry."""

    words: tuple[str, ...]
    """Its name in parts, with __map_NAMES for an entry's name."""
    default: Any
    """A value, or a type for a parameter that has to be given."""
    description: str = ""
    read_only: bool = False
    additional_constraints: str = ""
    limits: tuple[float, float] | None = None
    checks: tuple[Callable[[Parameter], str], ...] = ()
    maps: tuple[str, ...] = ()
    """The parameters with the names of the entries, the outermost first."""

    def descriptor(self) -> ParameterDescriptor:
        """Return what is told of it when it is declared."""
        told = ParameterDescriptor(
            description=self.description, read_only=self.read_only, additional_constraints=self.additional_constraints
        )
        if self.limits:
            from_value, to_value = self.limits
            if isinstance(from_value, float):
                told.floating_point_range = [FloatingPointRange(from_value=from_value, to_value=to_value)]
            else:
                told.integer_range = [IntegerRange(from_value=from_value, to_value=int(to_value))]
        return told

    def wrong(self, parameter: Parameter) -> str:
        """Return what the first check says that fails, or ''."""
        return next((reason for check in self.checks if (reason := check(parameter))), "")

    def names(self, params: ParameterSet) -> Iterator[list[str]]:
        """Yield the names on the way to it; for entries, each combination of the names that the parameters have now.

        >>> params = ParameterSet()
        >>> params.joints = ["hip", "knee"]
        >>> list(Described(("pid", "__map_joints", "p"), 1.0, maps=("joints",)).names(params))
        [['pid', 'hip', 'p'], ['pid', 'knee', 'p']]
        """
        for keys in itertools.product(*(_value(params, name) for name in self.maps)):
            rest = iter(keys)
            yield [next(rest) if word.startswith("__map_") else word for word in self.words]


def _value(params: ParameterSet, path: str) -> Any:
    place: Any = params
    for name in path.split(PARAMETER_SEPARATOR_STRING):
        place = getattr(place, name)
    return place


def _struct(params: ParameterSet, names: list[str]) -> ParameterStruct:
    """Return what holds a parameter; entries that are not there yet are added."""
    place: ParameterStruct = params
    for name in names[:-1]:
        place = place.add_entry(name)
    return place


class ParameterListener:
    """Declares the parameters of a file on a node, and keeps their values up to date."""

    def __init__(
        self, node: Node, params: ParameterSet, described: Sequence[Described], namespace: str, prefix: str
    ) -> None:
        self.prefix_ = prefix
        self.params_ = params
        self.node_ = node
        self.described_ = sorted(described, key=lambda described: bool(described.maps))  # the names of entries come first
        self.logger_ = get_logger(f"{namespace}.{prefix}")
        self.user_callback: Callable[[Any], None] | None = None
        self.clock_ = Clock()
        self.declare_params()
        self.node_.add_on_set_parameters_callback(self.update)

    def get_params(self) -> Any:
        """Return a copy of the values."""
        return copy.deepcopy(self.params_)

    def is_old(self, other_param: Any) -> bool:
        """Whether a parameter has been set since these values were taken."""
        return bool(self.params_.stamp_ != other_param.stamp_)

    def declare_params(self) -> None:
        """Declare all parameters; InvalidParameterValueException if a value that is given fails a check."""
        params = self.get_params()
        for described in self.described_:
            for names in described.names(params):
                self._declare(described, names, params)
        self.update_internal_params(params)

    def refresh_dynamic_parameters(self) -> None:
        """Declare the entries that have become possible since, by new names."""
        self.declare_params()

    def _declare(self, described: Described, names: list[str], params: ParameterSet) -> None:
        name = self.prefix_ + PARAMETER_SEPARATOR_STRING.join(names)
        struct = _struct(params, names)
        if not self.node_.has_parameter(name):
            default = getattr(struct, names[-1])
            self.node_.declare_parameter(name, described.default if default is None else default, described.descriptor())
        parameter = self.node_.get_parameter(name)
        if reason := described.wrong(parameter):
            path = PARAMETER_SEPARATOR_STRING.join(described.words)
            told = f"Invalid value set during initialization for parameter {path}: {reason}"
            raise InvalidParameterValueException(path, parameter.value, told)
        self._take(struct, names[-1], parameter)

    def _take(self, struct: ParameterStruct, name: str, parameter: Parameter) -> None:
        setattr(struct, name, parameter.value)
        self.logger_.debug(f"{parameter.name}: {parameter.type_.name} = {parameter.value}")

    def update(self, parameters: Sequence[Parameter]) -> SetParametersResult:
        """Take values that are set, unless one of them fails a check."""
        params = self.get_params()
        for described in self.described_:
            if reason := self._update(described, parameters, params):
                return SetParametersResult(successful=False, reason=reason)
        params.stamp_ = self.clock_.now()
        self.update_internal_params(params)
        if self.user_callback:
            self.user_callback(self.get_params())
        return SetParametersResult(successful=True)

    def _update(self, described: Described, parameters: Sequence[Parameter], params: ParameterSet) -> str:
        names_by_parameter = {
            self.prefix_ + PARAMETER_SEPARATOR_STRING.join(names): names for names in described.names(params)
        }
        for parameter in parameters:
            if names := names_by_parameter.get(parameter.name):
                if reason := described.wrong(parameter):
                    return reason
                self._take(_struct(params, names), names[-1], parameter)
        return ""

    def update_internal_params(self, updated_params: Any) -> None:
        """Replace the values."""
        self.params_ = updated_params

    def set_user_callback(self, callback: Callable[[Any], None]) -> None:
        """Call this with the values whenever they change."""
        self.user_callback = callback

    def clear_user_callback(self) -> None:
        """Call nothing any more."""
        self.user_callback = None

    def set_params_from_dict(self, param_dict: dict[str, Any]) -> None:
        """Take values from a dictionary, which may be nested; the node's parameters stay as they are."""
        self.update(self.unpack_parameter_dict("", param_dict))

    def unpack_parameter_dict(self, namespace: str, parameter_dict: dict[str, Any]) -> list[Parameter]:
        """Return the parameters of a nested dictionary, whose names begin with `namespace`."""
        parameters = []
        for name, value in parameter_dict.items():
            if isinstance(value, dict):
                parameters += self.unpack_parameter_dict(namespace + name + PARAMETER_SEPARATOR_STRING, value)
            else:
                parameters.append(Parameter(namespace + name, value=value))
        return parameters
