"""Executors: they wait for ready entities and run their callbacks.

Ready entities stand in a queue (`coursekit.core.ready`), so a wake-up costs the same with two nodes and with two
hundred; real rclpy asks every entity in every cycle.
"""

from __future__ import annotations

import inspect
import os
import threading
from collections.abc import Callable
from typing import Any

from coursekit.core.ready import ReadyQueue
from coursekit.core.session import current
from rclpy.task import Future, Task
from rclpy.utilities import get_default_context, timeout_sec_to_nsec

_POLL_WEIGHT = 100
"""A spin that may not wait and finds nothing counts as that many questions to the virtual clock."""


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Call `callback`, and await what it returns if it is a coroutine function."""
    result = callback(*args)
    return await result if inspect.iscoroutine(result) else result


class TimeoutException(Exception):
    """Nothing became ready in time."""


class ShutdownException(Exception):
    """The executor was shut down."""


class ExternalShutdownException(Exception):
    """The context was shut down while the executor waited."""


class ConditionReachedException(Exception):
    """What the caller waited for has come true."""


class TimeoutObject:
    """A timeout that later calls share: the time left shrinks."""

    def __init__(self, timeout: float | None) -> None:
        self._clock = current().clock
        self._deadline = _deadline(timeout)

    @property
    def timeout(self) -> float | None:
        """Seconds left, None for 'without end'."""
        return None if self._deadline is None else max(0.0, (self._deadline - self._clock.steady()) * 1e-9)


def _deadline(timeout_sec: Any) -> int | None:
    if isinstance(timeout_sec, TimeoutObject):
        timeout_sec = timeout_sec.timeout
    nanoseconds = timeout_sec_to_nsec(timeout_sec)
    return None if nanoseconds < 0 else current().clock.steady() + nanoseconds


def _never() -> bool:
    return False


class Executor:
    """The base of all executors; a subclass says in `spin_once` how a ready callback is run."""

    def __init__(self, *, context: Any = None) -> None:
        self._context = get_default_context() if context is None else context
        self._clock = current().clock
        self._queue = ReadyQueue(self._clock)
        self._nodes: list[Any] = []
        self._lock = threading.RLock()
        self._is_shutdown = False
        self._tasks: list[Task] = []
        self._waiting_tasks: list[Task] = []
        self._parked: list[Any] = []
        self._working = 0
        self._idle = self._clock.new_event()
        self._overrides_can_execute = type(self).can_execute is not Executor.can_execute
        self._context.on_shutdown(self.wake)

    @property
    def context(self) -> Any:
        """The context it belongs to."""
        return self._context

    # -- nodes

    def add_node(self, node: Any) -> bool:
        """Serve this node; False if it did already. A node is served by one executor, the last that took it."""
        with self._lock:
            if node in self._nodes:
                return False
            self._nodes.append(node)
            node.executor = self
        node._attach(self)
        self.wake()
        return True

    def remove_node(self, node: Any) -> None:
        """Serve this node no more."""
        with self._lock:
            if node not in self._nodes:
                return
            self._nodes.remove(node)
        if node.executor is self:
            node.executor = None
        self.wake()

    def get_nodes(self) -> list[Any]:
        """The nodes that it serves."""
        return list(self._nodes)

    def wake(self) -> None:
        """Have a blocked spin look again."""
        self._queue.wake()

    def _attach(self, entity: Any) -> None:
        """Serve an entity of one of the nodes."""
        for source in entity._sources():
            source.attach(self._queue, entity)

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
        """A task that is not done waits: for a future, or for the next thing that happens."""
        if task.done() or task.cancelled():
            return
        awaited = task.awaits
        if isinstance(awaited, Future):
            awaited_callback = self._resume(task)
            if awaited.done():
                awaited_callback(awaited)
            else:
                with awaited._lock:
                    awaited._callbacks.append(_Direct(awaited_callback))
        else:
            with self._lock:
                self._waiting_tasks.append(task)

    def _poll_waiting(self) -> None:
        if self._waiting_tasks:
            with self._lock:
                self._tasks.extend(self._waiting_tasks)
                self._waiting_tasks.clear()

    # -- waiting

    def can_execute(self, entity: Any) -> bool:
        """Whether the entity's callback may begin; a subclass may be stricter."""
        return entity.callback_group.can_execute(entity)

    def _next_work(self, deadline: int | None, condition: Callable[[], bool]) -> tuple[Any, Any]:
        """Wait for something to do: (entity, function) or (None, task). The entity's group has begun execution."""
        queue = self._queue
        context = self._context
        waited = False
        while True:
            if self._is_shutdown:
                raise ShutdownException()
            if not context.ok():
                raise ExternalShutdownException()
            if self._tasks:
                task = self._next_task()
                if task is not None:
                    return None, task
            entity = queue.pop()
            if entity is not None:
                work = self._begin(entity)
                if work is not None:
                    return entity, work
                continue
            if condition():
                raise ConditionReachedException()
            if deadline is not None and self._clock.steady() >= deadline:
                if not waited:
                    self._clock.poll(_POLL_WEIGHT)
                raise TimeoutException()
            waited = True
            queue.wait(deadline)
            self._poll_waiting()

    def _begin(self, entity: Any) -> Any:
        """Take an entity's data if its group lets it begin; None if there is nothing to do now."""
        sources = entity._sources()
        for source in sources:
            source.queued = False
        if not any(source.sink is self._queue for source in sources) or not self._serves(entity):
            return None
        group = entity.callback_group
        if self._overrides_can_execute and not self.can_execute(entity):
            self._parked.append(entity)
            return None
        if not group.beginning_execution(entity):
            for source in sources:
                source.queued = True
            self._parked.append(entity)
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

    def _serves(self, entity: Any) -> bool:
        return True

    def _ended(self, entity: Any) -> None:
        """The entity's callback has ended: its group is free for others."""
        entity.callback_group.ending_execution(entity)
        if self._parked:
            with self._lock:
                parked, self._parked = self._parked, []
            for other in parked:
                self._queue.put(other)

    def _run(self, entity: Any, work: Any) -> None:
        """Run work here and now; what it raises is raised."""
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

    def wait_for_ready_callbacks(
        self,
        timeout_sec: Any = None,
        nodes: list[Any] | None = None,
        condition: Callable[[], bool] = _never,
    ) -> tuple[Task, Any, Any]:
        """Wait for a callback; a task that runs it when called, its entity and its node.

        For executors of your own. Raises TimeoutException, ShutdownException, ExternalShutdownException and
        ConditionReachedException.
        """
        entity, work = self._next_work(_deadline(timeout_sec), condition)
        if entity is None:
            return work, None, None
        task = _Handler(self, entity, work)
        return task, entity, self._node_of(entity)

    def _node_of(self, entity: Any) -> Any:
        for node in self._nodes:
            if entity in node._entities():
                return node
        return None

    # -- spinning

    def spin(self) -> None:
        """Run callbacks until the context or the executor is shut down."""
        while self._context.ok() and not self._is_shutdown:
            self.spin_once()

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Run callbacks until `future` is done, at most `timeout_sec` (None or negative: without end)."""
        future.add_done_callback(lambda _: self.wake())
        timeout = TimeoutObject(timeout_sec if timeout_sec is None or timeout_sec >= 0 else None)
        while self._context.ok() and not future.done() and not self._is_shutdown:
            self.spin_once_until_future_complete(future, timeout)
            left = timeout.timeout
            if left is not None and left <= 0:
                return

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and run it, at most `timeout_sec`."""
        raise NotImplementedError()

    def spin_once_until_future_complete(self, future: Future, timeout_sec: Any = None) -> None:
        """Like `spin_once`, and returns when `future` is done."""
        raise NotImplementedError()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop; True if no callback was left running after `timeout_sec`."""
        self._is_shutdown = True
        self.wake()
        deadline = _deadline(timeout_sec)
        while self._working:
            left = None if deadline is None else (deadline - self._clock.steady()) * 1e-9
            if left is not None and left <= 0:
                return False
            self._idle.clear()
            if self._working:
                self._idle.wait(left)
        with self._lock:
            for node in list(self._nodes):
                self.remove_node(node)
        return True

    def __enter__(self) -> Executor:
        return self

    def __exit__(self, *_error: object) -> None:
        self.shutdown()


class _Direct:
    """A done callback that only puts a task back: it is not a task of its own."""

    def __init__(self, call: Callable[[Any], None]) -> None:
        self.call = call

    def __call__(self, future: Any) -> None:
        self.call(future)


async def _finish(executor: Executor, entity: Any, coroutine: Any) -> Any:
    """Await an entity's coroutine; its group stays taken until it ends."""
    try:
        return await coroutine
    finally:
        executor._ended(entity)


