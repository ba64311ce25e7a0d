"""Classes that are written in several files have one name: Python's errors call a method after the class it is called on."""

from __future__ import annotations

from collections.abc import Iterator
from types import FunctionType
from typing import Any, TypeVar

Class = TypeVar("Class", bound=type)


def one_class(whole: Class) -> Class:
    """Name the methods of private base classes after this class: `Node.create_timer() missing ...`, as in ROS.

    >>> rclpy.node.Node.create_timer.__qualname__
    'Node.create_timer'
    """
    for part in whole.__mro__[1:]:
        if part.__module__.partition(".")[2].startswith("_"):
            for function in _functions(part):
                function.__qualname__ = f"{whole.__qualname__}.{function.__name__}"
    return whole


def _functions(part: type) -> Iterator[FunctionType]:
    for value in vars(part).values():
        for function in _inside(value):
            if isinstance(function, FunctionType):
                yield function


def _inside(value: Any) -> tuple[Any, ...]:
    if isinstance(value, property):
        return value.fget, value.fset, value.fdel
    return (getattr(value, "__func__", value),)


__all__ = ["one_class"]
