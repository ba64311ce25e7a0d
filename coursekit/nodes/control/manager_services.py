"""The services of the controller manager."""

from __future__ import annotations

from collections.abc import Iterable

from controller_manager_msgs.msg import ChainConnection, ControllerState, HardwareComponentState, HardwareInterface
from controller_manager_msgs.srv import (
    ConfigureController,
    ListControllers,
    ListControllerTypes,
    ListHardwareComponents,
    ListHardwareInterfaces,
    LoadController,
    ReloadControllerLibraries,
    SetHardwareComponentState,
    SwitchController,
    UnloadController,
)

from .chains import Chains
from .cpp_controller import cpp_types
from .hardware import Hardware
from .lifecycle import bring
from .loaded_controller import Loaded
from .manager import Manager

BASE = "controller_interface::ControllerInterface"
STATES = {1: "unconfigured", 2: "inactive", 3: "active", 4: "finalized"}
_IDS = {label: number for number, label in STATES.items()}


class ManagerServices:
    """The services under `~/`."""

    def __init__(self, manager: Manager) -> None:
        self._manager = manager
        for kind, name, answer in (
            (ListControllers, "list_controllers", self._controllers),
            (ListControllerTypes, "list_controller_types", self._types),
            (ListHardwareComponents, "list_hardware_components", self._components),
            (ListHardwareInterfaces, "list_hardware_interfaces", self._interfaces),
            (LoadController, "load_controller", self._load), (ConfigureController, "configure_controller", self._configure),
            (UnloadController, "unload_controller", self._unload), (SwitchController, "switch_controller", self._switch),
            (ReloadControllerLibraries, "reload_controller_libraries", self._reload),
            (SetHardwareComponentState, "set_hardware_component_state", self._set_component),
        ):  # fmt: skip
            manager.node.create_service(kind, f"~/{name}", answer)

    def _load(self, request: LoadController.Request, answer: LoadController.Response) -> LoadController.Response:
        answer.ok = self._manager.load(request.name)
        return answer

    def _configure(
        self, request: ConfigureController.Request, answer: ConfigureController.Response
    ) -> ConfigureController.Response:
        answer.ok = self._manager.configure(request.name)
        return answer

    def _unload(self, request: UnloadController.Request, answer: UnloadController.Response) -> UnloadController.Response:
        answer.ok = self._manager.unload(request.name)
        return answer

    def _switch(self, request: SwitchController.Request, answer: SwitchController.Response) -> SwitchController.Response:
        start = [*request.activate_controllers, *request.start_controllers]
        stop = [*request.deactivate_controllers, *request.stop_controllers]
        answer.ok = self._manager.switch(start, stop, request.strictness == SwitchController.Request.STRICT)
        return answer

    def _reload(
        self, request: ReloadControllerLibraries.Request, answer: ReloadControllerLibraries.Response
    ) -> ReloadControllerLibraries.Response:
        busy = [name for name, loaded in self._manager.loaded.items() if loaded.state == "active"]
        if busy and not request.force_kill:
            self._manager.log.error("Cannot reload controller libraries because there are active controllers")
            return answer
        self._manager.switch([], busy, strict=False)
        gone = [self._manager.unload(name) for name in list(self._manager.loaded)]
        answer.ok = all(gone)
        return answer

    def _controllers(self, _request: ListControllers.Request, answer: ListControllers.Response) -> ListControllers.Response:
        for name, loaded in self._manager.loaded.items():
            msg = ControllerState(name=name, state=loaded.state, type=loaded.type, claimed_interfaces=loaded.claimed)
            msg.is_chainable, msg.is_chained = loaded.controller.chainable, loaded.controller.chained
            if loaded.is_configured:
                msg.required_command_interfaces = loaded.controller.command_names()
                msg.required_state_interfaces = loaded.controller.state_names()
                msg.reference_interfaces = [_without_owner(reference) for reference in loaded.controller.references]
                msg.chain_connections = self._connections(loaded)
            answer.controller.append(msg)
        return answer

    def _connections(self, loaded: Loaded) -> list[ChainConnection]:
        following = Chains(self._manager.loaded).following(loaded)
        return [
            ChainConnection(name=follower.name, reference_interfaces=[_without_owner(command) for command in commands])
            for follower, commands in following.items()
        ]

    def _types(
        self, _request: ListControllerTypes.Request, answer: ListControllerTypes.Response
    ) -> ListControllerTypes.Response:
        answer.types = sorted({*self._manager.makers, *cpp_types()})
        answer.base_classes = [BASE] * len(answer.types)
        return answer

    def _interfaces(
        self, _request: ListHardwareInterfaces.Request, answer: ListHardwareInterfaces.Response
    ) -> ListHardwareInterfaces.Response:
        for hardware in self._manager.hardware:
            answer.command_interfaces += self._told(hardware, list(hardware.commands))
            answer.state_interfaces += self._told(hardware, list(hardware.states))
        for loaded in self._manager.loaded.values():
            answer.command_interfaces += self._interfaces_named(loaded.controller.references, loaded.controller.chained)
        return answer

    def _told(self, hardware: Hardware, names: list[str]) -> list[HardwareInterface]:
        return self._interfaces_named(names, hardware.is_available)

    def _interfaces_named(self, names: Iterable[str], there: bool) -> list[HardwareInterface]:
        claimed = {name for loaded in self._manager.loaded.values() for name in loaded.claimed}
        return [HardwareInterface(name=name, is_available=there, is_claimed=name in claimed) for name in names]

    def _components(
        self, _request: ListHardwareComponents.Request, answer: ListHardwareComponents.Response
    ) -> ListHardwareComponents.Response:
        for hardware in self._manager.hardware:
            info = hardware.info
            msg = HardwareComponentState(name=info.name, type=info.kind, class_type=info.plugin)
            msg.state.id, msg.state.label = _IDS.get(hardware.state, 0), hardware.state
            msg.command_interfaces = self._told(hardware, list(hardware.commands))
            msg.state_interfaces = self._told(hardware, list(hardware.states))
            answer.component.append(msg)
        return answer

    def _set_component(
        self, request: SetHardwareComponentState.Request, answer: SetHardwareComponentState.Response
    ) -> SetHardwareComponentState.Response:
        component = next((each for each in self._manager.hardware if each.info.name == request.name), None)
        target = request.target_state.label or STATES.get(request.target_state.id, "")
        if component is None:
            self._manager.log.error(f"hardware component with name '{request.name}' does not exist")
            return answer
        if target not in _IDS:
            self._manager.log.error(f"hardware component with name '{request.name}' cannot be brought to '{target}'")
            return answer
        with self._manager.lock:
            answer.ok = bring(component, target, self._manager.hardware_log)
        answer.state.label, answer.state.id = component.state, _IDS.get(component.state, 0)
        return answer


def _without_owner(reference: str) -> str:
    """Return a reference's name without that of its controller, as messages have it."""
    return reference.partition("/")[2]


__all__ = ["ManagerServices"]
