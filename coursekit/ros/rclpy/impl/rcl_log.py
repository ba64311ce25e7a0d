"""The log lines of the library below rclpy: `--log-level rcl:=debug`. In ROS 2: rcl."""

from __future__ import annotations

from rclpy.impl.logging_state import LoggingSeverity, logging_state
from rclpy.impl.rcutils_logger import RcutilsLogger

_LOGGER = RcutilsLogger("rcl")


def _wanted() -> bool:
    return logging_state().effective_level("rcl") <= LoggingSeverity.DEBUG


def node_made(name: str, namespace: str, domain: int) -> None:
    """Log the creation of a node."""
    if _wanted():
        _LOGGER.debug(f"Initializing node '{name}' in namespace '{namespace}'")
        _LOGGER.debug(f"Using domain ID of '{domain}'")
        _LOGGER.debug("Node initialized")


def entity_made(entity: str, kind: str, given: str, full_name: str) -> None:
    """Log the creation of a publisher, subscription, client or service (`entity`) of a topic or a service (`kind`)."""
    if _wanted():
        _LOGGER.debug(f"Initializing {entity} for {kind} name '{given}'")
        _LOGGER.debug(f"Expanded and remapped {kind} name '{full_name}'")
        _LOGGER.debug(f"{entity.capitalize()} initialized")


def timer_made(period_ns: int) -> None:
    """Log the creation of a timer."""
    if _wanted():
        _LOGGER.debug(f"Initializing timer with period: {period_ns}ns")


def timer_called() -> None:
    """Log that an executor calls a timer."""
    if _wanted():
        _LOGGER.debug("Calling timer")
