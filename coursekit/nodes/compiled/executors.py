"""A compiled program's requests about executors."""

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
from coursekit.nodes.compiled.valid_objects import living_context

if TYPE_CHECKING:
    from rclpy.task import Task

    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host



def do_executor(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Make an executor with a number of threads."""
    threads, context = frame.integer(), living_context(host, frame)
    executor: Any
    executor = SingleThreadedExecutor(context=context) if threads == 1 else MultiThreadedExecutor(threads, context=context)
    executor.cancelled = False
    executor.is_cancelled = lambda: executor.cancelled
    return packed(host.keep(executor))


def do_add_node(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Add a node to an executor."""
    host.things[frame.integer()].add_node(host.things[frame.integer()])


def do_remove_node(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Remove a node from an executor."""
    host.things[frame.integer()].remove_node(host.things[frame.integer()])


def do_add_callback_group(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Add one group of a node to an executor, separately from the node."""
    executor, group, node = (host.things[frame.integer()] for _ in range(3))
    node.set_apart(group, executor)
    executor.apart = {**getattr(executor, "apart", {}), group: node}


def do_remove_callback_group(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Remove a group from an executor."""
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
            executor._spin_once(None, executor.is_cancelled)  # an idle executor can be cancelled too
    except (ShutdownException, ExternalShutdownException):
        pass


def do_spin_once(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Wait for one callback and run it, until a timeout (negative: none) or until the executor is cancelled."""
    executor, nanoseconds = host.things[frame.integer()], frame.integer()
    try:
        executor._spin_once(None if nanoseconds < 0 else nanoseconds / 1e9, executor.is_cancelled)
    except (ShutdownException, ExternalShutdownException):
        pass
    executor.cancelled = False


def do_spin_some(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Run each ready callback once, up to a time limit (0: none); with a final 1 also those that become ready."""
    executor, limit, everything = host.things[frame.integer()], frame.integer(), frame.integer()
    end = host.clock.steady() + limit
    left = executor._queue.count_ready()
    if not left:
        host.look_in_vain()
    while (everything or left > 0) and _run_one(executor) and (not limit or host.clock.steady() < end):
        left -= 1


def _run_one(executor: Executor) -> bool:
    """Run one ready callback; False if there is none."""
    try:
        task, _entity, _node = executor.wait_for_ready_callbacks(timeout_sec=0)
    except (TimeoutException, ShutdownException, ExternalShutdownException):
        return False
    _run(task)
    return True


def _run(task: Task) -> None:
    """Run a callback and raise its exception."""
    task()
    error = task.exception()
    if error is not None:
        raise error


class Work:
    """A callback whose group counts as executing, but which the program has not run yet."""

    def __init__(self, executor: Executor, task: Task, entity: Any) -> None:
        self._executor, self._task, self._entity = executor, task, entity

    def run(self) -> None:
        """Run the callback."""
        _run(self._task)

    def drop(self) -> None:
        """Do not run the callback: release its group."""
        if self._entity is not None:
            self._executor._ended(self._entity)


def do_next_work(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a callback with a timeout (negative: none). Returns its number and that of its entity, 0 for none."""
    executor, nanoseconds = host.things[frame.integer()], frame.integer()
    patience = None if nanoseconds < 0 else nanoseconds / 1e9
    try:
        task, entity, _node = executor.wait_for_ready_callbacks(patience, condition=executor.is_cancelled)
    except (TimeoutException, ShutdownException, ExternalShutdownException):
        return packed(0, 0)
    except ConditionReachedException:
        executor.cancelled = False
        return packed(0, 0)
    return packed(host.keep(Work(executor, task, entity)), _number_of(host, entity))


def _number_of(host: Host, entity: object) -> int:
    """Return the number of what a node destroys as this entity; 0 if the program does not know it."""
    kept = list(host.things.items())
    return next((number for number, thing in kept if isinstance(thing, tuple) and thing[-1] is entity), 0)


def do_run_work(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Run a callback obtained from `next_work`."""
    host.things.pop(frame.integer()).run()


def do_cancel(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Make the executor's spin return."""
    executor = host.things[frame.integer()]
    executor.cancelled = True
    executor.wake()
