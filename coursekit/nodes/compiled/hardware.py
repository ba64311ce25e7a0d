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
    return b"".join(
        (
            packed(element.get("name") or "", element.get("type") or "", hardware.tell("plugin")), _parameters(hardware),
            *components, _several(map(_transmission, element.all("transmission"))),
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


def _transmission(element: Element) -> bytes:
    return b"".join(
        (
            packed(element.get("name") or "", element.tell("plugin")), _several(map(_geared, element.all("joint"))),
            _several(map(_geared, element.all("actuator"))), _parameters(element),
        )
    )  # fmt: skip


def _geared(element: Element) -> bytes:
    reduction, offset = element.tell("mechanical_reduction") or "1", element.tell("offset") or "0"
    head = packed(element.get("name") or "", element.get("role") or "") + struct.pack("<2d", float(reduction), float(offset))
    return head + b"".join(
        _several(packed(child.get("name") or "") for child in element.all(kind))
        for kind in ("state_interface", "command_interface")
    )
