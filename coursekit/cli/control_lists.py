"""The output of `ros2 control list_...`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from controller_manager_msgs.srv import ListControllerTypes, ListHardwareComponents, ListHardwareInterfaces

from coursekit.nodes.control.manager_client import Asker

if TYPE_CHECKING:
    from argparse import Namespace


def list_controllers(asker: Asker, args: Namespace) -> None:
    """Print the loaded controllers, and the interfaces they claim."""
    for controller in asker.controllers():
        chained = [name for connection in controller.chain_connections for name in connection.reference_interfaces]
        print(f"{controller.name:20s}[{controller.type:20s}] {controller.state:10s}")
        for title, flag, names in (
            ("claimed interfaces", args.claimed_interfaces, controller.claimed_interfaces),
            ("required command interfaces", args.required_command_interfaces, controller.required_command_interfaces),
            ("required state interfaces", args.required_state_interfaces, controller.required_state_interfaces),
            ("chained to interfaces", args.chained_interfaces, [f"{name:20s}" for name in chained]),
            ("exported reference interfaces", args.reference_interfaces, controller.reference_interfaces),
        ):
            if flag or args.verbose:
                print(f"\t{title}:")
                for name in names:
                    print(f"\t\t{name}")


def list_types(asker: Asker, _args: Namespace) -> None:
    """Print the controller types that can be loaded."""
    answer = asker.ask(ListControllerTypes, "list_controller_types")
    for name, base in zip(answer.types, answer.base_classes, strict=True):
        print(f"{name:70s} {base}")


def list_interfaces(asker: Asker, _args: Namespace) -> None:
    """Print the command and state interfaces."""
    answer = asker.ask(ListHardwareInterfaces, "list_hardware_interfaces")
    print("command interfaces")
    for interface in sorted(answer.command_interfaces, key=lambda interface: str(interface.name)):
        claimed = "claimed" if interface.is_claimed else "unclaimed"
        print(f"\t{interface.name} [{'available' if interface.is_available else 'unavailable'}] [{claimed}]")
    print("state interfaces")
    for interface in sorted(answer.state_interfaces, key=lambda interface: str(interface.name)):
        print(f"\t{interface.name}")


def list_components(asker: Asker, args: Namespace) -> None:
    """Print the hardware components."""
    answer = asker.ask(ListHardwareComponents, "list_hardware_components")
    for number, component in enumerate(answer.component, 1):
        print(f"Hardware Component {number}\n\tname: {component.name}\n\ttype: {component.type}")
        print(f"\tplugin name: {component.class_type}")
        print(f"\tstate: id={component.state.id} label={component.state.label}\n\tcommand interfaces")
        for each in component.command_interfaces:
            words = "available" if each.is_available else "unavailable", "claimed" if each.is_claimed else "unclaimed"
            print(f"\t\t{each.name} [{words[0]}] [{words[1]}]")
        if args.verbose:
            print("\tstate interfaces")
            for each in component.state_interfaces:
                print(f"\t\t{each.name} [{'available' if each.is_available else 'unavailable'}]")
