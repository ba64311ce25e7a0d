"""`<plugin>` elements of worlds."""

from __future__ import annotations

from dataclasses import dataclass

from coursekit.urdf.xml_tree import Element

from .ros_names import RosNames, names_of
from .value_parsing import number


@dataclass(frozen=True)
class StatePlugin:
    """gazebo_ros_state: its names and update rate [1/s]."""

    names: RosNames
    rate: float = 100.0


def state_plugin(plugin: Element) -> StatePlugin | None:
    """Return a world plugin's settings if it is gazebo_ros_state. Raises UrdfError for an invalid rate."""
    if "gazebo_ros_state" not in (plugin.get("filename") or ""):
        return None
    rate = number(plugin, "update_rate", 100.0)
    if not 0.0 <= rate <= 10_000.0:
        raise plugin.error(f"has an update_rate of {rate:g}", "Give one from 0 (as fast as can be) to 10000 a second.")
    return StatePlugin(names_of(plugin), rate or 200.0)


__all__ = ["StatePlugin", "state_plugin"]
