"""A compiled program's guard conditions and wait sets."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.guard_condition import GuardCondition

from coursekit.core.ready_queue import ReadyQueue
from coursekit.nodes.compiled import qos
from coursekit.nodes.compiled.frames import Unpacker, packed

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host


class AwaitedEvent:
    """An event of one of the program's endpoints that is waited for in addition to its callback."""

    def __init__(self, event: Any) -> None:
        self.event = event

    def _sources(self) -> list[Any]:
        return [self.event.core]


def do_event(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return one kind of event of a publisher or subscription, for waiting."""
    end, kind = entity_of(host.things[frame.integer()]), frame.integer()
    handler = next(known for known in end.event_handlers if known.event_type == kind)
    return packed(host.keep(AwaitedEvent(handler._event)))


def do_take_event(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Take an event's data, which resets the event."""
    return qos.packed_event(host.things[frame.integer()].event.take_event())


def do_guard_condition(host: Host, _channel: Channel, _frame: Unpacker) -> bytes:
    """Make a guard condition."""
    return packed(host.keep(GuardCondition(None, None)))


def do_trigger(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Trigger a guard condition."""
    host.things[frame.integer()].trigger()


def do_wait(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait until entities are ready, with a timeout (negative: none). Returns 1 for each ready one, else 0."""
    nanoseconds = frame.integer()
    entities = [entity_of(host.things[frame.integer()]) for _ in range(frame.integer())]
    sources = [entity._sources()[0] for entity in entities]
    end = None if nanoseconds < 0 else host.clock.steady() + nanoseconds
    ready = _wait(host, sources, end)
    for entity, is_ready in zip(entities, ready, strict=True):
        if is_ready and isinstance(entity, GuardCondition):
            entity.handle.core.take()
    return packed(*map(int, ready))


def entity_of(thing: object) -> Any:
    """Return the program's object without its destroy method."""
    return thing[2] if isinstance(thing, tuple) else thing


def _wait(host: Host, sources: list[Any], end: int | None) -> list[bool]:
    """Return which sources have work; during the wait no executor serves them."""
    queue = ReadyQueue(host.clock)
    served = [(source, source.sink, source.item) for source in sources]
    host.waiting.append(queue)
    try:
        for source in sources:
            source.attach(queue, source)
        while True:
            ready = [source.has_work() for source in sources]
            if any(ready) or host.stopping or (end is not None and host.clock.steady() >= end):
                return ready
            queue.items.clear()
            for source in sources:
                source.queued = False
            queue.wait(end)
            queue.pop()
    finally:
        host.waiting.remove(queue)
        for source, sink, item in served:
            source.attach(sink, item)
