"""Fetches one topic's messages, for as long as somebody here listens."""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from typing import Any

from .remote import RemotePublisher
from .wire.attachment import Attachment, read_attachment

LARGEST = 1 << 30
"""Bytes of a message; more is a stranger's mistake or worse."""
MOST_EARLY = 64
"""Messages that are kept until their publisher's announcement is here, too."""


class Receiver:
    """Hears what comes on a topic's key, and has its publishers receive it; with `latched` also what was said before."""

    def __init__(self, zenoh_session: Any, key: str, *, latched: bool) -> None:
        from zenoh import Locality, ext

        self.latched = latched
        self._publishers: dict[bytes, RemotePublisher] = {}
        self._early: deque[tuple[bytes, Attachment | None]] = deque(maxlen=MOST_EARLY)
        self._lock = threading.Lock()
        self._subscriber = ext.declare_advanced_subscriber(
            zenoh_session,
            key,
            self._hear,
            allowed_origin=Locality.REMOTE,
            history=ext.HistoryConfig(detect_late_publishers=True) if latched else None,
            subscriber_detection=latched,
        )

    def set_publishers(self, publishers: list[RemotePublisher]) -> None:
        """These are the topic's publishers now; what was heard before any of them was known is received now."""
        with self._lock:
            self._publishers = {one.gid[:16]: one for one in publishers}
            while self._publishers and self._early:
                self._give(*self._early.popleft())

    def close(self) -> None:
        """Hear no more."""
        self._subscriber.undeclare()

    def _hear(self, sample: Any) -> None:
        data = sample.payload.to_bytes()
        if len(data) <= LARGEST:
            self.take(data, attachment_of(sample))

    def take(self, data: bytes, came_with: Attachment | None) -> None:
        """Take a message, from Zenoh or from a direct line."""
        with self._lock:
            if self._publishers:
                self._give(data, came_with)
            else:
                self._early.append((data, came_with))

    def _give(self, data: bytes, came_with: Attachment | None) -> None:
        one = self._publishers.get(came_with.gid) if came_with else None
        one = one or next(iter(self._publishers.values()))  # it names nobody we know: the first speaks for it
        one.receive(data, came_with)


def attachment_of(sample: Any) -> Attachment | None:
    """The attachment of a message or a request; None where it has none, or another one."""
    if sample.attachment is not None:
        with contextlib.suppress(ValueError):
            return read_attachment(sample.attachment.to_bytes())
    return None
