"""Requests to a controller manager."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import rclpy
from controller_manager_msgs.srv import (
    ConfigureController,
    ListControllers,
    LoadController,
    SwitchController,
    UnloadController,
)
from rclpy.duration import Duration

if TYPE_CHECKING:
    from rclpy.node import Node


class NoManager(Exception):
    """The controller manager does not respond; the message is ROS's."""


class Asker:
    """Calls the services of one manager."""

    def __init__(self, node: Node, manager: str, wait: float = 10.0) -> None:
        self.node, self.manager, self.wait = node, manager.rstrip("/"), wait

    def ask(self, kind: type[Any], service: str, **fields: Any) -> Any:
        """Call a service and return its response. Raises NoManager."""
        name = f"{self.manager}/{service}"
        client = self.node.create_client(kind, name)
        if not client.wait_for_service(timeout_sec=self.wait or None):
            raise NoManager(f"Could not contact service {name}")
        future = client.call_async(kind.Request(**fields))
        rclpy.spin_until_future_complete(self.node, future)
        self.node.destroy_client(client)
        return future.result()

    def controllers(self) -> list[Any]:
        """Return the loaded controllers."""
        return list(self.ask(ListControllers, "list_controllers").controller)

    def load(self, name: str) -> bool:
        """Load a controller."""
        return bool(self.ask(LoadController, "load_controller", name=name).ok)

    def configure(self, name: str) -> bool:
        """Configure a controller."""
        return bool(self.ask(ConfigureController, "configure_controller", name=name).ok)

    def unload(self, name: str) -> bool:
        """Unload a controller."""
        return bool(self.ask(UnloadController, "unload_controller", name=name).ok)

    def switch(self, stop: list[str], start: list[str], strict: bool = True, timeout: float = 5.0) -> bool:
        """Stop some controllers and start others."""
        request = SwitchController.Request
        return bool(
            self.ask(
                SwitchController, "switch_controller", activate_controllers=start, deactivate_controllers=stop,
                strictness=request.STRICT if strict else request.BEST_EFFORT, activate_asap=True,
                timeout=Duration(seconds=timeout).to_msg(),
            ).ok
        )  # fmt: skip


__all__ = ["Asker", "NoManager"]
