"""Others' nodes and ends in this graph: they match like the real thing, and what they are given goes out or is dropped.

None needs a class of its interface: a message is read as what the subscription here wants.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable
from typing import Any

from coursekit.core.graph import Graph, GraphNode
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
"""Messages that are kept until they can be carried."""
REMEMBERED = 256
"""Numbers of messages by which doubles are known: a publisher sends on several keys where its listeners' hashes differ."""


class RemotePublisher(Publisher):
    """Somebody else's publisher: delivers what came from it."""

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
        """Give a message in CDR bytes to the subscriptions here; doubles and velocities that were held up are dropped."""
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
        """Give a late joiner what came before."""
        if isinstance(target.msg_type, Named):
            return
        for data, stamp in self.kept():
            self._hand_over(target, data, stamp)

    def close(self) -> None:
        """Leave; a robot here that its last velocity still drives is stopped."""
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
        """Those on this side: others hear it by themselves."""
        return [one for one in self.targets if not isinstance(one.msg_type, Named)]

    def _hand_over(self, target: Subscription, data: bytes, stamp: int) -> None:
        try:
            msg = cdr.deserialize(data, target.msg_type)
        except Exception as error:  # a stranger's bytes
            if not self._unreadable:
                self._unreadable = True
                self._tell(
                    f"Messages on {self.name} from {self.node.full_name} cannot be read as {self.type_name} ({error}): the "
                    "definition differs there. Copy the package from there into ros2_ws/src and build it: %colcon build"
                )
            return
        target.push((msg if target.reduce is None else target.reduce(msg), stamp, self))

    def _watch_deadline(self) -> None:
        """The real one is watched where it is."""


class Early:
    """Takes what is published before a publisher's messages are carried, and hands it over in order when they are."""

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
        """Have `take` get what there is, and all that still comes here."""
        with self._lock:
            self._take = take
            while self._messages:
                take(*self._messages.popleft())


def _nothing(_msg: Any) -> None:
    return None


class RemoteSubscription(Subscription):
    """Somebody else's subscription: it matches; what is published goes out once for all of them, by the publisher's tap."""

    def __init__(self, graph: Graph, node: GraphNode, token: Token, *, hears: bool = True) -> None:
        super().__init__(graph, node, token.name, Named(token.type_name), core_qos(token.quality))
        self.type_hash = token.type_hash
        self.session = token.session
        self.reduce = _nothing
        self._hears = hears
        """Whether this side sends to it."""

    def meet(self, publisher: Publisher) -> None:
        """Keep what is published before the link knows of the match; a velocity is carried at once or not at all."""
        if self._hears and publisher.tap is None and publisher.type_name not in MOVING:
            publisher.tap = Early()

    def push(self, entry: tuple[Any, int, Publisher]) -> None:
        """Nothing: see above."""

    def _check_deadline(self) -> None:
        """The real one is watched where it is."""


Ask = Callable[["RemoteServer", bytes, RequestId], None]


class RemoteServer(Server):
    """Somebody else's server: passes requests on."""

    def __init__(self, graph: Graph, node: GraphNode, token: Token, ask: Ask) -> None:
        super().__init__(graph, node, token.name, Named(token.type_name), core_qos(token.quality))
        self.type_hash = token.type_hash
        self._ask = ask

    def push(self, request: Any, request_id: RequestId) -> None:
        """Ask all servers behind the same key at once; the first of them in the graph does."""
        same = [one for one in self.graph.servers.get(self.name, ()) if isinstance(one, RemoteServer)
                and (one.type_name, one.type_hash) == (self.type_name, self.type_hash)]  # fmt: skip
        if same[:1] == [self]:
            self._ask(self, cdr.serialize(request), request_id)


class RemoteClient(Client):
    """Somebody else's client; its requests come without it."""

    def __init__(self, graph: Graph, node: GraphNode, token: Token) -> None:
        super().__init__(graph, node, token.name, Named(token.type_name), core_qos(token.quality))


def is_latched(end: Endpoint) -> bool:
    """Whether a publisher keeps messages for late joiners, or a subscription asks for them."""
    return end.qos.durability == TRANSIENT_LOCAL
