"""Finds the Python executable that stands for a component."""

from __future__ import annotations

import os
import re

from ament_index_python.packages import PackageNotFoundError, get_package_prefix
from launch.launch_context import LaunchContext
from launch.utilities import perform_substitutions

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
    return Node(package=package, executable=executable, output="screen", **description.node_arguments)


def _executable(package: str, plugin: str) -> str:
    names = candidate_names(plugin)
    try:
        folder = os.path.join(get_package_prefix(package), "lib", package)
    except PackageNotFoundError as error:
        raise RuntimeError(f"component '{plugin}': {error}") from error
    for name in names:
        if os.path.isfile(os.path.join(folder, name)):
            return name
    raise RuntimeError(
        f"component '{plugin}' of package '{package}' is a C++ library, which cannot be loaded here; it "
        f"would run as a Python executable called {' or '.join(names)}, which the package does not have"
    )


def candidate_names(plugin: str) -> list[str]:
    """Return the names of executables that may stand for a component.

    >>> candidate_names('demo::TalkerNode')
    ['talker_node', 'talker']
    """
    snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", plugin.rsplit("::", 1)[-1]).lower()
    short = snake.removesuffix("_node")
    return [snake, short] if snake.endswith("_node") else [snake, f"{snake}_node"]
