"""Controllers that are C++ classes of built packages: their programs have the nodes, this process the interfaces."""

from __future__ import annotations

import math
import struct
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from rclpy.logging import get_logger
from rclpy.node import Node

from coursekit.nodes.compiled.classes import CppFault, PluginFault, Program, check, plugins_of, program_of
from coursekit.nodes.compiled.frames import Unpacker

from .controller import ControlError, Controller, Interfaces

if TYPE_CHECKING:
    from rclpy.executors import Executor

_PACKAGE = "controller_interface"
_CHAINABLE = "ChainableControllerInterface"
_BASES = ("ControllerInterface", _CHAINABLE)
_ALL, _INDIVIDUAL = range(2)
"""The numbers of interface_configuration_type; the third is none."""
_INACTIVE, _ACTIVE = 2, 3
"""lifecycle_msgs's numbers."""


class CppController(Controller):
    """A class derived from ControllerInterface or ChainableControllerInterface.

    Raises CppFault when it cannot be made, ControlError when it cannot be initialized.
    """

    def __init__(
        self, path: str, type_: str, chainable: bool, node: Node, name: str, words: Sequence[str], interfaces: Interfaces,
        rate: float,
    ) -> None:  # fmt: skip
        self.interfaces, self.rate, self.now_ns = interfaces, rate, 0
        self.chainable, self.references = chainable, {}
        self.log = get_logger(name)
        self._commands: list[str] = []
        self._states: list[str] = []
        self._every, self._steps = 1, 0
        self._program = Program(path, "controller", type_)
        listed = ["--ros-args", *words] if words else []
        answer = self._program.ask("make", name, node.get_namespace(), len(listed), *listed)
        try:
            check(answer)
            if answer.integer():
                raise ControlError(f"Could not initialize the controller named '{name}'")
        except (CppFault, ControlError):
            self._program.close()
            raise

    def configure(self) -> None:
        """Call on_configure. Raises ControlError."""
        self._go("configure", _INACTIVE)
        answer = self._program.ask("configuration")
        self._commands = _named(answer, self.interfaces.commands)
        self._states = _named(answer, self.interfaces.states)
        own = answer.integer()
        self._every = max(round(self.rate / own), 1) if own else 1
        self.references = {answer.text(): math.nan for _ in range(answer.integer())}

    def set_chained(self, chained: bool) -> bool:
        """Ask whether it takes its references from another controller; whether it does as asked."""
        answer = self._program.ask("chained", int(chained))
        try:
            check(answer)
        except CppFault as fault:
            self.log.error(str(fault))
            return False
        agreed = bool(answer.integer())
        self.chained = chained if agreed else self.chained
        return agreed

    def command_names(self) -> list[str]:
        """Return the commands of its configuration."""
        return self._commands

    def state_names(self) -> list[str]:
        """Return the states of its configuration."""
        return self._states

    def activate(self) -> None:
        """Call on_activate. Raises ControlError."""
        self._steps = 0
        names: list[str | int] = [len(self._states), *self._states, len(self._commands), *self._commands]
        self._go("activate", _ACTIVE, *names, rest=self._numbers())

    def deactivate(self) -> None:
        """Call on_deactivate."""
        self._go("deactivate", _INACTIVE)

    def cleanup(self) -> None:
        """Call on_cleanup."""
        self._go("cleanup", 1)

    def update(self, now_ns: int, dt: float) -> None:
        """Call update(), at its own rate if it has one."""
        self._steps += 1
        if (self._steps - 1) % self._every:
            return
        period = dt if self._every == 1 else self._every / self.rate
        answer = self._program.ask("update", now_ns, round(period * 1e9), rest=self._numbers())
        answer.integer()
        self._take(answer)

    def leave(self, executor: Executor) -> None:
        """End its program, which has its node."""
        self._program.close()

    def _go(self, what: str, goal: int, *words: str | int, rest: bytes = b"") -> None:
        answer = self._program.ask(what, *words, rest=rest)
        try:
            check(answer)
        except CppFault as fault:
            raise ControlError(str(fault)) from None
        state = answer.integer()
        self._take(answer)
        if state != goal:
            raise ControlError("")  # the class has said why

    def _numbers(self) -> bytes:
        values = [*map(self.interfaces.state, self._states), *map(self.interfaces.commanded, self._commands)]
        values += self.references.values() if self.chained else ()
        return struct.pack(f"<{len(values)}d", *values)

    def _take(self, answer: Unpacker) -> None:
        """Write the commands of an answer; before the first activation it has none."""
        if answer.rest():
            for name in self._commands:
                self.interfaces.command(name, answer.real())
            for name in self.references:
                self.references[name] = answer.real()


def _named(answer: Unpacker, everything: Callable[[], list[str]]) -> list[str]:
    kind, names = answer.integer(), [answer.text() for _ in range(answer.integer())]
    return everything() if kind == _ALL else names if kind == _INDIVIDUAL else []


def cpp_types() -> list[str]:
    """Return the names of all C++ controllers. Raises PluginFault."""
    return [name for base in _BASES for name in plugins_of(_PACKAGE, f"{_PACKAGE}::{base}")]


def make_cpp_controller(kind: str, *given: Any) -> CppController | None:
    """Return a controller of a C++ class, None if no package has it. Raises PluginFault, CppFault, ControlError."""
    for base in _BASES:
        if plugin := plugins_of(_PACKAGE, f"{_PACKAGE}::{base}").get(kind):
            return CppController(*program_of(plugin), base == _CHAINABLE, *given)
    return None


__all__ = ["CppController", "CppFault", "PluginFault", "cpp_types", "make_cpp_controller"]
