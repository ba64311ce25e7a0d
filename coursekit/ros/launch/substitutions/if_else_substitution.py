"""One of two texts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..conditions import InvalidConditionExpressionError, evaluate_condition_expression
from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


@expose_substitution("if")
class IfElseSubstitution(Substitution):
    """The first text if a condition is true, the second text if it is false.

    >>> from launch import LaunchContext
    >>> IfElseSubstitution("true", "simulated", "real").perform(LaunchContext())
    'simulated'
    """

    def __init__(
        self,
        condition: SomeSubstitutionsType,
        if_value: SomeSubstitutionsType = "",
        else_value: SomeSubstitutionsType = "",
    ) -> None:
        super().__init__()
        if if_value == else_value == "":
            raise RuntimeError("One of if_value and else_value must be specified")
        self._condition = normalize_to_list_of_substitutions(condition)
        self._if_value = normalize_to_list_of_substitutions(if_value)
        self._else_value = normalize_to_list_of_substitutions(else_value)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(if condition text)` or `$(if condition text other)`."""
        if not 2 <= len(data) <= 3:
            raise TypeError("if substitution expects 2 or 3 arguments")
        return cls, dict(zip(("condition", "if_value", "else_value"), data, strict=False))

    def describe(self) -> str:
        """Return a description of the three parts."""
        parts = (self._condition, self._if_value, self._else_value)
        texts = [" + ".join(sub.describe() for sub in part) for part in parts]
        return f"IfElseSubstitution({', '.join(texts)})"

    def perform(self, context: LaunchContext) -> str:
        """Return the chosen text.

        Raises:
            SubstitutionFailure: if the condition is neither true nor false.
        """
        try:
            chosen = evaluate_condition_expression(context, self._condition)
        except InvalidConditionExpressionError as error:
            raise SubstitutionFailure(str(error)) from error
        return perform_substitutions(context, self._if_value if chosen else self._else_value)
