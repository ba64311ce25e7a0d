"""Filters that pass on only messages that differ from the last one that they passed on."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from .simple_filter import SimpleFilter

Getter = Callable[[Any], Any]
"""Returns a field's value from a message."""


class ComparisonHandler:
    """Determines which messages pass; subclasses implement both methods."""

    def message_fits(self, message: Any) -> bool:
        """Whether the message passes."""
        raise NotImplementedError

    def do_fields_fit(self, field_a: Any, field_b: Any) -> bool:
        """Whether a message passes because of one field's values, the older one first."""
        raise NotImplementedError


class CachedComparisonHandler(ComparisonHandler):
    """Compares a message's fields with those of the last message that passed; the first one passes."""

    def __init__(self) -> None:
        self._field_getters: Sequence[Getter] = ()
        self._message_cache: Any = None

    def message_fits(self, message: Any) -> bool:
        """Whether the message is the first, or passes because of at least one of its fields."""
        last = self._message_cache
        fits = last is None or any(self.do_fields_fit(field(last), field(message)) for field in self._field_getters)
        if fits:
            self._message_cache = message
        return fits


class DeltaCompare(CachedComparisonHandler):
    """A message passes when one of its fields has another value than in the last message that passed.

    >>> from std_msgs.msg import Int32
    >>> compare = DeltaCompare([lambda message: message.data])
    >>> [compare.message_fits(Int32(data=number)) for number in (1, 1, 2)]
    [True, False, True]
    """

    def __init__(self, field_getters: Sequence[Getter]) -> None:
        super().__init__()
        self._field_getters = field_getters

    def do_fields_fit(self, field_a: Any, field_b: Any) -> bool:
        """Whether two numbers, texts or truth values differ.

        Raises:
            TypeError: for values of another kind.
        """
        if not all(isinstance(value, (bool, int, float, str)) for value in (field_a, field_b)):
            raise TypeError(f"values of {type(field_a)} and {type(field_b)} cannot be compared")
        return bool(field_a != field_b)


class ComparisonFilter(SimpleFilter):
    """Passes on the messages for which `comparison_handler.message_fits(message)` is true."""

    def __init__(self, comparison_handler: ComparisonHandler, message_filter: SimpleFilter | None = None) -> None:
        super().__init__()
        self._comparison_handler = comparison_handler
        self.incoming_connection: int | None = None
        self.connectInput(message_filter)

    def connectInput(self, message_filter: SimpleFilter | None) -> None:
        """Use the output of a filter as input.

        Raises:
            RuntimeError: if it has an input.
        """
        if self.incoming_connection is not None:
            raise RuntimeError(f"this {type(self).__name__} already has an input")
        if message_filter is not None:
            self.incoming_connection = message_filter.registerCallback(self.add)

    def message_fits(self, message: Any) -> bool:
        """Whether the message passes."""
        return self._comparison_handler.message_fits(message)

    def add(self, message: Any) -> None:
        """Pass a message on, if it passes."""
        if self.message_fits(message):
            self.signalMessage(message)


class DeltaFilter(ComparisonFilter):
    """Passes on the messages in which one of the values that the `field_getters` return has changed."""

    def __init__(self, field_getters: Sequence[Getter], message_filter: SimpleFilter | None = None) -> None:
        super().__init__(DeltaCompare(field_getters), message_filter)


class PathDeltaFilter(DeltaFilter):
    """Passes on the messages in which one of the fields has changed; for example 'pose.position.x'."""

    def __init__(self, field_path_list: Sequence[str], message_filter: SimpleFilter | None = None) -> None:
        super().__init__([partial(self.get_field_by_path, field_path=path) for path in field_path_list], message_filter)

    def get_field_by_path(self, message: Any, field_path: str) -> Any:
        """A field of a message, or of a message in it.

        Raises:
            RuntimeError: if there is no such field.
        """
        value = message
        for name in field_path.split("."):
            if getattr(value, name, None) is None:
                raise RuntimeError(f"{type(value).__name__} has no field '{name}' (of '{field_path}')")
            value = getattr(value, name)
        return value
