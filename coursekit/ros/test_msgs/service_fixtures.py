"""Requests with their responses for tests: for each type, several pairs that differ."""

from __future__ import annotations

from typing import Any

from . import srv as types
from .message_fixtures import get_msg_arrays as _arrays
from .message_fixtures import get_msg_basic_types as _basic_types


def get_msg_empty() -> list[list[Any]]:
    """A pair without fields."""
    return [[types.Empty.Request(), types.Empty.Response()]]


def get_msg_basic_types() -> list[list[Any]]:
    """Numbers from zero to the largest, and texts, of which one is long."""
    texts = ("request", "0123456789" * 2000, "", "request 3")
    pairs = [_pair(types.BasicTypes, message) for message in _basic_types()]
    for (request, response), text in zip(pairs, texts, strict=True):
        request.string_value, response.string_value = text, text.replace("request", "reply")
    return pairs


def get_msg_arrays() -> list[list[Any]]:
    """Arrays."""
    return [_pair(types.Arrays, message) for message in _arrays()]


def _pair(kind: Any, message: Any) -> list[Any]:
    """A request and a response with those fields of a message that they have."""
    pair = [kind.Request(), kind.Response()]
    for part in pair:
        for name in part.get_fields_and_field_types():
            if hasattr(message, name):
                setattr(part, name, getattr(message, name))
    return pair


def get_test_srv(service_name: str) -> list[list[Any]]:
    """The pairs of the type with that name; raises NotImplementedError for an unknown name.

    >>> [request, response] = get_test_srv("Empty")[0]
    >>> response
    test_msgs.srv.Empty_Response()
    """
    makers = {"Empty": get_msg_empty, "BasicTypes": get_msg_basic_types, "Arrays": get_msg_arrays}
    if service_name not in makers:
        raise NotImplementedError(f"There are no test requests '{service_name}' (known: {', '.join(sorted(makers))})")
    return makers[service_name]()
