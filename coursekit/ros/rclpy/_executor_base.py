"""The base of all executors: the nodes that it serves, and spinning."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rclpy._executor_work import TimeoutObject, Work, never
from rclpy._qualified_names import one_class
from rclpy.task import Future, Task

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.node import Node


@one_class
class Executor(Work):
    """The base of all executors; a subclass defines in `spin_once` how a ready callback is run."""

    def __init__(self, *, context: Context | None = None) -> None:
        super().__init__(context)
        self._nodes: list[Any] = []
        self._context.on_shutdown(self.wake)

    @property
    def context(self) -> Any:
        """The context it belongs to."""
        return self._context

    # -- nodes

    def add_node(self, node: Node) -> bool:
        """Serve this node; False if this executor already serves it. A node has one executor: the last it was added to."""
        _check_is_node(node)
        with self._lock:
            if node in self._nodes:
                return False
            self._nodes.append(node)
            node.executor = self
        node._rclpy_attach(self)
        self.wake()
        return True

    def remove_node(self, node: Node) -> None:
        """Stop serving this node. It still refers to its last executor, so that its tasks find it."""
        with self._lock:
            if node not in self._nodes:
                return
            self._nodes.remove(node)
        if node.executor is self:
            node._rclpy_detach()
        self.wake()

    def get_nodes(self) -> list[Any]:
        """The nodes that this executor serves."""
        return list(self._nodes)

    def _attach(self, entity: Any) -> None:
        """Serve an entity of one of the nodes."""
        for source in entity._sources():
            source.attach(self._queue, entity)

    def wait_for_ready_callbacks(
        self,
        timeout_sec: float | None = None,
        nodes: list[Any] | None = None,
        condition: Callable[[], bool] = never,
    ) -> tuple[Task, Any, Any]:
        """Wait for a callback; return a task that runs it when called, its entity and its node.

        For your own executors. Raises TimeoutException, ShutdownException, ExternalShutdownException and
        ConditionReachedException.
        """
        entity, work = self._next_work(timeout_sec, condition)
        if entity is None:
            return work, None, None
        task = _Handler(self, entity, work)
        return task, entity, self._node_of(entity)

    def _wait_for_ready_callbacks(self, *args: Any, **kwargs: Any) -> Iterator[tuple[Task, Any, Any]]:
        """Yield the result of `wait_for_ready_callbacks` again and again."""
        while True:
            yield self.wait_for_ready_callbacks(*args, **kwargs)

    def _node_of(self, entity: Any) -> Any:
        for node in self._nodes:
            if entity in node._rclpy_entities():
                return node
        return None

    # -- spinning

    def spin(self) -> None:
        """Run callbacks until the context or the executor is shut down."""
        ok, spin_once = self._context.ok, self.spin_once
        while ok() and not self._is_shutdown:
            spin_once()

    def spin_until_future_complete(self, future: Future, timeout_sec: float | None = None) -> None:
        """Run callbacks until `future` is done, for at most `timeout_sec` (None or negative: no limit).

        >>> executor = rclpy.executors.SingleThreadedExecutor()
        >>> executor.add_node(node)
        True
        >>> future = executor.create_task(lambda: 42)
        >>> executor.spin_until_future_complete(future)
        >>> future.result()
        42
        """
        future.add_done_callback(lambda _: self.wake())
        timeout = TimeoutObject(timeout_sec if timeout_sec is None or timeout_sec >= 0 else None)
        while self._context.ok() and not future.done() and not self._is_shutdown:
            self.spin_once_until_future_complete(future, timeout)
            left = timeout.timeout
            if left is not None and left <= 0:
                return

    def spin_once(self, timeout_sec: float | None = None) -> None:
        """Wait for one callback, for at most `timeout_sec`, and run it."""
        raise NotImplementedError()

    def spin_once_until_future_complete(self, future: Future, timeout_sec: float | TimeoutObject | None = None) -> None:
        """Like `spin_once`, but also return when `future` is done."""
        raise NotImplementedError()

    def shutdown(self, timeout_sec: float | None = None) -> bool:
        """Stop and return True. As in Humble, a running callback is not waited for: it may be the caller."""
        self._is_shutdown = True
        self.wake()
        with self._lock:
            for node in list(self._nodes):
                self.remove_node(node)
        return True

    def __enter__(self) -> Executor:
        return self

    def __exit__(self, *_error: object) -> None:
        self.shutdown()


def _check_is_node(node: Node) -> None:
    """Reject anything but a node before it is added: the executor could not remove it again."""
    if isinstance(node, type):
        name = node.__name__
        raise TypeError(f"{name} is a class, and an executor serves nodes: make one of it, as in rclpy.spin({name}())")
    node.executor  # noqa: B018  AttributeError for what has none


class _Handler(Task):
    """Runs an entity's callback when called. The executor handles a returned coroutine and the callback's end."""

    def __init__(self, executor: Executor, entity: Any, work: Any) -> None:
        super().__init__(self._run_work, executor=executor)
        self._owner, self._entity, self._work = executor, entity, work

    def _run_work(self) -> None:
        self._owner._run(self._entity, self._work)
