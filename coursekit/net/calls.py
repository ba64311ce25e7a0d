"""Services across the network: `Answers` for a local server, `Questions` for remote servers."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from coursekit.core.service import RequestId, Server
from coursekit.interfaces import cdr

from .receiving import attachment_of
from .remote import RemoteServer
from .wire.attachment import Attachment

PATIENCE_SECONDS = 86400.0
"""Timeout for a response: a day, since DDS has no limit; the wait also ends when the server leaves [s]."""


class Asker:
    """A proxy for a remote client during one request: the local server responds to it."""

    sink = None
    yields = False

    def __init__(self, query: Any, came_with: Attachment) -> None:
        self._query = query
        self._came_with = came_with

    def push(self, number: int, response: Any) -> None:
        """Send the response; harmless when the client no longer waits for it."""
        attachment = Attachment(number, time.time_ns(), self._came_with.gid).data()
        with self._query as query:
            query.reply(query.key_expr, cdr.serialize(response), attachment=attachment)


class Answers:
    """Passes requests that arrive on a key to a local server."""

    def __init__(self, zenoh_session: Any, server: Server, key: str, tell: Callable[[str], None]) -> None:
        from zenoh import Locality

        self._server = server
        self._tell = tell
        self._queryable = zenoh_session.declare_queryable(key, self._hear, complete=True, allowed_origin=Locality.REMOTE)

    def close(self) -> None:
        """Stop answering."""
        self._queryable.undeclare()

    def _hear(self, query: Any) -> None:
        came_with = attachment_of(query)
        if came_with is None or query.payload is None:
            return
        try:
            request = cdr.deserialize(query.payload.to_bytes(), self._server.msg_type.Request)
        except Exception as error:  # bytes from a peer
            self._tell(f"A request to {self._server.name} cannot be read ({error}): the definition differs there.")
            return
        asker: Any = Asker(query, came_with)
        self._server.push(request, RequestId(asker, came_with.number))


class Questions:
    """Sends requests to remote servers; the first response counts, as everywhere in ROS."""

    def __init__(self, zenoh_session: Any, key: str, gid: bytes) -> None:
        from zenoh import ConsolidationMode, Locality, QueryTarget

        self._gid = gid
        self._querier = zenoh_session.declare_querier(
            key,
            target=QueryTarget.ALL_COMPLETE,
            consolidation=ConsolidationMode.NONE,
            timeout=PATIENCE_SECONDS,
            allowed_destination=Locality.REMOTE,
        )

    def ask(self, _server: RemoteServer, data: bytes, request_id: RequestId) -> None:
        """Send the bytes of a request; the response goes to the client of the request."""
        client, number = request_id.client, request_id.sequence_number

        def hear(reply: Any) -> None:
            if reply.ok is not None:
                client.push(number, cdr.deserialize(reply.ok.payload.to_bytes(), client.msg_type.Response))

        gid = bytes(ours ^ its for ours, its in zip(self._gid, client.gid, strict=False))  # each client has its own gid
        self._querier.get(hear, payload=data, attachment=Attachment(number, time.time_ns(), gid).data())

    def close(self) -> None:
        """Stop sending requests."""
        self._querier.undeclare()
