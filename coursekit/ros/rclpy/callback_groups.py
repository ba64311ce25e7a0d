"""Callback groups: which callbacks of a node may run at the same time."""

from __future__ import annotations

import weakref
from typing import Any


class CallbackGroup:
    """Decides whether an entity's callback may begin."""

    def __init__(self) -> None:
        super().__init__()
        self.entities: weakref.WeakSet[Any] = weakref.WeakSet()

    def add_entity(self, entity: Any) -> None:
        """Put an entity under this group's control."""
        self.entities.add(entity)

    def has_entity(self, entity: Any) -> bool:
        """Whether `entity` was added."""
        return entity in self.entities

    def can_execute(self, entity: Any) -> bool:
        """Whether the entity's callback may begin now."""
        raise NotImplementedError()

    def beginning_execution(self, entity: Any) -> bool:
        """Note that the callback begins; False if it must not begin."""
        raise NotImplementedError()

    def ending_execution(self, entity: Any) -> None:
        """Note that the callback has ended."""
        raise NotImplementedError()


class ReentrantCallbackGroup(CallbackGroup):
    """All callbacks may run at the same time.

    >>> group = ReentrantCallbackGroup()
    >>> timer = node.create_timer(1.0, lambda: None, callback_group=group)
    >>> group.has_entity(timer)
    True
    """

    def can_execute(self, entity: Any) -> bool:
        return True

    def beginning_execution(self, entity: Any) -> bool:
        return True

    def ending_execution(self, entity: Any) -> None:
        pass


class MutuallyExclusiveCallbackGroup(CallbackGroup):
    """One callback at a time.

    >>> group = MutuallyExclusiveCallbackGroup()
    >>> timers = [node.create_timer(1.0, lambda: print("tick"), group) for _ in range(2)]
    >>> all(group.has_entity(timer) for timer in timers)
    True
    """

    def __init__(self) -> None:
        super().__init__()
        self._active: Any = None

    def can_execute(self, entity: Any) -> bool:
        return self._active is None

    def beginning_execution(self, entity: Any) -> bool:
        if self._active is not None:
            return False
        self._active = entity
        return True

    def ending_execution(self, entity: Any) -> None:
        if self._active is entity:
            self._active = None
