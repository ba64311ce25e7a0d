"""Starts a node."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Iterable
from typing import Any

import yaml
from launch.action import Action
from launch.actions import ExecuteProcess
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.logging import get_logger
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitutions import LocalSubstitution
from launch.temporary_files import temporary_files
from launch.utilities import (
    ensure_argument_type,
    normalize_to_list_of_substitutions,
    perform_substitutions,
)

from ..parameter_descriptions import Parameter
from ..parameters_type import SomeParameters
from ..remap_rule_type import SomeRemapRules
from ..substitutions import ExecutableInPackage
from ..substitutions.executable_in_package import NotCompiled
from ..utilities import (
    add_node_name,
    evaluate_parameters,
    get_node_name_count,
    make_namespace_absolute,
    normalize_parameters,
    normalize_remap_rules,
    prefix_namespace,
)
from ..utilities.to_parameters_list import yaml_inline
from .node_frontend import parse_node


@expose_action("node")
class Node(ExecuteProcess):
    """Starts an executable with ROS arguments: name, namespace, parameters, remappings.

    Parameters are a list of files and mappings; later entries win. Remappings are (from, to) tuples. The
    namespace is nested in those of PushRosNamespace unless it is absolute.

    >>> talker = Node(
    ...     package="demo_nodes_py",
    ...     executable="talker",
    ...     namespace="robot1",
    ...     parameters=[{"use_sim_time": True}],
    ...     remappings=[("chatter", "speech")],
    ...     output="screen",
    ... )
    >>> talker.node_package, talker.node_executable
    ('demo_nodes_py', 'talker')
    """

    UNSPECIFIED_NODE_NAME = "<node_name_unspecified>"
    UNSPECIFIED_NODE_NAMESPACE = "<node_namespace_unspecified>"

    def __init__(
        self,
        *,
        executable: SomeSubstitutionsType,
        package: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        exec_name: SomeSubstitutionsType | None = None,
        parameters: SomeParameters | None = None,
        remappings: SomeRemapRules | None = None,
        ros_arguments: Iterable[SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        program = (
            executable if package is None else ExecutableInPackage(package=package, executable=executable)
        )
        arguments = list(arguments or [])
        cmd: list[Any] = [program, *arguments]
        if ros_arguments is not None:
            cmd += ["--ros-args", *ros_arguments]
        cmd.append("--ros-args")
        if name is not None:
            cmd += ["-r", LocalSubstitution("ros_specific_arguments['name']", description="node name")]
        if parameters is not None:
            ensure_argument_type(parameters, (list,), "parameters", "Node")
        super().__init__(cmd=cmd, name=exec_name, **kwargs)
        self.__package = package
        self.__node_executable = executable
        self.__node_name = name
        self.__node_namespace = namespace
        self.__arguments = arguments
        self.__parameters = normalize_parameters(parameters or [])
        self.__remappings = list(normalize_remap_rules(remappings or []))
        self.__expanded_node_name = self.UNSPECIFIED_NODE_NAME
        self.__expanded_node_namespace = self.UNSPECIFIED_NODE_NAMESPACE
        self.__final_node_name: str | None = None
        self.__expanded_remappings: list[tuple[str, str]] | None = None
        self.__expanded_parameter_arguments: list[tuple[str, bool]] = []

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:  # type: ignore[override]
        """Read `<node pkg= exec= name= namespace= args= ...>` with param, remap and env inside."""
        _, kwargs = super().parse(entity, parser, ignore=["cmd", "name"])
        return cls, {**kwargs, **parse_node(cls, entity, parser)}

    # -- properties

    @property
    def node_package(self) -> SomeSubstitutionsType | None:
        """The package."""
        return self.__package

    @property
    def node_executable(self) -> SomeSubstitutionsType:
        """The executable."""
        return self.__node_executable

    @property
    def node_name(self) -> str:
        """The node's full name; RuntimeError before the action is executed."""
        if self.__final_node_name is None:
            raise RuntimeError("cannot access 'node_name' before executing action")
        return self.__final_node_name

    @property
    def expanded_node_name(self) -> str:
        """The node's name without its namespace."""
        return self.__expanded_node_name

    @property
    def expanded_node_namespace(self) -> str:
        """The node's namespace."""
        return self.__expanded_node_namespace

    @property
    def expanded_remapping_rules(self) -> list[tuple[str, str]] | None:
        """The remappings as text; None before the action is executed."""
        return self.__expanded_remappings

    def is_node_name_fully_specified(self) -> bool:
        """Return whether name and namespace are both known."""
        return "<" not in self.node_name

    # -- execution

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the node; warn if another node of the same name has been started."""
        self._perform_substitutions(context)
        arguments = {"name": f"__node:={self.__expanded_node_name}", "ns": f"__ns:={self.__expanded_node_namespace}"}
        context.extend_locals({"ros_specific_arguments": arguments})
        try:
            result = super().execute(context)
        except NotCompiled as error:  # on a robot it would start: here at least the rest does
            get_logger("launch_ros.actions.node").error(f"{error.why}; the launch goes on without it")
            return None
        if self.is_node_name_fully_specified():
            add_node_name(context, self.node_name)
            count = get_node_name_count(context, self.node_name)
            if count > 1:
                get_logger("launch_ros.actions.node").warning(
                    f"there are now at least {count} nodes with the name {self.node_name} created within "
                    "this launch context"
                )
        return result

    def _perform_substitutions(self, context: LaunchContext) -> None:
        """Evaluate names, parameters and remappings, once, and add them to the command line."""
        if self.__final_node_name is not None:
            return
        self.__expand_names(context)
        self.__final_node_name = prefix_namespace(self.__expanded_node_namespace, self.__expanded_node_name)
        for arguments in (
            self.__global_parameters(context),
            self.__own_parameters(context),
            self.__remap_arguments(context),
        ):
            self.cmd.extend(normalize_to_list_of_substitutions(argument) for argument in arguments)

    def __expand_names(self, context: LaunchContext) -> None:
        from rclpy.validate_namespace import validate_namespace
        from rclpy.validate_node_name import validate_node_name

        try:
            if self.__node_name is not None:
                self.__expanded_node_name = _perform(context, self.__node_name).lstrip("/")
                validate_node_name(self.__expanded_node_name)
            own = None if self.__node_namespace is None else _perform(context, self.__node_namespace)
            namespace = make_namespace_absolute(
                prefix_namespace(context.launch_configurations.get("ros_namespace"), own)
            )
            if namespace is not None:
                self.__expanded_node_namespace = namespace
                argument = LocalSubstitution("ros_specific_arguments['ns']", description="node namespace")
                self.cmd.extend([normalize_to_list_of_substitutions("-r"), [argument]])
                validate_namespace(namespace)
        except Exception:
            get_logger("launch_ros.actions.node").error(
                f"Error while expanding or validating node name or namespace for 'package={self.__package}, "
                f"executable={self.__node_executable}, name={self.__node_name}, namespace={self.__node_namespace}':"
            )
            raise

    def __global_parameters(self, context: LaunchContext) -> list[str]:
        """Return the arguments for the parameters that SetParameter and SetParametersFromFile have set before.

        Raises:
            FileNotFoundError: if one of their files does not exist.
        """
        arguments: list[str] = []
        settings: Any = context.launch_configurations.get("global_params", [])
        for setting in settings:
            if isinstance(setting, tuple):
                arguments += ["-p", f"{setting[0]}:={yaml_inline(setting[1])}"]
            elif not os.path.isfile(setting):
                raise FileNotFoundError(2, "parameter file does not exist", os.fspath(setting))
            else:
                arguments += self.__file_arguments(os.path.abspath(setting))
        return arguments

    def __own_parameters(self, context: LaunchContext) -> list[str]:
        arguments: list[str] = []
        for parameter in evaluate_parameters(context, self.__parameters):
            if isinstance(parameter, Parameter):
                name, value = parameter.evaluate(context)
                rule = f"{name}:={yaml_inline(value)}"
                self.__expanded_parameter_arguments.append((rule, False))
                arguments += ["-p", rule]
            elif isinstance(parameter, pathlib.Path):
                arguments += self.__file_arguments(str(parameter))
            else:
                arguments += self.__file_arguments(self._create_params_file_from_dict(parameter))
        return arguments

    def __file_arguments(self, path: str) -> list[str]:
        if not os.path.isfile(path):
            get_logger("launch_ros.actions.node").warning(f"Parameter file path is not a file: {path}")
            return []
        self.__expanded_parameter_arguments.append((path, True))
        return ["--params-file", path]

    def _create_params_file_from_dict(self, params: dict[str, Any]) -> str:
        """Write a parameter file for this node, or for all nodes if its name is unknown; return its path."""
        key = self.node_name if self.is_node_name_fully_specified() else "/**"
        path = temporary_files.new_path("launch_params_")
        with open(path, "w", encoding="utf-8") as file:
            yaml.dump({key: {"ros__parameters": params}}, file, default_flow_style=False)
        return path

    def __remap_arguments(self, context: LaunchContext) -> list[str]:
        everywhere: Any = context.launch_configurations.get("ros_remaps", [])
        own = [
            (perform_substitutions(context, source), perform_substitutions(context, target))
            for source, target in self.__remappings
        ]
        self.__expanded_remappings = [*everywhere, *own]
        return [
            part for source, target in self.__expanded_remappings for part in ("-r", f"{source}:={target}")
        ]


def _perform(context: LaunchContext, value: SomeSubstitutionsType) -> str:
    return perform_substitutions(context, normalize_to_list_of_substitutions(value))
