"""A compiled program's requests about ros2_control: descriptions of hardware."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from typing import TYPE_CHECKING

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.urdf.xml_tree import Element, read

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


Names = tuple[list[str], list[str]]
"""The names of states, and of commands."""
_NONE: Names = ([], [])


def do_hardware_infos(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the hardware in a robot's description; `cpp/src/hardware.cpp` reads it."""
    all_ = list(read(frame.text()).all("ros2_control"))
    return packed(len(all_)) + b"".join(map(_info, all_))


def _several(parts: Iterable[bytes]) -> bytes:
    listed = list(parts)
    return packed(len(listed)) + b"".join(listed)


def _info(element: Element) -> bytes:
    hardware = element.first("hardware") or element
    components = [_several(map(_component, element.all(kind))) for kind in ("joint", "sensor", "gpio")]
    joints = {joint.get("name") or "": _names(joint) for joint in element.all("joint")}
    kind, gears = element.get("type") or "", element.all("transmission")
    return b"".join(
        (
            packed(element.get("name") or "", kind, hardware.tell("plugin")), _parameters(hardware), *components,
            _several(_transmission(gear, joints, kind) for gear in gears),
        )
    )  # fmt: skip


def _parameters(element: Element) -> bytes:
    return _several(packed(param.get("name") or "", param.text.strip()) for param in element.all("param"))


def _component(element: Element) -> bytes:
    interfaces = (_several(map(_interface, element.all(f"{which}_interface"))) for which in ("command", "state"))
    return packed(element.get("name") or "", element.tag) + b"".join(interfaces) + _parameters(element)


def _interface(element: Element) -> bytes:
    told = {param.get("name") or "": param.text.strip() for param in element.all("param")}
    first = told.get("initial_value", "") or element.tell("initial_value")
    size = element.get("size") or "1"
    return packed(
        element.get("name") or "", told.get("min", ""), told.get("max", ""), first, element.get("data_type") or "double",
        int(size) if size.isdecimal() else 1,
    )  # fmt: skip


def _names(element: Element) -> Names:
    states, commands = (
        [child.get("name") or "" for child in element.all(f"{which}_interface")] for which in ("state", "command")
    )
    return states, commands


def _transmission(element: Element, known: dict[str, Names], kind: str) -> bytes:
    joints = [_geared(joint, known.get(joint.get("name") or "", _NONE)) for joint in element.all("joint")]
    actuators = [_geared(actuator, _names(actuator)) for actuator in element.all("actuator")]
    if kind == "actuator":  # such hardware is one motor, which need not be written down
        moved = [known.get(joint.get("name") or "", _NONE) for joint in element.all("joint")]
        interfaces = moved[0] if moved else _NONE
        actuators.append(_packed_gear("actuator1", "actuator1", 1.0, 0.0, interfaces))
    head = packed(element.get("name") or "", element.tell("plugin"))
    return head + _several(joints) + _several(actuators) + _parameters(element)


def _geared(element: Element, interfaces: Names) -> bytes:
    reduction, offset = element.tell("mechanical_reduction") or "1", element.tell("offset") or "0"
    name, role = element.get("name") or "", element.get("role") or ""
    return _packed_gear(name, role, float(reduction), float(offset), interfaces)


def _packed_gear(name: str, role: str, reduction: float, offset: float, interfaces: Names) -> bytes:
    """Pack a joint or an actuator of a transmission; a joint has the interfaces that the hardware's joint declares."""
    head = packed(name, role) + struct.pack("<2d", reduction, offset)
    return head + b"".join(_several(map(packed, names)) for names in interfaces)
