"""A compiled program's waitables: an executor waits for their entities, and executes them."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

from rclpy.guard_condition import GuardCondition

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.waiting import entity_of

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup

    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host
    from coursekit.nodes.compiled.node import GroupsApart


class CompiledWaitable:
    """Represents a waitable of the program: it may be ready when one of its entities is."""

    def __init__(self, host: Host, node: GroupsApart, group: CallbackGroup, handler: int) -> None:
        self._host, self._node, self._handler = host, node, handler
        self.callback_group = group
        self._waited_for: dict[int, Any] = {}
        """The entities, by the program's numbers."""

    def wait_for(self, numbers: list[int]) -> bool:
        """Set the entities to wait for. Returns whether they have changed."""
        if numbers == list(self._waited_for):
            return False
        for source in self._sources():
            source.attach(None, None)
        self._waited_for = {number: entity_of(self._host.things[number]) for number in numbers}
        return True

    def _sources(self) -> list[Any]:
        return [entity._sources()[0] for entity in self._waited_for.values()]

    def _take(self) -> Any:
        ready = []
        for number, entity in self._waited_for.items():
            source = entity._sources()[0]
            if source.has_work():
                ready.append(number)
                if isinstance(entity, GuardCondition):
                    source.take()
        return partial(self._execute, ready) if ready else None

    def _execute(self, ready: list[int]) -> None:
        answer = self._host.call(self._handler, packed(len(ready), *ready))
        if not answer.integer():
            self._host.look_in_vain()
        if self.wait_for(_numbers(answer)):
            self._node.serve_entity(self)


def _numbers(frame: Unpacker) -> list[int]:
    return list(dict.fromkeys(frame.integer() for _ in range(frame.integer())))


def do_waitable(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Attach a waitable to a node's executor."""
    node, group, handler = host.things[frame.integer()], host.things.get(frame.integer()), frame.integer()
    waitable = CompiledWaitable(host, node, group or node.default_callback_group, handler)
    waitable.wait_for(_numbers(frame))
    node.add_waitable(waitable)
    return packed(host.keep((node, "remove_waitable", waitable)))
