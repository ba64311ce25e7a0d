"""Who is there, what is carried, how often and how long it takes: the lines of `%network`."""

from __future__ import annotations

from collections.abc import Iterator

from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.registry import load

from .link import Link
from .traffic import Traffic

NOT_JOINED = "No network: messages stay in this notebook. Join one: %network ADDRESS (for example %network tcp/robot:7447)."


def report(link: Link | None) -> str:
    """What a link is and does, in lines."""
    if link is None or link.closed:
        return NOT_JOINED
    return "\n".join([_head(link), *_others(link), *_carried(link), *_unknown(link), *_same_names(link)])


def _head(link: Link) -> str:
    state = "joined" if link.is_up else "THE LINK IS GONE; it is tried again until %network off"
    only = ", you only listen" if link.listen_only else ""
    return f"Network {link.place.address}, domain {link.place.domain_id}: {state}{only}"


def _others(link: Link) -> Iterator[str]:
    sessions = {name: tokens for name, tokens in sorted(link.visitors.sessions.items()) if tokens}
    yield f"Others: {len(sessions) or 'nobody yet'}"
    for name, tokens in sessions.items():
        nodes = sorted({token.full_node_name for token in tokens if not token.node_name.startswith("_")})
        yield f"  {name[:8]}  {', '.join(nodes) or '(no nodes)'}"


def _carried(link: Link) -> Iterator[str]:
    now = link.place.graph.clock.now()
    heard = [(one.name, one.type_name, one.traffic) for one in link.visitors.publishers if one.traffic.total]
    senders = [(one.publisher, one.traffic) for one in link.announcer.senders if one.traffic.total]
    sent = [(one.name, one.type_name, traffic) for one, traffic in senders]
    for title, group in (("Heard", heard), ("Sent", sent)):
        if group:
            yield f"{title}:"
        for name, type_name, traffic in sorted(group, key=lambda one: one[0]):
            yield f"  {name}  {type_name}  {_figures(traffic, now, title == 'Heard')}"


def _figures(traffic: Traffic, now: int, with_delay: bool) -> str:
    delay = traffic.delay(now) if with_delay else None
    late = f", {1e3 * delay:.1f} ms on the way" if delay is not None else ""
    return f"{traffic.total} messages, {traffic.rate(now):.1f} a second{late}"


def _unknown(link: Link) -> Iterator[str]:
    """Types that nobody here has, and the cure."""
    tokens = [token for group in list(link.visitors.sessions.values()) for token in list(group) if token.type_name]
    for type_name in sorted({token.type_name for token in tokens}):
        if not is_known(type_name):
            names = ", ".join(sorted({token.name for token in tokens if token.type_name == type_name}))
            package = type_name.split("/")[0]
            yield f"Unknown here: {type_name} ({names})"
            build = f"%colcon build --packages-select {package}"
            yield f"  Copy the package {package} from the robot into ros2_ws/src, then: {build}"


def is_known(type_name: str) -> bool:
    """Whether this side has the definition of a type, also of a part of an action."""
    try:
        load(type_name)
    except (InterfaceError, LookupError, OSError):
        return False
    return True


def _same_names(link: Link) -> Iterator[str]:
    for name in link.visitors.same_names:
        yield f"Two nodes are called {name}: rename one, or take a ROS_DOMAIN_ID of your own."



__all__ = ["is_known", "report"]
