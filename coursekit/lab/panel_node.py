"""The node of a panel: hidden (its name begins with '_'), with its own context, spun in a background thread."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from coursekit.cli.session_client import domain_id
from coursekit.processes.session import Session, current

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.task import Future

WAIT_SECONDS = 5.0
"""The timeout for an answer [s]."""


APPEAR_SECONDS = 3.0
"""The timeout for a node, topic or service that an earlier cell may only just have started [s]."""


def appears(condition: Callable[[], bool]) -> bool:
    """Wait until `condition()` holds, at most `APPEAR_SECONDS`. Returns whether it holds."""
    clock = current().clock
    give_up = clock.steady() + round(APPEAR_SECONDS * 1e9)
    while not condition() and clock.steady() < give_up:
        clock.sleep(0.05)
    return condition()


class HiddenNode:
    """An rclpy node that spins until `close`, and leaves nothing behind.

    >>> from coursekit.processes.session import Session
    >>> with Session(virtual=True).use():
    ...     hidden = HiddenNode("looker")
    ...     print(hidden.node.get_name())
    ...     hidden.close()
    _looker
    """

    def __init__(self, name: str) -> None:
        import rclpy
        from rclpy.context import Context
        from rclpy.executors import SingleThreadedExecutor

        self.session: Session = current()
        self.graph = self.session.graph(domain_id())
        self.context = Context()
        self.context.init(args=[], initialize_logging=False, domain_id=domain_id())
        self.node: Node = rclpy.create_node(
            self._free(f"_{name}"),
            context=self.context,
            use_global_arguments=False,
            enable_rosout=False,
            start_parameter_services=False,
        )
        self._executor = SingleThreadedExecutor(context=self.context)
        self._executor.add_node(self.node)
        self.session.spawn(self._spin)

    def _free(self, name: str) -> str:
        taken = {node.name for node in list(self.graph.nodes)}
        number = 1
        while (tried := name if number == 1 else f"{name}_{number}") in taken:
            number += 1
        return tried

    def _spin(self) -> None:
        from rclpy.executors import ExternalShutdownException, ShutdownException

        try:
            while self.context.ok():
                self._executor.spin_once()
        except (ExternalShutdownException, ShutdownException):
            pass

    def close(self) -> None:
        """Leave the graph and shut down the context; further calls have no effect."""
        if self.context.ok():
            self.context.try_shutdown()
            self.node.destroy_node()
            self._executor.wake()

    def result(self, future: Future, timeout_sec: float = WAIT_SECONDS) -> Any:
        """Wait for a future of this node; TimeoutError when there is no result in time."""
        done = self.session.clock.new_event()
        future.add_done_callback(lambda _: done.set())
        if not future.done() and not done.wait(timeout_sec):
            raise TimeoutError(f"No answer within {timeout_sec:g} s. Does the node that should answer spin?")
        return future.result()
