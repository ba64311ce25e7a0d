"""A compiled program's requests about camera calibrations: their YAML is read and written as in Python."""

from __future__ import annotations

from typing import TYPE_CHECKING

from camera_info_manager.camera_info_manager import UNREADABLE, calibration_of, calibration_text
from sensor_msgs.msg import CameraInfo

from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


def do_calibration_read(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return whether a text is a calibration, then the camera's name and the calibration."""
    try:
        name, info = calibration_of(frame.text())
        return packed(1, name, info)
    except UNREADABLE:
        return packed(0)


def do_calibration_text(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return a camera's calibration as text."""
    name = frame.text()
    return packed(calibration_text(frame.message(CameraInfo), name))
