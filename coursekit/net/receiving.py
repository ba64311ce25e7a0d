"""Receives one topic's messages, for as long as there are local subscriptions."""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from typing import Any

from .remote import RemotePublisher
from .wire.attachment import Attachment, read_attachment

LARGEST = 1 << 30
"""Maximum size of a message in bytes; a larger one is a peer's mistake or worse."""
MOST_EARLY = 64
"""Maximum number of messages kept until their publisher is announced."""


class Receiver:
    """Receives the messages of a topic's key for its remote publishers; with `latched` also earlier messages."""

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
        """Set the topic's current publishers; messages received before any of them was known are delivered now."""
        with self._lock:
            self._publishers = {publisher.gid[:16]: publisher for publisher in publishers}
            while self._publishers and self._early:
                self._give(*self._early.popleft())

    def close(self) -> None:
        """Stop receiving."""
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
        publisher = self._publishers.get(came_with.gid) if came_with else None
        publisher = publisher or next(iter(self._publishers.values()))  # its publisher is unknown: the first one stands in
        publisher.receive(data, came_with)


def attachment_of(sample: Any) -> Attachment | None:
    """Return the attachment of a message or a request; None for a missing or malformed one."""
    if sample.attachment is not None:
        with contextlib.suppress(ValueError):
            return read_attachment(sample.attachment.to_bytes())
    return None