class _Handler(Task):
    """Runs an entity's callback when called; the executor is told of its coroutine and its end."""

    def __init__(self, executor: Executor, entity: Any, work: Any) -> None:
        super().__init__(self._run_work, executor=executor)
        self._owner, self._entity, self._work = executor, entity, work

    def _run_work(self) -> None:
        self._owner._run(self._entity, self._work)


class SingleThreadedExecutor(Executor):
    """Runs callbacks one after the other in the thread that spins."""

    def __init__(self, *, context: Any = None) -> None:
        super().__init__(context=context)

    def _spin_once(self, deadline: int | None, condition: Callable[[], bool]) -> None:
        try:
            entity, work = self._next_work(deadline, condition)
        except (ShutdownException, TimeoutException, ConditionReachedException):
            return
        self._working += 1
        try:
            self._run(entity, work)
        finally:
            self._working -= 1
            if self._is_shutdown:
                self._idle.set()

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and run it, at most `timeout_sec`."""
        self._spin_once(_deadline(timeout_sec), _never)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: Any = None) -> None:
        """Like `spin_once`, and returns when `future` is done."""
        future.add_done_callback(lambda _: self.wake())
        self._spin_once(_deadline(timeout_sec), future.done)


class MultiThreadedExecutor(Executor):
    """Runs callbacks in several threads, as far as their callback groups allow."""

    def __init__(self, num_threads: int | None = None, *, context: Any = None) -> None:
        super().__init__(context=context)
        if num_threads is None:
            num_threads = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count()
        self._num_threads = max(1, num_threads or 2)
        self._errors: list[BaseException] = []
        self._free = self._clock.new_event()

    def _spin_once(self, deadline: int | None, condition: Callable[[], bool]) -> None:
        self._raise_error()
        try:
            entity, work = self._next_work(deadline, lambda: condition() or bool(self._errors))
        except (ShutdownException, TimeoutException, ConditionReachedException):
            self._raise_error()
            return
        while self._working >= self._num_threads:
            self._free.clear()
            if self._working >= self._num_threads:
                self._free.wait()
        with self._lock:
            self._working += 1
        current().spawn(self._work, entity, work)

    def _work(self, entity: Any, work: Any) -> None:
        try:
            self._run(entity, work)
        except Exception as error:
            self._errors.append(error)
        finally:
            with self._lock:
                self._working -= 1
            self._free.set()
            if self._is_shutdown:
                self._idle.set()
            self.wake()

    def _raise_error(self) -> None:
        if self._errors:
            raise self._errors.pop(0)

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback and have a thread run it."""
        self._spin_once(_deadline(timeout_sec), _never)

    def spin_once_until_future_complete(self, future: Future, timeout_sec: Any = None) -> None:
        """Like `spin_once`, and returns when `future` is done."""
        future.add_done_callback(lambda _: self.wake())
        self._spin_once(_deadline(timeout_sec), future.done)
