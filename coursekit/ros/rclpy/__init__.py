"""The ROS 2 client library for Python, Humble's names and behaviour, on coursekit's in-process middleware.

    import rclpy
    rclpy.init()
    node = rclpy.create_node("my_node")
    rclpy.spin(node)
"""

from __future__ import annotations

import importlib
import importlib.util
from typing import TYPE_CHECKING, Any

from coursekit.processes import import_hooks, script
from coursekit.processes.patching import patch_manager
from coursekit.processes.session import locals_here
from rclpy._lent import lender
from rclpy.signals import SignalHandlerOptions, install_signal_handlers, uninstall_signal_handlers
from rclpy.utilities import (
    get_default_context,
    get_rmw_implementation_identifier,
    ok,
)
from rclpy.utilities import shutdown as _shutdown
from rclpy.utilities import try_shutdown as _try_shutdown

if TYPE_CHECKING:
    from rclpy.context import Context
    from rclpy.executors import Executor
    from rclpy.node import Node
    from rclpy.task import Future

__all__ = [
    "create_node",
    "get_default_context",
    "get_global_executor",
    "get_rmw_implementation_identifier",
    "init",
    "ok",
    "shutdown",
    "spin",
    "spin_once",
    "spin_until_future_complete",
    "try_shutdown",
]


_lend = lender(__name__)


def __getattr__(name: str) -> Any:
    """Load submodules such as `rclpy.executors` on first access: programs use them without importing them."""
    if name in ("Context", "Future", "Parameter"):
        return _lend(name)
    if name.startswith("__") or importlib.util.find_spec(f"rclpy.{name}") is None:
        raise AttributeError(f"module 'rclpy' has no attribute '{name}'")
    return importlib.import_module(f"rclpy.{name}")


class InitContextManager:
    """Shuts the context down at the end of `with rclpy.init():` (ROS releases after Humble)."""

    def __init__(self, context: Context) -> None:
        self.context = context

    def __enter__(self) -> InitContextManager:
        return self

    def __exit__(self, *_error: object) -> None:
        self.context.try_shutdown()


def init(
    *,
    args: list[str] | None = None,
    context: Context | None = None,
    domain_id: int | None = None,
    signal_handler_options: SignalHandlerOptions | None = None,
) -> InitContextManager:
    """Initialize the context: read the ROS arguments and join the domain. A second call is an error."""
    context = get_default_context() if context is None else context
    if signal_handler_options is None:
        default = context is get_default_context()
        signal_handler_options = SignalHandlerOptions.ALL if default else SignalHandlerOptions.NO
    context.init(args, domain_id=domain_id)
    install_signal_handlers(signal_handler_options)
    return InitContextManager(context)


def get_global_executor() -> Any:
    """The executor that the spin functions use by default; one per process."""
    kept = locals_here()
    executor = kept.get("executor")
    if executor is None or executor.context is not get_default_context() or executor._is_shutdown:
        from rclpy.executors import SingleThreadedExecutor

        executor = kept["executor"] = SingleThreadedExecutor()
    return executor


def shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut the context down; a second call is an error."""
    default = context is None or context is get_default_context()
    if default:
        _close_executor()
    _shutdown(context=context)
    if uninstall_handlers or (uninstall_handlers is None and default):
        uninstall_signal_handlers()


def try_shutdown(*, context: Context | None = None, uninstall_handlers: bool | None = None) -> None:
    """Shut the context down unless it is already shut down."""
    default = context is None or context is get_default_context()
    if default and get_default_context().ok():
        _close_executor()
    _try_shutdown(context=context)
    if uninstall_handlers or (uninstall_handlers is None and default):
        uninstall_signal_handlers()


def _close_executor() -> None:
    executor = locals_here().pop("executor", None)
    if executor is not None:
        executor.shutdown(0)


def create_node(
    node_name: str,
    *,
    context: Context | None = None,
    cli_args: list[str] | None = None,
    namespace: str | None = None,
    use_global_arguments: bool = True,
    enable_rosout: bool = True,
    start_parameter_services: bool = True,
    parameter_overrides: list[Any] | None = None,
    allow_undeclared_parameters: bool = False,
    automatically_declare_parameters_from_overrides: bool = False,
) -> Any:
    """Create a node.

    >>> camera = rclpy.create_node("camera", namespace="robot1")
    >>> camera.get_fully_qualified_name()
    '/robot1/camera'
    >>> camera.destroy_node()
    """
    from rclpy.node import Node

    return Node(
        node_name,
        context=context,
        cli_args=cli_args,
        namespace=namespace,
        use_global_arguments=use_global_arguments,
        enable_rosout=enable_rosout,
        start_parameter_services=start_parameter_services,
        parameter_overrides=parameter_overrides,
        allow_undeclared_parameters=allow_undeclared_parameters,
        automatically_declare_parameters_from_overrides=automatically_declare_parameters_from_overrides,
    )


def spin_once(node: Node, *, executor: Executor | None = None, timeout_sec: float | None = None) -> None:
    """Wait for one callback of `node`, for at most `timeout_sec`, and run it.

    >>> timer = node.create_timer(1.0, lambda: print("tick"))
    >>> rclpy.spin_once(node, timeout_sec=0.5)  # too short for the timer
    >>> rclpy.spin_once(node)
    tick
    """
    executor = get_global_executor() if executor is None else executor
    added = False
    try:
        added = executor.add_node(node)
        executor.spin_once(timeout_sec=timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


def spin(node: Node, executor: Executor | None = None) -> None:
    """Run the callbacks of `node` until the context is shut down.

    >>> timer = node.create_timer(1.0, rclpy.shutdown)  # otherwise Ctrl-C ends it
    >>> rclpy.spin(node)
    >>> rclpy.ok()
    False
    """
    executor = get_global_executor() if executor is None else executor
    try:
        executor.add_node(node)
        ok, spin_once = executor.context.ok, executor.spin_once
        while ok():
            spin_once()
    finally:
        executor.remove_node(node)


def spin_until_future_complete(
    node: Node, future: Future, executor: Executor | None = None, timeout_sec: float | None = None
) -> None:
    """Run the callbacks of `node` until `future` is done, for at most `timeout_sec`.

    >>> future = rclpy.task.Future()
    >>> timer = node.create_timer(1.0, lambda: future.set_result("done"))
    >>> rclpy.spin_until_future_complete(node, future, timeout_sec=5.0)
    >>> future.result()
    'done'
    """
    executor = get_global_executor() if executor is None else executor
    added = False
    try:
        added = executor.add_node(node)
        executor.spin_until_future_complete(future, timeout_sec)
    finally:
        if added:
            executor.remove_node(node)


script.join()
patch_manager.put_at_once("sys.meta_path (last)")
import_hooks.lend_older_names()
