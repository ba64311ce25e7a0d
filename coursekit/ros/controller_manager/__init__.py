"""The services of a controller manager as Python functions, as the spawner uses them."""

from __future__ import annotations

from .controller_manager_services import (
    configure_controller,
    list_controller_types,
    list_controllers,
    list_hardware_components,
    list_hardware_interfaces,
    load_controller,
    reload_controller_libraries,
    set_hardware_component_state,
    switch_controllers,
    unload_controller,
)

__all__ = [
    "configure_controller",
    "list_controller_types",
    "list_controllers",
    "list_hardware_components",
    "list_hardware_interfaces",
    "load_controller",
    "reload_controller_libraries",
    "set_hardware_component_state",
    "switch_controllers",
    "unload_controller",
]
