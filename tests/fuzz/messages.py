"""Definitions of messages, their bytes, and bags of them."""

from __future__ import annotations

import sqlite3
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

from .format import TEXT, YAML, Faults, Format


def _interface(path: Path) -> Any:
    from coursekit.interfaces.parser import parse_file

    named = path.with_name(f"Name{path.suffix}")
    path.replace(named)
    return parse_file("pkg", named)


def _interface_faults() -> Faults:
    from coursekit.interfaces.errors import InterfaceError

    return (InterfaceError,)


def _scan() -> Any:
    from sensor_msgs.msg import LaserScan

    scan = LaserScan(ranges=[1.0, 2.0], intensities=[3.0])
    scan.header.frame_id = "laser"
    return scan


def _tf() -> Any:
    from geometry_msgs.msg import TransformStamped
    from tf2_msgs.msg import TFMessage

    transform = TransformStamped(child_frame_id="base")
    transform.header.frame_id = "map"
    return TFMessage(transforms=[transform, transform])


def _serialized(make: Callable[[], Any]) -> Callable[[], bytes]:
    def sound() -> bytes:
        from coursekit.interfaces.cdr import serialize

        return serialize(make())

    return sound


def _deserialize(make: Callable[[], Any]) -> Callable[[Path], Any]:
    def read(path: Path) -> Any:
        from coursekit.interfaces.cdr import deserialize

        return deserialize(path.read_bytes(), type(make()))

    return read


def _cdr_faults() -> Faults:
    from coursekit.interfaces.errors import CdrError

    return (CdrError,)


@cache
def _bag(storage: str) -> dict[str, bytes]:
    from coursekit.bag.writer import BagWriter, WriteSettings
    from tests.bag.made import CHATTER, Message, text_bytes

    with tempfile.TemporaryDirectory() as folder:
        writer = BagWriter(WriteSettings(f"{folder}/talk", storage_id=storage))
        writer.create_topic(CHATTER)
        for number in range(5):
            writer.write(Message(CHATTER.name, text_bytes(f"Hello {number}"), number * 10**9))
        writer.close()
        return {path.name: path.read_bytes() for path in Path(folder, "talk").iterdir()}


def _bag_read(storage: str) -> Callable[[Path], Any]:
    def read(path: Path) -> Any:
        from tests.bag.made import all_of

        with tempfile.TemporaryDirectory() as folder:
            for name, data in _bag(storage).items():
                Path(folder, name).write_bytes(path.read_bytes() if name.endswith(path.suffix) else data)
            return all_of(Path(folder))

    return read


def _bag_sound(storage: str, ending: str) -> Callable[[], bytes]:
    return lambda: next(data for name, data in _bag(storage).items() if name.endswith(ending))


def _bag_faults() -> Faults:
    from coursekit.bag.errors import BagError

    return BagError, sqlite3.Error


FORMATS = (
    Format("message", ".msg", lambda: b"uint8 A=1\nstring<=5[<=3] names # x\nfloat64[3] p [1, 2, 3]\nstd_msgs/Header h\n"
           b"string TEXT='a b'\nbool ok true\n", _interface, _interface_faults, TEXT),
    Format("service", ".srv", lambda: b"int64 a\n---\nint64 sum 3\n", _interface, _interface_faults, TEXT),
    Format("action", ".action", lambda: b"int32 order\n---\nint32[] sequence\n---\nint32[] partial\n", _interface,
           _interface_faults, TEXT),
    Format("CDR of a scan", ".bin", _serialized(_scan), _deserialize(_scan), _cdr_faults),
    Format("CDR of transforms", ".bin", _serialized(_tf), _deserialize(_tf), _cdr_faults),
    Format("bag's metadata", ".yaml", _bag_sound("sqlite3", ".yaml"), _bag_read("sqlite3"), _bag_faults, YAML),
    Format("SQLite bag", ".db3", _bag_sound("sqlite3", ".db3"), _bag_read("sqlite3"), _bag_faults),
    Format("MCAP bag", ".mcap", _bag_sound("mcap", ".mcap"), _bag_read("mcap"), _bag_faults),
)  # fmt: skip
