"""`ros2 run controller_manager spawner NAME ...`: loads, configures and activates controllers."""

from __future__ import annotations

import argparse
import os
import sys
from typing import Any

import rclpy
from rcl_interfaces.msg import Parameter as ParameterMessage
from rcl_interfaces.msg import ParameterType, ParameterValue
from rcl_interfaces.srv import SetParameters
from rclpy.node import Node
from rclpy.signals import SignalHandlerOptions
from rclpy.utilities import remove_ros_args

from .manager_client import Asker, NoManager


def arguments(argv: list[str]) -> argparse.Namespace:
    """Parse the command line; an error ends the program with status 2."""
    parser = argparse.ArgumentParser(prog="spawner", description="Load, configure and activate controllers.")
    parser.add_argument("controller_names", nargs="+", help="List of controllers")
    parser.add_argument("-c", "--controller-manager", default="controller_manager", help="Name of the manager's ROS node")
    parser.add_argument("-p", "--param-file", action="append", help="Controller param file to be loaded before configure")
    parser.add_argument("-n", "--namespace", default="", help="Namespace for the controller")
    parser.add_argument("-t", "--controller-type", default="", help="If not provided, the manager's parameters have it")
    parser.add_argument("--load-only", action="store_true", help="Only load the controller and leave unconfigured.")
    for name in ("--stopped", "--inactive"):
        parser.add_argument(name, action="store_true", dest="inactive", help="Load and configure, do not activate")
    parser.add_argument("-u", "--unload-on-kill", action="store_true", help="Wait until interrupted and unload controller")
    for name, usual in (("--controller-manager-timeout", 10.0), ("--switch-timeout", 5.0), ("--service-call-timeout", 10.0)):
        parser.add_argument(name, type=float, default=usual, help="seconds")
    parser.add_argument("--activate-as-group", action="store_true", help="Activate all controllers together")
    parser.add_argument("--switch-asap", action=argparse.BooleanOptionalAction, default=False, help="accepted")
    parser.add_argument("--controller-ros-args", action="append", help="accepted")
    parser.add_argument("--ros-args", nargs="*", help=argparse.SUPPRESS)
    return parser.parse_args(argv)


class Spawner:
    """Brings controllers to the state set by the arguments."""

    def __init__(self, node: Node, told: argparse.Namespace) -> None:
        self.node, self.told, self.log = node, told, node.get_logger()
        name, space = told.controller_manager, (told.namespace or node.get_namespace()).strip("/")
        if not name.startswith("/"):
            name = f"/{space}/{name}" if space else f"/{name}"
        self.manager = name
        self.asker = Asker(node, name, told.controller_manager_timeout)

    def run(self) -> int:
        """Run all steps. Returns 0, or 1 after a failed step."""
        if not self._wait():
            return 1
        names = list(dict.fromkeys(self.told.controller_names))
        for name in names:
            if not self._bring(name):
                return 1
        if self.told.activate_as_group and not self.told.inactive and not self.told.load_only:
            if not self.asker.switch([], names, timeout=self.told.switch_timeout):
                self.log.error("Failed to activate the parsed controllers list")
                return 1
            self.log.info("Configured and activated all the parsed controllers list!")
        return 0

    def _wait(self) -> bool:
        begun, said = self.node.get_clock().now().nanoseconds, -2e9
        while not any(self._full(namespace) == self.manager for namespace in self.node.get_node_names_and_namespaces()):
            waited = self.node.get_clock().now().nanoseconds - begun
            if waited - said >= 2e9:
                said = waited
                self.log.info(f"Waiting for '{self.manager}' node to exist")
            if 0 < self.told.controller_manager_timeout * 1e9 <= waited:
                self.log.error(
                    "Controller manager not available: no ros2_control_node runs, and no robot was spawned whose "
                    "gazebo_ros2_control plugin is one"
                )
                return False
            rclpy.spin_once(self.node, timeout_sec=0.1)
        return True

    @staticmethod
    def _full(name_and_space: tuple[str, str]) -> str:
        name, space = name_and_space
        return f"{space.rstrip('/')}/{name}"

    def _bring(self, name: str) -> bool:
        if any(controller.name == name for controller in self.asker.controllers()):
            self.log.warning("Controller already loaded, skipping load_controller")
        else:
            if not self._set_parameters(name):
                return False
            if not self.asker.load(name):
                self.log.fatal(f"Failed loading controller {name}")
                return False
            self.log.info(f"Loaded {name}")
        if self.told.load_only:
            return True
        if not self.asker.configure(name):
            self.log.error("Failed to configure controller")
            return False
        if self.told.inactive or self.told.activate_as_group:
            return True
        if not self.asker.switch([], [name], timeout=self.told.switch_timeout):
            self.log.error("Failed to activate controller")
            return False
        self.log.info(f"Configured and activated {name}")
        return True

    def _set_parameters(self, name: str) -> bool:
        wanted = {"type": self.told.controller_type}
        if self.told.param_file:
            wanted["params_file"] = os.path.abspath(self.told.param_file[-1])
        for key, value in wanted.items():
            if not value:
                continue
            text = ParameterValue(type=ParameterType.PARAMETER_STRING, string_value=value)
            told = ParameterMessage(name=f"{name}.{key}", value=text)
            results = self.asker.ask(SetParameters, "set_parameters", parameters=[told]).results
            if not results or not results[0].successful:
                self.log.fatal(f'Could not set controller {key} to "{value}" for {name}')
                return False
            self.log.info(f'Set controller {key} to "{value}" for {name}')
        return True

    def unload(self) -> int:
        """Unload the controllers."""
        names = self.told.controller_names
        self.log.info("Deactivating and unloading controllers...")
        if not self.told.inactive and not self.asker.switch(names, []):
            self.log.error("Failed to deactivate controller")
            return 1
        for name in names:
            if not self.asker.unload(name):
                self.log.error(f"Failed to unload controller {name}")
                return 1
        self.log.info("Unloaded controllers")
        return 0


def main(args: list[str] | None = None) -> Any:
    """Spawn the controllers. Returns the exit code."""
    words = remove_ros_args(args if args is not None else sys.argv)[1:]
    told = arguments([word for word in words if word])  # conditions in launch files leave empty arguments
    for file in told.param_file or ():
        if not os.path.isfile(file):
            print(f"FileNotFoundError: [Errno 2] No such file or directory: '{file}'", file=sys.stderr)
            return 1
    rclpy.init(args=args, signal_handler_options=SignalHandlerOptions.NO)
    spawner = Spawner(rclpy.create_node(f"spawner_{told.controller_names[0]}"), told)
    try:
        code = spawner.run()
        if code == 0 and told.unload_on_kill:
            spawner.log.info("Waiting until interrupt to unload controllers")
            try:
                rclpy.spin(spawner.node)
            except KeyboardInterrupt:
                spawner.log.info("KeyboardInterrupt captured!")
                return spawner.unload()
        return code
    except NoManager as error:
        spawner.log.fatal(str(error))
        return 1
    except KeyboardInterrupt:
        return 130
    finally:
        rclpy.try_shutdown()
