"""A temporary value of the launch system."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from ..substitution import Substitution
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LocalSubstitution(Substitution):
    """A local of the launch context, such as `event.reason` or `ros_specific_arguments['ns']`."""

    def __init__(self, expression: str, description: str | None = None) -> None:
        super().__init__()
        self.__expression = expression
        self.__description = description

    @property
    def expression(self) -> str:
        """The expression without the prefix 'context.locals.'."""
        return self.__expression

    def describe(self) -> str:
        """Return the description, else the expression."""
        return f"LocalVar('{self.__description or self.__expression}')"

    def perform(self, context: LaunchContext) -> str:
        """Return the local's value as text.

        Raises:
            SubstitutionFailure: if there is no such local.
        """
        tree = ast.parse(self.__expression, mode="eval").body
        try:
            return str(_value(tree, context.get_locals_as_dict()))
        except (AttributeError, KeyError, IndexError) as error:
            raise SubstitutionFailure(f"local '{self.__expression}' does not exist: {error}") from error


def _value(node: ast.AST, names: Mapping[str, Any]) -> Any:
    """Return the value of a chain of names, attributes and subscripts; anything else is an error."""
    if isinstance(node, ast.Name):
        return names[node.id]
    if isinstance(node, ast.Attribute):
        return getattr(_value(node.value, names), node.attr)
    if isinstance(node, ast.Subscript):
        return _value(node.value, names)[_value(node.slice, names)]
    if isinstance(node, ast.Constant):
        return node.value
    raise SubstitutionFailure(f"a local is a name, an attribute or an item, not {ast.unparse(node)!r}")
