"""The threads of a compiled program that run the session's callbacks, one at a time each."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING

from coursekit.nodes.compiled.channel import Channel, Gone

if TYPE_CHECKING:
    from coursekit.core.clock import Clock, Event


class _Wish:
    """A request for a thread of the program."""

    def __init__(self, came: Event) -> None:
        self.came = came
        self.channel: Channel | None = None


class Workers:
    """Idle and starting threads; `accept` waits on the virtual clock for the next one."""

    def __init__(self, clock: Clock, accept: Callable[[], Channel]) -> None:
        self._clock, self._accept = clock, accept
        self._lock = threading.Lock()
        self._control: socket.socket | None = None
        self._all: list[Channel] = []
        self._idle: list[Channel] = []
        self._wishes: list[_Wish] = []
        """The callers that wait on the wall clock for a starting thread."""

    def ask_by(self, control: socket.socket) -> None:
        """Set the control connection: the program makes a thread for each W sent on it."""
        self._control = control

    def tell_signal(self, number: int) -> bool:
        """Send a signal to the program. Returns whether the connection exists by then."""
        control = self._control
        try:
            return control is not None and control.send(bytes([number])) == 1
        except OSError:
            return False

    def take(self) -> Channel:
        """Return a thread that waits for calls, a new one if all are busy. Raises Gone when the program has ended."""
        with self._lock:
            if self._idle:
                return self._idle.pop()
            if self._control is None:
                raise Gone
            try:
                self._control.sendall(b"W")
            except OSError:
                raise Gone from None
            if self._clock.virtual:
                return self._begin(self._accept())
            wish = _Wish(self._clock.new_event())
            self._wishes.append(wish)
        wish.came.wait()
        if wish.channel is None:
            raise Gone
        return wish.channel

    def put_back(self, channel: Channel) -> None:
        """Return a thread to the idle ones."""
        self._idle.append(channel)

    def welcome(self, channel: Channel) -> None:
        """Assign a new thread to the longest waiting request."""
        self._begin(channel)
        with self._lock:
            if not self._wishes:
                self._idle.append(channel)
                return
            wish = self._wishes.pop(0)
            wish.channel = channel
        wish.came.set()

    def end(self) -> None:
        """End all waiting: the program has ended."""
        with self._lock:
            wishes, self._wishes, control, self._control = self._wishes, [], self._control, None
        for wish in wishes:
            wish.came.set()  # without a thread
        for channel in self._all:
            channel.close()
        if control is not None:
            control.close()

    def _begin(self, channel: Channel) -> Channel:
        self._all.append(channel)
        channel.begin_worker()
        return channel
