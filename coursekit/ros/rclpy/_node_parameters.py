"""The part of Node that declares and reads parameters."""

from __future__ import annotations

from typing import Any

from rcl_interfaces.msg import (
    ParameterDescriptor,
    ParameterValue,
)

from rclpy._parameter_checks import read_declaration
from rclpy._parameter_setting import ParameterSetting
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import PARAMETER_SEPARATOR_STRING, Parameter
from rclpy.validate_parameter_name import validate_parameter_name

Declaration = tuple[Any, ...]


class NodeParameters(ParameterSetting):
    """Parameters of a node."""

    _parameter_overrides: dict[str, Parameter]

    # -- declaring

    def declare_parameter(
        self,
        name: str,
        value: Any = None,
        descriptor: ParameterDescriptor | None = None,
        ignore_override: bool = False,
    ) -> Parameter:
        """Declare a parameter with its default value or its type, and return it.

        >>> node.declare_parameter("speed", 0.5).value
        0.5
        >>> from rcl_interfaces.msg import FloatingPointRange, ParameterDescriptor
        >>> limits = [FloatingPointRange(from_value=0.0, to_value=1.0)]
        >>> turn = node.declare_parameter("turn", 0.2, ParameterDescriptor(floating_point_range=limits))
        >>> node.set_parameters([rclpy.parameter.Parameter("turn", value=9.0)])[0].successful
        False
        """
        declaration: Declaration
        if value is None and descriptor is None:
            declaration = (name,)
        else:
            declaration = (name, value, ParameterDescriptor() if descriptor is None else descriptor)
        return self.declare_parameters("", [declaration], ignore_override)[0]

    def declare_parameters(self, namespace: str, parameters: list[Any], ignore_override: bool = False) -> list[Parameter]:
        """Declare several parameters: tuples of (name), (name, value or type) or (name, value or type, descriptor).

        >>> pair = node.declare_parameters("wheel", [("radius", 0.03), ("count", 4)])
        >>> node.get_parameter("wheel.radius").value
        0.03
        """
        declared: list[Parameter] = []
        descriptors: dict[str, ParameterDescriptor] = {}
        for index, declaration in enumerate(parameters):
            name, value, descriptor = read_declaration(index, declaration)
            full_name = f"{namespace}{PARAMETER_SEPARATOR_STRING}{name}" if namespace else name
            validate_parameter_name(full_name)
            if not ignore_override and full_name in self._parameter_overrides:
                value = self._parameter_overrides[full_name].value
            elif isinstance(value, ParameterValue):
                raise ValueError(
                    f"Cannot declare a Parameter from a ParameterValue, as here {full_name}, without an override that is "
                    "not ignored: give the value itself."
                )
            declared.append(Parameter(full_name, value=value))
            descriptor.name = full_name
            descriptors[full_name] = descriptor
        known = [parameter.name for parameter in declared if parameter.name in self._parameters]
        if known:
            raise ParameterAlreadyDeclaredException(known)
        for parameter in declared:
            self._rclpy_declare(parameter, descriptors[parameter.name])
        return [self._parameters[parameter.name] for parameter in declared]

    def _rclpy_declare(self, parameter: Parameter, descriptor: ParameterDescriptor) -> None:
        if parameter.type_ == Parameter.Type.NOT_SET and not descriptor.dynamic_typing:
            self._parameters[parameter.name] = parameter
            self._descriptors[parameter.name] = descriptor
            return
        self._descriptors[parameter.name] = descriptor
        result = self._rclpy_apply([parameter], declares=True)
        if result.successful:
            return
        del self._descriptors[parameter.name]
        if result.reason.startswith("Wrong parameter type"):
            raise InvalidParameterTypeException(parameter, Parameter.Type(descriptor.type).name)
        raise InvalidParameterValueException(parameter.name, parameter.value, result.reason)

    def undeclare_parameter(self, name: str) -> None:
        """Undeclare a parameter.

        >>> speed = node.declare_parameter("speed", 0.5)
        >>> node.undeclare_parameter("speed")
        >>> node.has_parameter("speed")
        False
        """
        if not self.has_parameter(name):
            raise ParameterNotDeclaredException(name)
        if self._descriptors[name].read_only:
            raise ParameterImmutableException(name)
        del self._parameters[name]
        del self._descriptors[name]

    def has_parameter(self, name: str) -> bool:
        """Whether a parameter is declared.

        >>> node.has_parameter("speed")
        False
        """
        return name in self._parameters

    def _rclpy_listed_names(self) -> list[str]:
        """The names of all parameters in the order in which they are listed."""
        return list(self._parameters)

    def _rclpy_reason(self, error: Exception, together: bool = False) -> str:
        """What the node's services say of an exception; `together` for set_parameters_atomically."""
        return str(error)

    # -- reading

    def get_parameter_types(self, names: list[str]) -> list[int]:
        """The types of several parameters, as numbers of rcl_interfaces/ParameterType."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter_type(name) for name in names]

    def get_parameter_type(self, name: str) -> int:
        """The type of a parameter, as a number of rcl_interfaces/ParameterType."""
        if name in self._parameters:
            return int(self._parameters[name].type_.value)
        if self._allow_undeclared_parameters:
            return int(Parameter.Type.NOT_SET.value)
        raise ParameterNotDeclaredException(name)

    def get_parameters(self, names: list[str]) -> list[Parameter]:
        """Several parameters."""
        if not all(isinstance(name, str) for name in names):
            raise TypeError("All names must be instances of type str")
        return [self.get_parameter(name) for name in names]

    def get_parameter(self, name: str) -> Parameter:
        """A parameter; an undeclared one is an error unless the node allows undeclared parameters.

        >>> speed = node.declare_parameter("speed", 0.5)
        >>> node.get_parameter("speed").value
        0.5
        """
        if name in self._parameters:
            parameter = self._parameters[name]
            if parameter.type_ != Parameter.Type.NOT_SET or self._descriptors[name].dynamic_typing:
                return parameter
            raise ParameterUninitializedException(name)
        if self._allow_undeclared_parameters:
            return Parameter(name, Parameter.Type.NOT_SET, None)
        raise ParameterNotDeclaredException(name)

    def get_parameter_or(self, name: str, alternative_value: Parameter | None = None) -> Parameter:
        """A parameter, or the alternative when it has no value.

        >>> node.get_parameter_or("speed", rclpy.parameter.Parameter("speed", value=0.1)).value
        0.1
        """
        if alternative_value is None:
            alternative_value = Parameter(name, Parameter.Type.NOT_SET)
        if not self.has_parameter(name) or self._parameters[name].type_ == Parameter.Type.NOT_SET:
            return alternative_value
        return self._parameters[name]

    def get_parameters_by_prefix(self, prefix: str) -> dict[str, Parameter]:
        """The parameters below `prefix.`, keyed by the rest of their names.

        >>> pair = node.declare_parameters("wheel", [("radius", 0.03), ("count", 4)])
        >>> {name: parameter.value for name, parameter in node.get_parameters_by_prefix("wheel").items()}
        {'radius': 0.03, 'count': 4}
        """
        start = f"{prefix}{PARAMETER_SEPARATOR_STRING}" if prefix else ""
        return {
            name.removeprefix(start): parameter for name, parameter in self._parameters.items() if name.startswith(start)
        }

    def describe_parameter(self, name: str) -> ParameterDescriptor:
        """The descriptor of a parameter.

        >>> speed = node.declare_parameter("speed", 0.5)
        >>> node.describe_parameter("speed").type  # ParameterType.PARAMETER_DOUBLE
        3
        """
        if name in self._descriptors:
            return self._descriptors[name]
        if self._allow_undeclared_parameters:
            return ParameterDescriptor()
        raise ParameterNotDeclaredException(name)

    def describe_parameters(self, names: list[str]) -> list[ParameterDescriptor]:
        """The descriptors of several parameters."""
        return [self.describe_parameter(name) for name in names]
