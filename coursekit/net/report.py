"""The lines of `%network`: the peers, the carried topics, and their rates and delays."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from coursekit.core.topic import Publisher
from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.registry import load
from coursekit.words.counting import counted

from .link import Link
from .traffic import Traffic

NOT_JOINED = "No network: messages stay in this notebook. Join one: %network ADDRESS (for example %network tcp/robot:7447)."


@dataclass(frozen=True)
class Report:
    """The state of a link."""

    address: str
    domain_id: int
    is_up: bool
    listen_only: bool
    others: dict[str, list[str]]
    """The names of nodes, by session."""
    heard: list[list[str]]
    """A row for each publisher: topic, rate, count, delay, node, type."""
    sent: list[list[str]]
    notes: list[str]
    """Problems, each with its remedy."""

    def head(self) -> str:
        """Return the state in one line."""
        state = "joined" if self.is_up else "THE LINK IS GONE; it is tried again until %network off"
        return f"Network {self.address}, domain {self.domain_id}: {state}{', you only listen' if self.listen_only else ''}"

    def lines(self) -> Iterator[str]:
        """Yield the whole report."""
        yield self.head()
        yield f"Others: {len(self.others) or 'nobody yet'}"
        yield from (f"  {name}  {', '.join(nodes) or '(no nodes)'}" for name, nodes in self.others.items())
        for title, rows in (("Heard", self.heard), ("Sent", self.sent)):
            if rows:
                yield f"{title}:"
                yield from (f"  {line}" for line in _aligned(rows))
        yield from self.notes


def report(link: Link | None) -> str:
    """Return the state of a link as text."""
    if link is None or link.closed:
        return NOT_JOINED
    return "\n".join(report_of(link).lines())


def report_of(link: Link) -> Report:
    """Return the state of a link."""
    now = link.place.graph.clock.now()
    heard = [
        _row(publisher, publisher.traffic, now, with_delay=True)
        for publisher in link.visitors.publishers
        if publisher.traffic.total
    ]
    sent = [
        _row(sender.publisher, sender.traffic, now, with_delay=False)
        for sender in link.announcer.senders
        if sender.traffic.total
    ]
    sessions = {name[:8]: tokens for name, tokens in sorted(link.visitors.sessions.items()) if tokens}
    return Report(
        link.place.address,
        link.place.domain_id,
        link.is_up,
        link.listen_only,
        {name: sorted({token.full_node_name for token in tokens if not token.node_name.startswith("_")})
         for name, tokens in sessions.items()},
        sorted(heard),
        sorted(sent),
        [*_unknown(link), *_same_names(link)],
    )  # fmt: skip


def _row(end: Publisher, traffic: Traffic, now: int, *, with_delay: bool) -> list[str]:
    """Return topic, rate, count, delay, node, type: long parts come last, where lines wrap."""
    delay = traffic.delay(now) if with_delay else None
    many = counted(traffic.total, "message")
    late = f"{1e3 * delay:.1f} ms on the way" if delay is not None else ""
    return [end.name, f"{traffic.rate(now):.1f} a second", many, late, f"from {end.node.full_name}", end.type_name]


def _aligned(rows: list[list[str]]) -> Iterator[str]:
    """Align the columns of the rows; a column that is empty in all rows takes no space.

    >>> list(_aligned([["/scan", "5"], ["/tf", "20"]]))
    ['/scan  5', '/tf    20']
    """
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        yield "  ".join(part.ljust(width) for part, width in zip(row, widths, strict=True) if width).rstrip()


def _unknown(link: Link) -> Iterator[str]:
    """Yield the types that are unknown here, with the remedy."""
    tokens = [token for group in list(link.visitors.sessions.values()) for token in list(group) if token.type_name]
    for type_name in sorted({token.type_name for token in tokens}):
        if not is_known(type_name):
            names = ", ".join(sorted({token.name for token in tokens if token.type_name == type_name}))
            package = type_name.split("/")[0]
            yield f"Unknown here: {type_name} ({names})"
            build = f"%colcon build --packages-select {package}"
            yield f"  Copy the package {package} from the robot into ros2_ws/src, then: {build}"


def is_known(type_name: str) -> bool:
    """Whether this side has the definition of a type, including a part of an action.

    >>> is_known("std_msgs/msg/String"), is_known("robot_msgs/msg/Gripper")
    (True, False)
    """
    try:
        load(type_name)
    except (InterfaceError, LookupError, OSError):
        return False
    return True


def _same_names(link: Link) -> Iterator[str]:
    for name in link.visitors.same_names:
        yield f"Two nodes are called {name}: rename one, or take a ROS_DOMAIN_ID of your own."



__all__ = ["NOT_JOINED", "Report", "is_known", "report", "report_of"]
