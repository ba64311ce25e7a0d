"""The lifecycle of hardware: the transitions from one state to another, told as the resource manager tells them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.nodes.compiled.classes import CppFault

from .hardware import ACTIVE, FINALIZED, INACTIVE, TRANSITIONS, UNCONFIGURED, Hardware

if TYPE_CHECKING:
    from rclpy.impl.rcutils_logger import RcutilsLogger

_WAYS: dict[str, dict[str, tuple[str, ...]]] = {
    UNCONFIGURED: {INACTIVE: ("cleanup",), ACTIVE: ("deactivate", "cleanup")},
    INACTIVE: {UNCONFIGURED: ("configure",), ACTIVE: ("deactivate",)},
    ACTIVE: {UNCONFIGURED: ("configure", "activate"), INACTIVE: ("activate",)},
    FINALIZED: {UNCONFIGURED: ("shutdown",), INACTIVE: ("shutdown",), ACTIVE: ("deactivate", "shutdown")},
}
"""The transitions to a state, by the state in which the hardware is."""
_DOING = {
    "configure": "configuring", "activate": "activating", "deactivate": "deactivating", "cleanup": "cleaning up",
    "shutdown": "shutting down",
}  # fmt: skip


def bring(hardware: Hardware, target: str, log: RcutilsLogger) -> bool:
    """Bring hardware to a state; return whether it is there."""
    if hardware.state == FINALIZED != target:
        log.warning(f"hardware '{hardware.info.name}' is in finalized state and can be only destroyed.")
        return False
    return all(_go(hardware, name, log) for name in _WAYS[target].get(hardware.state, ()))


def _go(hardware: Hardware, name: str, log: RcutilsLogger) -> bool:
    label = hardware.info.name
    log.info(f"'{name}' hardware '{label}' ")
    try:
        hardware.transition(name)
    except CppFault as fault:
        log.error(f"Exception of type : {fault.kind} occurred while {_DOING[name]} hardware '{label}': {fault}")
        return False
    if hardware.state != TRANSITIONS[name]:
        log.error(f"Failed to '{name}' hardware '{label}'")
        return False
    log.info(f"Successful '{name}' of hardware '{label}'")
    return True


__all__ = ["bring"]
