"""Features of rclcpp nodes that rclpy lacks, for nodes that replace C++ programs."""

from __future__ import annotations

from typing import Any, TypeVar

from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent, SetParametersResult
from rclpy.exceptions import ParameterNotDeclaredException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import qos_profile_parameter_events

_EVENTS_QOS = {"depth": 1000, "durability": "volatile", "history": "keep_last", "reliability": "reliable"}


class CppNode(Node):
    """Has the QoS of its parameter events as parameters, subscribes to these events, and refuses parameters like rclcpp."""

    declares_events_qos = True
    """Managed nodes of rclcpp do not."""

    def __init__(self, node_name: str, **options: Any) -> None:
        super().__init__(node_name, **options)
        for policy, value in _EVENTS_QOS.items() if self.declares_events_qos else ():
            name = f"qos_overrides./parameter_events.publisher.{policy}"
            self.declare_parameter(name, value, ParameterDescriptor(read_only=True))
        self.create_subscription(ParameterEvent, "/parameter_events", lambda _event: None, qos_profile_parameter_events)

    def _rclpy_reason(self, error: Exception, together: bool = False) -> str:
        if not isinstance(error, ParameterNotDeclaredException):
            return super()._rclpy_reason(error)
        return "One or more parameters were not declared before setting" if together else undeclared(error)

    def _rclpy_listed_names(self) -> list[str]:
        return sorted(super()._rclpy_listed_names())  # rclcpp keeps them in a std::map

    def _rclpy_store(self, parameters: list[Parameter], declares: bool) -> None:
        changed = [one for one in parameters if declares or not self._is_unset(one)]  # what was not set stays declared
        super()._rclpy_store(changed, declares)

    def _is_unset(self, given: Parameter) -> bool:
        old = self._parameters.get(given.name)
        return given.type_ == Parameter.Type.NOT_SET and old is not None and old.type_ == Parameter.Type.NOT_SET

    def _rclpy_check(
        self, parameter: Parameter, descriptor: ParameterDescriptor | None, check_read_only: bool
    ) -> SetParametersResult:
        result = super()._rclpy_check(parameter, descriptor, check_read_only)
        if result.successful and descriptor is not None and _is_in_turned_range(parameter, descriptor):
            result.successful = False
        if descriptor is not None and not result.successful:
            result.reason = _reason(parameter, descriptor, check_read_only)
        return result


Kind = TypeVar("Kind", bound=Node)


def as_cpp(kind: type[Kind]) -> type[Kind]:
    """Return the class of a Python demo's node with what rclcpp gives to each node.

    >>> class Talker(Node): ...
    >>> as_cpp(Talker).__name__, issubclass(as_cpp(Talker), CppNode)
    ('Talker', True)
    """
    return type(kind.__name__, (kind, CppNode), {})


def undeclared(error: ParameterNotDeclaredException) -> str:
    """Return rclcpp's words for setting a parameter that is not declared.

    >>> undeclared(ParameterNotDeclaredException("speed"))
    "parameter 'speed' cannot be set because it was not declared"
    """
    names = error.args[1]
    return f"parameter '{names if isinstance(names, str) else names[0]}' cannot be set because it was not declared"


def _reason(parameter: Parameter, descriptor: ParameterDescriptor, check_read_only: bool) -> str:
    """Return why a parameter may not have that value."""
    if check_read_only and descriptor.read_only:
        return f"parameter '{parameter.name}' cannot be set because it is read-only"
    if parameter.type_ == Parameter.Type.NOT_SET and not descriptor.dynamic_typing:
        return "cannot undeclare an statically typed parameter"
    if descriptor.type != parameter.type_.value:
        return wrong_type(parameter.name, Parameter.Type(descriptor.type), parameter.type_)
    kind = "integer" if parameter.type_ == Parameter.Type.INTEGER else "floating point"
    return f"Parameter {{{parameter.name}}} doesn't comply with {kind} range."


def _is_in_turned_range(parameter: Parameter, descriptor: ParameterDescriptor) -> bool:
    """Whether a value is inside an integer range from high to low: nothing but its ends fits one in rclcpp."""
    if parameter.type_ != Parameter.Type.INTEGER or not descriptor.integer_range:
        return False
    allowed = descriptor.integer_range[0]
    return bool(allowed.to_value < parameter.value < allowed.from_value)


def wrong_type(name: str, declared: Parameter.Type, given: Parameter.Type) -> str:
    """Return rclcpp's words for a value of another type than the declared one.

    >>> wrong_type("rate", Parameter.Type.DOUBLE, Parameter.Type.INTEGER)
    'Wrong parameter type, parameter {rate} is of type {double}, setting it to {integer} is not allowed.'
    """
    old, new = _in_words(declared), _in_words(given)
    return f"Wrong parameter type, parameter {{{name}}} is of type {{{old}}}, setting it to {{{new}}} is not allowed."


def _in_words(kind: Parameter.Type) -> str:
    return "not set" if kind == Parameter.Type.NOT_SET else kind.name.lower()
