"""Filters one after another as one filter."""

from __future__ import annotations

from typing import Any

from .simple_filter import SimpleFilter


class Chain(SimpleFilter):
    """Passes its input to its first filter, each filter's output to the next one, and the last one's output on.

    >>> from message_filters import SimpleFilter
    >>> class Doubled(SimpleFilter):
    ...     def add(self, number):
    ...         self.signalMessage(2 * number)
    >>> chain = Chain()
    >>> chain.addFilter(Doubled())
    >>> chain.addFilter(Doubled())
    >>> connection = chain.registerCallback(print)
    >>> chain.add(3)
    12
    """

    def __init__(self, message_filter: SimpleFilter | None = None) -> None:
        super().__init__()
        self.incoming_connection: int | None = None
        self._filters: list[Any] = []
        self._output: int | None = None
        if message_filter is not None:
            self.connectInput(message_filter)

    def connectInput(self, message_filter: SimpleFilter) -> None:
        """Use the output of a filter as input.

        Raises:
            RuntimeError: if it has an input.
        """
        if self.incoming_connection is not None:
            raise RuntimeError("this Chain already has an input")
        self.incoming_connection = message_filter.registerCallback(self.add)

    def addFilter(self, message_filter: Any) -> None:
        """Add a filter, which has `add(message)`, to the end."""
        if self._output is not None:
            self._filters[-1].unregisterCallback(self._output)
            self._filters[-1].registerCallback(message_filter.add)
        self._filters.append(message_filter)
        self._output = message_filter.registerCallback(self.signalMessage)

    def getFilter(self, index: int) -> Any:
        """The filter that was added as number `index`, from 0.

        Raises:
            KeyError: if there is none.
        """
        if not 0 <= index < len(self._filters):
            raise KeyError(index)
        return self._filters[index]

    def add(self, message: Any) -> None:
        """Pass a message to the first filter."""
        if self._filters:
            self._filters[0].add(message)
