"""A compiled program's requests to tf2."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_ros import Buffer, TransformListener
from tf2_ros.buffer_server import BufferServer
from yaml import safe_load

from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


def do_tf_buffer(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make a buffer with a cache time; with a node it serves `tf2_frames`. The program itself clears it after a jump."""
    buffer = Buffer(Duration(nanoseconds=frame.integer()), host.things.get(frame.integer()))
    if hasattr(buffer, "jump_handle"):
        buffer.jump_handle.unregister()
    return packed(host.keep(buffer))


def do_tf_listener(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Fill a buffer from broadcasts, with its own thread and node, so that a callback may wait for it."""
    buffer, static_only = host.things[frame.integer()], bool(frame.integer())
    return packed(host.keep(TransformListener(buffer, None, spin_thread=True, static_only=static_only)))


def _buffer(host: Host, frame: Unpacker) -> tuple[Any, Duration]:
    return host.things[frame.integer()], Duration(nanoseconds=frame.integer())


def do_tf_lookup(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for the transform from a source to a target."""
    buffer, timeout = _buffer(host, frame)
    return packed(buffer.lookup_transform(frame.text(), frame.text(), _time(frame), timeout))


def do_tf_lookup_full(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for the transform between two times, through a frame fixed in between."""
    buffer, timeout = _buffer(host, frame)
    return packed(
        buffer.lookup_transform_full(frame.text(), _time(frame), frame.text(), _time(frame), frame.text(), timeout)
    )


def do_tf_can(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a transform and return whether it exists, and why not."""
    buffer, timeout = _buffer(host, frame)
    can, why = buffer.can_transform(frame.text(), frame.text(), _time(frame), timeout, return_debug_tuple=True)
    return packed(int(can), why)


def do_tf_can_full(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a transform between two times and return whether it exists, and why not."""
    buffer, timeout = _buffer(host, frame)
    asked = (frame.text(), _time(frame), frame.text(), _time(frame), frame.text())
    can, why = buffer.can_transform_full(*asked, timeout, return_debug_tuple=True)
    return packed(int(can), why)


def do_tf_chain(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the names of the frames on the path from a source to a target."""
    buffer, _timeout = _buffer(host, frame)
    names = buffer._chain(frame.text(), _time(frame), frame.text(), _time(frame), frame.text())
    return packed(len(names), *names)


def do_tf_parent(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the name of a frame's parent; empty for none."""
    tree = safe_load(host.things[frame.integer()].all_frames_as_yaml())
    return packed((tree or {}).get(frame.text().lstrip("/"), {}).get("parent", ""))


def do_tf_dot(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the tree in graphviz format, at a time, or without one for 0."""
    buffer, time = host.things[frame.integer()], frame.integer()
    return packed(buffer._allFramesAsDot(Time(nanoseconds=time) if time else None))


def do_tf_server(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Serve BufferClients from a buffer, through an action of a node."""
    buffer, node, name = host.things[frame.integer()], host.things[frame.integer()], frame.text()
    return packed(host.keep(BufferServer(buffer, node, name, Duration(nanoseconds=frame.integer()))))


def do_tf_set(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Set a transform in a buffer; return whether it was taken."""
    buffer, authority, is_static = host.things[frame.integer()], frame.text(), frame.integer()
    return packed(int(buffer._set(frame.message(TransformStamped), authority, bool(is_static))))


def do_tf_clear(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Clear a buffer."""
    host.things[frame.integer()].clear()


def do_tf_text(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return all frames as text."""
    return packed(host.things[frame.integer()].all_frames_as_string())


def do_tf_yaml(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return all frames as YAML."""
    return packed(host.things[frame.integer()].all_frames_as_yaml())


def do_tf_names(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the names of all frames."""
    names = host.things[frame.integer()]._getFrameStrings()
    return packed(len(names), *names)


def _time(frame: Unpacker) -> Time:
    return Time(nanoseconds=frame.integer())
