"""`${...}` of xacro files, evaluated with limits: a description computes numbers, it has no access to Python.

xacro's own evaluator checks names with two underscores only in the outermost code, and computes `9**9**9` for ever.
"""

from __future__ import annotations

import ast
from collections.abc import Sequence
from types import CodeType
from typing import Any

BITS = 100_000
"""Maximum size of an integer [bits]."""
LENGTH = 1_000_000
"""Maximum length of a list or string."""
_GUARDED = {ast.Pow: "pow", ast.LShift: "shift", ast.Mult: "times"}


class Unbounded(ValueError):
    """An expression that does not belong in a robot's description."""


def evaluate(expression: str, names: dict[str, Any], local: Any = None) -> Any:
    """Evaluate a Python expression with these names.

    Raises:
        Unbounded: for private names, and for results that are too large; other errors as in Python.

    >>> evaluate("2 * pi", {"pi": 3})
    6
    >>> evaluate("9**9**9", {})
    Traceback (most recent call last):
    coursekit.urdf.expressions.Unbounded: 9 ** 387420489 has too many digits
    """
    names.update(_HELPERS)  # in place: xacro's name tables look up missing names elsewhere
    return eval(_compiled(expression.strip()), names, local)


def _compiled(text: str) -> CodeType:
    tree = ast.parse(text, "<expression>", "eval")
    private = [name for node in ast.walk(tree) for name in _names(node) if name.startswith("__")]
    if private:
        raise Unbounded(f"the name {private[0]} is Python's own and not for descriptions")
    return compile(ast.fix_missing_locations(_Guard().visit(tree)), "<expression>", "eval")


def _names(node: ast.AST) -> Sequence[str]:
    if isinstance(node, ast.Attribute):
        return [node.attr]
    if isinstance(node, ast.Name):
        return [node.id]
    if isinstance(node, (ast.arg, ast.keyword)):
        return [node.arg or ""]
    return ()


class _Guard(ast.NodeTransformer):
    """Replaces the operators that make large objects from small ones by checked functions."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        self.generic_visit(node)
        name = _GUARDED.get(type(node.op))
        if name is None:
            return node
        helper = ast.Name(id=f"__{name}", ctx=ast.Load())
        return ast.copy_location(ast.Call(func=helper, args=[node.left, node.right], keywords=[]), node)


def _pow(base: Any, exponent: Any) -> Any:
    if isinstance(base, int) and isinstance(exponent, int) and base.bit_length() * exponent > BITS:
        raise Unbounded(f"{base} ** {exponent} has too many digits")
    return base**exponent


def _shift(number: Any, places: Any) -> Any:
    if isinstance(number, int) and isinstance(places, int) and number.bit_length() + places > BITS:
        raise Unbounded(f"{number} << {places} has too many digits")
    return number << places


def _times(one: Any, other: Any) -> Any:
    for times, things in ((one, other), (other, one)):
        if isinstance(times, int) and isinstance(things, (str, bytes, list, tuple)) and times * len(things) > LENGTH:
            raise Unbounded(f"{len(things)} * {times} elements are too many")
    if isinstance(one, int) and isinstance(other, int) and one.bit_length() + other.bit_length() > BITS:
        raise Unbounded("a product has too many digits")
    return one * other


_HELPERS = {"__builtins__": {}, "__pow": _pow, "__shift": _shift, "__times": _times}

__all__ = ["Unbounded", "evaluate"]
