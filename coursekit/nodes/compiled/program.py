"""A compiled program's requests about itself: init, time, threads, logging."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import TYPE_CHECKING

import rclpy
from rclpy.impl.logging_state import logging_state
from rclpy.signals import shutdown_all

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.processes.components import tells_of

if TYPE_CHECKING:
    from coursekit.core.clock import Waiter
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

_INFO = 20
_LINE = 256
"""Reads of fewer bytes are for single keys."""


def do_init(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Initialise rclpy with the program's arguments."""
    context, domain = host.context_called(frame.integer()), frame.integer()
    words = [frame.text() for _ in range(frame.integer())]
    if host.served is not None and context.ok():
        return  # it is a part of a process that has done so
    rclpy.init(args=words[1:], context=context, domain_id=None if domain < 0 else domain)
    host.process.on_signal.clear()


def do_domain(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the ROS domain of a context."""
    return packed(host.context_called(frame.integer()).get_domain_id())


def do_catch_signals(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Set whether Ctrl-C and `kill` end the program's spinning."""
    interrupt, terminate = frame.integer(), frame.integer()
    host.caught = {number for number, caught in ((signal.SIGINT, interrupt), (signal.SIGTERM, terminate)) if caught}


def tell_signal(host: Host, number: int) -> None:
    """Write the log line of rclcpp's signal handler: components of one container have one handler."""
    if not tells_of(host.process, number):
        return
    text, caller = f"signal_handler(signum={number})", ("signal_handler.cpp", "signal_handler", 0)
    logging_state().write(_INFO, "rclcpp", text, caller, host.clock.now())


def do_shutdown(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Shut down a context."""
    number = frame.integer()
    if number or any(context.ok() for context in host.contexts.values()):
        rclpy.try_shutdown(context=host.context_called(number))
    else:
        shutdown_all()


def do_sleep(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Sleep for the thread; 0 if Ctrl-C was received, or the given context (not -1) ended meanwhile."""
    until, number = host.clock.steady() + frame.integer(), frame.integer()
    context = None if number < 0 else host.context_called(number)
    waiter = host.clock.new_waiter()
    if context is None or not context.ok():
        _sleep(host, waiter, until, lambda: True)
        return packed(int(not host.stopping))

    def wake() -> None:  # a separate function: contexts hold methods weakly, and waiters cannot be referenced weakly
        waiter.notify()

    context.on_shutdown(wake)
    _sleep(host, waiter, until, context.ok)
    context.remove_on_shutdown(wake)
    return packed(int(not host.stopping and context.ok()))


def _sleep(host: Host, waiter: Waiter, until: int, goes_on: Callable[[], bool]) -> None:
    while not host.stopping and host.clock.steady() < until and goes_on():
        waiter.wait(until)


def do_read(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for standard input with a timeout (negative: none); 0 if Ctrl-C was received, else 1 and the bytes."""
    size, by_keys, patience = frame.integer(), frame.integer(), frame.integer()
    keys = host.process.stdin
    while not host.typed and not host.over:
        if host.stopping:
            return packed(0)
        if keys.wait_for_keys(None if patience < 0 else patience * 1e-9):
            host.typed = keys.read(1).encode() if by_keys or size < _LINE else keys.readline().encode()
            break
        if patience >= 0:
            host.look_in_vain()
            break
    data, host.typed = host.typed[:size], host.typed[size:]
    return packed(1, data)


def do_has_input(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Whether standard input is readable within the timeout (negative: none)."""
    patience = frame.integer()
    if patience == 0:
        host.look_in_vain()
        return packed(int(bool(host.typed) or host.process.stdin.has_keys()))
    ready = bool(host.typed) or host.process.stdin.wait_for_keys(None if patience < 0 else patience * 1e-9)
    return packed(int(ready))


def do_want_keys(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Handle a terminal set to single keys; with 1 Ctrl-C is also a key."""
    keys = host.process.stdin
    keys.ctrl_c_is_a_key = bool(frame.integer())
    if not keys.by_keys:
        keys.by_keys = True
        host.process.want_keys()


def do_thread(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Handle a thread made on the virtual clock: it gets an execution context, and starts when that is scheduled."""
    host.threads[frame.integer()] = channel = host.accept()[1]
    host.session.spawn(channel.serve)


def do_join(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Wait for the end of a thread, regardless of Ctrl-C: the thread may only end on request."""
    ended = host.threads[frame.integer()].ended
    while not ended.wait():
        pass


def do_block(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Wait for a mutex or a condition variable; 0 after the timeout."""
    address, until = frame.integer(), frame.integer()
    waiter = host.clock.new_waiter()
    waiters = host.blocked.setdefault(address, [])
    waiters.append(waiter)
    woken = waiter.wait(None if until < 0 else until)
    waiters.remove(waiter)
    return packed(int(woken))


def do_unblock(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Wake one or all threads that wait for a mutex or a condition variable."""
    waiters, everyone = host.blocked.get(frame.integer(), []), frame.integer()
    for waiter in waiters[: None if everyone else 1]:
        waiter.notify()


def do_log(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Write a line of a logger, if its level permits it."""
    name, level, text = frame.text(), frame.integer(), frame.text()
    caller = (frame.text(), frame.text(), frame.integer())
    state = logging_state()
    if level < state.effective_level(name):
        return
    stamp = host.clock.now()
    state.write(level, name, text, (caller[0], caller[1], caller[2]), stamp)
    if listener := state.listeners.get(name):
        listener(level, name, text, *caller, stamp)


def do_log_level(_host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Set a logger's level."""
    logging_state().set_level(frame.text(), frame.integer())


def do_logger_level(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the level set for a logger itself."""
    return packed(int(logging_state().level(frame.text())))


def do_effective_level(_host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the effective level of a logger."""
    return packed(int(logging_state().effective_level(frame.text())))
