"""Small helpers of the commands."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.utilities import timeout_sec_to_nsec

from coursekit.processes.session import current

if TYPE_CHECKING:
    from rclpy.node import Node

_WAIT_SECONDS = 5.0


def get_ros_domain_id() -> int:
    """The domain in ROS_DOMAIN_ID, 0 if it is not set."""
    return int(os.environ.get("ROS_DOMAIN_ID") or 0)


def get_rmw_additional_env(rmw_implementation: str) -> dict[str, str]:
    """The environment variables that select this middleware in a child process."""
    return {"RMW_IMPLEMENTATION": rmw_implementation}


def wait_for(predicate: Callable[[], bool], timeout: float | None, period: float = 0.1) -> bool:
    """Poll every `period` seconds until `predicate()` holds. Return False after `timeout` seconds.

    >>> wait_for(lambda: True, timeout=0.0)
    True
    """
    clock = current().clock
    nanoseconds = timeout_sec_to_nsec(timeout)
    deadline = clock.steady() + nanoseconds
    while not predicate():
        if nanoseconds >= 0 and deadline <= clock.steady():
            return predicate()
        clock.sleep(period)
    return True


def call_service(node: Node, kind: Any, name: str, request: Any, absent: str) -> Any:
    """Wait for a service, call it and return its response.

    Raises:
        RuntimeError: with the text `absent` if the service does not appear within 5 s; also if the call itself fails.
    """
    target = getattr(node, "node", node)
    client = target.create_client(kind, name)
    try:
        if not client.wait_for_service(timeout_sec=_WAIT_SECONDS):
            raise RuntimeError(absent)
        future = client.call_async(request)
        rclpy.spin_until_future_complete(target, future)
        if future.result() is None:
            raise RuntimeError(f"Exception while calling service '{name}': {future.exception()}")
        return future.result()
    finally:
        target.destroy_client(client)


def pretty_print_call(func: Callable[..., Any], *args: Any, **kwargs: Any) -> None:
    """Print a call as it would be typed.

    >>> pretty_print_call(max, 1, default=2)
    max(1, default=2)
    """
    name = getattr(func, "__name__", str(func))
    words = [*map(str, args), *(f"{key}={value}" for key, value in kwargs.items())]
    print(f"{name}({', '.join(words)})")


def before_invocation(func: Callable[..., Any], hook: Callable[..., Any]) -> Callable[..., Any]:
    """`func` with a preceding call of `hook(func, *arguments)`."""

    @functools.wraps(func)
    def wrapper(*args: Any, **kwargs: Any) -> Any:
        hook(getattr(func, "__wrapped__", func), *args, **kwargs)
        return func(*args, **kwargs)

    return wrapper
