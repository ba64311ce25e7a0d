"""The context of a link: its graph, domain, Zenoh session and address, and its reports to the user."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from coursekit.core.graph import Graph

from .wire.names import ANY_HASH, data_key


@dataclass(frozen=True)
class LinkContext:
    """The context shared by all parts of a link; `tell` reports a sentence to the user."""

    graph: Graph
    domain_id: int
    session: Any
    address: str
    tell: Callable[[str], None]

    @property
    def id(self) -> str:
        """The id by which peers distinguish this session's tokens from their own."""
        return str(self.session.info.zid())

    def key(self, name: str, type_name: str, type_hash: str = ANY_HASH) -> str:
        """The key of a topic or service."""
        return data_key(self.domain_id, name, type_name, type_hash)
