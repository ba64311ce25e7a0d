"""Finds the Python executable that stands for a component."""

from __future__ import annotations

from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions

from coursekit.core.components import find_component

from ..descriptions import ComposableNode
from .node import Node


def nodes_for(context: LaunchContext, descriptions: list[ComposableNode]) -> list[Node]:
    """Return a Node for each component whose condition holds.

    Raises:
        RuntimeError: when a component has no Python executable; says which names were looked for.
    """
    nodes = []
    for description in descriptions:
        condition = description.condition()
        if condition is None or condition.evaluate(context):
            nodes.append(_node(context, description))
    return nodes


def _node(context: LaunchContext, description: ComposableNode) -> Node:
    package = perform_substitutions(context, description.package)
    plugin = perform_substitutions(context, description.node_plugin)
    executable = _executable(package, plugin)
    return Node(executable=executable, output="screen", **description.node_arguments)


def _executable(package: str, plugin: str) -> str:
    try:
        return str(find_component(package, plugin))
    except LookupError as error:
        raise RuntimeError(str(error) if plugin in str(error) else f"component '{plugin}': {error}") from error
