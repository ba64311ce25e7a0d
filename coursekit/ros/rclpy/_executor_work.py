"""An executor's next work: ready entities and tasks, and waiting for them.

Ready entities are in a queue (`coursekit.core.ready_queue`), so a wake-up costs the same with two nodes and with two
hundred; real rclpy checks every entity in every cycle.
"""

from __future__ import annotations

import inspect
import threading
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from coursekit.core.ready_queue import ReadyQueue
from coursekit.processes.session import current
from rclpy.task import Future, Task
from rclpy.utilities import get_default_context, timeout_sec_to_nsec

if TYPE_CHECKING:
    from rclpy.context import Context

_POLL_WEIGHT = 100
"""A spin that may not wait and finds nothing counts as this many polls of the virtual clock."""


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Call `callback`, and await the result if it is a coroutine."""
    result = callback(*args)
    return await result if inspect.iscoroutine(result) else result


class TimeoutException(Exception):
    """Nothing became ready in time."""

    __module__ = "rclpy.executors"


class ShutdownException(Exception):
    """The executor was shut down."""

    __module__ = "rclpy.executors"


class ExternalShutdownException(Exception):
    """The context was shut down while the executor waited."""

    __module__ = "rclpy.executors"


class ConditionReachedException(Exception):
    """The condition that the caller waited for has come true."""

    __module__ = "rclpy.executors"


class TimeoutObject:
    """A timeout shared by successive calls: the time left shrinks."""

    def __init__(self, timeout: float | None) -> None:
        self._clock = current().clock
        self._deadline = deadline_of(timeout)

    @property
    def timeout(self) -> float | None:
        """Seconds left; None for no limit."""
        return None if self._deadline is None else max(0.0, (self._deadline - self._clock.steady()) * 1e-9)


def deadline_of(timeout_sec: float | TimeoutObject | None) -> int | None:
    """The steady-clock time [ns] at which a timeout [s] ends; None for never."""
    if timeout_sec is None:
        return None
    if isinstance(timeout_sec, TimeoutObject):
        timeout_sec = timeout_sec.timeout
    nanoseconds = timeout_sec_to_nsec(timeout_sec)
    return None if nanoseconds < 0 else current().clock.steady() + nanoseconds


def never() -> bool:
    """The condition of a spin without a condition: always False."""
    return False


class Work:
    """The queue of ready entities and the tasks of one executor."""

    def __init__(self, context: Context | None) -> None:
        self._context = get_default_context() if context is None else context
        self._clock = current().clock
        self._queue = ReadyQueue(self._clock)
        self._lock = threading.RLock()
        self._is_shutdown = False
        self._tasks: list[Task] = []
        self._waiting_tasks: list[Task] = []
        self._parked: list[Any] = []
        self._errors: list[BaseException] = []
        self._cycle: Any = None
        self._past_waiting = False
        self._overrides_can_execute = type(self).can_execute is not Work.can_execute

    def wake(self) -> None:
        """Make a blocked spin check for work again."""
        self._queue.wake()

    # -- tasks

    def create_task(self, callback: Any, *args: Any, **kwargs: Any) -> Task:
        """Run a function or coroutine in this executor; the task is a future for its result."""
        task = Task(callback, args, kwargs, executor=self)
        self._add_task(task)
        return task

    def _add_task(self, task: Task) -> None:
        with self._lock:
            self._tasks.append(task)
        self.wake()

    def _resume(self, task: Task) -> Callable[[Any], None]:
        return lambda _future: self._add_task(task)

    def _next_task(self) -> Task | None:
        with self._lock:
            while self._tasks:
                task = self._tasks.pop()
                if not task.done() and not task.cancelled():
                    return task
        return None

    def _after_step(self, task: Task) -> None:
        """Let an unfinished task wait for the future that it awaits, or else for the next cycle."""
        if task.done() or task.cancelled():
            return
        awaited = task.awaits
        if isinstance(awaited, Future):
            awaited_callback = self._resume(task)
            if awaited.done():
                awaited_callback(awaited)
            else:
                with awaited._lock:
                    awaited._resumptions.append(awaited_callback)
        else:
            with self._lock:
                self._waiting_tasks.append(task)

    def _begin_cycle(self, cycle: Any) -> None:
        """Resume the tasks that await no future, once before each wait, as the real executor does."""
        self._cycle, self._past_waiting = cycle, False
        if self._waiting_tasks:
            self._clock.poll(_POLL_WEIGHT)
            with self._lock:
                self._tasks.extend(self._waiting_tasks)
                self._waiting_tasks.clear()

    # -- waiting

    def can_execute(self, entity: Any) -> bool:
        """Whether the entity's callback may begin; a subclass may be stricter."""
        return entity.callback_group.can_execute(entity)

    def _next_work(self, timeout_sec: float | TimeoutObject | None, condition: Callable[[], bool]) -> tuple[Any, Any]:
        """Wait for work: (entity, function) or (None, task). The entity's group has begun execution.

        A cycle checks the tasks, waits once, and serves everything that is ready then. The next call with the same
        arguments continues it.
        """
        queue = self._queue
        handle = self._context._handle  # checked below as in Context.ok: a call costs 1/40 of a message's delivery
        deadline = None if timeout_sec is None else deadline_of(timeout_sec)
        waited = False
        if self._cycle != (cycle := (timeout_sec, condition)):
            self._begin_cycle(cycle)
        while True:
            if self._is_shutdown:
                raise ShutdownException()
            if handle is None or not handle.alive:
                raise ExternalShutdownException()
            if self._tasks:
                task = self._next_task()
                if task is not None:
                    return None, task
            entity = queue.pop(deadline)
            if entity is not None:
                work = self._begin(entity)
                if work is not None:
                    self._past_waiting = True
                    return entity, work
                continue
            if self._past_waiting:
                self._begin_cycle(cycle)
                if self._tasks:
                    continue
            if (condition is not never and condition()) or self._errors:
                self._cycle = None
                raise ConditionReachedException()
            if deadline is not None and self._clock.steady() >= deadline:
                self._cycle = None
                if not waited:
                    self._clock.poll(_POLL_WEIGHT)
                raise TimeoutException()
            waited = True
            queue.wait(deadline)
            if not queue.items:
                self._begin_cycle(cycle)

    def _begin(self, entity: Any) -> Any:
        """Take an entity's data if its group allows it to begin; None if there is nothing to do now."""
        sources = entity._sources()
        served = False
        for source in sources:
            if source.yields:
                source.yields = False
                if self._queue.items:
                    self._queue.put(entity)
                    return None
            source.queued = False
            served = served or source.sink is self._queue
        if not served:
            return None
        group = entity.callback_group
        if self._overrides_can_execute and not self.can_execute(entity):
            self._park(entity)
            return None
        if not group.beginning_execution(entity):
            for source in sources:
                source.queued = True
            self._park(entity)
            return None
        try:
            work = entity._take()
        except BaseException:
            self._ended(entity)
            raise
        if work is None:
            self._ended(entity)
        for source in sources:
            if not source.queued and source.has_work():
                source.signal()
        return work

    def _ended(self, entity: Any) -> None:
        """The entity's callback has ended: its group is free for others."""
        entity.callback_group.ending_execution(entity)
        if self._parked:
            self._unpark()

    def _park(self, entity: Any) -> None:
        """Let an entity wait for the end of a callback; one that ended in another thread just before did not see it."""
        with self._lock:
            self._parked.append(entity)
        if entity.callback_group.can_execute(entity) and self.can_execute(entity):
            self._unpark()

    def _unpark(self) -> None:
        with self._lock:
            parked, self._parked = self._parked, []
        for entity in parked:
            self._queue.put(entity)

    def _run(self, entity: Any, work: Any) -> None:
        """Run work in this thread; its exceptions propagate."""
        if entity is None:
            work()
            self._after_step(work)
            if work.done() and work._exception is not None:
                raise work.exception()
            return
        try:
            result = work()
        except BaseException:
            self._ended(entity)
            raise
        if result is not None and inspect.iscoroutine(result):
            task = Task(_finish(self, entity, result), executor=self)
            self._run(None, task)
        else:
            self._ended(entity)


async def _finish(executor: Work, entity: Any, coroutine: Any) -> Any:
    """Await an entity's coroutine; its group stays busy until it ends."""
    try:
        return await coroutine
    finally:
        executor._ended(entity)
