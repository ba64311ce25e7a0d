"""A compiled program's requests to the process that it is a part of: waiting for its wishes, and using its objects."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


def do_serve(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Offer a handler to the process that the program is a part of, and wait until that needs it no longer."""
    if host.served is None:
        raise RuntimeError("it is started by the process that it is a part of")
    host.served.offer(frame.integer())


def do_shared_node(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the facts of a node of the process."""
    return facts(host, frame.integer())


def do_shared_call(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Call a function of the process, which reads its arguments and packs its result."""
    answer: bytes = host.things[frame.integer()](frame)
    return answer


def facts(host: Host, number: int) -> bytes:
    """Return a node's number, names and group; `cpp/src/node.cpp` reads them."""
    node = host.things[number]
    host.node_clocks.append(node.get_clock())
    names = node.get_name(), node.get_namespace(), node.get_fully_qualified_name(), node.get_logger().name
    return packed(number, *names, host.keep(node.default_callback_group))
