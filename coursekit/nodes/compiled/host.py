"""A compiled rclcpp program as a process of the session: `host.py PROGRAM ARGUMENTS...`.

The program is a child of the system. Each of its threads has one connection and, here, one execution context that
represents it. While the thread computes, the context waits for it. While the thread sleeps or spins, the context does
so instead.
"""

from __future__ import annotations

import contextvars
import os
import re
import signal
import socket
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rclpy.context import Context
from rclpy.exceptions import NotInitializedException, ParameterException
from rclpy.signals import shutdown_all
from rclpy.utilities import get_default_context

from coursekit.core.ready_queue import ReadyQueue
from coursekit.cpp.age import is_of_another_age
from coursekit.nodes.compiled import (
    actions,
    arrival_callbacks,
    bags,
    calibrations,
    components,
    entities,
    executors,
    graph,
    hardware,
    lifecycle,
    parameters,
    plugins,
    program,
    robot_descriptions,
    shared_objects,
    topics,
    transforms,
    tree_nodes,
    vision,
    waitables,
    waiting,
    yaml_nodes,
)
from coursekit.nodes.compiled.channel import Channel, Gone
from coursekit.nodes.compiled.child import Child
from coursekit.nodes.compiled.frames import Unpacker
from coursekit.nodes.compiled.program_address import open_listener
from coursekit.nodes.compiled.workers import Workers
from coursekit.processes.executables import is_compiled_here
from coursekit.processes.process import ProcessKilled, current_process
from coursekit.processes.session import current

if TYPE_CHECKING:
    from coursekit.core.clock import Event
    from coursekit.nodes.compiled.embedded_program import EmbeddedProgram

VIRTUAL, STOPPING, SIMULATED = 1, 2, 4
_LAST_WORDS_S = 1.0
_COMPUTE_LIMIT_S = 60.0
_IDLE_WEIGHT = 250
"""The weight of a request without a result: a loop of them passes a second of virtual time in 4000 iterations."""
_TOO_LONG = (
    "[coursekit] {name} has computed for {limit:g} s without asking rclcpp for anything, and was killed: virtual time "
    "does not advance meanwhile. Let its loops sleep or spin; COURSEKIT_COMPUTE_LIMIT=SECONDS gives it longer.\n"
)
ANOTHER_AGE = (
    "[coursekit] {name} was built by another version of coursekit than this one, and cannot talk with it. Build its "
    "workspace again: `colcon build`."
)
_ERRORS = {
    "InvalidNodeNameException": "InvalidNodeNameError",
    "InvalidNamespaceException": "InvalidNamespaceError",
    "InvalidTopicNameException": "InvalidTopicNameError",
    "InvalidServiceNameException": "InvalidServiceNameError",
    "UnsupportedEventTypeError": "UnsupportedEventTypeException",
    "InvalidQosOverridesError": "InvalidQosOverridesException",
    "UnknownROSArgsError": "RCLInvalidROSArgsError",
}
_NOT_VALID = (
    "failed to create guard condition: the given context is not valid, either rcl_init() was not called or rcl_shutdown() "
    "was called., at ./src/rcl/guard_condition.c:67"
)
"""rclcpp's messages for nodes and executors made before init() or after shutdown()."""
_ROOMS = (
    program, entities, topics, graph, parameters, executors, waiting, waitables, lifecycle, arrival_callbacks, actions,
    transforms, vision, bags, plugins, robot_descriptions, calibrations, components, hardware, shared_objects, tree_nodes,
    yaml_nodes,
)  # fmt: skip
OPERATIONS = {name[3:]: do for room in _ROOMS for name, do in vars(room).items() if name.startswith("do_")}


