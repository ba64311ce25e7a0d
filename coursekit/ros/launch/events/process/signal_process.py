"""The event that sends a signal to processes."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import TYPE_CHECKING

from coursekit.systems.signal_names import signal_called

from ...utilities import ensure_argument_type
from .process_targeted_event import ProcessTargetedEvent

if TYPE_CHECKING:
    from ...actions.execute_local import ExecuteLocal


class SignalProcess(ProcessTargetedEvent):
    """A request to send a signal to the process, given by name, number or `signal.Signals`.

    >>> SignalProcess(signal_number='SIGINT', process_matcher=lambda action: True).signal_name
    'SIGINT'
    """

    name = "launch.events.process.SignalProcess"

    def __init__(
        self,
        *,
        signal_number: str | int | signal.Signals,
        process_matcher: Callable[[ExecuteLocal], bool],
    ) -> None:
        ensure_argument_type(signal_number, (str, int, signal.Signals), "signal_number", "SignalProcess")
        super().__init__(process_matcher=process_matcher)
        self.__signal = signal_called(signal_number)

    @property
    def signal(self) -> signal.Signals:
        """The signal."""
        return self.__signal

    @property
    def signal_name(self) -> str:
        """The signal's name, such as SIGINT."""
        return self.__signal.name
