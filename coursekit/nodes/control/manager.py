"""The controller manager: loads, configures and switches controllers, and runs them on the hardware."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from typing import Any

import yaml
from rclpy.node import Node

from coursekit.files import read_text
from coursekit.urdf.errors import close

from .controller import ControlError, Interfaces, Maker
from .hardware import Hardware
from .switching import Loaded, Switching
from .types import TYPES


class Manager:
    """Controllers and hardware; `node` is the manager's node, `arguments` are for the controllers' nodes."""

    def __init__(
        self, node: Node, executor: Any, arguments: Sequence[str] = (), makers: Mapping[str, Maker] = TYPES
    ) -> None:
        self.node, self.executor, self.arguments, self.makers = node, executor, list(arguments), makers
        self.log = node.get_logger()
        self.lock = threading.RLock()
        self.hardware: list[Hardware] = []
        self.loaded: dict[str, Loaded] = {}
        self.now_ns = 0
        """The time of the last step [ns]."""
        self._commands: dict[str, dict[str, float]] = {}
        self._states: dict[str, dict[str, float]] = {}
        self.interfaces = Interfaces(self._commands, self._states)
        self.rate = float(self._rate())

    def _rate(self) -> float:
        if not self.node.has_parameter("update_rate"):
            self.node.declare_parameter("update_rate", 100)
        rate = self.node.get_parameter("update_rate").value
        if not isinstance(rate, (int, float)) or not 0 < rate <= 10_000:
            self.log.error(f"update_rate is {rate}: give one above 0, up to 10000 a second; 100 is taken")
            return 100.0
        return float(rate)

    def add(self, hardware: Hardware) -> None:
        """Add a piece of hardware; its interfaces can then be claimed."""
        with self.lock:
            self.hardware.append(hardware)
            self._commands.update(dict.fromkeys(hardware.commands, hardware.commands))
            self._states.update(dict.fromkeys(hardware.states, hardware.states))
        self.log.info(f"Loading hardware '{hardware.info.name}' ")
        self.log.info(f"Successful initialization of hardware '{hardware.info.name}'")

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
            if kind not in self.makers:
                self.log.error(f"Loader for controller '{name}' (type '{kind}') not found. {close(kind, self.makers)}")
                return False
            words = self.arguments + (["--params-file", file] if file else [])
            cli = ["--ros-args", *words] if words else []
            space, context = self.node.get_namespace(), self.node.context
            node = Node(name, context=context, namespace=space, cli_args=cli, use_global_arguments=False)
            self.executor.add_node(node)
            self.loaded[name] = Loaded(name, kind, self.makers[kind](node, self.interfaces, self.rate))
            return True

    def _told(self, name: str) -> str:
        return str(self.node.get_parameter(name).value or "") if self.node.has_parameter(name) else ""

    def configure(self, name: str) -> bool:
        """Configure a loaded controller; an inactive one is cleaned up, and reads its parameters again."""
        with self.lock:
            self.log.info(f"Configuring controller '{name}'")
            one = self.loaded.get(name)
            if one is None:
                self.log.error(
                    f"Could not configure controller with name '{name}' because no controller with this name exists"
                )
                return False
            if one.state == "active":
                self.log.error(f"Controller '{name}' can not be configured from '{one.state}' state.")
                return False
            if one.state == "inactive":
                self.log.debug(f"Controller '{name}' is cleaned-up before being configured")
                one.controller.cleanup()
                one.state = "unconfigured"
            try:
                one.controller.configure()
            except ControlError as error:
                one.controller.log.error(str(error))
                self.log.error(f"After configuring, controller '{name}' is in state 'unconfigured' , expected inactive.")
                return False
            one.state = "inactive"
            return True

    def switch(self, start: Sequence[str], stop: Sequence[str], strict: bool) -> bool:
        """Activate and deactivate; `strict` is all or nothing."""
        with self.lock:
            plan = Switching(self.loaded, self.interfaces, self.log, strict).plan(start, stop)
            if plan is None:
                return False
            starting, stopping = plan
            for one in stopping:
                self._deactivate(one)
            done = [self._activate(one) for one in starting]
            return all(done)

    def _activate(self, one: Loaded) -> bool:
        one.controller.now_ns = self.now_ns
        try:
            one.controller.activate()
        except ControlError as error:
            one.controller.log.error(str(error))
            self.log.error(f"After activating, controller '{one.name}' is in state 'inactive' (2), expected active (3).")
            return False
        one.state, one.claimed = "active", one.controller.command_names()
        return True

    def _deactivate(self, one: Loaded) -> None:
        one.controller.deactivate()
        held = {name for other in self.loaded.values() if other is not one for name in other.claimed}
        for hardware in self.hardware:
            gone = [name for name in one.claimed if name in hardware.commands and name not in held]
            hardware.write(0.0)
            hardware.released(gone)
        one.state, one.claimed = "inactive", []

    def unload(self, name: str) -> bool:
        """Unload a controller; it must not be active."""
        with self.lock:
            one = self.loaded.get(name)
            if one is None or one.state == "active":
                why = "no controller with this name exists" if one is None else "it is still active"
                self.log.error(f"Could not unload controller with name '{name}' because {why}")
                return False
            del self.loaded[name]
            self.executor.remove_node(one.controller.node)
            one.controller.close()
            return True

    # -- work

    def update(self, now_ns: int, dt: float) -> None:
        """Do one step: read, update the active controllers, write."""
        with self.lock:
            self.now_ns = now_ns
            for hardware in self.hardware:
                hardware.read(dt)
            for one in list(self.loaded.values()):
                if one.state == "active":
                    one.controller.now_ns = now_ns
                    one.controller.update(now_ns, dt)
            for hardware in self.hardware:
                hardware.write(dt)

    def restart(self, now_ns: int) -> None:
        """Restart the active controllers after a reset of time."""
        with self.lock:
            self.now_ns = now_ns
            for one in [each for each in self.loaded.values() if each.state == "active"]:
                self._deactivate(one)
                self._activate(one)

    def close(self) -> None:
        """Remove all nodes from the graph."""
        with self.lock:
            for one in list(self.loaded.values()):
                if one.state == "active":
                    one.controller.deactivate()
                self.executor.remove_node(one.controller.node)
                one.controller.close()
            self.loaded.clear()
            self.executor.remove_node(self.node)
            self.node.destroy_node()


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
