"""The value of a Python expression."""

from __future__ import annotations

import builtins
import importlib
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ..frontend.expose import expose_substitution
from ..some_substitutions_type import SomeSubstitutionsType
from ..substitution import Substitution
from ..utilities import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class UnknownNameError(SubstitutionFailure, NameError):
    """Raised if an expression uses an unknown name."""


@expose_substitution("eval")
class PythonExpression(Substitution):
    """The value of a Python expression, as text; the expression may use the names of `math`.

    >>> from launch import LaunchContext
    >>> PythonExpression(['1 + ', '2']).perform(LaunchContext())
    '3'
    """

    def __init__(
        self,
        expression: SomeSubstitutionsType,
        python_modules: SomeSubstitutionsType = ("math",),
    ) -> None:
        super().__init__()
        self.__expression = normalize_to_list_of_substitutions(expression)
        self.__python_modules = normalize_to_list_of_substitutions(python_modules)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Read `$(eval 'expression')`, optionally followed by 'module, module'."""
        if not 1 <= len(data) <= 2:
            raise TypeError("eval substitution expects 1 or 2 arguments; put the expression in quotes")
        kwargs: dict[str, Any] = {"expression": data[0]}
        if len(data) == 2:
            texts = [getattr(sub, "text", "") for sub in normalize_to_list_of_substitutions(data[1])]
            kwargs["python_modules"] = [name.strip() for name in "".join(texts).split(",")]
        return cls, kwargs

    @property
    def expression(self) -> list[Substitution]:
        """The expression, as substitutions."""
        return self.__expression

    @property
    def python_modules(self) -> list[Substitution]:
        """The modules that the expression may use, as substitutions."""
        return self.__python_modules

    def describe(self) -> str:
        """Return a description of the expression and its modules."""
        modules = ", ".join(sub.describe() for sub in self.__python_modules)
        return f"PythonExpr({' + '.join(sub.describe() for sub in self.__expression)}, [{modules}])"

    def perform(self, context: LaunchContext) -> str:
        """Return the expression's value as text.

        Raises:
            SubstitutionFailure: if the expression fails; the cause is Python's own error.
            NameError: if it uses an unknown name (this is also a SubstitutionFailure).
        """
        expression = perform_substitutions(context, self.__expression)
        try:
            return str(eval(expression, self.__names(context)))
        except Exception as error:
            kind = UnknownNameError if isinstance(error, NameError) else SubstitutionFailure
            raise kind(
                f'failed to evaluate the expression "{expression}": {type(error).__name__}: {error}; '
                "text values need quotes of their own"
            ) from error

    def __names(self, context: LaunchContext) -> dict[str, Any]:
        """Return the names for the expression: the modules, and their contents (which never hide Python's own names)."""
        known: dict[str, Any] = {}
        for module_name in self.__python_modules:
            name = perform_substitutions(context, [module_name])
            if name:
                module = importlib.import_module(name)
                inside = {key: value for key, value in vars(module).items() if not hasattr(builtins, key)}
                known = {**known, **inside, name: module}
        return known
