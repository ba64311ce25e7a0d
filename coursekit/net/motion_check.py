"""The local nodes that would move the peers' robots: they are reported to the user before a network is joined."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from coursekit.core.graph import Graph

from .wire.moving import MOVING
from .wire.token import SERVER, SUBSCRIPTION, Token

_GOAL = "/_action/send_goal"


def would_move(graph: Graph, tokens: Iterable[Token]) -> list[str]:
    """Return a sentence for each local node that would move a robot of the peers that announce these tokens."""
    sentences: dict[str, None] = {}
    for token in tokens:
        if token.kind == SUBSCRIPTION and token.type_name in MOVING:
            ends: list[Any] = list(graph.publishers.get(token.name, ()))
            said = f"{{}} publishes {token.name}, {token.full_node_name} listens"
        elif token.kind == SERVER and token.name.endswith(_GOAL):
            ends = list(graph.clients.get(token.name, ()))
            said = f"{{}} sends goals to {token.name.removesuffix(_GOAL)}, {token.full_node_name} carries them out"
        else:
            continue
        for end in ends:
            if end.type_name == token.type_name and not end.node.remote:
                sentences[said.format(end.node.full_name)] = None
    return list(sentences)
