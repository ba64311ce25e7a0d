"""Conditions that decide whether an action of a launch file is executed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .condition import Condition
from .some_substitutions_type import SomeSubstitutionsType
from .substitution import Substitution

if TYPE_CHECKING:
    from .launch_context import LaunchContext

__all__ = [
    "IfCondition",
    "InvalidConditionExpressionError",
    "LaunchConfigurationEquals",
    "LaunchConfigurationNotEquals",
    "UnlessCondition",
    "evaluate_condition_expression",
]

VALID_TRUE = ("true", "1")
VALID_FALSE = ("false", "0")


class InvalidConditionExpressionError(RuntimeError):
    """Raised when the text of a condition is neither true, 1, false nor 0."""

    def __init__(self, expression: str) -> None:
        self.expression = expression
        super().__init__(
            f"invalid condition expression, expected one of '{list(VALID_TRUE)}' or "
            f"'{list(VALID_FALSE)}', but got '{expression}'"
        )


def evaluate_condition_expression(context: LaunchContext, expression: Sequence[Substitution]) -> bool:
    """Return the truth value of an expression's text: true or 1, false or 0; case and surrounding spaces are ignored.

    Raises:
        InvalidConditionExpressionError: for any other text.
    """
    from .utilities import perform_substitutions

    text = perform_substitutions(context, expression)
    word = text.strip().lower()
    if word in VALID_TRUE:
        return True
    if word in VALID_FALSE:
        return False
    raise InvalidConditionExpressionError(text)


class _ExpressionCondition(Condition):
    """True if the expression's text is true (or false, for `wanted=False`)."""

    def __init__(self, predicate_expression: SomeSubstitutionsType, wanted: bool) -> None:
        from .utilities import normalize_to_list_of_substitutions

        self.__expression = normalize_to_list_of_substitutions(predicate_expression)
        self.__wanted = wanted
        super().__init__(predicate=self.__holds)

    def __holds(self, context: LaunchContext) -> bool:
        return evaluate_condition_expression(context, self.__expression) is self.__wanted

    def describe(self) -> str:
        """Return the condition with its expression."""
        inner = " + ".join(sub.describe() for sub in self.__expression)
        return f"{type(self).__name__}({inner})"


class IfCondition(_ExpressionCondition):
    """True if the expression's text is true or 1.

    >>> from launch import LaunchContext
    >>> from launch.substitutions import LaunchConfiguration
    >>> context = LaunchContext()
    >>> context.launch_configurations["use_rviz"] = "true"
    >>> IfCondition(LaunchConfiguration("use_rviz")).evaluate(context)
    True
    """

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        super().__init__(predicate_expression, True)


class UnlessCondition(_ExpressionCondition):
    """True if the expression's text is false or 0.

    >>> from launch import LaunchContext
    >>> UnlessCondition("false").evaluate(LaunchContext())
    True
    """

    def __init__(self, predicate_expression: SomeSubstitutionsType) -> None:
        super().__init__(predicate_expression, False)


class _ConfigurationCondition(Condition):
    """Compares a launch configuration with a text; None means 'not set'."""

    def __init__(self, name: str, expected: SomeSubstitutionsType | None, wanted: bool) -> None:
        from .utilities import normalize_to_list_of_substitutions

        self.__name = name
        self.__expected = None if expected is None else normalize_to_list_of_substitutions(expected)
        self.__wanted = wanted
        super().__init__(predicate=self.__holds)

    def __holds(self, context: LaunchContext) -> bool:
        from .utilities import perform_substitutions

        expected = None
        if self.__expected is not None:
            expected = perform_substitutions(context, self.__expected)
        return (context.launch_configurations.get(self.__name) == expected) is self.__wanted


class LaunchConfigurationEquals(_ConfigurationCondition):
    """True if the launch configuration has this value (None: is not set).

    >>> from launch import LaunchContext
    >>> context = LaunchContext()
    >>> context.launch_configurations["robot"] = "burger"
    >>> LaunchConfigurationEquals("robot", "burger").evaluate(context)
    True
    """

    def __init__(self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None) -> None:
        super().__init__(launch_configuration_name, expected_value, True)


class LaunchConfigurationNotEquals(_ConfigurationCondition):
    """True if the launch configuration does not have this value (None: is set)."""

    def __init__(self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None) -> None:
        super().__init__(launch_configuration_name, expected_value, False)
