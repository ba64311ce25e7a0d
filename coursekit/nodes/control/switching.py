"""Which controllers can be started and stopped together: they must exist, and their interfaces must be free."""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from coursekit.urdf.errors import close

from .chains import Chains, ChainSwitch
from .controller import Interfaces
from .loaded_controller import Loaded

if TYPE_CHECKING:
    from rclpy.impl.rcutils_logger import RcutilsLogger


@dataclass
class Plan:
    """What a switch does: who starts and stops, and whose mode changes in between."""

    starting: list[Loaded]
    stopping: list[Loaded]
    chained: list[Loaded] = field(default_factory=list)
    """Those that another controller commands from then on."""
    unchained: list[Loaded] = field(default_factory=list)


class Switching:
    """One switch; a `strict` one is done completely or not at all. `closed` are the interfaces that are not available."""

    def __init__(
        self,
        loaded: Mapping[str, Loaded],
        interfaces: Interfaces,
        log: RcutilsLogger,
        strict: bool,
        closed: Set[str] = frozenset(),
    ) -> None:
        self._loaded, self._interfaces, self._log, self._strict = loaded, interfaces, log, strict
        self._closed = closed

    def plan(self, start: Sequence[str], stop: Sequence[str]) -> Plan | None:
        """Return what to do; None, with a log message, if it is impossible."""
        stopping = self._fitting(stop, "active", "deactivate")
        starting = self._fitting(start, "inactive", "activate")
        if stopping is None or starting is None:
            return None
        switch = ChainSwitch(Chains(self._loaded), self._log, starting, stopping)
        if not switch.drop(self._strict):
            return None
        switch.restart()
        held = {name for loaded in self._loaded.values() if loaded not in stopping for name in loaded.claimed}
        free = self._free(starting, held)
        return None if free is None else Plan(free, stopping, switch.chained, switch.unchained)

    def _fitting(self, names: Sequence[str], state: str, what: str) -> list[Loaded] | None:
        fitting = []
        for name in names:
            loaded = self._loaded.get(name)
            if loaded is not None and loaded.state == state:
                fitting.append(loaded)
                continue
            why = "no controller with this name exists" if loaded is None else f"it is not {state}"
            text = f"Could not '{what}' controller with name '{name}' because {why}"
            (self._log.error if self._strict else self._log.warning)(text)
            if self._strict:
                return None
        return fitting

    def _free(self, starting: list[Loaded], held: set[str]) -> list[Loaded] | None:
        """Return those whose interfaces exist and are free."""
        free = []
        for loaded in starting:
            wanted = loaded.controller.command_names()
            fault = self._missing(loaded, wanted, held)
            if not fault:
                held |= set(wanted)
                free.append(loaded)
                continue
            self._log.error(fault)
            if self._strict:
                return None
        return free

    def _missing(self, loaded: Loaded, wanted: list[str], held: set[str]) -> str:
        for kind, names, there in (
            ("command", wanted, self._interfaces.commands()),
            ("state", loaded.controller.state_names(), self._interfaces.states()),
        ):
            for name in names:
                if kind == "command" and name in held:
                    return (
                        f"Resource conflict for controller '{loaded.name}'. Command interface '{name}' is already claimed."
                    )
                if name not in there:
                    hint = close(name, there)
                    return f"Can't activate controller '{loaded.name}': {kind} interface '{name}' does not exist. {hint}"
                if name in self._closed:
                    return f"Can't activate controller '{loaded.name}': {kind} interface '{name}' is not available."
        return ""


__all__ = ["Plan", "Switching"]
