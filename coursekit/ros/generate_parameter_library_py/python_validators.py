"""Checks that a YAML file of parameters can name."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:  # a build reads the names of the checks only
    from rclpy.parameter import Parameter


class ParameterValidators:
    """Each check returns what is wrong with a parameter's value, or ''.

    >>> from rclpy.parameter import Parameter
    >>> ParameterValidators.lt(Parameter("rate", value=5.0), 2.0)
    "Parameter 'rate' with the value 5.0 must be less than 2.0"
    >>> ParameterValidators.bounds(Parameter("rate", value=5.0), 0.0, 9.0)
    ''
    """

    @staticmethod
    def lt(param: Parameter, value: float) -> str:
        """A number below a limit."""
        return "" if param.value < value else _must_be(param, "less than", value)

    @staticmethod
    def gt(param: Parameter, value: float) -> str:
        """A number above a limit."""
        return "" if param.value > value else _must_be(param, "greater than", value)

    @staticmethod
    def lt_eq(param: Parameter, value: float) -> str:
        """A number at or below a limit."""
        return "" if param.value <= value else _must_be(param, "below upper bound of", value)

    @staticmethod
    def gt_eq(param: Parameter, value: float) -> str:
        """A number at or above a limit."""
        return "" if param.value >= value else _must_be(param, "above lower bound of", value)

    @staticmethod
    def bounds(param: Parameter, lower: float, upper: float) -> str:
        """A number between two limits, or at one of them."""
        return "" if lower <= param.value <= upper else _out_of_bounds(param, lower, upper)

    @staticmethod
    def not_empty(param: Parameter) -> str:
        """A text or an array that holds something."""
        return "" if len(param.value) else f"Parameter '{param.name}' cannot be empty"

    @staticmethod
    def one_of(param: Parameter, values: Collection[Any]) -> str:
        """One value of a list."""
        if param.value in values:
            return ""
        return f"Parameter '{param.name}' with the value '{param.value}' is not in the set {values}"

    @staticmethod
    def unique(param: Parameter) -> str:
        """An array without repetitions."""
        repeats = len(set(param.value)) != len(param.value)
        return f"Parameter '{param.name}' must only contain unique values" if repeats else ""

    @staticmethod
    def subset_of(param: Parameter, values: Collection[Any]) -> str:
        """An array whose elements are in a list."""
        for entry in param.value:
            if entry not in values:
                return f"Entry '{entry}' in parameter '{param.name}' is not in the set {values}"
        return ""

    @staticmethod
    def fixed_size(param: Parameter, length: int) -> str:
        """A text or an array of one length."""
        return "" if len(param.value) == length else _length_must_be(param, "equal to", length)

    @staticmethod
    def size_gt(param: Parameter, length: int) -> str:
        """A text or an array that is longer than this."""
        return "" if len(param.value) > length else _length_must_be(param, "greater than", length)

    @staticmethod
    def size_lt(param: Parameter, length: int) -> str:
        """A text or an array that is shorter than this."""
        return "" if len(param.value) < length else _length_must_be(param, "less than", length)

    @staticmethod
    def element_bounds(param: Parameter, lower: float, upper: float) -> str:
        """An array of numbers between two limits, or at one of them."""
        return "" if all(lower <= value <= upper for value in param.value) else _out_of_bounds(param, lower, upper)

    @staticmethod
    def lower_element_bounds(param: Parameter, lower: float) -> str:
        """An array of numbers at or above a limit."""
        return _element_beyond(param, [value for value in param.value if value < lower], lower)

    @staticmethod
    def upper_element_bounds(param: Parameter, upper: float) -> str:
        """An array of numbers at or below a limit."""
        return _element_beyond(param, [value for value in param.value if value > upper], upper)


def _must_be(param: Parameter, what: str, value: float) -> str:
    return f"Parameter '{param.name}' with the value {param.value} must be {what} {value}"


def _length_must_be(param: Parameter, what: str, length: int) -> str:
    return f"Length of parameter '{param.name}' is '{len(param.value)}' but must be {what} {length}"


def _out_of_bounds(param: Parameter, lower: float, upper: float) -> str:
    return f"Value {param.value} in parameter '{param.name}' must be within bounds [{lower}, {upper}]"


def _element_beyond(param: Parameter, wrong: list[float], limit: float) -> str:
    """Upstream says "above lower bound" of both limits."""
    return f"Value {wrong[0]} in parameter '{param.name}' must be above lower bound of {limit}" if wrong else ""
