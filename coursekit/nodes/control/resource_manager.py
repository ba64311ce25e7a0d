"""The hardware of a robot's description: mock hardware, and the C++ classes of built packages."""

from __future__ import annotations

from typing import TYPE_CHECKING

from coursekit.nodes.compiled.classes import CppFault, PluginFault, plugins_of, program_of

from .description import HardwareInfo
from .driver import Driver
from .hardware import MOCKS, GenericSystem, Hardware

if TYPE_CHECKING:
    from rclpy.impl.rcutils_logger import RcutilsLogger

_BASE = "hardware_interface::{}Interface"


class WrongInterfaces(Exception):
    """Hardware without all interfaces of its description; the message is the resource manager's."""


def load(info: HardwareInfo, description: str, log: RcutilsLogger) -> Hardware | None:
    """Make and initialize hardware; None, with log messages, if that fails. Raises WrongInterfaces."""
    log.info(f"Loading hardware '{info.name}' ")
    try:
        hardware = GenericSystem(info) if info.plugin in MOCKS else Driver(info, *_program(info))
    except (PluginFault, CppFault) as fault:
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


def _initialize(hardware: Driver, description: str, log: RcutilsLogger) -> bool:
    info = hardware.info
    try:
        if hardware.initialize(description):
            log.info(f"Successful initialization of hardware '{info.name}'")
            return True
        log.info(f"Failed to initialize hardware '{info.name}'")
    except CppFault as fault:
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
    base = _BASE.format(info.kind.capitalize())
    known = plugins_of("hardware_interface", base)
    if info.plugin in known:
        return program_of(known[info.plugin])
    raise PluginFault(
        "LibraryLoadException",
        f"According to the loaded plugin descriptions the class {info.plugin} with base class type {base} does not exist. "
        f"Declared types are  {' '.join([*MOCKS, *known])}. If {info.plugin} is the driver of a device, build its "
        "package and source its workspace; in a simulation the robot's plugin gazebo_ros2_control or gz_ros2_control is the "
        "manager: spawn the robot.",
    )


__all__ = ["WrongInterfaces", "load"]
