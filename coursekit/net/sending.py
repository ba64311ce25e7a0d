"""Sends the messages of one publisher out of the graph, for as long as there are remote listeners."""

from __future__ import annotations

import itertools
import threading
import time
from collections import deque
from collections.abc import Callable
from typing import Any

from coursekit.core.qos import KEEP_ALL, RELIABLE
from coursekit.core.topic import Publisher
from coursekit.interfaces import cdr

from .direct import LONGEST, Line, frame
from .remote import Early, is_latched
from .traffic import Traffic
from .wire.attachment import Attachment

MOST_LATCHED = 1000
"""Maximum history for late joiners on the network, for a publisher that keeps all messages."""


class Sender:
    """Sends on one key per type hash of the listeners, given by `key_of`. Without a hash nothing is sent or serialized."""

    def __init__(self, zenoh_session: Any, publisher: Publisher, gid: bytes, key_of: Callable[[str], str]) -> None:
        self.publisher = publisher
        self.traffic = Traffic()
        self._session = zenoh_session
        self._gid = gid
        self._key_of = key_of
        self._zenoh_publishers: dict[str, Any] = {}
        self._lines: tuple[Line, ...] = ()
        qos = publisher.qos
        self._keeps = is_latched(publisher)
        self._may_block = qos.history == KEEP_ALL and qos.reliability == RELIABLE
        self._numbers = itertools.count(1)
        depth = MOST_LATCHED if qos.history == KEEP_ALL else min(qos.depth, MOST_LATCHED)
        self._kept: deque[tuple[bytes, bytes]] = deque(maxlen=depth)
        self._last_kept = -1
        self._lock = threading.Lock()

    def want(self, hashes: set[str], lines: tuple[Line, ...] = ()) -> None:
        """Send to listeners with these hashes from now on; late joiners first get the kept messages.

        `lines` are the direct lines to all listeners, if there are any. Once Zenoh carries a topic, it continues to do so:
        otherwise messages could overtake those in transit.
        """
        for gone in self._zenoh_publishers.keys() - hashes:
            with self._lock:
                zenoh_publisher = self._zenoh_publishers.pop(gone)
            zenoh_publisher.undeclare()
        begins = bool(hashes) and self.publisher.tap != self._take
        if begins or self._lines:
            with self._lock:
                self._take_lines(() if self._keeps or self._may_block else lines)
        if begins:
            self._read_kept()
        for new in hashes - self._zenoh_publishers.keys():
            self._add(new)
        if begins or not hashes:
            self._tap(bool(hashes))

    def close(self) -> None:
        """Stop sending."""
        self.want(set())

    def _tap(self, carries: bool) -> None:
        """Start taking the publisher's messages, including those since the match with a remote listener, or stop."""
        early = self.publisher.tap
        if carries and isinstance(early, Early):
            early.hand_over(self._take)
        self.publisher.tap = self._take if carries else None

    def _read_kept(self) -> None:
        with self._lock:
            self._kept.clear()
            for msg, stamp in self.publisher.kept():
                self._last_kept = stamp
                self._packed(msg)

    def _add(self, type_hash: str) -> None:
        from zenoh import CongestionControl, ext

        control = CongestionControl.BLOCK if self._may_block else CongestionControl.DROP
        options: dict[str, Any] = {"congestion_control": control}
        if self._keeps:
            options |= {"cache": ext.CacheConfig(self._kept.maxlen), "publisher_detection": True}
        zenoh_publisher = ext.declare_advanced_publisher(self._session, self._key_of(type_hash), **options)
        with self._lock:
            for data, attachment in self._kept:
                zenoh_publisher.put(data, attachment=attachment)
            self._zenoh_publishers[type_hash] = zenoh_publisher

    def _take(self, msg: Any, stamp: int) -> None:
        with self._lock:
            if stamp <= self._last_kept and self._keeps:
                return  # it was one of the kept messages
            data, attachment = self._packed(msg)
            if not self._sent_directly(data, attachment):
                for zenoh_publisher in self._zenoh_publishers.values():
                    zenoh_publisher.put(data, attachment=attachment)
        self.traffic.count(self.publisher.graph.clock.now())

    def _sent_directly(self, data: bytes, attachment: bytes) -> bool:
        """Send over the direct lines and return whether all got it. If not, Zenoh resends it; receivers drop duplicates."""
        if self._lines:
            sent = frame(self.publisher.name, self.publisher.type_name, data, attachment) if len(data) <= LONGEST else b""
            if not sent or not all(line.send(sent) for line in self._lines):
                self._take_lines(())
        return bool(self._lines)

    def _take_lines(self, lines: tuple[Line, ...]) -> None:
        """Send over these lines from now on. Before Zenoh takes over, or nobody does, what is on its way arrives."""
        if not lines:
            for line in self._lines:
                line.settle()
        self._lines = lines

    def _packed(self, msg: Any) -> tuple[bytes, bytes]:
        entry = cdr.serialize(msg), Attachment(next(self._numbers), time.time_ns(), self._gid).data()
        if self._keeps:
            self._kept.append(entry)
        return entry
