"""Hardware that is a C++ class of a built package: its program does what a driver in a library does on a robot."""

from __future__ import annotations

import math
import struct

from coursekit.nodes.compiled.classes import Program, check
from coursekit.nodes.compiled.frames import Unpacker

from .description import HardwareInfo
from .hardware import ACTIVE, FINALIZED, INACTIVE, UNCONFIGURED, Hardware

_STATES = ("unknown", UNCONFIGURED, INACTIVE, ACTIVE, FINALIZED)
"""The states by lifecycle_msgs's numbers."""


class Driver(Hardware):
    """A class derived from SystemInterface, ActuatorInterface or SensorInterface.

    `program` is its program, `kind` the class. As on a robot, what ends the program ends this process.
    Raises CppFault when the class cannot be made.
    """

    def __init__(self, info: HardwareInfo, program: str, kind: str) -> None:
        super().__init__(info)
        self.state = _STATES[0]
        self.commands, self.states = {}, {}
        self._program = Program(program, "hardware", kind)
        check(self._program.ask("make"))

    def initialize(self, description: str) -> bool:
        """Call on_init; return whether it succeeded. Raises CppFault."""
        answer = self._program.ask("initialize", self.info.name, description)
        check(answer)
        self._take_numbers(answer)
        return self.state == UNCONFIGURED

    def export(self) -> None:
        """Read the names of the interfaces."""
        answer = self._program.ask("export")
        self.states, self.commands = (
            dict.fromkeys([answer.text() for _ in range(answer.integer())], math.nan) for _ in range(2)
        )
        self._take_numbers(answer)

    def transition(self, name: str) -> None:
        """Call its on_configure, on_activate, on_deactivate, on_cleanup or on_shutdown; on_error after an error."""
        answer = self._program.ask(name)
        try:
            check(answer)
        finally:
            self._take_numbers(answer)

    def prepare_switch(self, start: list[str], stop: list[str]) -> bool:
        """Call prepare_command_mode_switch."""
        return self._switch("prepare", start, stop)

    def perform_switch(self, start: list[str], stop: list[str]) -> bool:
        """Call perform_command_mode_switch."""
        return self._switch("perform", start, stop)

    def _switch(self, what: str, start: list[str], stop: list[str]) -> bool:
        return self._program.ask(what, len(start), *start, len(stop), *stop).integer() == 0

    def read(self, dt: float) -> bool:
        """Call read()."""
        return self._step("read", dt)

    def write(self, dt: float) -> bool:
        """Call write()."""
        return self._step("write", dt)

    def _step(self, what: str, dt: float) -> bool:
        numbers = struct.pack(f"<{len(self.commands)}d", *self.commands.values())
        answer = self._program.ask(what, self.now_ns, round(dt * 1e9), rest=numbers)
        done = answer.integer() == 0
        self._take_numbers(answer)
        return done

    def released(self, names: list[str]) -> None:
        """Do nothing: commands keep their last values."""

    def close(self) -> None:
        """Destroy the object, and end its program."""
        self._program.close()

    def _take_numbers(self, answer: Unpacker) -> None:
        self.state = _STATES[answer.integer()]
        for table in (self.states, self.commands):
            for name in table:
                table[name] = answer.real()


__all__ = ["Driver"]
