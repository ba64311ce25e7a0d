"""The faults of a graph, each with a sentence for the fault and one for the remedy."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from coursekit.core.qos import (
    BEST_EFFORT,
    INFINITE,
    MANUAL_BY_TOPIC,
    RELIABLE,
    TRANSIENT_LOCAL,
    VOLATILE,
    Qos,
)
from coursekit.suggestions import hint, similar

from .graph_facts import End, Facts, names_of, nodes_at, types_of

ALIKE = 0.75
"""The similarity (difflib's ratio) from which a name counts as a typo of another."""


@dataclass(frozen=True)
class Fault:
    """A fault; a serious one is drawn in red, others are remarks. `places` are its names in the picture."""

    text: str
    cure: str
    places: tuple[str, ...]
    serious: bool = True
    ends: tuple[tuple[str, str], ...] = ()
    """(node, topic) pairs whose connection does not work."""


def find(facts: Facts) -> list[Fault]:
    """Return all faults of the graph, serious ones first, otherwise in a fixed order."""
    faults = [
        *_duplicates(facts),
        *_types(facts),
        *_qos(facts),
        *_topics(facts),
        *_calls("service", facts.servers, facts.clients),
        *_calls("action", facts.action_servers, facts.action_clients),
    ]
    return sorted(faults, key=lambda fault: not fault.serious)


def _duplicates(facts: Facts) -> Iterator[Fault]:
    for name, count in facts.duplicates:
        yield Fault(
            f"{count} nodes are called {name}",
            f"Give each its own name: --ros-args -r __node:={name.rpartition('/')[2]}_2, or put them into namespaces.",
            (name,),
        )


def _types(facts: Facts) -> Iterator[Fault]:
    for name in facts.topics:
        ends = [end for end in (*facts.publishers, *facts.subscriptions) if end.name == name]
        types = types_of(name, ends)
        if len(types) > 1:
            said = "; ".join(f"{kind} at {_listed(e.node for e in ends if e.type == kind)}" for kind in types)
            yield Fault(
                f"{name} is used with {len(types)} types: {said}",
                "Messages pass only between equal types: use one type, or another topic name.",
                (name,),
                ends=tuple((end.node, name) for end in ends),
            )


def _listed(names: object) -> str:
    return ", ".join(sorted(set(names)))  # type: ignore[call-overload]


# -- quality of service


def _qos(facts: Facts) -> Iterator[Fault]:
    for pub in facts.publishers:
        for sub in facts.subscriptions:
            if (pub.name, pub.type) == (sub.name, sub.type):
                for policy, offer, wish, cure in mismatches(pub, sub):
                    yield Fault(
                        f"{pub.name}: {policy} does not match: {pub.node} offers {offer}, {sub.node} requests {wish}",
                        cure,
                        (pub.name,),
                        ends=((pub.node, pub.name), (sub.node, sub.name)),
                    )


def mismatches(pub: End, sub: End) -> list[tuple[str, str, str, str]]:
    """Return (policy, offered value, requested value, remedy) for each policy that does not match."""
    offer, wish = pub.qos.resolved(), sub.qos.resolved()
    differences = []
    if offer.reliability == BEST_EFFORT and wish.reliability == RELIABLE:
        cure = f"Let {sub.node} ask for BEST_EFFORT (qos_profile_sensor_data), or let {pub.node} offer RELIABLE."
        differences.append(("reliability", "BEST_EFFORT", "RELIABLE", cure))
    if offer.durability == VOLATILE and wish.durability == TRANSIENT_LOCAL:
        cure = f"Let {pub.node} offer TRANSIENT_LOCAL, or let {sub.node} ask for VOLATILE and miss earlier messages."
        differences.append(("durability", "VOLATILE", "TRANSIENT_LOCAL", cure))
    return [*differences, *_timing(pub.node, sub.node, offer, wish)]


def _timing(pub: str, sub: str, offer: Qos, wish: Qos) -> Iterator[tuple[str, str, str, str]]:
    if offer.deadline > wish.deadline:
        cure = f"Let {pub} promise a deadline of {_seconds(wish.deadline)} or less, or let {sub} ask for a longer one."
        yield "deadline", _seconds(offer.deadline), _seconds(wish.deadline), cure
    if offer.liveliness < wish.liveliness:
        cure = f"Let {pub} offer MANUAL_BY_TOPIC, or let {sub} ask for AUTOMATIC."
        yield "liveliness", _liveliness(offer), _liveliness(wish), cure
    if offer.lease > wish.lease:
        cure = f"Let {pub} offer a lease of {_seconds(wish.lease)} or less, or let {sub} ask for a longer one."
        yield "lease duration", _seconds(offer.lease), _seconds(wish.lease), cure


def _liveliness(qos: Qos) -> str:
    return "MANUAL_BY_TOPIC" if qos.liveliness == MANUAL_BY_TOPIC else "AUTOMATIC"


def _seconds(nanoseconds: int) -> str:
    return "none" if nanoseconds == INFINITE else f"{nanoseconds * 1e-9:g} s"


# -- ends without a counterpart


def _topics(facts: Facts) -> Iterator[Fault]:
    heard = names_of(facts.subscriptions)
    published = names_of(facts.publishers)
    gone = dict(facts.gone)
    for name in facts.topics:
        if name in gone and name not in published:
            yield _gone(name, gone[name], facts)
        elif name not in published:
            yield _lonely(name, published, facts, heard=True)
        elif name not in heard:
            other = _alike(name, facts.publishers, facts.subscriptions)
            if other is None or other in published:  # otherwise the other name reports it
                yield _lonely(name, heard, facts, heard=False)


def _gone(name: str, publisher: str, facts: Facts) -> Fault:
    nodes = nodes_at(name, facts.subscriptions)
    waiting = f"{_listed(nodes)} waits for it." if len(nodes) == 1 else f"{_listed(nodes)} wait for it."
    return Fault(
        f"{publisher} is gone: no node publishes {name} any more",
        f"Start {publisher} again, and read the last lines of its terminal; {waiting}",
        (name,),
        ends=tuple((node, name) for node in nodes),
    )


def _lonely(name: str, others: Sequence[str], facts: Facts, *, heard: bool) -> Fault:
    mine, theirs = (facts.subscriptions, facts.publishers) if heard else (facts.publishers, facts.subscriptions)
    nodes, other = nodes_at(name, mine), _alike(name, mine, theirs)
    said = f"no node publishes {name}" if heard else f"no node subscribes to {name}"
    if other is None or other not in others:
        there = f"{_listed(nodes)} listens to it." if heard else f"{_listed(nodes)} publishes it."
        return Fault(said, there, (name,), serious=False)
    there = _listed(nodes_at(other, theirs))
    cure = f"Remap it ({nodes[0]} with --ros-args -r {name}:={other}) or change the name; {other} is used by {there}."
    return Fault(f"{said}; did you mean {other}?", cure, (name,), ends=tuple((node, name) for node in nodes))


def _alike(name: str, mine: Sequence[End], theirs: Sequence[End]) -> str | None:
    """Find the probably intended topic of this type: a similar name, or the same last part and no such end."""
    types = types_of(name, mine)
    candidates = [
        other for other in names_of(end for end in theirs if end.type in types) if _letters(other) != _letters(name)
    ]
    last, served = name.rpartition("/")[2], names_of(mine)
    close = similar(name, candidates, 1, ALIKE)
    namesakes = [candidate for candidate in candidates if candidate.rpartition("/")[2] == last and candidate not in served]
    return next(iter(close or namesakes), None)


def _letters(name: str) -> str:
    """Return a name without digits: /turtle1 is no typo of /turtle2."""
    return "".join(letter for letter in name if not letter.isdigit())


def _calls(kind: str, servers: Sequence[End], clients: Sequence[End]) -> Iterator[Fault]:
    served = names_of(servers)
    for name in names_of(clients):
        nodes = nodes_at(name, clients)
        ends = tuple((node, name) for node in nodes)
        offered, wanted = types_of(name, servers), types_of(name, clients)
        if name not in served:
            there = ", ".join(served) or f"no {kind}"
            cure = f"Start the node that serves it; {_listed(nodes)} waits. Served: {there}."
            yield Fault(f"no node serves the {kind} {name}{hint(name, served, cutoff=ALIKE)}", cure, (name,), ends=ends)
        elif offered != wanted:
            cure = f"Use one type: served is {', '.join(offered)}, called {', '.join(wanted)}."
            yield Fault(f"{kind} {name} is used with two types", cure, (name,), ends=ends)
