"""`ros2 control list_controllers|load_controller|set_controller_state|switch_controllers|...`."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from controller_manager_msgs.srv import ReloadControllerLibraries, SetHardwareComponentState

from coursekit.cli import api, control_lists
from coursekit.nodes.control.manager_client import Asker, NoManager

if TYPE_CHECKING:
    import argparse
    from argparse import Namespace

HELP = {
    "list_controllers": "Output the list of loaded controllers, their type and status",
    "list_controller_types": "Output the available controller types and their base classes",
    "list_hardware_components": "Output the list of available hardware components",
    "list_hardware_interfaces": "Output the list of available command and state interfaces",
    "load_controller": "Load a controller in a controller manager",
    "reload_controller_libraries": "Reload controller libraries",
    "set_controller_state": "Adjust the state of the controller",
    "set_hardware_component_state": "Adjust the state of the hardware component",
    "switch_controllers": "Switch controllers in a controller manager",
    "unload_controller": "Unload a controller in a controller manager",
    "view_controller_chains": "Generates a diagram of the loaded chained controllers",
}
_LOGS = "check controller_manager logs"


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    parser = subparsers.add_parser("control", help="Various control related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    for name, text in HELP.items():
        verb = verbs.add_parser(name, help=text)
        verb.add_argument("-c", "--controller-manager", default="/controller_manager", help="Name of the manager's ROS node")
        verb.add_argument("--include-hidden-nodes", action="store_true", help="Consider hidden nodes as well")
        _OPTIONS.get(name, lambda _: None)(verb)
        verb.set_defaults(main=_with_manager(_VERBS[name]))


def _with_manager(verb: Callable[[Asker, Any], str | None]) -> Callable[[Any], int]:
    def main(args: Namespace) -> int:
        with api.command_node() as node:
            try:
                fault = verb(Asker(node, api.full_name(args.controller_manager), wait=10.0), args)
            except NoManager as error:
                fault = str(error)
        if fault:
            print(fault, file=sys.stderr)
        return int(bool(fault))

    return main


# -- changes


def _load(asker: Asker, args: Namespace) -> str | None:
    if not asker.load(args.controller_name):
        return f"Error loading controller, {_LOGS}"
    if not args.set_state:
        print(f"Successfully loaded controller {args.controller_name}")
        return None
    if not asker.configure(args.controller_name):
        return "Error configuring controller"
    if args.set_state == "active" and not asker.switch([], [args.controller_name]):
        return f"Error activating controller, {_LOGS}"
    print(f"Sucessfully loaded controller {args.controller_name} into state {args.set_state}")  # ROS's spelling
    return None


def _set_state(asker: Asker, args: Namespace) -> str | None:
    name, wanted = args.controller_name, args.state
    state = next((controller.state for controller in asker.controllers() if controller.name == name), None)
    if state is None:
        return f"controller {name} does not seem to be loaded"
    if wanted == "inactive" and state == "unconfigured":
        if not asker.configure(name):
            return f"Error configuring controller, {_LOGS}"
        print(f"Successfully configured {name}")
    elif wanted == "inactive" and state == "active":
        if not asker.switch([name], []):
            return f"Error stopping controller, {_LOGS}"
        print(f"Successfully deactivated {name}")
    elif wanted == "inactive":
        return f"cannot put {name} in 'inactive' state from its current state {state}"
    elif state != "inactive":
        return f"cannot activate {name} from its current state {state}"
    else:
        if not asker.switch([], [name]):
            return f"Error activating controller, {_LOGS}"
        print(f"Successfully activated {name}")
    return None


def _switch(asker: Asker, args: Namespace) -> str | None:
    stop, start = args.deactivate or args.stop, args.activate or args.start
    if not asker.switch(stop, start, args.strict, float(args.switch_timeout)):
        return f"Error switching controllers, {_LOGS}"
    print("Successfully switched controllers")
    return None


def _unload(asker: Asker, args: Namespace) -> str | None:
    if not asker.unload(args.controller_name):
        return f"Error unloading controllers, {_LOGS}"
    print(f"Successfully unloaded controller {args.controller_name}")
    return None


def _reload(asker: Asker, args: Namespace) -> str | None:
    if not asker.ask(ReloadControllerLibraries, "reload_controller_libraries", force_kill=args.force_kill).ok:
        return f"Error reloading libraries, {_LOGS}"
    print("Reload successful")
    return None


def _set_component(asker: Asker, args: Namespace) -> str | None:
    from lifecycle_msgs.msg import State

    target = State(label=args.state)
    name = args.hardware_component_name
    answer = asker.ask(SetHardwareComponentState, "set_hardware_component_state", name=name, target_state=target)
    if not answer.ok:
        return f"Error setting hardware component {name} to {args.state}, {_LOGS}"
    print(f"Successfully set {name} to state {answer.state}")
    return None


def _chains(_asker: Asker, _args: Namespace) -> str:
    return "view_controller_chains draws chained controllers with graphviz: there are none here"


def _name(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("controller_name", help="Name of the controller")


def _list_options(verb: argparse.ArgumentParser) -> None:
    for option in ("claimed-interfaces", "required-state-interfaces", "required-command-interfaces", "chained-interfaces",
                   "reference-interfaces"):  # fmt: skip
        verb.add_argument(f"--{option}", action="store_true", help=f"List controller's {option.replace('-', ' ')}")
    verb.add_argument("-v", "--verbose", action="store_true", help="List all of them")


def _load_options(verb: argparse.ArgumentParser) -> None:
    _name(verb)
    verb.add_argument("--set-state", choices=["inactive", "active"], help="Set the state of the loaded controller")


def _state_options(verb: argparse.ArgumentParser) -> None:
    _name(verb)
    verb.add_argument("state", choices=["inactive", "active"], help="State in which the controller should be changed to")


def _switch_options(verb: argparse.ArgumentParser) -> None:
    for option in ("activate", "deactivate", "start", "stop"):
        verb.add_argument(f"--{option}", nargs="*", default=[], help=f"Names of the controllers to {option}")
    verb.add_argument("--strict", action="store_true", help="Strict switch")
    for option in ("--activate-asap", "--start-asap"):
        verb.add_argument(option, action="store_true", help="Start asap controllers")
    verb.add_argument("--switch-timeout", default=5.0, help="Timeout for switching controllers")


def _component_options(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("hardware_component_name", help="Name of the hardware component to be changed")
    verb.add_argument("state", choices=["unconfigured", "inactive", "active"], help="State in which it should be changed to")


_OPTIONS: dict[str, Callable[[Any], None]] = {
    "list_controllers": _list_options,
    "list_hardware_components": lambda verb: verb.add_argument("-v", "--verbose", action="store_true", help="States, too"),
    "load_controller": _load_options,
    "set_controller_state": _state_options,
    "set_hardware_component_state": _component_options,
    "switch_controllers": _switch_options,
    "unload_controller": _name,
    "reload_controller_libraries": lambda verb: verb.add_argument("--force-kill", action="store_true", help="Stop them"),
}
_VERBS: dict[str, Callable[[Asker, Any], str | None]] = {
    "list_controllers": control_lists.list_controllers,
    "list_controller_types": control_lists.list_types,
    "list_hardware_components": control_lists.list_components,
    "list_hardware_interfaces": control_lists.list_interfaces,
    "load_controller": _load,
    "reload_controller_libraries": _reload,
    "set_controller_state": _set_state,
    "set_hardware_component_state": _set_component,
    "switch_controllers": _switch,
    "unload_controller": _unload,
    "view_controller_chains": _chains,
}
