"""The controller manager: loads, configures and switches controllers, and runs them on the hardware."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import yaml
from rclpy.logging import get_logger
from rclpy.node import Node

from coursekit.files import read_text

from .chains import Chains
from .controller import ControlError, Interfaces, Maker
from .controller_factory import ControllerMaker
from .hardware import ACTIVE, INACTIVE, UNCONFIGURED, Hardware
from .lifecycle import bring
from .loaded_controller import Loaded
from .switching import Switching
from .types import TYPES

if TYPE_CHECKING:
    from rclpy.executors import Executor


class Manager:
    """Controllers and hardware; `node` is the manager's node, `arguments` are for the controllers' nodes."""

    def __init__(
        self, node: Node, executor: Executor, arguments: Sequence[str] = (), makers: Mapping[str, Maker] = TYPES
    ) -> None:
        self.node, self.executor, self.arguments, self.makers = node, executor, list(arguments), makers
        self.log = node.get_logger()
        self.hardware_log = get_logger("resource_manager")
        self.lock = threading.RLock()
        self.hardware: list[Hardware] = []
        self.loaded: dict[str, Loaded] = {}
        self._order: list[Loaded] = []
        """The same, each before those that it commands."""
        self.now_ns = 0
        """The time of the last step [ns]."""
        self._commands: dict[str, dict[str, float]] = {}
        self._states: dict[str, dict[str, float]] = {}
        self.interfaces = Interfaces(self._commands, self._states, self._closed)
        self.rate = float(self._rate())
        self._maker = ControllerMaker(node, executor, makers, self.interfaces, self.rate)

    def _rate(self) -> float:
        if not self.node.has_parameter("update_rate"):
            self.node.declare_parameter("update_rate", 100)
        rate = self.node.get_parameter("update_rate").value
        if not isinstance(rate, (int, float)) or not 0 < rate <= 10_000:
            self.log.error(f"update_rate is {rate}: give one above 0, up to 10000 a second; 100 is taken")
            return 100.0
        return float(rate)

    def add(self, hardware: Hardware) -> None:
        """Add a piece of hardware and bring it to its first state; its interfaces can then be claimed."""
        with self.lock:
            self.hardware.append(hardware)
            self._commands.update(dict.fromkeys(hardware.commands, hardware.commands))
            self._states.update(dict.fromkeys(hardware.states, hardware.states))
            bring(hardware, self._first_state(hardware.info.name), self.hardware_log)

    def _first_state(self, name: str) -> str:
        for state in (UNCONFIGURED, INACTIVE):
            parameter = f"hardware_components_initial_state.{state}"
            if self.node.has_parameter(parameter) and name in (self.node.get_parameter(parameter).value or ()):
                return state
        return ACTIVE

    # -- service requests; each returns its success

    def load(self, name: str) -> bool:
        """Load a controller, whose type is in the parameters."""
        with self.lock:
            self.log.info(f"Loading controller '{name}'")
            if name in self.loaded:
                self.log.error(f"A controller named '{name}' was already loaded inside the controller manager")
                return False
            file = self._told(f"{name}.params_file")
            kind = self._told(f"{name}.type") or _type_in(file, name)
            if not kind:
                self.log.error(f"The 'type' param was not defined for '{name}'.")
                return False
            words = self.arguments + (["--params-file", file] if file else [])
            controller = self._maker.make(name, kind, words)
            if controller is not None:
                self.loaded[name] = Loaded(name, kind, controller)
                self._order.append(self.loaded[name])
            return controller is not None

    def _told(self, name: str) -> str:
        return str(self.node.get_parameter(name).value or "") if self.node.has_parameter(name) else ""

    def configure(self, name: str) -> bool:
        """Configure a loaded controller; an inactive one is cleaned up, and reads its parameters again."""
        with self.lock:
            self.log.info(f"Configuring controller '{name}'")
            loaded = self.loaded.get(name)
            if loaded is None:
                self.log.error(
                    f"Could not configure controller with name '{name}' because no controller with this name exists"
                )
                return False
            if loaded.state == "active":
                self.log.error(f"Controller '{name}' can not be configured from '{loaded.state}' state.")
                return False
            if loaded.state == "inactive":
                self.log.debug(f"Controller '{name}' is cleaned-up before being configured")
                loaded.controller.cleanup()
                self._forget_references(loaded)
                loaded.state = "unconfigured"
            try:
                loaded.controller.configure()
            except ControlError as error:
                _say(loaded, error)
                self.log.error(f"After configuring, controller '{name}' is in state 'unconfigured' , expected inactive.")
                return False
            loaded.state = "inactive"
            self._order = Chains(self.loaded).in_order()
            return self._export_references(loaded)

    def _export_references(self, loaded: Loaded) -> bool:
        """Make a chainable controller's references claimable; False if it has none."""
        if not loaded.controller.chainable:
            return True
        self.log.debug(f"Controller '{loaded.name}' is chainable. Interfaces are being exported to resource manager.")
        if not loaded.controller.references:
            self.log.error(f"Controller '{loaded.name}' is chainable, but does not export any reference interfaces.")
        self._commands.update(dict.fromkeys(loaded.controller.references, loaded.controller.references))
        return bool(loaded.controller.references)

    def _forget_references(self, loaded: Loaded) -> None:
        for name in loaded.controller.references:
            self._commands.pop(name, None)
        loaded.controller.references = {}

    def switch(self, start: Sequence[str], stop: Sequence[str], strict: bool) -> bool:
        """Activate and deactivate; `strict` is all or nothing."""
        with self.lock:
            plan = Switching(self.loaded, self.interfaces, self.log, strict, self._closed()).plan(start, stop)
            if plan is None:
                return False
            claimed = [name for loaded in plan.starting for name in loaded.controller.command_names()]
            released = [name for loaded in plan.stopping for name in loaded.claimed]
            if not self._prepare(claimed, released):
                self.log.error("Could not switch controllers since prepare command mode switch was rejected.")
                return False
            for loaded in plan.stopping:
                self._deactivate(loaded)
            for loaded in (*plan.chained, *plan.unchained):
                self._set_chained(loaded, loaded in plan.chained)
            if not self._perform(claimed, released):
                self.log.error("Error while performing mode switch.")
            done = [self._activate(loaded) for loaded in plan.starting]
            return all(done)

    def _closed(self) -> set[str]:
        """Return the commands and states of hardware that is not configured."""
        closed = [component for component in self.hardware if not component.is_available]
        return {name for component in closed for name in (*component.commands, *component.states)}

    def _set_chained(self, loaded: Loaded, chained: bool) -> None:
        if not loaded.controller.set_chained(chained):
            self.log.error(
                f"Got request to turn {'ON' if chained else 'OFF'} controller '{loaded.name}' in chained mode, "
                "but controller refused to do it! The control will probably not work as expected. "
                "Try to restart all controllers. If the error persist check controllers' individual configuration."
            )

    def _prepare(self, claimed: list[str], released: list[str]) -> bool:
        """Ask the hardware whether commands can be claimed and released."""
        for hardware in self._asked(claimed, released):
            if not hardware.prepare_switch(claimed, released):
                told = _listed("Start", claimed) + _listed("Stop", released)
                text = f"Component '{hardware.info.name}' did not accept new command resource combination: \n {told}"
                self.hardware_log.error(text)
                return False
        return True

    def _perform(self, claimed: list[str], released: list[str]) -> bool:
        for hardware in self._asked(claimed, released):
            if not hardware.perform_switch(claimed, released):
                self.hardware_log.error(f"Component '{hardware.info.name}' could not perform switch")
                return False
        return True

    def _asked(self, claimed: list[str], released: list[str]) -> list[Hardware]:
        """Return the hardware that must agree to a switch: none if no commands are concerned."""
        return [component for component in self.hardware if component.is_available] if claimed or released else []

    def _activate(self, loaded: Loaded) -> bool:
        loaded.controller.now_ns = self.now_ns
        try:
            loaded.controller.activate()
        except ControlError as error:
            _say(loaded, error)
            self.log.error(f"After activating, controller '{loaded.name}' is in state 'inactive' (2), expected active (3).")
            return False
        loaded.state, loaded.claimed = "active", loaded.controller.command_names()
        return True

    def _deactivate(self, loaded: Loaded) -> None:
        loaded.controller.deactivate()
        held = {name for other in self.loaded.values() if other is not loaded for name in other.claimed}
        for hardware in self.hardware:
            if hardware.is_available:
                hardware.released([name for name in loaded.claimed if name in hardware.commands and name not in held])
        loaded.state, loaded.claimed = "inactive", []

    def unload(self, name: str) -> bool:
        """Unload a controller; it must not be active."""
        with self.lock:
            loaded = self.loaded.get(name)
            if loaded is None or loaded.state == "active":
                why = "no controller with this name exists" if loaded is None else "it is still active"
                self.log.error(f"Could not unload controller with name '{name}' because {why}")
                return False
            del self.loaded[name]
            self._order.remove(loaded)
            self._forget_references(loaded)
            loaded.controller.leave(self.executor)
            return True

    # -- work

    def update(self, now_ns: int, dt: float) -> None:
        """Do one step: read, update the active controllers, write."""
        with self.lock:
            self.now_ns = now_ns
            self._exchange("read", dt)
            for loaded in self._order:
                if loaded.state == "active":
                    loaded.controller.now_ns = now_ns
                    loaded.controller.update(now_ns, dt)
            self._exchange("write", dt)

    def _exchange(self, what: str, dt: float) -> None:
        """Read from or write to all hardware; controllers of hardware with an error are deactivated."""
        for hardware in [component for component in self.hardware if component.is_available]:
            hardware.now_ns = self.now_ns
            if getattr(hardware, what)(dt) is False:
                self._deactivate_users(hardware)

    def _deactivate_users(self, hardware: Hardware) -> None:
        names = {*hardware.commands, *hardware.states}
        for loaded in list(self.loaded.values()):
            if loaded.state == "active" and names & {*loaded.claimed, *loaded.controller.state_names()}:
                self._deactivate(loaded)

    def restart(self, now_ns: int) -> None:
        """Restart the active controllers after a reset of time."""
        with self.lock:
            self.now_ns = now_ns
            for loaded in [each for each in self.loaded.values() if each.state == "active"]:
                self._deactivate(loaded)
                self._activate(loaded)

    def close(self) -> None:
        """Remove all nodes from the graph."""
        with self.lock:
            for loaded in list(self.loaded.values()):
                if loaded.state == "active":
                    loaded.controller.deactivate()
                loaded.controller.leave(self.executor)
            self.loaded.clear()
            self._order.clear()
            self.executor.remove_node(self.node)
            self.node.destroy_node()


def _listed(what: str, names: list[str]) -> str:
    return "\n".join([f"{what} interfaces: ", "[", *(f"  {name}" for name in names), "]", ""])


def _say(loaded: Loaded, error: ControlError) -> None:
    """Write the reason of an error, unless the controller has written it."""
    if str(error):
        loaded.controller.log.error(str(error))


def _type_in(file: str, name: str) -> str:
    """Return the type in the controller's own parameter file."""
    if not file:
        return ""
    try:
        data = yaml.safe_load(read_text(file))
        return str(data[name]["ros__parameters"]["type"])
    except (OSError, ValueError, RecursionError, yaml.YAMLError, TypeError, KeyError):
        return ""


__all__ = ["Manager"]
