"""Contexts: the lifetime between `init` and `shutdown`; nodes and executors belong to one."""

from __future__ import annotations

import os
import sys
import threading
import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from coursekit.processes.process import current_process
from coursekit.processes.session import current, locals_here
from coursekit.rcl.arguments import RosArgumentsError, UnknownRosArguments, parse_ros_arguments
from rclpy._rclpy_pybind11 import RCLError, RCLInvalidROSArgsError, UnknownROSArgsError

if TYPE_CHECKING:
    from rclpy.node import Node


class ContextHandle:
    """The content of an initialized context: its arguments, its graph and its nodes."""

    def __init__(self, args: list[str], domain_id: int) -> None:
        self.arguments = _parse(args)
        self.domain_id = domain_id
        self.session = current()
        self.graph = self.session.graph(domain_id)
        self.process = current_process()
        self.alive = True
        self.nodes: list[Any] = []

    def __enter__(self) -> ContextHandle:
        return self

    def __exit__(self, *_error: object) -> None:
        """Nothing is held."""

    def ok(self) -> bool:
        """Whether the context has not been shut down."""
        return self.alive

    def get_domain_id(self) -> int:
        """The ROS domain."""
        return self.domain_id

    def shutdown(self) -> None:
        """Shut the context down; a second call is an error."""
        if not self.alive:
            raise RCLError(
                "failed to shutdown: rcl_shutdown already called on the given context, at ./src/rcl/init.c:241"
            )
        self.alive = False


def _parse(args: list[str]) -> Any:
    try:
        return parse_ros_arguments(args)
    except UnknownRosArguments as error:
        raise UnknownROSArgsError(str(error)) from None
    except RosArgumentsError as error:
        raise RCLInvalidROSArgsError(f"Failed to parse ROS arguments: {error}") from None


class Context:
    """Encapsulates the lifecycle of init and shutdown."""

    def __init__(self) -> None:
        self._handle: ContextHandle | None = None
        self._lock = threading.RLock()
        self._callbacks: list[Any] = []

    @property
    def handle(self) -> ContextHandle | None:
        """The handle; None before `init`."""
        return self._handle

    def destroy(self) -> None:
        """Invalidate the handle."""
        if self._handle is not None:
            self._handle.alive = False

    def init(
        self, args: list[str] | None = None, *, initialize_logging: bool = True, domain_id: int | None = None
    ) -> None:
        """Initialize the context: read the ROS arguments (sys.argv by default) and join the domain."""
        if domain_id is not None and domain_id < 0:
            raise RuntimeError(f"Domain id ({domain_id}) should not be lower than zero.")
        words = list(sys.argv if args is None else args)
        for word in words:
            word.encode()  # UnicodeEncodeError for text that cannot be encoded
        with self._lock:
            if self._handle is not None and self._handle.ok():
                raise RuntimeError("Context.init() must only be called once")
            self._handle = ContextHandle(words, _domain() if domain_id is None else domain_id)
        _contexts_here().append(self)
        if initialize_logging:
            from rclpy.logging import configure

            configure(self._handle.arguments)
        self._handle.session.plan_stop()
        self._handle.session.meet(self._handle.domain_id)

    def ok(self) -> bool:
        """Whether the context is between init and shutdown."""
        handle = self._handle
        return handle is not None and handle.alive

    def shutdown(self) -> None:
        """Shut the context down; a second call is an error."""
        if self._handle is None:
            raise RuntimeError("Context must be initialized before it can be shutdown")
        with self._lock:
            self._handle.shutdown()
        self._call_on_shutdown_callbacks()

    def try_shutdown(self) -> None:
        """Shut the context down unless it is already shut down."""
        with self._lock:
            if not self.ok():
                return
            assert self._handle is not None
            self._handle.alive = False
        self._call_on_shutdown_callbacks()

    def on_shutdown(self, callback: Callable[[], Any]) -> None:
        """Call `callback()` when the context is shut down."""
        if not callable(callback):
            raise TypeError("callback should be a callable, got {}", type(callback))
        with self._lock:
            self._callbacks.append(
                weakref.WeakMethod(callback, self._forget) if hasattr(callback, "__self__") else callback  # type: ignore[arg-type]
            )

    def remove_on_shutdown(self, callback: Callable[[], Any]) -> None:
        """Remove a shutdown callback."""
        with self._lock:
            self._callbacks = [known for known in self._callbacks if _resolve(known) != callback]

    def _forget(self, reference: Any) -> None:
        self._callbacks = [callback for callback in self._callbacks if callback is not reference]

    def _call_on_shutdown_callbacks(self) -> None:
        contexts = _contexts_here()
        if self in contexts:
            contexts.remove(self)
        with self._lock:
            callbacks, self._callbacks = self._callbacks, []
        for reference in callbacks:
            callback = _resolve(reference)
            if callback is not None:
                callback()

    def get_domain_id(self) -> int:
        """The ROS domain that the context has joined."""
        if self._handle is None:
            raise RuntimeError("Context must be initialized before it can have a domain id")
        return self._handle.domain_id

    def track_node(self, node: Node) -> None:
        """Do nothing; a node that joins calls this."""

    def untrack_node(self, node: Node) -> None:
        """Do nothing; a node that leaves calls this."""

    def __enter__(self) -> Context:
        if self._handle is None:
            self.init()
        return self

    def __exit__(self, *_error: object) -> None:
        self.try_shutdown()


def _resolve(callback: Any) -> Any:
    return callback() if isinstance(callback, weakref.WeakMethod) else callback


def _domain() -> int:
    text = os.environ.get("ROS_DOMAIN_ID", "") or "0"
    if not text.isdecimal():
        raise RCLError(
            f"rcl_get_default_domain_id failed: ROS_DOMAIN_ID is '{text}', which is no number from 0 to 232"
        )
    return int(text)


def _contexts_here() -> list[Context]:
    """The contexts that live in this process, oldest first."""
    kept = locals_here()
    contexts: list[Context] | None = kept.get("contexts")
    if contexts is None:
        contexts = kept["contexts"] = []
        process = current_process()
        if process is not None:
            process.cleanups.append(lambda: _end_all(process))
    return contexts


def _end_all(process: Any) -> None:
    """At the end of a process, shut down its contexts and close its remaining nodes."""
    for context in list(process.locals["contexts"]):
        context.try_shutdown()
    for graph in process.session.graphs.values():
        for node in [node for node in list(graph.nodes) if node.process is process]:
            node.close()


def shutdown_all() -> None:
    """Shut down every context of this process, as a signal does."""
    for context in list(_contexts_here()):
        context.try_shutdown()
