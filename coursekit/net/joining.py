"""Joining and leaving: `join` asks before a robot could move, and this side is invisible on the network until then."""

from __future__ import annotations

import functools
import os
import sys
import threading
from collections.abc import Callable
from weakref import WeakKeyDictionary

from coursekit.processes.current_process import outside
from coursekit.processes.session import NETWORK_VARIABLE, Session

from .address import read_address
from .errors import NoNetwork
from .link import Link
from .link_context import LinkContext
from .motion_check import would_move
from .zenoh_session import Credentials, open_client

_links: WeakKeyDictionary[Session, dict[int, Link]] = WeakKeyDictionary()
_tried: WeakKeyDictionary[Session, set[int]] = WeakKeyDictionary()
_lock = threading.RLock()

Confirm = Callable[[list[str]], bool]
"""Receives one sentence for each robot that would move, and returns whether to join anyway."""


def join(
    session: Session,
    domain_id: int,
    address: str,
    *,
    credentials: Credentials = Credentials(),
    listen_only: bool = False,
    confirm: Confirm = lambda _moves: False,
) -> Link:
    """Join a session's graph of a domain to the network at an address; an existing link is left first.

    With `listen_only` nothing is sent but subscriptions.

    Raises:
        NoNetwork: when joining failed; the message gives the reason.
    """
    if session.clock.virtual:
        raise NoNetwork("A session on the virtual clock runs faster than others and joins no network: use the wall clock.")
    where = read_address(address)
    leave(session, domain_id)
    engine = open_client(where, credentials)
    link = Link(LinkContext(session.graph(domain_id), domain_id, engine, where, tell), listen_only=listen_only)
    try:
        moves = [] if listen_only else would_move(link.place.graph, link.tokens())
        if moves and not confirm(moves):
            raise NoNetwork("Not joined: " + "; ".join(moves) + ". Listen without sending: %network ADDRESS --listen-only")
    except BaseException:
        link.close()
        raise
    with _lock:
        if session not in _links:
            _links[session] = {}
            session.on_close.append(functools.partial(leave, session))
        _links[session][domain_id] = link
    link.begin()
    return link


def leave(session: Session, domain_id: int | None = None) -> bool:
    """Leave the network of a domain, or all of them; return whether there was one."""
    with _lock:
        links = _links.get(session, {})
        joined = [links.pop(domain) for domain in ([domain_id] if domain_id is not None else list(links)) if domain in links]
    for link in joined:
        link.close()
    return bool(joined)


def link_of(session: Session, domain_id: int) -> Link | None:
    """Return the link of a domain, or None if it is not joined."""
    return _links.get(session, {}).get(domain_id)


def credentials_from_the_environment() -> Credentials:
    """Read COURSEKIT_NETWORK_USER, COURSEKIT_NETWORK_PASSWORD and COURSEKIT_NETWORK_CERTIFICATE."""
    values = (os.environ.get(f"{NETWORK_VARIABLE}_{name}", "") for name in ("USER", "PASSWORD", "CERTIFICATE"))
    return Credentials(*values)


def join_as_the_environment_says(session: Session, domain_id: int) -> bool:
    """Join the network named by COURSEKIT_NETWORK, once; return whether it is joined.

    A failure is reported, and the program continues without a network. Tests never join: they must not reach a robot.
    """
    with _lock:
        tried = _tried.setdefault(session, set())
        if domain_id in tried or "pytest" in sys.modules:
            return link_of(session, domain_id) is not None
        tried.add(domain_id)
    address, *words = os.environ[NETWORK_VARIABLE].split()
    asked, listen_only = credentials_from_the_environment(), "--listen-only" in words
    # Not in the program that happens to be first: it would not end before the network's threads.
    begin = functools.partial(join, session, domain_id, address, credentials=asked, listen_only=listen_only)
    try:
        outside(begin)
    except NoNetwork as error:
        tell(str(error))
    return link_of(session, domain_id) is not None


def tell(sentence: str) -> None:
    """Print a message to the user, from any thread."""
    print(f"[network] {sentence}", file=sys.stderr, flush=True)
