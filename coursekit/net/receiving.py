"""Fetches one topic's messages, for as long as somebody here listens and somebody there publishes."""

from __future__ import annotations

import contextlib
from typing import Any

from .remote import RemotePublisher
from .wire.attachment import Attachment, read_attachment

LARGEST = 1 << 30
"""Bytes of a message; more is a stranger's mistake or worse."""


class Receiver:
    """Has `publishers`, by gid, receive what comes on a key; with `latched` also what was said before."""

    def __init__(self, publishers: dict[bytes, RemotePublisher], *, latched: bool) -> None:
        self.latched = latched
        self.publishers = publishers
        self._subscriber: Any = None

    def begin(self, zenoh_session: Any, key: str) -> None:
        """Hear from now on."""
        from zenoh import Locality, ext

        self._subscriber = ext.declare_advanced_subscriber(
            zenoh_session,
            key,
            self._hear,
            allowed_origin=Locality.REMOTE,
            history=ext.HistoryConfig(detect_late_publishers=True) if self.latched else None,
            subscriber_detection=self.latched,
        )

    def close(self) -> None:
        """Hear no more."""
        self._subscriber.undeclare()

    def _hear(self, sample: Any) -> None:
        came_with = attachment_of(sample)
        publishers = self.publishers
        one = publishers.get(came_with.gid) if came_with else None
        one = one or next(iter(publishers.values()), None)  # it names nobody we know: the first speaks for it
        data = sample.payload.to_bytes()
        if one is not None and len(data) <= LARGEST:
            one.receive(data, came_with)


def attachment_of(sample: Any) -> Attachment | None:
    """What came with a message or a request; None for what came without, or with something else."""
    if sample.attachment is not None:
        with contextlib.suppress(ValueError):
            return read_attachment(sample.attachment.to_bytes())
    return None
