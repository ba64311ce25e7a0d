"""A compiled program's requests to the behaviour tree that its nodes are in: ticks of their children."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.nav.behavior_tree import FAILURE, IDLE, RUNNING, SUCCESS
from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

STATUSES = (IDLE, RUNNING, SUCCESS, FAILURE)
"""In the order of BehaviorTree.CPP's NodeStatus."""


def do_tree_child(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Tick or halt a child of a node, and return its status; a tick may have to begin anew."""
    child = host.things[frame.integer()].children[frame.integer()]
    what = frame.text()
    if what != "tick":
        child.halt()
    return packed(STATUSES.index(child.status if what == "halt" else child.tick()))
