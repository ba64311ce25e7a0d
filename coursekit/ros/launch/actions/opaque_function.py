"""Calls a Python function."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from ..action import Action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..utilities import ensure_argument_type


class OpaqueFunction(Action):
    """Calls `function(context, *args, **kwargs)`; the entities it returns are visited next.

    >>> from launch import LaunchContext
    >>> from launch.actions import LogInfo
    >>> from launch.substitutions import LaunchConfiguration
    >>> def robots(context):
    ...     count = int(LaunchConfiguration("count").perform(context))
    ...     return [LogInfo(msg=f"robot {number}") for number in range(count)]
    >>> context = LaunchContext()
    >>> context.launch_configurations["count"] = "3"
    >>> len(OpaqueFunction(function=robots).execute(context))
    3
    """

    def __init__(
        self,
        *,
        function: Callable[..., Any],
        args: Iterable[Any] | None = None,
        kwargs: Mapping[str, Any] | None = None,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        if not callable(function):
            raise TypeError(f"OpaqueFunction expected a callable for 'function', got '{type(function)}'")
        ensure_argument_type(args, (Iterable, type(None)), "args", "OpaqueFunction")
        ensure_argument_type(kwargs, (Mapping, type(None)), "kwargs", "OpaqueFunction")
        self.__function = function
        self.__args = list(args or [])
        self.__kwargs = dict(kwargs or {})

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Call the function."""
        entities: list[LaunchDescriptionEntity] | None = self.__function(
            context, *self.__args, **self.__kwargs
        )
        return entities
