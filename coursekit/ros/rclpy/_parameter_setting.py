"""The part of Node that sets parameters: checks, callbacks, and the event that reports the change."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

from rcl_interfaces.msg import ParameterDescriptor, ParameterEvent, SetParametersResult

from rclpy._parameter_checks import outside_floating_range, outside_integer_range
from rclpy.exceptions import (
    InvalidParameterValueException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
)
from rclpy.parameter import Parameter


class ParameterSetting:
    """How a node's parameters change."""

    PARAM_REL_TOL = 1e-6
    """Relative tolerance for floating point ranges and steps."""

    _parameters: dict[str, Parameter]
    _descriptors: dict[str, ParameterDescriptor]
    _parameters_callbacks: list[Callable[[list[Parameter]], SetParametersResult]]
    _rclpy_pre_set_callbacks: list[Callable[[list[Parameter]], list[Parameter]]]
    _rclpy_post_set_callbacks: list[Callable[[list[Parameter]], None]]
    _allow_undeclared_parameters: bool
    _parameter_event_publisher: Any

    def set_parameters(self, parameter_list: list[Parameter]) -> list[SetParametersResult]:
        """Set several parameters one by one. The first undeclared one raises an error, unless the node allows them.

        >>> speed = node.declare_parameter("speed", 0.5)
        >>> node.set_parameters([rclpy.parameter.Parameter("speed", value=1.0)])[0].successful
        True
        >>> node.get_parameter("speed").value
        1.0
        """
        results = []
        for parameter in parameter_list:
            self._rclpy_check_declared([parameter])
            results.append(self._rclpy_set([parameter]))
        return results

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all or none.

        >>> pair = node.declare_parameters("", [("kp", 1.0), ("kd", 0.1)])
        >>> Parameter = rclpy.parameter.Parameter
        >>> node.set_parameters_atomically([Parameter("kp", value=2.0), Parameter("kd", value=0.2)]).successful
        True
        """
        self._rclpy_check_declared(parameter_list)
        return self._rclpy_set(parameter_list)

    def _rclpy_check_declared(self, parameters: list[Parameter]) -> None:
        if not all(isinstance(parameter, Parameter) for parameter in parameters):
            raise TypeError(f"parameter must be instance of type '{Parameter!r}'")
        if self._allow_undeclared_parameters:
            return
        unknown = [parameter.name for parameter in parameters if parameter.name not in self._descriptors]
        if unknown:
            raise ParameterNotDeclaredException(unknown)

    def _rclpy_set(self, parameters: list[Parameter]) -> SetParametersResult:
        for callback in list(self._rclpy_pre_set_callbacks):
            parameters = callback(parameters)
        self._rclpy_check_declared(parameters)
        return self._rclpy_apply(parameters)

    def _rclpy_apply(self, parameters: list[Parameter], declares: bool = False) -> SetParametersResult:
        """Check, call the callbacks, set, and publish on /parameter_events; only declaring may leave a parameter unset."""
        for parameter in parameters:
            descriptor = self._descriptors.get(parameter.name)
            result = self._rclpy_check(parameter, descriptor, not declares)
            if not result.successful:
                return result
        for callback in list(self._parameters_callbacks):
            result = callback(parameters)
            if not isinstance(result, SetParametersResult):
                warnings.warn("Callback returned an invalid type, it should return SetParameterResult.", stacklevel=1)
                return SetParametersResult(successful=False, reason="Callback returned an invalid type")
            if not result.successful:
                return result
        self._rclpy_store(parameters, declares)
        for post in list(self._rclpy_post_set_callbacks):
            post(parameters)
        return SetParametersResult(successful=True)

    def _rclpy_check(
        self, parameter: Parameter, descriptor: ParameterDescriptor | None, check_read_only: bool
    ) -> SetParametersResult:
        if descriptor is None:
            return SetParametersResult(successful=True)
        if check_read_only and descriptor.read_only:
            return SetParametersResult(successful=False, reason=f"Trying to set a read-only parameter: {parameter.name}.")
        return self._rclpy_check_value(parameter, descriptor)

    def _rclpy_check_value(self, parameter: Parameter, descriptor: ParameterDescriptor) -> SetParametersResult:
        if not descriptor.dynamic_typing and descriptor.type and descriptor.type != parameter.type_.value:
            if parameter.type_ == Parameter.Type.NOT_SET:
                return SetParametersResult(successful=False, reason="Static parameter cannot be undeclared")
            expected = Parameter.Type(descriptor.type)
            return SetParametersResult(
                successful=False,
                reason=f"Wrong parameter type, expected '{expected}' got '{parameter.type_}'",
            )
        reason = ""
        if parameter.type_ == Parameter.Type.INTEGER and descriptor.integer_range:
            reason = outside_integer_range(parameter, descriptor.integer_range[0])
        elif parameter.type_ == Parameter.Type.DOUBLE and descriptor.floating_point_range:
            reason = outside_floating_range(parameter, descriptor.floating_point_range[0], self.PARAM_REL_TOL)
        return SetParametersResult(successful=not reason, reason=reason)

    def _rclpy_store(self, parameters: list[Parameter], declares: bool) -> None:
        event = ParameterEvent(node=self.get_fully_qualified_name())  # type: ignore[attr-defined]
        event.stamp = self.get_clock().now().to_msg()  # type: ignore[attr-defined]
        for parameter in parameters:
            old = self._parameters.get(parameter.name)
            had_value = old is not None and old.type_ != Parameter.Type.NOT_SET
            if parameter.type_ == Parameter.Type.NOT_SET:
                if had_value:
                    event.deleted_parameters.append(Parameter(parameter.name).to_parameter_msg())
                if declares:
                    self._parameters[parameter.name] = parameter
                else:
                    self._parameters.pop(parameter.name, None)
                    self._descriptors.pop(parameter.name, None)
                continue
            (event.changed_parameters if had_value else event.new_parameters).append(parameter.to_parameter_msg())
            self._rclpy_remember(parameter)
        self._parameter_event_publisher.publish(event)

    def _rclpy_remember(self, parameter: Parameter) -> None:
        if parameter.name not in self._descriptors:
            self._descriptors[parameter.name] = ParameterDescriptor(name=parameter.name, dynamic_typing=True)
        self._descriptors[parameter.name].type = parameter.type_.value
        self._parameters[parameter.name] = parameter

    def set_descriptor(self, name: str, descriptor: ParameterDescriptor, alternative_value: Any = None) -> Any:
        """Replace a parameter's descriptor, and by `alternative_value` a value that does not fit it.

        The descriptor says the value's type, or that it may change (`dynamic_typing`).
        """
        if name not in self._parameters:
            if self._allow_undeclared_parameters:
                return Parameter(name).get_parameter_value()
            raise ParameterNotDeclaredException(name)
        if self._descriptors[name].read_only:
            raise ParameterImmutableException(name)
        parameter = self._parameters[name]
        descriptor.name = name
        result = self._rclpy_check_new(parameter, descriptor)
        if not result.successful and alternative_value is not None:
            parameter = Parameter.from_parameter_msg(_parameter_msg(name, alternative_value))
            result = self._rclpy_check_new(parameter, descriptor)
        if not result.successful:
            raise InvalidParameterValueException(name, parameter.value, result.reason)
        self._descriptors[name] = descriptor
        self._parameters[name] = parameter
        return parameter.get_parameter_value()

    def _rclpy_check_new(self, parameter: Parameter, descriptor: ParameterDescriptor) -> SetParametersResult:
        kind, unset = parameter.type_, Parameter.Type.NOT_SET
        if descriptor.dynamic_typing:
            descriptor.type = kind.value
        elif descriptor.type == unset.value and kind != unset:
            return SetParametersResult(successful=False, reason=f"Wrong parameter type, expected '{unset}' got '{kind}'")
        return self._rclpy_check_value(parameter, descriptor)

    # -- callbacks

    def add_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], SetParametersResult]) -> None:
        """Let `callback(parameters)` accept or refuse every change; the newest callback is called first.

        >>> from rcl_interfaces.msg import SetParametersResult
        >>> speed = node.declare_parameter("speed", 0.5)
        >>> def check(parameters):
        ...     slow = all(parameter.value <= 1.0 for parameter in parameters)
        ...     return SetParametersResult(successful=slow, reason="" if slow else "too fast")
        >>> node.add_on_set_parameters_callback(check)
        >>> node.set_parameters([rclpy.parameter.Parameter("speed", value=9.0)])[0].reason
        'too fast'
        """
        if not callable(callback):
            raise TypeError("Callback must be callable, got {}", type(callback))
        self._parameters_callbacks.insert(0, callback)

    def remove_on_set_parameters_callback(self, callback: Callable[[list[Parameter]], SetParametersResult]) -> None:
        """Remove the callback; ValueError if it was not registered."""
        self._parameters_callbacks.remove(callback)

    def add_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Let `callback` change the list before it is checked (ROS releases after Humble)."""
        self._rclpy_pre_set_callbacks.insert(0, callback)

    def remove_pre_set_parameters_callback(self, callback: Callable[[list[Parameter]], list[Parameter]]) -> None:
        """Remove the callback."""
        self._rclpy_pre_set_callbacks.remove(callback)

    def add_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        """Call `callback(parameters)` after each change (ROS releases after Humble)."""
        self._rclpy_post_set_callbacks.insert(0, callback)

    def remove_post_set_parameters_callback(self, callback: Callable[[list[Parameter]], None]) -> None:
        """Remove the callback."""
        self._rclpy_post_set_callbacks.remove(callback)


def _parameter_msg(name: str, value: Any) -> Any:
    from rcl_interfaces.msg import Parameter as ParameterMsg

    return ParameterMsg(name=name, value=value)
