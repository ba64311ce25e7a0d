"""Remote nodes and endpoints in this graph: they match like local ones; their messages are sent on or dropped.

None needs a class of its interface: a message is deserialized as the local subscription's type.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import Any

from coursekit.core.graph import Graph
from coursekit.core.graph_node import GraphNode
from coursekit.core.qos import TRANSIENT_LOCAL
from coursekit.core.service import Client, RequestId, Server
from coursekit.core.topic import Endpoint, Publisher, Subscription
from coursekit.interfaces import cdr
from coursekit.joined.ghosts import Named

from .quality import core_qos
from .traffic import Traffic
from .wire.attachment import Attachment
from .wire.moving import MOVING, VELOCITIES, Punctual
from .wire.token import Token

MOST_EARLY = 64
"""Maximum number of messages kept until they can be carried."""
REMEMBERED = 256
"""Message numbers remembered to detect duplicates: a publisher uses several keys if its listeners' hashes differ."""


class RemotePublisher(Publisher):
    """A remote publisher: delivers its messages to local subscriptions."""

    def __init__(self, graph: Graph, node: GraphNode, token: Token, tell: Callable[[str], None]) -> None:
        super().__init__(graph, node, token.name, Named(token.type_name), core_qos(token.quality))
        self.traffic = Traffic()
        self._tell = tell
        self._numbers: deque[tuple[bytes, int]] = deque(maxlen=REMEMBERED)
        self._punctual = Punctual()
        self._moving = False
        self._unreadable = False
        self._lock = threading.Lock()

    def receive(self, data: bytes, came_with: Attachment | None) -> None:
        """Deliver a message in CDR bytes to local subscriptions; duplicates and delayed velocity commands are dropped."""
        now = self.graph.clock.now()
        with self._lock:
            if came_with is not None:
                number = came_with.gid, came_with.number
                if number in self._numbers:
                    return
                self._numbers.append(number)
                if self.type_name in MOVING and self._punctual.is_late(came_with.stamp, now):
                    return
            self.traffic.count(now, now - came_with.stamp if came_with else 0)
            self._deliver(data, now)

    def replay(self, target: Subscription) -> None:
        """Send earlier messages to a late joiner."""
        if isinstance(target.msg_type, Named):
            return
        for data, stamp in self.kept():
            self._hand_over(target, data, stamp)

    def close(self) -> None:
        """Leave the graph; a local robot still driven by its last velocity command is stopped."""
        if self._moving:
            for target in self._listeners():
                self._hand_over(target, cdr.serialize(target.msg_type()), self.graph.clock.now())
        super().close()

    def _deliver(self, data: bytes, now: int) -> None:
        if self._history is not None:
            self._history.append((data, now))
        for target in self._listeners():
            self._hand_over(target, data, now)
        self._moving = self.type_name in VELOCITIES and any(data[4:])

    def _listeners(self) -> list[Subscription]:
        """The local subscriptions: peers receive the messages themselves."""
        return [target for target in self.targets if not isinstance(target.msg_type, Named)]

    def _hand_over(self, target: Subscription, data: bytes, stamp: int) -> None:
        try:
            msg = cdr.deserialize(data, target.msg_type)
        except Exception as error:  # bytes from a peer
            if not self._unreadable:
                self._unreadable = True
                self._tell(
                    f"Messages on {self.name} from {self.node.full_name} cannot be read as {self.type_name} ({error}): the "
                    "definition differs there. Copy the package from there into ros2_ws/src and build it: %colcon build"
                )
            return
        target.push((msg if target.reduce is None else target.reduce(msg), stamp, self))

    def _watch_deadline(self) -> None:
        """Do nothing: the deadline is checked on the publisher's own side."""


class Early:
    """Stores messages published before they can be carried, and hands them over in order afterwards."""

    def __init__(self) -> None:
        self._messages: deque[tuple[Any, int]] = deque(maxlen=MOST_EARLY)
        self._take: Callable[[Any, int], None] | None = None
        self._lock = threading.Lock()

    def __call__(self, msg: Any, stamp: int) -> None:
        """Take a message, as a publisher's tap."""
        with self._lock:
            if self._take is None:
                self._messages.append((msg._clone(), stamp))
            else:
                self._take(msg, stamp)

    def hand_over(self, take: Callable[[Any, int], None]) -> None:
        """Pass the stored messages and all later ones to `take`."""
        with self._lock:
            self._take = take
            while self._messages:
                take(*self._messages.popleft())


def _nothing(_msg: Any) -> None:
    return None


class RemoteSubscription(Subscription):
    """A remote subscription: it matches; messages go out once for all of them, through the publisher's tap."""

    def __init__(self, graph: Graph, node: GraphNode, token: Token, *, hears: bool = True) -> None:
        super().__init__(graph, node, token.name, Named(token.type_name), core_qos(token.quality))
        self.type_hash = token.type_hash
        self.session = token.session
        self.reduce = _nothing
        self._hears = hears
        """Whether this side sends to it."""

    def meet(self, publisher: Publisher) -> None:
        """Store messages published before the link knows of the match; a velocity command is sent at once or not at all."""
        if self._hears and publisher.tap is None and publisher.type_name not in MOVING:
            publisher.tap = Early()

    def push(self, entry: tuple[Any, int, Publisher]) -> None:
        """Do nothing: the publisher's tap sends the messages."""

    def _check_deadline(self) -> None:
        """Do nothing: the deadline is checked on the subscription's own side."""


Ask = Callable[["RemoteServer", bytes, RequestId], None]


class RemoteServer(Server):
    """A remote server: sends requests to it."""

    def __init__(self, graph: Graph, node: GraphNode, token: Token, ask: Ask) -> None:
        super().__init__(graph, node, token.name, Named(token.type_name), core_qos(token.quality))
        self.type_hash = token.type_hash
        self._ask = ask

    def push(self, request: Any, request_id: RequestId) -> None:
        """Send the request once to all servers with the same key; only the first of them in the graph does so."""
        same = [server for server in self.graph.servers.get(self.name, ()) if isinstance(server, RemoteServer)
                and (server.type_name, server.type_hash) == (self.type_name, self.type_hash)]  # fmt: skip
        if same[:1] == [self]:
            self._ask(self, cdr.serialize(request), request_id)


class RemoteClient(Client):
    """A remote client; its requests arrive through `Asker`."""

    def __init__(self, graph: Graph, node: GraphNode, token: Token) -> None:
        super().__init__(graph, node, token.name, Named(token.type_name), core_qos(token.quality))


def is_latched(end: Endpoint) -> bool:
    """Whether a publisher keeps messages for late joiners, or a subscription requests them."""
    return end.qos.durability == TRANSIENT_LOCAL
