"""A compiled program's questions about executors."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy.executors import (
    ConditionReachedException,
    Executor,
    ExternalShutdownException,
    MultiThreadedExecutor,
    ShutdownException,
    SingleThreadedExecutor,
    TimeoutException,
)

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.living import living_context

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host



def do_executor(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make an executor with so many threads."""
    threads, context = frame.integer(), living_context(host, frame)
    executor: Any
    executor = SingleThreadedExecutor(context=context) if threads == 1 else MultiThreadedExecutor(threads, context=context)
    executor.cancelled = False
    executor.is_cancelled = lambda: executor.cancelled
    return packed(host.keep(executor))


def do_add_node(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Have an executor serve a node."""
    host.things[frame.integer()].add_node(host.things[frame.integer()])


def do_remove_node(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Have an executor serve a node no more."""
    host.things[frame.integer()].remove_node(host.things[frame.integer()])


def do_add_callback_group(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Have an executor serve one group of a node, apart from the node's own."""
    executor, group, node = (host.things[frame.integer()] for _ in range(3))
    node.set_apart(group, executor)
    executor.apart = {**getattr(executor, "apart", {}), group: node}


def do_remove_callback_group(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Have an executor serve a group no more."""
    executor, group = (host.things[frame.integer()] for _ in range(2))
    node = executor.apart.pop(group, None)
    if node is not None:
        node.set_apart(group)


def do_spin(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Run callbacks until the context ends or the executor is cancelled."""
    executor = host.things[frame.integer()]
    executor.cancelled = False
    try:
        while executor.context.ok() and not executor.cancelled:
            executor._spin_once(None, executor.is_cancelled)  # one that has nothing to do is cancelled too
    except (ShutdownException, ExternalShutdownException):
        pass


def do_spin_once(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Wait for one callback and run it, at most so long (negative: without end), or until the executor is cancelled."""
    executor, nanoseconds = host.things[frame.integer()], frame.integer()
    try:
        executor._spin_once(None if nanoseconds < 0 else nanoseconds / 1e9, executor.is_cancelled)
    except (ShutdownException, ExternalShutdownException):
        pass
    executor.cancelled = False


def do_spin_some(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Run each that is ready once, at most so long (0: without end); with the last word 1 all that is and becomes ready."""
    executor, limit, everything = host.things[frame.integer()], frame.integer(), frame.integer()
    end = host.clock.steady() + limit
    left = executor._queue.count_ready()
    if not left:
        host.look_in_vain()
    while (everything or left > 0) and _run_one(executor) and (not limit or host.clock.steady() < end):
        left -= 1


def _run_one(executor: Executor) -> bool:
    """Run one callback that is ready now; False where there is none."""
    try:
        task, _entity, _node = executor.wait_for_ready_callbacks(timeout_sec=0)
    except (TimeoutException, ShutdownException, ExternalShutdownException):
        return False
    _run(task)
    return True


def _run(task: Any) -> None:
    """Run a callback; what it raises is raised."""
    task()
    error = task.exception()
    if error is not None:
        raise error


class Work:
    """A callback that has begun its group's execution, and that the program has not run yet."""

    def __init__(self, executor: Any, task: Any, entity: Any) -> None:
        self._executor, self._task, self._entity = executor, task, entity

    def run(self) -> None:
        """Run it."""
        _run(self._task)

    def drop(self) -> None:
        """It will not be run: its group is free for others."""
        if self._entity is not None:
            self._executor._ended(self._entity)


def do_next_work(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a callback, at most so long (negative: without end); its number, 0 for none."""
    executor, nanoseconds = host.things[frame.integer()], frame.integer()
    patience = None if nanoseconds < 0 else nanoseconds / 1e9
    try:
        task, entity, _node = executor.wait_for_ready_callbacks(patience, condition=executor.is_cancelled)
    except (TimeoutException, ShutdownException, ExternalShutdownException):
        return packed(0)
    except ConditionReachedException:
        executor.cancelled = False
        return packed(0)
    return packed(host.keep(Work(executor, task, entity)))


def do_run_work(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Run such a callback."""
    host.things.pop(frame.integer()).run()


def do_cancel(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Have a spin of this executor return."""
    executor = host.things[frame.integer()]
    executor.cancelled = True
    executor.wake()
