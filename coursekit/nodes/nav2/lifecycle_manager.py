"""`ros2 run nav2_lifecycle_manager lifecycle_manager`: starts and shuts down lifecycle nodes in order."""

from __future__ import annotations

import rclpy
from lifecycle_msgs.msg import Transition
from lifecycle_msgs.srv import ChangeState
from nav2_msgs.srv import ManageLifecycleNodes
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_srvs.srv import Trigger

from coursekit.nodes.running import run

_CONFIGURE = (Transition.TRANSITION_CONFIGURE, "Configuring")
_ACTIVATE = (Transition.TRANSITION_ACTIVATE, "Activating")
_DEACTIVATE = (Transition.TRANSITION_DEACTIVATE, "Deactivating")
_CLEANUP = (Transition.TRANSITION_CLEANUP, "Cleaning up")
_SHUTDOWN = (Transition.TRANSITION_UNCONFIGURED_SHUTDOWN, "Shutting down")

# command: first message, transitions, whether a failure stops it, final message, whether nodes are then active
_COMMANDS: dict[int, tuple[str, tuple[tuple[int, str], ...], bool, str, bool]] = {
    0: ("Starting managed nodes bringup...", (_CONFIGURE, _ACTIVATE), True, "active", True),
    1: ("Pausing managed nodes...", (_DEACTIVATE,), True, "paused", False),
    2: ("Resuming managed nodes...", (_ACTIVATE,), True, "active", True),
    3: ("Resetting managed nodes...", (_DEACTIVATE, _CLEANUP), False, "reset", False),
    4: ("Shutting down managed nodes...", (_DEACTIVATE, _CLEANUP, _SHUTDOWN), False, "shut down", False),
}


class LifecycleManager(Node):
    """Takes the nodes in `node_names` through their states, on start with `autostart`, and on manage_nodes."""

    def __init__(self) -> None:
        super().__init__("lifecycle_manager")
        self.get_logger().info("Creating")
        self.declare_parameter("node_names", Parameter.Type.STRING_ARRAY)
        self.declare_parameter("autostart", False)
        self.declare_parameter("bond_timeout", 0.0)
        self._names = list(self.get_parameter_or("node_names", Parameter("node_names", value=[""])).value)
        self._active = False
        name = self.get_name()
        self.create_service(ManageLifecycleNodes, f"{name}/manage_nodes", self._manage)
        self.create_service(Trigger, f"{name}/is_active", self._is_active)
        self._asker = rclpy.create_node(
            f"{name}_service_client", namespace=self.get_namespace(), use_global_arguments=False, context=self.context
        )
        self._executor_of_asker = SingleThreadedExecutor(context=self.context)
        self._executor_of_asker.add_node(self._asker)
        self.get_logger().info("Creating and initializing lifecycle service clients")
        self._clients_of = {
            node: self._asker.create_client(ChangeState, f"{node}/change_state") for node in self._names if node
        }
        self._start = self.create_timer(0.0, self._first) if self.get_parameter("autostart").value else None

    def destroy_node(self) -> None:
        """Destroy the client node as well."""
        self._asker.destroy_node()
        super().destroy_node()

    def _first(self) -> None:
        if self._start is not None:
            self._start.cancel()
        if self._run(ManageLifecycleNodes.Request.STARTUP):
            return
        self.get_logger().error("Failed to bring up all requested nodes. Aborting bringup.")

    def _manage(
        self, request: ManageLifecycleNodes.Request, response: ManageLifecycleNodes.Response
    ) -> ManageLifecycleNodes.Response:
        response.success = self._run(request.command)
        return response

    def _is_active(self, _request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        response.success = self._active
        return response

    def _run(self, command: int) -> bool:
        """Run a ManageLifecycleNodes command. Returns whether it succeeded for every node."""
        if command not in _COMMANDS:
            self.get_logger().error(f"Unknown command {command}: 0 startup, 1 pause, 2 resume, 3 reset, 4 shutdown")
            return False
        first, transitions, strict, last, active = _COMMANDS[command]
        self.get_logger().info(first)
        was_active, self._active = self._active, False
        followed = True
        for transition in transitions:
            if transition == _DEACTIVATE and not strict and not was_active:
                continue
            followed = self._change_all(transition, strict) and followed
            if strict and not followed:
                return False
        self._active = active and followed
        verb = "are" if active else "have been"
        self.get_logger().info(f"Managed nodes {verb} {last}")
        return followed

    def _change_all(self, transition: tuple[int, str], strict: bool) -> bool:
        up = transition in (_CONFIGURE, _ACTIVATE)
        names = list(self._clients_of) if up else list(reversed(self._clients_of))
        followed = True
        for name in names:
            followed = self._change(name, transition) and followed
            if strict and not followed:
                break
        return followed

    def _change(self, name: str, transition: tuple[int, str]) -> bool:
        client = self._clients_of[name]
        while not client.wait_for_service(1.0):
            if not self.context.ok():
                return False
            self.get_logger().info(f"Waiting for service {name}/change_state...")
        self.get_logger().info(f"{transition[1]} {name}")
        future = client.call_async(ChangeState.Request(transition=Transition(id=transition[0])))
        while not future.done() and client.service_is_ready():  # a costmap may wait a long time for its robot
            self._executor_of_asker.spin_until_future_complete(future, 1.0)
        answer = future.result() if future.done() else None
        if answer is None or not answer.success:
            self.get_logger().error(f"Failed to change state for node: {name}")
            return False
        return True


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(LifecycleManager, args)
