"""A compiled program's arrival callbacks: they are called when data arrives, before it is taken."""

from __future__ import annotations

import contextlib
import threading
from collections import deque
from typing import TYPE_CHECKING, Any

from rclpy._rclpy_info import as_bytes
from rclpy.action import ActionClient, ActionServer

from coursekit.core.ready_queue import Source
from coursekit.core.status import DEADLINE, INCOMPATIBLE, LIVELINESS, MESSAGE_LOST, Status
from coursekit.core.topic import Subscription
from coursekit.nodes.compiled.channel import CallbackFailed, Gone
from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from rclpy.node import Node

    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

_ITSELF, _IN_PROGRAM = -1, -2
"""The kinds of events of an entity: arrivals, and those within the program. Other numbers are QoS events."""
_EVENTS = (DEADLINE, LIVELINESS, INCOMPATIBLE, MESSAGE_LOST)
"""By rcl's numbers, of publishers as of subscriptions."""


class News:
    """Notifies the program in order of arrival, in a separate thread: publishers are not delayed."""

    def __init__(self, host: Host) -> None:
        self._host = host
        self._lock = threading.Lock()
        self._untold: deque[tuple[int, bytes]] = deque()
        self._telling = False

    def tell(self, handler: int, count: int, logger: str) -> None:
        """Call a callback of the program with the number of arrivals; its exceptions go to that logger."""
        with self._lock:
            self._untold.append((handler, packed(count, logger)))
            begins, self._telling = not self._telling, True
        if begins:  # in this program, whichever one has published
            self._host.context.copy().run(self._host.session.spawn, self._tell_all)

    def _tell_all(self) -> None:
        while (told := self._next()) is not None:
            with contextlib.suppress(Gone, CallbackFailed):
                self._host.call(*told)

    def _next(self) -> tuple[int, bytes] | None:
        with self._lock:
            self._telling = bool(self._untold)
            return self._untold.popleft() if self._untold else None


class Listener:
    """Called with all arrivals at a source."""

    def __init__(self, host: Host, node: Node, entity: object) -> None:
        self._host, self._entity = host, entity
        self.logger: str = node.get_logger().name
        self.handlers: dict[int, int] = {}
        """The program's callbacks: for arrivals, and for those within the program."""
        self.untold: dict[int, int] = {}
        """How many arrivals of a kind no callback has been told of."""

    def __call__(self, came: Any) -> None:
        kind = self.kind_of(came)
        if kind is None:
            return
        handler = self.handlers.get(kind)
        if handler is None:
            self.untold[kind] = self.untold.get(kind, 0) + 1
        else:
            self._host.news.tell(handler, 1, self.logger)

    def kind_of(self, came: Any) -> int | None:
        """Return the kind of an arrival; None if its subscription ignores it."""
        hearing = getattr(self._entity, "hearing", None)
        if hearing is None:
            return _ITSELF
        message, _stamp, publisher = came
        if not hearing.wants(as_bytes(message), publisher.gid):
            return None
        return _IN_PROGRAM if hearing.stays and publisher.gid in self._host.staying_gids else _ITSELF


def do_stays(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Allow a publisher's or subscription's messages to stay in the program."""
    entity = host.things[frame.integer()][2]
    if hasattr(entity, "hearing"):
        entity.hearing.stays = True
    else:
        host.staying_gids.add(entity._core.gid)


def do_on_new(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Set the callback for queued and new arrivals, 0 for none."""
    thing, kind, handler = host.things[frame.integer()], frame.integer(), frame.integer()
    node, entity, source = _source_of(thing, kind)
    listener = source.listener
    if not isinstance(listener, Listener):
        listener = source.listener = Listener(host, node, entity)
        listener.untold = {kind: _waiting(source, listener, kind) for kind in (_ITSELF, _IN_PROGRAM)}
    listened = kind if kind == _IN_PROGRAM else _ITSELF
    listener.handlers.pop(listened, None)
    if handler:
        listener.handlers[listened] = handler
        untold = min(listener.untold.pop(listened, 0), _waiting(source, listener, listened))
        if untold:
            host.news.tell(handler, untold, listener.logger)


def _source_of(thing: Any, kind: int) -> tuple[Any, Any, Source]:
    """Return the node, the entity, and the source of arrivals."""
    if isinstance(thing, ActionClient):
        clients = (thing._goal_client, thing._result_client, thing._cancel_client)
        entity = (*clients, thing._feedback_subscription, thing._status_subscription)[kind]
        return thing._node, entity, entity._sources()[0]
    if isinstance(thing, ActionServer):
        goal, cancel, result = thing._services
        entity = (goal, result, cancel)[kind]
        return thing._node, entity, entity._sources()[0]
    node, _how, entity = thing
    if kind >= 0:
        return node, None, entity.handle.core.status(_EVENTS[kind])
    return node, entity, entity._sources()[0]


def _waiting(source: Any, listener: Listener, kind: int) -> int:
    """Return the number of untaken arrivals."""
    if isinstance(source, Status):
        return max(abs(source.change), 1) if source.changed else 0
    if isinstance(source, Subscription):
        return sum(listener.kind_of(entry) == kind for entry in list(source.queue))
    return len(source.queue)
