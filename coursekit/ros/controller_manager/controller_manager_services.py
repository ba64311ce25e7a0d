"""One function for each service of a controller manager; each returns the service's response.

`node` makes the call, `controller_manager_name` is the manager's full name. Raises RuntimeError if it does not answer.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from controller_manager_msgs.srv import (
    ConfigureController,
    ListControllers,
    ListControllerTypes,
    ListHardwareComponents,
    ListHardwareInterfaces,
    LoadController,
    ReloadControllerLibraries,
    SetHardwareComponentState,
    SwitchController,
    UnloadController,
)

from coursekit.nodes.control.manager_client import Asker, NoManager

if TYPE_CHECKING:
    from rclpy.node import Node


class ServiceNotFoundError(RuntimeError):
    """The manager does not answer."""


def _ask(node: Node, manager: str, kind: Any, service: str, timeout: float, **fields: Any) -> Any:
    try:
        return Asker(node, manager, timeout).ask(kind, service, **fields)
    except NoManager as error:
        raise ServiceNotFoundError(str(error)) from None


def configure_controller(
    node: Node, controller_manager_name: str, controller_name: str, service_timeout: float = 10.0
) -> Any:
    """Configure a loaded controller."""
    name = "configure_controller"
    return _ask(node, controller_manager_name, ConfigureController, name, service_timeout, name=controller_name)


def list_controllers(node: Node, controller_manager_name: str, service_timeout: float = 10.0) -> Any:
    """The loaded controllers."""
    return _ask(node, controller_manager_name, ListControllers, "list_controllers", service_timeout)


def list_controller_types(node: Node, controller_manager_name: str, service_timeout: float = 10.0) -> Any:
    """The controllers that can be loaded."""
    return _ask(node, controller_manager_name, ListControllerTypes, "list_controller_types", service_timeout)


def list_hardware_components(node: Node, controller_manager_name: str, service_timeout: float = 10.0) -> Any:
    """The hardware components."""
    return _ask(node, controller_manager_name, ListHardwareComponents, "list_hardware_components", service_timeout)


def list_hardware_interfaces(node: Node, controller_manager_name: str, service_timeout: float = 10.0) -> Any:
    """The interfaces for commands and states."""
    return _ask(node, controller_manager_name, ListHardwareInterfaces, "list_hardware_interfaces", service_timeout)


def load_controller(
    node: Node, controller_manager_name: str, controller_name: str, service_timeout: float = 10.0
) -> Any:
    """Load a controller whose type is in the manager's parameters."""
    return _ask(node, controller_manager_name, LoadController, "load_controller", service_timeout, name=controller_name)


def reload_controller_libraries(
    node: Node, controller_manager_name: str, force_kill: bool, service_timeout: float = 10.0
) -> Any:
    """Unload all controllers; active controllers only with `force_kill`."""
    name = "reload_controller_libraries"
    return _ask(
        node, controller_manager_name, ReloadControllerLibraries, name, service_timeout, force_kill=force_kill
    )


def set_hardware_component_state(
    node: Node, controller_manager_name: str, component_name: str, lifecyle_state: Any, service_timeout: float = 10.0
) -> Any:
    """Set the state of a hardware component."""
    return _ask(
        node, controller_manager_name, SetHardwareComponentState, "set_hardware_component_state", service_timeout,
        name=component_name, target_state=lifecyle_state,
    )  # fmt: skip


def switch_controllers(
    node: Node, controller_manager_name: str, deactivate_controllers: list[str], activate_controllers: list[str],
    strict: bool, activate_asap: bool, timeout: float,
) -> Any:  # fmt: skip
    """Deactivate some controllers and activate others; with `strict`, all of them or none."""
    answer = SwitchController.Response()
    try:
        asker = Asker(node, controller_manager_name)
        answer.ok = asker.switch(list(deactivate_controllers), list(activate_controllers), strict, timeout)
    except NoManager as error:
        raise ServiceNotFoundError(str(error)) from None
    return answer


def unload_controller(
    node: Node, controller_manager_name: str, controller_name: str, service_timeout: float = 10.0
) -> Any:
    """Unload a controller that is not active."""
    name = "unload_controller"
    return _ask(node, controller_manager_name, UnloadController, name, service_timeout, name=controller_name)
