"""Layers of costmaps that are C++ classes."""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.nav.costmap import Costmap
from coursekit.nodes.nav2.cpp_plugins import CppPlugin, packed_costs, where_is

if TYPE_CHECKING:
    from collections.abc import Iterable

    from coursekit.nav.footprint import Footprint
    from coursekit.nodes.nav2.costmap_node import CostmapNode


class CppLayer(CppPlugin):
    """A class derived from nav2_costmap_2d::Layer."""

    served, base = "layer", "nav2_costmap_2d::Layer"
    what, created = "layer", 'Using plugin "{name}"'

    def update(self, costs: Costmap, robot: Footprint, at: Pose2D) -> None:
        """Call updateBounds and updateCosts. An exception ends the process, as that of nav2's thread of updates does."""
        answer = self._program.ask("update", rest=packed_costs(costs, robot) + struct.pack("<3d", *at))
        costs.cells[:] = np.frombuffer(answer.blob(), np.uint8).reshape(costs.cells.shape)

    def reset(self) -> None:
        """Call reset."""
        self.ask("reset")


def foreign_layer(node: CostmapNode, name: str, kind: str, known: Iterable[str]) -> CppLayer:
    """Return a layer of a costmap's node, not configured yet. Raises NoPlugin, CppFault."""
    layer = CppLayer(*where_is(CppLayer, name, kind, known), name, node, node)
    node.get_logger().info(CppLayer.created.format(name=name))
    return layer
