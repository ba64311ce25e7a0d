"""The request to a container to load a component."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions

from ..descriptions import ComposableNode
from ..parameter_descriptions import ParameterFile
from ..utilities import (
    evaluate_parameters,
    make_namespace_absolute,
    normalize_parameter_dict,
    prefix_namespace,
    to_parameters_list,
)


def get_composable_node_load_request(description: ComposableNode, context: LaunchContext) -> Any:
    """Return the LoadNode request of a component; None if its condition is false.

    It contains the namespace, remappings and parameters that the launch has set before (PushRosNamespace, SetRemap,
    SetParameter, ...).
    """
    from composition_interfaces.srv import LoadNode

    condition = description.condition()
    if condition is not None and not condition.evaluate(context):
        return None
    name = _text(context, description.node_name) or ""
    own = _text(context, description.node_namespace)
    base = context.launch_configurations.get("ros_namespace")
    namespace = make_namespace_absolute(prefix_namespace(base, own))
    parameters = [*_parameters_for_all(context), *(description.parameters or ())]
    return LoadNode.Request(
        package_name=perform_substitutions(context, description.package),
        plugin_name=perform_substitutions(context, description.node_plugin),
        node_name=name,
        node_namespace=namespace or "",
        remap_rules=_remap_rules(description, context),
        parameters=_messages(context, name, namespace, parameters),
        extra_arguments=_messages(context, name, namespace, description.extra_arguments or ()),
    )


def _text(context: LaunchContext, parts: Any) -> str | None:
    return None if parts is None else perform_substitutions(context, parts)


def _remap_rules(description: ComposableNode, context: LaunchContext) -> list[str]:
    everywhere: Any = context.launch_configurations.get("ros_remaps", [])
    own = [
        (perform_substitutions(context, source), perform_substitutions(context, target))
        for source, target in description.remappings or ()
    ]
    return [f"{source}:={target}" for source, target in [*everywhere, *own]]


def _parameters_for_all(context: LaunchContext) -> list[Any]:
    settings: Any = context.launch_configurations.get("global_params", [])
    return [
        normalize_parameter_dict({setting[0]: setting[1]}) if isinstance(setting, tuple) else ParameterFile(setting)
        for setting in settings
    ]


def _messages(context: LaunchContext, name: str, namespace: str | None, parameters: Sequence[Any]) -> list[Any]:
    evaluated = evaluate_parameters(context, tuple(parameters))
    return [parameter.to_parameter_msg() for parameter in to_parameters_list(context, name, namespace, evaluated)]
