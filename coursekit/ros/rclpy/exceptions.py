"""rclpy's exceptions. In ROS 2: rclpy.exceptions, Humble's argument tuples."""

from __future__ import annotations

from typing import Any

from rclpy._rclpy_pybind11 import InvalidHandle as InvalidHandle
from rclpy._rclpy_pybind11 import TimerCancelledError as TimerCancelledError


class NotInitializedException(Exception):
    """Something that needs `rclpy.init()` was used before it.

    >>> str(NotInitializedException("cannot create node"))
    "('rclpy.init() has not been called', 'cannot create node')"
    """

    def __init__(self, *args: Any) -> None:
        super().__init__("rclpy.init() has not been called", *args)


class NoTypeSupportImportedException(Exception):
    """A class that is not a ROS interface was passed as a type."""

    def __init__(self, *args: Any) -> None:
        super().__init__("no type_support imported", *args)


class NameValidationException(Exception):
    """A name breaks the rules; the message points at the first bad character.

    >>> print(NameValidationException("topic name", "a b", "must not contain a space", 1))
    Invalid topic name: must not contain a space:
      'a b'
        ^
    """

    def __init__(self, name_type: str, name: str, error_msg: str, invalid_index: int, *args: Any) -> None:
        self.name_type = name_type
        self.invalid_name = name
        self.error_msg = error_msg
        self.invalid_index = invalid_index
        pointer = " " * (3 + invalid_index) + "^"
        super().__init__(f"Invalid {name_type}: {error_msg}:\n  '{name}'\n{pointer}", *args)


class InvalidNamespaceException(NameValidationException):
    """A namespace breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: Any) -> None:
        super().__init__("namespace", name, error_msg, invalid_index, *args)


class InvalidNodeNameException(NameValidationException):
    """A node name breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: Any) -> None:
        super().__init__("node name", name, error_msg, invalid_index, *args)


class InvalidTopicNameException(NameValidationException):
    """A topic name breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: Any) -> None:
        super().__init__("topic name", name, error_msg, invalid_index, *args)


class InvalidServiceNameException(NameValidationException):
    """A service name breaks the rules."""

    def __init__(self, name: str, error_msg: str, invalid_index: int, *args: Any) -> None:
        super().__init__("service name", name, error_msg, invalid_index, *args)


class ParameterException(Exception):
    """The base class of exceptions about parameters."""

    def __init__(self, error_msg: str, parameters: Any, *args: Any) -> None:
        super().__init__(error_msg, parameters, *args)


class ParameterNotDeclaredException(ParameterException):
    """A parameter was used before it was declared."""

    def __init__(self, parameters: Any, *args: Any) -> None:
        super().__init__("Invalid access to undeclared parameter(s)", parameters, *args)


class ParameterAlreadyDeclaredException(ParameterException):
    """A parameter was declared twice."""

    def __init__(self, parameters: Any, *args: Any) -> None:
        super().__init__("Parameter(s) already declared", parameters, *args)


class InvalidParameterException(ParameterException):
    """A parameter's name is invalid."""

    def __init__(self, parameter: Any, *args: Any) -> None:
        super().__init__("Invalid parameter name", parameter, *args)


class InvalidParameterTypeException(ParameterException):
    """A value's type differs from the declared type of the parameter."""

    def __init__(self, desired_parameter: Any, expected_type: Any, *args: Any) -> None:
        was = f"to '{desired_parameter.value}' of type '{desired_parameter.type_.name}'"
        text = f"Trying to set parameter '{desired_parameter.name}' {was}, expecting type '{expected_type}'"
        super().__init__(text, desired_parameter.name, *args)


class InvalidParameterValueException(ParameterException):
    """A value was refused by the parameter's descriptor or by a callback of the node."""

    def __init__(self, parameter: Any, value: Any, reason: str, *args: Any) -> None:
        text = f"Invalid parameter value ({value}) for parameter. Reason: {reason}"
        super().__init__(text, parameter, *args)


class ParameterImmutableException(ParameterException):
    """An attempt to change a read-only parameter."""

    def __init__(self, parameter: Any, *args: Any) -> None:
        super().__init__("Attempted to modify read-only parameter", parameter, *args)


class ParameterUninitializedException(ParameterException):
    """A parameter that was declared by type only was read before it had a value."""

    def __init__(self, parameter_name: Any, *args: Any) -> None:
        super().__init__(f"The parameter '{parameter_name}' is not initialized", parameter_name, *args)


class ROSInterruptException(Exception):
    """A wait ended because ROS was shut down."""

    def __init__(self, *args: Any) -> None:
        super().__init__("rclpy.shutdown() has been called", *args)