class Host:
    """One compiled program: its child process, its channels, and its objects in the session."""

    def __init__(self, path: str, argv: list[str]) -> None:
        self.path, self.argv = path, argv
        self.session = current()
        self.clock = self.session.clock
        process = current_process()
        assert process is not None, "a compiled program runs in a process of the session"
        self.process = process
        self.node_clocks: list[Any] = []
        """The clocks of the program's nodes, some of which may follow /clock."""
        self.stopping = False
        """Whether Ctrl-C or `kill` was received."""
        self.things: dict[int, Any] = {}
        """The program's objects, by number."""
        self.of_context: dict[Any, Channel] = {}
        self.threads: dict[int, Channel] = {}
        """The channels of threads made by the program on the virtual clock, by its own numbers."""
        self.blocked: dict[int, list[Any]] = {}
        """The threads that wait on the virtual clock for a mutex or condition variable, by its address."""
        self.seen: list[tuple[Any, ...]] = []
        """The movements of sliders and the mouse in the program's windows that it was not told of yet."""
        self.typed = b""
        """The typed characters not read yet."""
        self.over = False
        """Whether the program has ended."""
        self.waiting: list[ReadyQueue] = []
        """The queues of the currently waiting wait sets."""
        self.contexts: dict[int, Context] = {}
        """The contexts made by the program in addition to the default one, by its own numbers."""
        self.own_gids: set[bytes] = set()
        """This program's publishers, for subscriptions that ignore them."""
        self.staying_gids: set[bytes] = set()
        """Those publishers whose messages may stay in the program."""
        self.news = arrival_callbacks.News(self)
        self.context = contextvars.copy_context()
        self.served: EmbeddedProgram | None = None
        """What the program carries out requests for, if it is a part of a process of Python."""
        self.caught: set[int] = set()
        """Signals that interrupt the program's waiting, and do not end the program."""
        self._lock = threading.Lock()
        self._channels: list[Channel] = []
        self._workers = Workers(self.clock, lambda: self.accept()[1])

    @property
    def flags(self) -> int:
        """The header of every frame to the program."""
        simulated = any(clock.ros_time_is_active for clock in self.node_clocks)
        return VIRTUAL * self.clock.virtual | STOPPING * self.stopping | SIMULATED * simulated

    # -- the child

    def run(self) -> int:
        """Run the program to its end. Returns its exit code, negative if a signal ended it."""
        self._listener = open_listener()
        try:
            self._child = Child([self.path, *self.argv], self._listener.address, self.process, self._workers.tell_signal)
            self.output = self._child.output
            self._begin_signals()
            self.process.cleanups.append(self._child.kill)
            return self._stand_for_it() if self.clock.virtual else self._stand_by()
        finally:
            self._listener.close()

    def _begin_signals(self) -> None:
        for number in (signal.SIGINT, signal.SIGTERM):
            self.process.handlers[number] = self._on_signal

    def _stand_for_it(self) -> int:
        """Represent the program on the virtual clock: one action at a time, in a fixed order."""
        if self.output.wait_for(self._listener.listening):
            self.accept()[1].serve()
        self.over = True
        code = self._child.wait()
        self.output.drain()
        self._workers.end()
        return code

    def _stand_by(self) -> int:
        ended = self.clock.new_event()
        self.session.spawn(self._accept_all)
        self.session.spawn(self._watch, ended)
        ended.wait()
        self.over = True
        self._wake()
        for channel in list(self._channels):  # its last requests must still be carried out
            channel.ended.wait(_LAST_WORDS_S)
        self._listener.close()
        self._workers.end()
        return self._child.wait()

    def _watch(self, ended: Event) -> None:
        self.output.pass_all_on()
        self._child.wait()
        ended.set()

    def accept(self) -> tuple[bytes, Channel]:
        """Return the next connection: its purpose and its channel."""
        connection = self._listener.accept()
        purpose = connection.recv(1)
        if purpose == b"C":
            self._workers.ask_by(connection)
            return self.accept()
        return purpose, Channel(self, connection)

    def _accept_all(self) -> None:
        while True:
            try:
                purpose, channel = self.accept()
            except OSError:
                return
            if purpose == b"W":
                self._workers.welcome(channel)
            else:
                self._channels.append(channel)
                self.session.spawn(channel.serve)

    def _on_signal(self, signum: int, _frame: object) -> None:
        if signum in self.caught:
            self.context.copy().run(program.tell_signal, self, signum)  # first, as on a robot: woken threads print too
        self.stopping = True
        self._wake()
        self._child.send(signum)
        self.context.copy().run(shutdown_all)  # the delivering thread may not belong to this process

    def _wake(self) -> None:
        """Wake threads that wait on behalf of the program."""
        self.process.stdin.wake()
        for queue in list(self.waiting):
            queue.wake()

    def wait_for(self, connection: socket.socket) -> None:
        """Wait in real time while the program computes: virtual time does not advance. An endless computation is ended."""
        limit = float(self.process.env.get("COURSEKIT_COMPUTE_LIMIT") or _COMPUTE_LIMIT_S)
        try:
            self.output.wait_for(connection, limit)
        except TimeoutError:
            self.process.out.write("stderr", _TOO_LONG.format(name=os.path.basename(self.path), limit=limit))
            self._child.kill()
            raise Gone from None

    # -- requests

    def carry_out(self, channel: Channel, name: str, frame: Unpacker) -> bytes:
        """Carry out a request. Returns the packed response."""
        answer: bytes | None = OPERATIONS[name](self, channel, frame)
        return answer or b""

    def refusal(self, error: Exception) -> tuple[str, str]:
        """Return the name and text of rclcpp's exception for one of rclpy's."""
        name = type(error).__name__
        if isinstance(error, NotInitializedException):
            return _ERRORS.get(name, name), _NOT_VALID
        text = parameters.told(error) if isinstance(error, ParameterException) else str(error)
        return _ERRORS.get(name, name), re.sub(r"^[Ff]ailed to create(?= (action )?\w+: )", "could not create", text)

    def context_called(self, number: int) -> Context:
        """Return the program's context of that number; 0 is the default one."""
        return self.contexts.setdefault(number, Context()) if number else get_default_context()

    def look_in_vain(self) -> None:
        """Handle a request without a result: on the virtual clock, a loop of them lets time pass."""
        self.clock.poll(_IDLE_WEIGHT)

    def keep(self, thing: object) -> int:
        """Register an object made by the program. Returns its number."""
        with self._lock:
            number = len(self.things) + 1
            while number in self.things:
                number += 1
            self.things[number] = thing
            return number

    def call(self, handler: int, data: bytes = b"") -> Unpacker:
        """Call a callback of the program in the thread of the running context, else in a worker thread."""
        channel = self.of_context.get(self.session.execution_context())
        if channel is not None:
            return channel.call(handler, data)
        channel = self._workers.take()
        self.of_context[self.session.execution_context()] = channel
        try:
            return channel.call(handler, data)
        finally:
            self.of_context.pop(self.session.execution_context(), None)
            self._workers.put_back(channel)


def main(argv: list[str]) -> int:
    """Run a compiled program in a process of the session. Returns its exit code."""
    for word in argv:
        if os.path.isfile(word) and is_compiled_here(Path(word)) and is_of_another_age(Path(word)):
            print(ANOTHER_AGE.format(name=os.path.basename(word)), file=sys.stderr)
            return 1
    code = Host(argv[0], argv[1:]).run()
    if code < 0:
        raise ProcessKilled(-code)
    return code


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
