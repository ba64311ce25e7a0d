"""The hardware of a robot's description: mock hardware, and the C++ classes of built packages."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from coursekit.cpp.age import is_of_another_age
from coursekit.nodes.compiled.host import ANOTHER_AGE
from coursekit.nodes.compiled.plugins import InvalidManifest, Plugin, declared
from coursekit.processes.executables import prefix_of
from coursekit.systems.layout import executable_files

from .description import HardwareInfo
from .driver import Driver
from .hardware import MOCKS, GenericSystem, Hardware, HardwareFault

_BASE = "hardware_interface::{}Interface"


class WrongInterfaces(Exception):
    """Hardware without all interfaces of its description; the message is the resource manager's."""


class PluginFault(Exception):
    """A class that cannot be loaded: pluginlib's exception and its text."""

    def __init__(self, kind: str, text: str) -> None:
        super().__init__(text)
        self.kind = f"pluginlib::{kind}"


def load(info: HardwareInfo, description: str, log: Any) -> Hardware | None:
    """Make and initialize hardware; None, with log messages, if that fails. Raises WrongInterfaces."""
    log.info(f"Loading hardware '{info.name}' ")
    try:
        hardware = GenericSystem(info) if info.plugin in MOCKS else Driver(info, *_program(info))
    except (PluginFault, HardwareFault) as fault:
        log.error(f"Caught exception of type : {fault.kind} while loading hardware '{info.name}': {fault}")
        return None
    log.info(f"Initialize hardware '{info.name}' ")
    if isinstance(hardware, Driver):
        if not _initialize(hardware, description, log):
            hardware.close()
            _check(hardware)
            return None
        hardware.export()
        try:
            _check(hardware)
        except WrongInterfaces:
            hardware.close()
            raise
    return hardware


def _initialize(hardware: Driver, description: str, log: Any) -> bool:
    info = hardware.info
    try:
        if hardware.initialize(description):
            log.info(f"Successful initialization of hardware '{info.name}'")
            return True
        log.info(f"Failed to initialize hardware '{info.name}'")
    except HardwareFault as fault:
        log.error(f"Exception of type : {fault.kind} occurred while initializing hardware '{info.name}': {fault}")
    what = f"{info.kind.capitalize()} hardware component '{info.name}' from plugin '{info.plugin}'"
    log.warning(f"{what} failed to initialize.")
    return False


def _check(hardware: Hardware) -> None:
    """Raise WrongInterfaces unless all interfaces of the description are exported."""
    missing = {
        which: [name for name in hardware.info.interfaces(which) if name not in there]
        for which, there in (("states", hardware.states), ("commands", hardware.commands))
    }
    if any(missing.values()):
        states, commands = ("".join(f"' {name} '\t" for name in names) for names in missing.values())
        raise WrongInterfaces(
            "Wrong state or command interface configuration.\n"
            f"missing state interfaces:\n{states}\nmissing command interfaces:\n{commands}"
        )


def _program(info: HardwareInfo) -> tuple[str, str]:
    """Return the program that has the class of some hardware, and the class. Raises PluginFault."""
    plugin = _plugin(info)
    stem = Path(plugin.library).name.removesuffix(".dylib").removesuffix(".so").removeprefix("lib")
    folder = prefix_of(plugin.package) / "lib" / plugin.package
    for path in executable_files(folder, f"__hardware_{stem}"):
        if path.is_file() and is_of_another_age(path):
            raise PluginFault("LibraryLoadException", ANOTHER_AGE.format(name=plugin.library))
        if path.is_file():
            return str(path), plugin.type
    raise PluginFault(
        "LibraryLoadException",
        f"Could not find library corresponding to plugin {info.plugin}. Make sure that the library '{plugin.library}' "
        "actually exists.",
    )


def _plugin(info: HardwareInfo) -> Plugin:
    base = _BASE.format(info.kind.capitalize())
    try:
        known = {one.name: one for one in declared("hardware_interface", base)}
    except InvalidManifest as fault:
        raise PluginFault("InvalidXMLException", str(fault)) from None
    if info.plugin in known:
        return known[info.plugin]
    raise PluginFault(
        "LibraryLoadException",
        f"According to the loaded plugin descriptions the class {info.plugin} with base class type {base} does not exist. "
        f"Declared types are  {' '.join([*MOCKS, *known])}. If {info.plugin} is the driver of a device, build its "
        "package and source its workspace; in a simulation the robot's plugin gazebo_ros2_control or gz_ros2_control is the "
        "manager: spawn the robot.",
    )


__all__ = ["WrongInterfaces", "load"]
