"""Visiting entities."""

from __future__ import annotations

import asyncio
from collections.abc import Iterator
from typing import TYPE_CHECKING

from ..launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


def visit_entities(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> Iterator[tuple[LaunchDescriptionEntity, asyncio.Future[None]]]:
    """Visit `entity` and all its sub-entities, depth first; yield ongoing work as it begins."""
    sub_entities = entity.visit(context) or []
    future = entity.get_asyncio_future()
    if future is not None:
        yield entity, future
    for sub_entity in sub_entities:
        yield from visit_entities(sub_entity, context)
    entity.leave(context)


def visit_all_entities_and_collect_futures(
    entity: LaunchDescriptionEntity, context: LaunchContext
) -> list[tuple[LaunchDescriptionEntity, asyncio.Future[None]]]:
    """Visit `entity` and all its sub-entities, depth first; return the ongoing work."""
    return list(visit_entities(entity, context))
