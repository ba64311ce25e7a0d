"""Waitables: custom entities, made of several handles, that an executor waits for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._rclpy_pybind11 import WaitSet

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.task import Future


class NumberOfEntities:
    """The number of handles of each kind that a waitable adds."""

    __slots__ = (  # noqa: RUF023 - the order in which it prints
        "num_subscriptions",
        "num_guard_conditions",
        "num_timers",
        "num_clients",
        "num_services",
        "num_events",
    )

    def __init__(
        self,
        num_subs: int = 0,
        num_gcs: int = 0,
        num_timers: int = 0,
        num_clients: int = 0,
        num_services: int = 0,
        num_events: int = 0,
    ) -> None:
        self.num_subscriptions = num_subs
        self.num_guard_conditions = num_gcs
        self.num_timers = num_timers
        self.num_clients = num_clients
        self.num_services = num_services
        self.num_events = num_events

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        total = self.__class__()
        for name in self.__slots__:
            setattr(total, name, getattr(self, name) + getattr(other, name))
        return total

    __iadd__ = __add__

    def __repr__(self) -> str:
        counts = ", ".join(str(getattr(self, name)) for name in self.__slots__)
        return f"<{self.__class__.__name__}({counts})>"


class Waitable:
    """Base class; a subclass defines what it waits for, takes the data and executes."""

    def __init__(self, callback_group: CallbackGroup) -> None:
        callback_group.add_entity(self)
        self.callback_group = callback_group
        self._futures: list[Any] = []
        self._wait_set: WaitSet | None = None

    def __enter__(self) -> None:
        """Mark as in use."""

    def __exit__(self, *_error: object) -> None:
        """Mark as no longer in use."""

    def add_future(self, future: Future) -> None:
        """Remember a future."""
        self._futures.append(future)

    def remove_future(self, future: Future) -> None:
        """Forget a future."""
        self._futures.remove(future)

    def is_ready(self, wait_set: WaitSet) -> bool:
        """Whether one of its entities is ready."""
        raise NotImplementedError("Must be implemented by subclass")

    def take_data(self) -> Any:
        """Take the data; the waitable must not be ready again at once."""
        raise NotImplementedError("Must be implemented by subclass")

    async def execute(self, taken_data: Any) -> Any:
        """Process the taken data."""
        raise NotImplementedError("Must be implemented by subclass")

    def get_num_entities(self) -> NumberOfEntities:
        """The number of entities of each kind that it uses."""
        raise NotImplementedError("Must be implemented by subclass")

    def add_to_wait_set(self, wait_set: WaitSet) -> None:
        """Add its entities to the wait set."""
        raise NotImplementedError("Must be implemented by subclass")

    # -- for coursekit's executors

    def _sources(self) -> list[Any]:
        """The entities that make it ready; the handles are collected once."""
        if self._wait_set is None:
            self._wait_set = WaitSet()
            self.add_to_wait_set(self._wait_set)
        return list(self._wait_set.sources())

    def _take(self) -> Any:
        """The work to do; None if the waitable is not ready after all."""
        if self._wait_set is None or not self.is_ready(self._wait_set):
            return None
        data = self.take_data()
        return lambda: self.execute(data)
