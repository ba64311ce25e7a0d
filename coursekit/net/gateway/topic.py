"""One topic in both directions: remote publishers have ROS publishers here; ROS is subscribed to while peers listen."""

from __future__ import annotations

import itertools
import time
from collections import deque
from collections.abc import Mapping
from typing import Any

from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.serialization import deserialize_message, serialize_message
from zenoh import CongestionControl, Locality, ext

from ..wire.attachment import Attachment, read_attachment
from ..wire.moving import MOVING, VELOCITIES, Punctual
from ..wire.names import ANY_HASH
from ..wire.quality import Quality
from .echo import Echo
from .types import is_latched, kept, profile_of, quality_of

LEAST_DEPTH = 10


class Speaker:
    """A remote publisher, represented by a ROS publisher."""

    def __init__(self, publisher: Any, kind: Any, type_name: str) -> None:
        self.publisher = publisher
        self._kind = kind
        self._type_name = type_name
        self._numbers: deque[tuple[bytes, int]] = deque(maxlen=256)
        self._punctual = Punctual()
        self._moving = False

    def speak(self, data: bytes, came_with: Attachment | None, echo: Echo) -> None:
        """Publish a message, unless it is a duplicate or a delayed velocity command."""
        if came_with is not None:
            number = came_with.gid, came_with.number
            if number in self._numbers:
                return
            self._numbers.append(number)
            if self._type_name in MOVING and self._punctual.is_late(came_with.stamp, time.time_ns()):
                return
        deserialize_message(data, self._kind)  # bytes from a peer: the middleware would pass them on unread
        self._moving = self._type_name in VELOCITIES and any(data[4:])
        echo.publish(self.publisher.publish, data)

    def stop(self, echo: Echo) -> None:
        """Publish a stop if the last velocity command was not zero: its publisher is gone."""
        if self._moving:
            self._moving = False
            echo.publish(self.publisher.publish, serialize_message(self._kind()))


class Topic:
    """The transport of one topic between ROS and the network."""

    def __init__(self, gateway: Any, name: str, type_name: str, kind: Any) -> None:
        self._gateway, self._name, self._type_name, self._kind = gateway, name, type_name, kind
        self._echo = Echo()
        self._speakers: dict[bytes, Speaker] = {}
        self._listeners: dict[str, tuple[str, Quality]] = {}
        self._ear: Any = None
        self._ear_profile: Any = None
        self._hearing: Any = None
        self._zenoh_publishers: dict[str, Any] = {}
        self._numbers = itertools.count(1)
        self._in_order = MutuallyExclusiveCallbackGroup()

    def add_speaker(self, gid: bytes, publisher: Any, *, latched: bool) -> None:
        """Add a remote publisher."""
        self._speakers[gid] = Speaker(publisher, self._kind, self._type_name)
        if self._ear is None or (latched and not self._ear[1]):
            if self._ear is not None:
                self._ear[0].undeclare()
            history = ext.HistoryConfig(detect_late_publishers=True) if latched else None
            subscriber = ext.declare_advanced_subscriber(
                self._gateway.session, self._key(ANY_HASH), self._from_network,
                allowed_origin=Locality.REMOTE, history=history, subscriber_detection=latched,
            )  # fmt: skip
            self._ear = subscriber, latched

    def remove_speaker(self, gid: bytes) -> None:
        """Remove a remote publisher."""
        self._speakers.pop(gid).stop(self._echo)
        if not self._speakers and self._ear is not None:
            self._ear[0].undeclare()
            self._ear = None

    def add_listener(self, token: str, type_hash: str, quality: Quality) -> None:
        """Add a remote subscription."""
        self._listeners[token] = type_hash, quality

    def remove_listener(self, token: str) -> None:
        """Remove a remote subscription."""
        self._listeners.pop(token, None)

    def compare(self, offered: list[Any]) -> None:
        """Subscribe to ROS publishers with these profiles, while there are any and peers listen."""
        wanted = self._wanted(offered) if offered and self._listeners else None
        if wanted != self._ear_profile:
            self._stop_hearing()
            self._ear_profile = wanted
        hashes = {type_hash for type_hash, _ in self._listeners.values()} if wanted is not None else set()
        for gone in self._zenoh_publishers.keys() - hashes:
            self._zenoh_publishers.pop(gone).undeclare()
        if wanted is not None:
            profile = profile_of(wanted)
            for new in hashes - self._zenoh_publishers.keys():
                self._zenoh_publishers[new] = self._zenoh_publisher(new, profile)
            if self._hearing is None:
                self._hearing = self._gateway.node.create_subscription(
                    self._kind, self._name, self._from_ros, profile, raw=True, callback_group=self._in_order
                )

    def close(self) -> None:
        """Stop carrying messages."""
        self._listeners.clear()
        self.compare([])

    def _wanted(self, offered: list[Any]) -> Any:
        """Return the strongest QoS that all publishers offer, as `ros2 topic echo` does, with the listeners' largest depth.

        The publishers' own depth is not used: DDS does not announce it.
        """
        qualities, asked = [quality_of(info) for info in offered], [quality for _, quality in self._listeners.values()]
        return Quality(
            reliability=max(offer.reliability for offer in qualities),
            durability=max(offer.durability for offer in qualities),
            history=max(profile.history for profile in asked),
            depth=max(LEAST_DEPTH, *(profile.depth for profile in asked)),
        )

    def _zenoh_publisher(self, type_hash: str, profile: Any) -> Any:
        may_block = int(profile.history) == 2 and int(profile.reliability) == 1
        options: dict[str, Any] = {"congestion_control": CongestionControl.BLOCK if may_block else CongestionControl.DROP}
        if is_latched(profile):
            options |= {"cache": ext.CacheConfig(kept(profile)), "publisher_detection": True}
        return ext.declare_advanced_publisher(self._gateway.session, self._key(type_hash), **options)

    def _stop_hearing(self) -> None:
        if self._hearing is not None:
            self._gateway.node.destroy_subscription(self._hearing)
            self._hearing = None
        for zenoh_publisher in self._zenoh_publishers.values():
            zenoh_publisher.undeclare()
        self._zenoh_publishers.clear()

    def _key(self, type_hash: str) -> str:
        return str(self._gateway.key(self._name, self._type_name, type_hash))

    def _from_network(self, sample: Any) -> None:
        try:
            came_with = read_attachment(sample.attachment.to_bytes()) if sample.attachment is not None else None
            speaker = self._speakers.get(came_with.gid if came_with else b"") or next(iter(self._speakers.values()), None)
            if speaker is not None:
                speaker.speak(sample.payload.to_bytes(), came_with, self._echo)
        except Exception as error:  # bytes from a peer, or a node that ends at this moment
            self._gateway.tell(f"A message on {self._name} was not passed on: {error}")

    def _from_ros(self, data: bytes, info: Mapping[str, Any]) -> None:
        if not self._echo.is_own(data, info["source_timestamp"]):
            gid = self._gateway.announced.gid_of_publisher(self._name, self._type_name)
            attachment = Attachment(next(self._numbers), time.time_ns(), gid).data()
            for zenoh_publisher in list(self._zenoh_publishers.values()):
                zenoh_publisher.put(data, attachment=attachment)
