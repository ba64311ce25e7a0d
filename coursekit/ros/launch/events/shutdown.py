"""The event that ends the launch."""

from __future__ import annotations

from ..event import Event


class Shutdown(Event):
    """A request to end the launch."""

    name = "launch.events.Shutdown"

    def __init__(self, *, reason: str = "reason not given", due_to_sigint: bool = False) -> None:
        self.__reason = reason
        self.__due_to_sigint = due_to_sigint

    @property
    def reason(self) -> str:
        """The reason as text."""
        return self.__reason

    @property
    def due_to_sigint(self) -> bool:
        """Whether the cause was a Ctrl-C."""
        return self.__due_to_sigint
