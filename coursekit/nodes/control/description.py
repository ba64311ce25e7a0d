"""`<ros2_control>` in a robot description: the joints, sensors and interfaces of hardware."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from coursekit.urdf import parse
from coursekit.urdf.model import Robot
from coursekit.urdf.xml_tree import Element, read

KINDS = ("joint", "sensor", "gpio")
MOCK_OFFSET = "position_state_following_offset"
"""The parameter of mock hardware that is a number; all others are text, which a driver reads as it likes."""


@dataclass(frozen=True)
class Interface:
    """A number that is written or read; `initial` is nan if not set."""

    name: str
    initial: float = math.nan


@dataclass(frozen=True)
class Component:
    """A joint, sensor or gpio."""

    name: str
    kind: str
    commands: tuple[Interface, ...] = ()
    states: tuple[Interface, ...] = ()
    parameters: dict[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class HardwareInfo:
    """One `<ros2_control>`: `kind` is system, actuator or sensor, `plugin` its class."""

    name: str
    kind: str
    plugin: str
    components: tuple[Component, ...]
    parameters: dict[str, str] = field(default_factory=dict)
    mimics: dict[str, tuple[str, float, float]] = field(default_factory=dict)
    """By joint: the joint that it mimics, the factor, the offset."""

    def interfaces(self, which: str) -> dict[str, Interface]:
        """Return all "commands" or "states" by their full names, such as `wheel/velocity`."""
        return {f"{part.name}/{interface.name}": interface for part in self.components for interface in getattr(part, which)}


def read_hardware(text: str, file: str = "") -> tuple[Robot, list[HardwareInfo]]:
    """Parse the robot and its hardware. Raises UrdfError with line and remedy.

    >>> robot = "<robot name='r'><link name='l'/><ros2_control name='h' type='system'><hardware><plugin>p</plugin>"
    >>> robot += "</hardware><joint name='j'><command_interface name='position'/></joint></ros2_control></robot>"
    >>> list(read_hardware(robot)[1][0].interfaces("commands"))
    ['j/position']
    """
    robot = parse(text, file)
    return robot, [_hardware(element, robot) for element in read(text, file).all("ros2_control")]


def _hardware(element: Element, robot: Robot) -> HardwareInfo:
    name, kind, plugin = element.get("name") or "", element.get("type") or "", element.tell("hardware/plugin")
    if kind not in ("system", "actuator", "sensor"):
        raise element.error(f"has type '{kind}'", "Give it type='system', 'actuator' or 'sensor'.")
    if not plugin:
        raise element.error("names no class", "Say <hardware><plugin>mock_components/GenericSystem</plugin></hardware>.")
    hardware = element.first("hardware")
    assert hardware is not None
    parameters = _parameters(hardware)
    _number(hardware, parameters.get(MOCK_OFFSET) or "0")
    parts = tuple(_component(child) for child in element.children if child.tag in KINDS)
    known = {part.name for part in parts if part.kind == "joint"}
    for moved in (joint for gears in element.all("transmission") for joint in gears.all("joint")):
        if moved.get("name") not in known:
            raise moved.error(f"is no joint of the hardware '{name}'", "Declare it there, or name another.")
    mimics = {
        joint.name: (joint.mimic.joint, joint.mimic.multiplier, joint.mimic.offset)
        for joint in robot.joints.values() if joint.mimic is not None and joint.name in known
    }  # fmt: skip
    for part in parts:
        leader = part.parameters.get("mimic", "")
        if leader and leader not in ("true", "false"):
            mimics[part.name] = (leader, _number(element, part.parameters.get("multiplier", "1")), 0.0)
    return HardwareInfo(name, kind, plugin, parts, parameters, mimics)


def _parameters(element: Element) -> dict[str, str]:
    return {param.get("name") or "": param.text.strip() for param in element.all("param")}


def _component(element: Element) -> Component:
    name = element.get("name")
    if not name:
        raise element.error("has no name", f"Name the {element.tag}.")
    commands, states = (
        tuple(_interface(child) for child in element.all(f"{which}_interface")) for which in ("command", "state")
    )
    return Component(name, element.tag, commands, states, _parameters(element))


def _interface(element: Element) -> Interface:
    name = element.get("name")
    if not name:
        raise element.error("has no name", "Name it: position, velocity or effort.")
    first = element.tell("initial_value") or _parameters(element).get("initial_value", "")
    return Interface(name, _number(element, first) if first else math.nan)


def _number(element: Element, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise element.error(f"has '{text}', which is no number", "Write a number such as 0.5.") from None


__all__ = ["Component", "HardwareInfo", "Interface", "read_hardware"]
