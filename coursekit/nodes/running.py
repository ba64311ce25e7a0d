"""The execution of the underlay's nodes until Ctrl-C."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator

import rclpy
from rclpy.executors import Executor, ExternalShutdownException
from rclpy.node import Node

from coursekit.processes.process import ProcessKilled, current_process
from coursekit.systems import signal_names


@contextlib.contextmanager
def to_the_end(*nodes: Node) -> Iterator[None]:
    """Run a block until its end or until Ctrl-C; then destroy the nodes."""
    try:
        yield
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        for node in nodes:
            node.destroy_node()
        rclpy.try_shutdown()


def spin_to_the_end(*nodes: Node, executor: Executor | None = None) -> int:
    """Spin nodes together until Ctrl-C, in one thread or with the given executor. Return the exit code."""
    together = rclpy.get_global_executor() if executor is None else executor
    for node in nodes:
        together.add_node(node)
    with to_the_end(*nodes):
        together.spin()
    return 0


def run(
    make: Callable[[], Node], args: list[str] | None = None, *, refuses: tuple[type[Exception], ...] = ()
) -> int:
    """Start rclpy, and run the node that `make` returns until Ctrl-C; on an exception in `refuses`, end as C++ does."""
    rclpy.init(args=args)
    with to_the_end():
        try:
            node = make()
        except refuses as fault:
            return terminate(str(fault))
        return spin_to_the_end(node)
    return 0


def terminate(what: str, kind: str = "std::runtime_error") -> int:
    """Shut rclpy down and end as a C++ program does after an uncaught exception of the type `kind`."""
    print(f"terminate called after throwing an instance of '{kind}'\n  what():  {what}", file=sys.stderr)
    rclpy.try_shutdown()
    if current_process() is not None:
        raise ProcessKilled(signal_names.ABORT)
    return 1


def pass_on_output() -> Callable[[str, str], None]:
    """A value for `on_output` of a process that makes this process write that process's output."""
    mine = current_process()

    def pass_on(stream: str, text: str) -> None:
        if mine is not None:
            mine.out.write(stream, text)
        else:
            print(text, end="", flush=True)

    return pass_on
