"""A graph as text, and the details of one node or topic."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from coursekit.words.counting import counted
from coursekit.words.gettext import gettext

from .graph_facts import End, Facts, nodes_at, types_of
from .graph_faults import Fault


def described(facts: Facts, faults: Sequence[Fault], *, services: bool, actions: bool, dead_ends: bool) -> str:
    """Return the graph, a line for each topic; sorted and deterministic.

    `dead_ends` includes topics with only publishers or only subscribers, and marks them.
    """
    counts = [counted(len(facts.nodes), "node"), counted(len(facts.topics), "topic")]
    lines = [f"graph: {', '.join(counts)}", f"nodes: {', '.join(_marked(facts)) or '(none)'}"]
    for name in facts.topics:
        if dead_ends or (nodes_at(name, facts.publishers) and nodes_at(name, facts.subscriptions)):
            lines.append(_line("topic", name, facts.publishers, facts.subscriptions))
    if services:
        lines += [_line("service", name, facts.clients, facts.servers) for name in facts.services]
    if actions:
        lines += [_line("action", name, facts.action_clients, facts.action_servers) for name in facts.actions]
    for fault in faults:
        if fault.serious:
            lines += [f"! {gettext(fault.text)}", f"  {gettext('cure')}: {gettext(fault.cure)}"]
    return "\n".join(lines)


def _marked(facts: Facts) -> Iterable[str]:
    """Return the nodes; those from the network are marked."""
    return (f"{name} (network)" if name in facts.remote else name for name in facts.nodes)


def _line(kind: str, name: str, sources: Sequence[End], targets: Sequence[End]) -> str:
    types = ", ".join(types_of(name, sources, targets))
    nobody = "(nobody)"
    left, right = (", ".join(nodes_at(name, ends)) or nobody for ends in (sources, targets))
    return f"{kind} {name} [{types}]: {left} -> {right}"


# -- details


def details(graph: Any, name: str) -> str:
    """Return the output of `ros2 node info` or `ros2 topic info -v` for the node, topic, service or action of that name."""
    node = next((node for node in list(graph.nodes) if node.full_name == name), None)
    if node is not None:
        return _of_node(node)
    publishers, subscriptions = graph.publishers.get(name, ()), graph.subscriptions.get(name, ())
    if publishers or subscriptions:
        return _of_topic(name, list(publishers), list(subscriptions))
    service = name if name in graph.servers or name in graph.clients else f"{name}/_action/send_goal"
    return _of_service(name, list(graph.servers.get(service, ())), list(graph.clients.get(service, ())))


def _of_node(node: Any) -> str:
    lines = [node.full_name]
    for title, endpoints in (
        ("Subscribers", node.subscriptions),
        ("Publishers", node.publishers),
        ("Service Servers", node.servers),
        ("Service Clients", node.clients),
    ):
        lines.append(f"  {title}:")
        lines += sorted(
            {f"    {endpoint.name}: {endpoint.type_name}" for endpoint in list(endpoints) if "/_" not in endpoint.name}
        )
    if node.remote:
        lines.append(f"  Runs elsewhere; heard at {node.remote}")
    if node.process is not None:
        lines.append(f"  Process: {node.process.pid} {' '.join(node.process.argv)}")
    return "\n".join(lines)


def _of_topic(name: str, publishers: list[Any], subscriptions: list[Any]) -> str:
    types = sorted({end.type_name for end in (*publishers, *subscriptions)})
    lines = [name, f"Type: {', '.join(types)}"]
    for title, ends in (("Publisher", publishers), ("Subscription", subscriptions)):
        lines.append(f"{title} count: {len(ends)}")
        for end in ends:
            lines += [f"  {end.node.full_name}", *_qos_lines(end.qos)]
    return "\n".join(lines)


def _qos_lines(qos: Any) -> Iterable[str]:
    from rclpy._node_graph import profile_of

    profile = profile_of(qos)
    depth = f" ({profile.depth})" if profile.history.name == "KEEP_LAST" else ""
    yield f"    Reliability: {profile.reliability.name}"
    yield f"    Durability: {profile.durability.name}"
    yield f"    History (Depth): {profile.history.name}{depth}"
    for word, duration in (
        ("Lifespan", profile.lifespan),
        ("Deadline", profile.deadline),
        ("Liveliness lease", profile.liveliness_lease_duration),
    ):
        if duration.nanoseconds < 9223372036854775807:
            yield f"    {word}: {duration.nanoseconds * 1e-9:g} s"


def _of_service(name: str, servers: list[Any], clients: list[Any]) -> str:
    if not servers and not clients:
        return f"{name}: not in the graph any more"
    types = sorted({end.type_name.removesuffix("_SendGoal") for end in (*servers, *clients)})
    lines = [name, f"Type: {', '.join(types)}"]
    for title, ends in (("Servers", servers), ("Clients", clients)):
        lines.append(f"{title}: {', '.join(sorted({end.node.full_name for end in ends})) or '(none)'}")
    return "\n".join(lines)
