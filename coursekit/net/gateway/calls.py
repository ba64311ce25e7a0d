"""Services in both directions."""

from __future__ import annotations

import itertools
import os
import time
from typing import TYPE_CHECKING, Any

from rclpy.serialization import deserialize_message, serialize_message
from rclpy.task import Future
from zenoh import ConsolidationMode, Locality, QueryTarget

from ..wire.attachment import Attachment, read_attachment
from ..wire.names import ANY_HASH

if TYPE_CHECKING:
    from rclpy.node import Node

PATIENCE_SECONDS = 86400.0
"""Timeout for a response [s]."""


class Offered:
    """A ROS server that is offered to peers."""

    def __init__(self, gateway: Any, name: str, type_name: str, kind: Any) -> None:
        self._gateway, self._name, self._kind = gateway, name, kind
        self._client = gateway.node.create_client(kind, name, callback_group=gateway.group)
        key = gateway.key(name, type_name, ANY_HASH)
        self._queryable = gateway.session.declare_queryable(key, self._hear, complete=True, allowed_origin=Locality.REMOTE)

    def close(self) -> None:
        """Stop answering."""
        self._queryable.undeclare()
        self._gateway.node.destroy_client(self._client)

    def _hear(self, query: Any) -> None:
        try:
            came_with = read_attachment(query.attachment.to_bytes())
            request = deserialize_message(query.payload.to_bytes(), self._kind.Request)
            future = self._client.call_async(request)
        except Exception as error:  # bytes from a peer, or a server that leaves at this moment
            self._gateway.tell(f"A request to {self._name} was not passed on: {error}")
            return

        def answer(done: Any) -> None:
            attachment = Attachment(came_with.number, time.time_ns(), came_with.gid).data()
            with query:
                query.reply(query.key_expr, serialize_message(done.result()), attachment=attachment)

        future.add_done_callback(answer)


class Passed:
    """A remote server, offered as a ROS service at a node here."""

    def __init__(self, gateway: Any, node: Node, name: str, type_name: str, type_hash: str, kind: Any, profile: Any) -> None:
        self._gateway, self._node, self._kind = gateway, node, kind
        self._numbers = itertools.count(1)
        self._gid = os.urandom(16)
        self._querier = gateway.session.declare_querier(
            gateway.key(name, type_name, type_hash),
            target=QueryTarget.ALL_COMPLETE,
            consolidation=ConsolidationMode.NONE,
            timeout=PATIENCE_SECONDS,
            allowed_destination=Locality.REMOTE,
        )
        self._service = node.create_service(kind, name, self._ask, callback_group=gateway.group, qos_profile=profile)

    def close(self) -> None:
        """Stop passing requests on."""
        self._querier.undeclare()
        self._node.destroy_service(self._service)

    async def _ask(self, request: Any, _response: Any) -> Any:
        future: Any = Future(executor=self._gateway.executor)

        def hear(reply: Any) -> None:
            if reply.ok is not None and not future.done():
                future.set_result(deserialize_message(reply.ok.payload.to_bytes(), self._kind.Response))

        attachment = Attachment(next(self._numbers), time.time_ns(), self._gid).data()
        self._querier.get(hear, payload=serialize_message(request), attachment=attachment)
        return await future
