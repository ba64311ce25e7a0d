"""Types of attributes of XML and YAML elements."""

from __future__ import annotations

from typing import Any, get_args, get_origin

from ..utilities.type_utils import coerce_to_type, extract_type, get_typed_value
from .entity import Entity

__all__ = ["check_is_list_entity", "coerce_to_type", "extract_type", "get_typed_value"]


def check_is_list_entity(data_type: Any) -> bool:
    """Return whether `data_type` is a list of elements.

    >>> check_is_list_entity(list[Entity]), check_is_list_entity(str)
    (True, False)
    """
    if get_origin(data_type) is not list:
        return False
    item = get_args(data_type)[0]
    return isinstance(item, type) and issubclass(item, Entity)
