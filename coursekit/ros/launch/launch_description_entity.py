"""The base class of all entities of a launch description."""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .launch_context import LaunchContext


class LaunchDescriptionEntity:
    """An action or a description: visiting it does its work and returns the entities to visit next."""

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Do the work of this entity; return the entities to visit next."""
        return None

    def leave(self, context: LaunchContext) -> None:
        """Clean up after all entities that `visit` returned have been visited."""
        return None

    def describe(self) -> str:
        """Return a short description of this entity; subclasses override this.

        Raises:
            NotImplementedError: if the subclass does not implement it.
        """
        raise NotImplementedError(f"{type(self).__name__} has no describe()")

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that are always visited with this one."""
        return []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return (description of the condition, entities) for entities that may be visited later."""
        return []

    def get_asyncio_future(self) -> asyncio.Future[None] | None:
        """Return a future that is done when this entity's work is done, or None if it already is."""
        return None
