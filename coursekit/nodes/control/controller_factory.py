"""Makes controllers: ours by their types, C++ ones of built packages by their plugins."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from rclpy.node import Node

from coursekit.urdf.errors import close

from .controller import ControlError, Controller, Interfaces, Maker
from .cpp_controller import CppFault, PluginFault, make_cpp_controller

if TYPE_CHECKING:
    from rclpy.executors import Executor


class ControllerMaker:
    """Makes the controllers of the manager whose node this is."""

    def __init__(
        self, node: Node, executor: Executor, makers: Mapping[str, Maker], interfaces: Interfaces, rate: float
    ) -> None:
        self._node, self._executor, self._makers = node, executor, makers
        self._interfaces, self._rate, self._log = interfaces, rate, node.get_logger()

    def make(self, name: str, kind: str, words: list[str]) -> Controller | None:
        """Return a controller of a type, its node with these arguments; None, with a log message, if there is none."""
        return self._own(name, kind, words) if kind in self._makers else self._cpp(name, kind, words)

    def _own(self, name: str, kind: str, words: list[str]) -> Controller:
        cli = ["--ros-args", *words] if words else []
        space, context = self._node.get_namespace(), self._node.context
        node = Node(name, context=context, namespace=space, cli_args=cli, use_global_arguments=False)
        self._executor.add_node(node)
        return self._makers[kind](node, self._interfaces, self._rate)

    def _cpp(self, name: str, kind: str, words: list[str]) -> Controller | None:
        try:
            controller = make_cpp_controller(kind, self._node, name, words, self._interfaces, self._rate)
            if controller is None:
                self._log.error(f"Loader for controller '{name}' (type '{kind}') not found. {close(kind, self._makers)}")
            return controller
        except ControlError as error:
            self._log.error(str(error))
        except (CppFault, PluginFault) as fault:
            what = f"Caught exception of type : {fault.kind} while loading the controller '{name}' of plugin type '{kind}'"
            self._log.error(f"{what}:\n{fault}")
        return None


__all__ = ["ControllerMaker"]
