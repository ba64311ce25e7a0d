"""The launch's own node, for topics and services that only a node can use."""

from __future__ import annotations

from typing import Any

from launch.launch_context import LaunchContext

from coursekit.core.execution_context import ProcessKilled
from coursekit.processes import session
from coursekit.processes.process import current_process

KEY = "ros_adapter"


class ROSAdapter:
    """A node with its own context and executor, which spins in parallel to the launch."""

    def __init__(self, *, argv: list[str] | None = None, autostart: bool = True) -> None:
        self.__argv = argv
        self.__ros_context: Any = None
        self.__ros_node: Any = None
        self.__ros_executor: Any = None
        if autostart:
            self.start()

    def start(self) -> None:
        """Create the node and start spinning."""
        import rclpy
        import rclpy.context
        import rclpy.executors
        import rclpy.node

        current = session.current()
        process = current_process()
        self.__ros_context = rclpy.context.Context()
        rclpy.init(args=self.__argv, context=self.__ros_context)
        number = process.pid if process is not None else current.new_pid()
        self.__ros_node = rclpy.node.Node(f"launch_ros_{number}", context=self.__ros_context)
        self.__ros_executor = rclpy.executors.SingleThreadedExecutor(context=self.__ros_context)
        self.__ros_executor.add_node(self.__ros_node)
        current.spawn(self.__spin)

    def __spin(self) -> None:
        from rclpy.executors import ExternalShutdownException, ShutdownException

        try:
            self.__ros_executor.spin()
        except (ExternalShutdownException, ShutdownException, KeyboardInterrupt, ProcessKilled):
            pass  # the launch is over

    def shutdown(self) -> None:
        """Stop spinning and destroy the node."""
        if self.__ros_context is not None and self.__ros_context.ok():
            self.__ros_executor.shutdown(timeout_sec=0)
            self.__ros_node.destroy_node()
            self.__ros_context.shutdown()
        self.__ros_node = None

    @property
    def ros_context(self) -> Any:
        """The context."""
        return self.__ros_context

    @property
    def ros_node(self) -> Any:
        """The node."""
        return self.__ros_node

    @property
    def ros_executor(self) -> Any:
        """The executor."""
        return self.__ros_executor


def get_ros_adapter(context: LaunchContext) -> ROSAdapter:
    """Return the launch's adapter, created on first use; it ends with the launch."""
    adapter: ROSAdapter | None = context.get_locals_as_dict().get(KEY)
    if adapter is None:
        adapter = ROSAdapter(argv=context.argv)
        context.extend_globals({KEY: adapter})
        context._at_end.append(lambda: _end(context, adapter))
    return adapter


def _end(context: LaunchContext, adapter: ROSAdapter) -> None:
    adapter.shutdown()
    context.extend_globals({KEY: None})


def get_ros_node(context: LaunchContext) -> Any:
    """Return the launch's node, created on first use."""
    return get_ros_adapter(context).ros_node
