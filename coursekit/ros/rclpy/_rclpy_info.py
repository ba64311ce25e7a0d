"""The metadata of a message, request or response: its bytes, timestamps and numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from coursekit.processes.session import current


@dataclass
class RequestInfo:
    """The number of a request."""

    sequence_number: int


@dataclass
class ServiceInfo:
    """The information about a request or response."""

    request_id: Any
    source_timestamp: int
    received_timestamp: int


def service_info(request_id: Any) -> ServiceInfo:
    """The header of a request or response taken now: both timestamps are the current time."""
    now = current().clock.now()
    return ServiceInfo(request_id, now, now)


def as_bytes(msg: Any) -> bytes:
    """The message as ROS would send it."""
    from coursekit.interfaces import cdr

    return cdr.serialize(msg)


def message_info(entry: tuple[Any, int, Any]) -> dict[str, Any]:
    """The second argument of a subscription's callback."""
    _, stamp, publisher = entry
    return {"source_timestamp": stamp, "received_timestamp": stamp, "publisher_gid": publisher.gid}
