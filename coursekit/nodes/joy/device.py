"""Linux gamepads: /dev/input/js*, whose driver reports each change of an axis or button."""

from __future__ import annotations

import os
import struct
import sys
from pathlib import Path

INPUTS = Path("/dev/input")
_EVENT = struct.Struct("=IhBB")  # time [ms], value, kind, number
_BUTTON, _AXIS, _FIRST = 0x01, 0x02, 0x80
_NAME_SIZE = 128
_ASK_NAME = 0x80006A13 + (_NAME_SIZE << 16)
_CHUNK = 64 * _EVENT.size


def devices() -> list[Path]:
    """Return the connected gamepads, in order."""
    paths = [path for path in INPUTS.glob("js*") if path.name[2:].isdigit()] if INPUTS.is_dir() else []
    return sorted(paths, key=lambda path: int(path.name[2:]))


class Device:
    """An open gamepad: raw axes (-32767 … 32767, right and down positive) and buttons (0, 1), as last reported.

    OSError when it cannot be opened.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._file = os.open(path, os.O_RDONLY | os.O_NONBLOCK)
        self.name = self._ask_name()
        self.axes: list[int] = []
        self.buttons: list[int] = []
        self.pressed: list[int] = []
        self._rest = b""

    def _ask_name(self) -> str:
        if sys.platform == "linux":
            import fcntl

            room = bytearray(_NAME_SIZE)
            try:
                fcntl.ioctl(self._file, _ASK_NAME, room)
            except OSError:
                return self.path.name
            return room.split(b"\0")[0].decode(errors="replace") or self.path.name
        return self.path.name

    def read(self) -> bool:
        """Read pending events. Returns whether an axis or button changed. OSError if the gamepad was unplugged.

        `pressed` has the buttons that were pressed.
        """
        self.pressed.clear()
        moved = False
        while True:
            try:
                data = os.read(self._file, _CHUNK)
            except BlockingIOError:
                return moved
            if not data:
                raise OSError(f"{self.path} has nothing more to tell")
            data = self._rest + data
            whole = len(data) - len(data) % _EVENT.size
            self._rest = data[whole:]
            for _, value, kind, number in _EVENT.iter_unpack(data[:whole]):
                moved |= self._take(value, kind, number)

    def _take(self, value: int, kind: int, number: int) -> bool:
        states = {_AXIS: self.axes, _BUTTON: self.buttons}.get(kind & ~_FIRST)
        if states is None:
            return False
        states.extend([0] * (number + 1 - len(states)))
        changed, states[number] = states[number] != value, value
        if changed and value and states is self.buttons and not kind & _FIRST:
            self.pressed.append(number)
        return changed

    def close(self) -> None:
        """Close the device."""
        os.close(self._file)


def name_of(path: Path) -> str:
    """Return a gamepad's name, or '' if it cannot be opened."""
    try:
        device = Device(path)
    except OSError:
        return ""
    device.close()
    return device.name
