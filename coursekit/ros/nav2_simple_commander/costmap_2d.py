"""A costmap or a map as rows of cells. In ROS 2: nav2_simple_commander.costmap_2d."""

from __future__ import annotations

import math
from typing import Any

import numpy as np


class PyCostmap2D:
    """Cells of a nav_msgs/OccupancyGrid or a nav2_msgs/Costmap, row by row from the origin.

    `costmap` holds them as uint8: -1 of an OccupancyGrid (unknown) is 255.

    >>> from nav_msgs.msg import OccupancyGrid
    >>> grid = OccupancyGrid(data=[0, 100, -1, 0])
    >>> grid.info.width = grid.info.height = 2; grid.info.resolution = 0.5; grid.info.origin.position.x = -1.0
    >>> costs = PyCostmap2D(grid)
    >>> costs.getCostXY(1, 0), costs.getCostXY(0, 1), costs.worldToMap(-0.4, 0.1), costs.mapToWorld(1, 0)
    (np.uint8(100), np.uint8(255), (1, 0), (-0.25, 0.25))
    """

    def __init__(self, occupancy_map: Any) -> None:
        info = occupancy_map.info if hasattr(occupancy_map, "info") else occupancy_map.metadata
        self.size_x = info.width if hasattr(info, "width") else info.size_x
        self.size_y = info.height if hasattr(info, "height") else info.size_y
        self.resolution = info.resolution
        self.origin_x, self.origin_y = info.origin.position.x, info.origin.position.y
        self.global_frame_id = occupancy_map.header.frame_id
        self.costmap_timestamp = occupancy_map.header.stamp
        self.costmap = np.asarray(occupancy_map.data).astype(np.uint8)

    def getSizeInCellsX(self) -> int:
        """The number of columns."""
        return self.size_x

    def getSizeInCellsY(self) -> int:
        """The number of rows."""
        return self.size_y

    def getSizeInMetersX(self) -> float:
        """The distance from the first column to the centre of the last [m], as in nav2."""
        return (self.size_x - 1 + 0.5) * self.resolution

    def getSizeInMetersY(self) -> float:
        """The distance from the first row to the centre of the last [m]."""
        return (self.size_y - 1 + 0.5) * self.resolution

    def getOriginX(self) -> float:
        """The x coordinate at which the first column begins [m]."""
        return self.origin_x

    def getOriginY(self) -> float:
        """The y coordinate at which the first row begins [m]."""
        return self.origin_y

    def getResolution(self) -> float:
        """Width of a cell [m]."""
        return self.resolution

    def getGlobalFrameID(self) -> str:
        """The frame of the cells."""
        return self.global_frame_id

    def getCostmapTimestamp(self) -> Any:
        """The stamp of the costmap."""
        return self.costmap_timestamp

    def getCostXY(self, mx: int, my: int) -> np.uint8:
        """The cost of the cell in a column and row."""
        return self.costmap[self.getIndex(mx, my)]

    def getCostIdx(self, index: int) -> np.uint8:
        """The cost of the cell with an index."""
        return self.costmap[index]

    def setCost(self, mx: int, my: int, cost: int) -> None:
        """Set the cost of a cell."""
        self.costmap[self.getIndex(mx, my)] = cost

    def mapToWorld(self, mx: int, my: int) -> tuple[float, float]:
        """The centre of a cell [m]."""
        return self.origin_x + (mx + 0.5) * self.resolution, self.origin_y + (my + 0.5) * self.resolution

    def worldToMap(self, wx: float, wy: float) -> tuple[int, int]:
        """Column and row of a position [m]; they may lie outside the costmap."""
        return math.floor((wx - self.origin_x) / self.resolution), math.floor((wy - self.origin_y) / self.resolution)

    def worldToMapValidated(self, wx: float, wy: float) -> tuple[int | None, int | None]:
        """Column and row of a position [m]; (None, None) outside the costmap."""
        mx, my = self.worldToMap(wx, wy)
        return (mx, my) if 0 <= mx < self.size_x and 0 <= my < self.size_y else (None, None)

    def getIndex(self, mx: int, my: int) -> int:
        """The index of the cell in a column and row."""
        return my * self.size_x + mx
