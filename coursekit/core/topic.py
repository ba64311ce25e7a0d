"""Topics: publishers copy each message once per matching subscription, so no object is shared."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from .interface import Interface, Message
from .qos import AUTOMATIC, INFINITE, KEEP_ALL, TRANSIENT_LOCAL, Qos
from .ready_queue import Source
from .status import DEADLINE, INCOMPATIBLE, LIVELINESS, MATCHED, Status

if TYPE_CHECKING:
    from .graph import Graph
    from .graph_node import GraphNode


class Endpoint(Source):
    """One end of a topic or service: its node, name, type, QoS and number."""

    __slots__ = ("alive", "gid", "graph", "msg_type", "name", "node", "qos", "statuses")

    def __init__(self, graph: Graph, node: GraphNode, name: str, msg_type: Interface, qos: Qos) -> None:
        super().__init__()
        self.graph = graph
        self.node = node
        self.name = name
        self.msg_type: Any = msg_type
        self.qos = qos.resolved()
        self.alive = True
        self.gid = b"\x01\x0f" + (0).to_bytes(10, "big") + graph.new_number().to_bytes(4, "big") + bytes(8)
        self.statuses: dict[str, Status] = {}

    @property
    def type_name(self) -> str:
        """For example 'std_msgs/msg/String'."""
        return self.msg_type._TYPE_NAME

    def status(self, kind: str) -> Status:
        """Return the event counter of that kind, created on first use."""
        status = self.statuses.get(kind)
        if status is None:
            status = self.statuses[kind] = Status()
        return status


class Publisher(Endpoint):
    """The sending end."""

    __slots__ = ("_deadline_timer", "_history", "_last_sent", "_last_sign", "_lease_timer", "_live", "tap", "targets")

    def __init__(self, graph: Graph, node: GraphNode, name: str, msg_type: Interface, qos: Qos) -> None:
        super().__init__(graph, node, name, msg_type, qos)
        self.tap: Callable[[Any, int], None] | None = None
        """Called with each message and its stamp, to carry it out of the graph; it must not keep or change the message."""
        self.targets: tuple[Subscription, ...] = ()
        keeps = self.qos.durability == TRANSIENT_LOCAL
        depth = None if self.qos.history == KEEP_ALL else self.qos.depth
        self._history: deque[tuple[Any, int]] | None = deque(maxlen=depth) if keeps else None
        self._last_sent = self._last_sign = 0  # a deadline is met by messages, a lease by any sign of life
        self._live = True
        self._deadline_timer: Any = None
        self._lease_timer: Any = None
        if self.qos.deadline != INFINITE:
            self._watch_deadline()
        if self.qos.lease != INFINITE and self.qos.liveliness != AUTOMATIC:
            self._live = False  # alive only after its first assertion

    def publish(self, msg: Message) -> None:
        """Deliver a copy of `msg` to every matching subscription.

        >>> from std_msgs.msg import String
        >>> from coursekit.core.graph import Graph
        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> node = Graph(VirtualClock()).add_node("robot", "/")
        >>> heard, said = node.subscription("/chatter", String, Qos()), node.publisher("/chatter", String, Qos())
        >>> said.publish(String(data="hello"))
        >>> msg, stamp, publisher = heard.take()
        >>> msg.data, publisher is said
        ('hello', True)
        """
        stamp = self.graph.clock.now()
        for target in self.targets:
            kept = msg._clone() if target.reduce is None else target.reduce(msg)
            target.push((kept, stamp, self))
        if self._history is not None:
            self._history.append((msg._clone(), stamp))
        if self.tap is not None:
            self.tap(msg, stamp)
        if self._deadline_timer is not None:
            self._last_sent = self.graph.clock.steady()
        if not self._live or self._lease_timer is not None:
            self._sign_of_life()

    def kept(self) -> list[tuple[Any, int]]:
        """The messages and stamps kept for late joiners: none, unless the publisher is transient local.

        >>> from std_msgs.msg import Int8
        >>> from coursekit.core.graph import Graph
        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> node = Graph(VirtualClock()).add_node("map_server", "/")
        >>> said = node.publisher("/map", Int8, Qos(depth=1, durability=TRANSIENT_LOCAL))
        >>> said.publish(Int8(data=1)); said.publish(Int8(data=2))
        >>> [msg.data for msg, stamp in said.kept()]
        [2]
        >>> late = node.subscription("/map", Int8, Qos(durability=TRANSIENT_LOCAL))
        >>> late.take()[0].data
        2
        """
        return list(self._history or ())

    def replay(self, target: Subscription) -> None:
        """Send the kept messages to a late joiner."""
        for msg, stamp in self.kept():
            kept = msg._clone() if target.reduce is None else target.reduce(msg)
            target.push((kept, stamp, self))

    def assert_liveliness(self) -> None:
        """Assert liveliness without publishing."""
        self._sign_of_life()

    def _sign_of_life(self) -> None:
        steady = self.graph.clock.steady()
        self._last_sign = steady
        if self.qos.lease == INFINITE or self.qos.liveliness == AUTOMATIC:
            return
        if not self._live:
            self._live = True
            for target in self.targets:
                target.status(LIVELINESS).add(1, -1 if target.lost_publisher(self) else 0)
        if self._lease_timer is None:
            self._lease_timer = self.graph.clock.call_at(steady + self.qos.lease, self._check_lease)

    def _check_lease(self) -> None:
        self._lease_timer = None
        if not self.alive:
            return
        due = self._last_sign + self.qos.lease
        if due > self.graph.clock.steady():
            self._lease_timer = self.graph.clock.call_at(due, self._check_lease)
        elif self._live:
            self._live = False
            self.status(LIVELINESS).add()
            for target in self.targets:
                target.lose_publisher(self)

    def is_live(self) -> bool:
        """Whether its lease is still valid."""
        return self._live

    def _watch_deadline(self) -> None:
        steady = self.graph.clock.steady()
        due = self._last_sent + self.qos.deadline
        if self._deadline_timer is not None and due <= steady:
            self.status(DEADLINE).add()
            self._last_sent = steady
        if self.alive:
            due = max(self._last_sent, steady if self._deadline_timer is None else 0) + self.qos.deadline
            self._deadline_timer = self.graph.clock.call_at(due, self._watch_deadline)

    def close(self) -> None:
        """Leave the graph."""
        self.alive = False
        for handle in (self._deadline_timer, self._lease_timer):
            if handle is not None:
                handle.cancel()
        self.graph.remove_publisher(self)


class Subscription(Endpoint):
    """The receiving end: a queue of (message, stamp ns, publisher).

    A reader that needs only a few numbers of each message sets `reduce`: its result is queued instead of a copy.
    """

    __slots__ = ("_deadline_timer", "_last_sign", "_lost", "queue", "reduce")

    def __init__(self, graph: Graph, node: GraphNode, name: str, msg_type: Interface, qos: Qos) -> None:
        super().__init__(graph, node, name, msg_type, qos)
        self.queue: deque[tuple[Any, int, Publisher]] = deque(
            maxlen=None if self.qos.history == KEEP_ALL else self.qos.depth
        )
        self.reduce: Callable[[Any], Any] | None = None
        self._lost: list[Publisher] = []
        self._last_sign = graph.clock.steady()
        self._deadline_timer: Any = None
        if self.qos.deadline != INFINITE:
            due = self._last_sign + self.qos.deadline
            self._deadline_timer = graph.clock.call_at(due, self._check_deadline)

    def has_work(self) -> bool:
        """Whether a message is waiting."""
        return bool(self.queue)

    def push(self, entry: tuple[Any, int, Publisher]) -> None:
        """Queue a message; a full queue drops its oldest."""
        self.queue.append(entry)
        if self._deadline_timer is not None:
            self._last_sign = self.graph.clock.steady()
        if not self.queued:
            self.signal()
        if self.listener is not None:
            self.listener(entry)

    def take(self) -> tuple[Any, int, Publisher] | None:
        """Return the oldest message within its publisher's lifespan, or None.

        >>> from std_msgs.msg import String
        >>> from coursekit.core.graph import Graph
        >>> from coursekit.core.virtual_clock import VirtualClock
        >>> node = Graph(VirtualClock()).add_node("echo", "/")
        >>> heard, said = node.subscription("/a", String, Qos(depth=2)), node.publisher("/a", String, Qos())
        >>> for word in ("one", "two", "three"):  # a queue of two keeps the newest
        ...     said.publish(String(data=word))
        >>> heard.take()[0].data
        'two'
        """
        while True:
            try:
                entry = self.queue.popleft()
            except IndexError:
                return None
            lifespan = entry[2].qos.lifespan
            if lifespan == INFINITE or self.graph.clock.now() - entry[1] <= lifespan:
                return entry

    def meet(self, publisher: Publisher) -> None:
        """Hook: a publisher is about to be matched; none of its messages has been pushed yet."""

    def lose_publisher(self, publisher: Publisher) -> None:
        """Note that the lease of a matched publisher has expired."""
        self._lost.append(publisher)
        self.status(LIVELINESS).add(-1, 1)

    def lost_publisher(self, publisher: Publisher) -> bool:
        """Forget that `publisher` was lost; return whether it was."""
        if publisher in self._lost:
            self._lost.remove(publisher)
            return True
        return False

    def _check_deadline(self) -> None:
        if not self.alive:
            return
        steady = self.graph.clock.steady()
        if self._last_sign + self.qos.deadline <= steady:
            self.status(DEADLINE).add()
            self._last_sign = steady
        self._deadline_timer = self.graph.clock.call_at(self._last_sign + self.qos.deadline, self._check_deadline)

    def close(self) -> None:
        """Leave the graph."""
        self.alive = False
        if self._deadline_timer is not None:
            self._deadline_timer.cancel()
        self.graph.remove_subscription(self)


def match(publisher: Publisher, subscription: Subscription) -> bool:
    """Connect the two if they are compatible; count the mismatch on both sides if their QoS is not."""
    if publisher.type_name != subscription.type_name:
        return False
    if publisher.node is subscription.node and publisher.node.deaf_to_itself:
        return False
    policy = publisher.qos.incompatible_with(subscription.qos)
    if policy is not None:
        publisher.status(INCOMPATIBLE).add(policy=policy)
        subscription.status(INCOMPATIBLE).add(policy=policy)
        return False
    subscription.meet(publisher)
    publisher.targets = (*publisher.targets, subscription)
    publisher.status(MATCHED).add()
    subscription.status(MATCHED).add()
    if publisher.is_live():
        subscription.status(LIVELINESS).add()
    if subscription.qos.durability == TRANSIENT_LOCAL:
        publisher.replay(subscription)
    return True
