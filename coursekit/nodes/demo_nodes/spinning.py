"""Running the Python demos: an external shutdown, for instance by SIGTERM, ends them with 1."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


@contextmanager
def demo(node: Node) -> Iterator[None]:
    """Run a block until its end or Ctrl-C; the node is then destroyed."""
    try:
        yield
    except KeyboardInterrupt:
        pass
    except ExternalShutdownException:
        sys.exit(1)
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def spin_demo(make: Callable[[], Node], args: list[str] | None) -> None:
    """Initialise rclpy, and spin the node made by `make` until Ctrl-C."""
    rclpy.init(args=args)
    node = make()
    with demo(node):
        rclpy.spin(node)
