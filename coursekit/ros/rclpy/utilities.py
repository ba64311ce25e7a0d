"""The default context and executor of a process, and small helpers."""

from __future__ import annotations

from coursekit.processes.session import current, locals_here
from coursekit.rcl.arguments import remove_ros_arguments as _remove
from rclpy.context import Context


def get_default_context(*, shutting_down: bool = False) -> Context:
    """The process's default context, created on first use."""
    kept = locals_here()
    context = kept.get("context")
    if context is None:
        context = kept["context"] = Context()
    if shutting_down:
        kept["context"] = None
    return context


def ok(*, context: Context | None = None) -> bool:
    """Whether the context is between init and shutdown."""
    current().clock.poll()
    return (context or get_default_context()).ok()


def shutdown(*, context: Context | None = None) -> None:
    """Shut the context down."""
    if context is None:
        get_default_context(shutting_down=True).shutdown()
    else:
        context.shutdown()


def try_shutdown(*, context: Context | None = None) -> None:
    """Shut the context down unless it is already shut down."""
    (context or get_default_context()).try_shutdown()


def remove_ros_args(args: list[str] | None = None) -> list[str]:
    """`args` (sys.argv by default) without the ROS arguments."""
    import sys

    return _remove(sys.argv if args is None else args)


def get_rmw_implementation_identifier() -> str:
    """The middleware's name."""
    return "rmw_coursekit"


def get_available_rmw_implementations() -> set[str]:
    """The available middlewares."""
    return {"rmw_coursekit"}


def timeout_sec_to_nsec(timeout_sec: float | None) -> int:
    """Convert seconds to nanoseconds; -1 for None and negative values, which mean no limit."""
    if timeout_sec is None or timeout_sec < 0:
        return -1
    return int(float(timeout_sec) * 1_000_000_000)
