"""Substitutions that are true or false."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from ..conditions import InvalidConditionExpressionError, evaluate_condition_expression
from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def _truth(context: LaunchContext, value: list[Substitution]) -> bool:
    try:
        return evaluate_condition_expression(context, value)
    except InvalidConditionExpressionError as error:
        raise SubstitutionFailure(str(error)) from error


def _exactly(count: int, name: str, data: Sequence[Any]) -> None:
    if len(data) != count:
        raise TypeError(f"{name} substitution expects {count} argument(s), got {len(data)}")


@expose_substitution("not")
class NotSubstitution(Substitution):
    """'true' if the value is false, and vice versa.

    >>> from launch import LaunchContext
    >>> NotSubstitution("true").perform(LaunchContext())
    'false'
    """

    def __init__(self, value: SomeSubstitutionsType) -> None:
        super().__init__()
        self.__value = normalize_to_list_of_substitutions(value)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(not value)`."""
        _exactly(1, "not", data)
        return cls, {"value": data[0]}

    @property
    def value(self) -> list[Substitution]:
        """The value, as substitutions."""
        return self.__value

    def describe(self) -> str:
        """Return a description of the value."""
        return f"NotSubstitution({' + '.join(sub.describe() for sub in self.__value)})"

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        return str(not _truth(context, self.__value)).lower()


class _PairSubstitution(Substitution):
    """Two values, left and right."""

    def __init__(self, left: Any, right: Any) -> None:
        super().__init__()
        self._left = normalize_to_list_of_substitutions(_text(left))
        self._right = normalize_to_list_of_substitutions(_text(right))

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read the two arguments."""
        _exactly(2, cls.__name__, data)
        return cls, {"left": data[0], "right": data[1]}

    @property
    def left(self) -> list[Substitution]:
        """The left value, as substitutions."""
        return self._left

    @property
    def right(self) -> list[Substitution]:
        """The right value, as substitutions."""
        return self._right

    def describe(self) -> str:
        """Return a description of both values."""
        sides = [" + ".join(sub.describe() for sub in side) for side in (self._left, self._right)]
        return f"{type(self).__name__}({', '.join(sides)})"


@expose_substitution("and")
class AndSubstitution(_PairSubstitution):
    """'true' if both values are true.

    >>> from launch import LaunchContext
    >>> AndSubstitution("true", "false").perform(LaunchContext())
    'false'
    """

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        left, right = _truth(context, self._left), _truth(context, self._right)
        return str(left and right).lower()


@expose_substitution("or")
class OrSubstitution(_PairSubstitution):
    """'true' if at least one of the values is true.

    >>> from launch import LaunchContext
    >>> OrSubstitution("true", "false").perform(LaunchContext())
    'true'
    """

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        left, right = _truth(context, self._left), _truth(context, self._right)
        return str(left or right).lower()


@expose_substitution("equals")
class EqualsSubstitution(_PairSubstitution):
    """'true' if the texts are equal, or denote the same truth value or number."""

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        return str(self._equal(context)).lower()

    def _equal(self, context: LaunchContext) -> bool:
        left = perform_substitutions(context, self._left)
        right = perform_substitutions(context, self._right)
        return left == right or _same_truth(left, right) or _same_number(left, right)


@expose_substitution("not-equals")
class NotEqualsSubstitution(EqualsSubstitution):
    """'true' if EqualsSubstitution would be 'false'."""

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        return str(not self._equal(context)).lower()


class _ManySubstitution(Substitution):
    """Any number of truth values."""

    def __init__(self, *args: SomeSubstitutionsType) -> None:
        super().__init__()
        self._values = [normalize_to_list_of_substitutions(value) for value in args]

    @classmethod
    def parse(cls, data: Iterable[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read the arguments."""
        return cls, {"args": list(data)}

    def describe(self) -> str:
        """Return a description of the values."""
        values = [" + ".join(sub.describe() for sub in value) for value in self._values]
        return f"{type(self).__name__}({', '.join(values)})"


@expose_substitution("any")
class AnySubstitution(_ManySubstitution):
    """'true' if at least one of the values is true."""

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        values = [_truth(context, value) for value in self._values]  # evaluate all: each must be a truth value
        return str(any(values)).lower()


@expose_substitution("all")
class AllSubstitution(_ManySubstitution):
    """'true' if all values are true."""

    def perform(self, context: LaunchContext) -> str:
        """Return 'true' or 'false'."""
        values = [_truth(context, value) for value in self._values]
        return str(all(values)).lower()


def _text(value: Any) -> Any:
    return str(value) if isinstance(value, (bool, int, float)) else "" if value is None else value


def _same_truth(left: str, right: str) -> bool:
    words = {"true": True, "1": True, "false": False, "0": False}
    known = left.strip().lower() in words and right.strip().lower() in words
    return known and words[left.strip().lower()] == words[right.strip().lower()]


def _same_number(left: str, right: str) -> bool:
    try:
        return math.isclose(float(left), float(right))
    except ValueError:
        return False
