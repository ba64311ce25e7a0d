"""The sensors that a filter subscribes to: parameters such as odom0, odom0_config, imu1_differential."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from typing import Any

import numpy as np
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node

from coursekit.nav.fusion.state import SIZE, Mask
from coursekit.nodes.nav2.parameters import declare

THRESHOLDS = {
    "odom": ("pose_rejection_threshold", "twist_rejection_threshold"),
    "pose": ("rejection_threshold",),
    "twist": ("rejection_threshold",),
    "imu": ("pose_rejection_threshold", "twist_rejection_threshold", "linear_acceleration_rejection_threshold"),
}
"""The parameters that limit how far a message may deviate, by kind of sensor."""
MEASURES = {"odom": ("pose", "twist"), "pose": ("pose",), "twist": ("twist",), "imu": ("pose", "twist", "acceleration")}
PLACES = {"pose": slice(0, 6), "twist": slice(6, 12), "acceleration": slice(12, 15)}
_NO_LIMIT = sys.float_info.max


@dataclass(frozen=True)
class Source:
    """One sensor: its name (odom0), its topic, which of the 15 state variables it measures, and how they are used."""

    name: str
    kind: str
    topic: str
    used: Mask
    queue_size: int
    differential: bool
    relative: bool
    thresholds: dict[str, float]
    remove_gravity: bool = False

    def part(self, measure: str) -> Mask:
        """Which of the 15 state variables are used from its pose, twist or acceleration."""
        mask = np.zeros(SIZE, bool)
        if measure in MEASURES[self.kind]:
            mask[PLACES[measure]] = self.used[PLACES[measure]]
        return mask


def sources(node: Node) -> list[Source]:
    """All sensors in a node's parameters: odom0, odom1 and so on without a gap, then poses, twists and IMUs."""
    return [source for kind in MEASURES for source in _of_kind(node, kind)]


def _of_kind(node: Node, kind: str) -> list[Source]:
    numbered: list[Source] = []
    while topic := _given(node, name := f"{kind}{len(numbered)}"):
        numbered.append(_read(node, kind, name, str(topic)))
    return numbered


def _given(node: Node, name: str) -> Any:
    """A parameter without a default; if it is not given, undeclare it again and return None."""
    value = node.declare_parameter(name, descriptor=ParameterDescriptor(dynamic_typing=True)).value
    if value is None:
        node.undeclare_parameter(name)
    return value


def _read(node: Node, kind: str, name: str, topic: str) -> Source:
    defaults: dict[str, Any] = {f"{name}_config": [False] * SIZE, f"{name}_queue_size": 10}
    defaults |= {f"{name}_{threshold}": _NO_LIMIT for threshold in THRESHOLDS[kind]}
    if kind != "twist":
        defaults |= {f"{name}_differential": False, f"{name}_relative": False}
    if kind == "imu":
        defaults[f"{name}_remove_gravitational_acceleration"] = False
    given = declare(node, defaults)
    differential, relative = (bool(given.get(f"{name}_{how}", False)) for how in ("differential", "relative"))
    if differential and relative:
        both = f"Both {name}_differential and {name}_relative were set to true."
        node.get_logger().warning(f"{both} Using differential mode.")
    return Source(
        name, kind, topic, _mask(node, name, given[f"{name}_config"]), max(int(given[f"{name}_queue_size"]), 1),
        differential, relative and not differential,
        {what: given[f"{name}_{how}"] for what, how in zip(MEASURES[kind], THRESHOLDS[kind], strict=True)},
        bool(given.get(f"{name}_remove_gravitational_acceleration", False)),
    )  # fmt: skip


def _mask(node: Node, name: str, config: list[bool]) -> Mask:
    if len(config) != SIZE:
        raise ValueError(
            f"{name}_config has {len(config)} values: give 15 of true and false, for x, y, z, roll, pitch, yaw, "
            "vx, vy, vz, vroll, vpitch, vyaw, ax, ay, az"
        )
    if not any(config):
        node.get_logger().warning(f"{name} is listed as an input topic, but all its update variables are false")
    return np.array(config, bool)
