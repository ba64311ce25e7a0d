"""The cost of a robot's outline on a costmap. In ROS 2: nav2_simple_commander.footprint_collision_checker."""

from __future__ import annotations

import math

from geometry_msgs.msg import Point32, Polygon

from nav2_simple_commander.costmap_2d import PyCostmap2D
from nav2_simple_commander.line_iterator import LineIterator

NO_INFORMATION = 255
LETHAL_OBSTACLE = 254
INSCRIBED_INFLATED_OBSTACLE = 253
MAX_NON_OBSTACLE = 252
FREE_SPACE = 0
_NO_COSTMAP = "Costmap not specified, use setCostmap to specify the costmap first"


class FootprintCollisionChecker:
    """Costs of outlines (geometry_msgs/Polygon, in metres) on the costmap of `setCostmap`."""

    def __init__(self) -> None:
        self.costmap_: PyCostmap2D | None = None

    def setCostmap(self, costmap: PyCostmap2D) -> None:
        """Use this costmap from now on."""
        self.costmap_ = costmap

    @property
    def _costs(self) -> PyCostmap2D:
        if self.costmap_ is None:
            raise ValueError(_NO_COSTMAP)
        return self.costmap_

    def footprintCostAtPose(self, x: float, y: float, theta: float, footprint: Polygon) -> float:
        """The cost of an outline after a rotation by theta [rad] and a translation to (x, y) [m]."""
        c, s = math.cos(theta), math.sin(theta)
        turned = [Point32(x=x + p.x * c - p.y * s, y=y + p.x * s + p.y * c) for p in footprint.points]
        return self.footprintCost(Polygon(points=turned))

    def footprintCost(self, footprint: Polygon) -> float:
        """The greatest cost on the edges; 254 when they touch an obstacle or leave the costmap."""
        cells = [self.worldToMapValidated(point.x, point.y) for point in footprint.points]
        cost = 0.0
        for (x0, y0), (x1, y1) in zip(cells, [*cells[1:], cells[0]], strict=True):
            if x0 is None or y0 is None or x1 is None or y1 is None:
                return LETHAL_OBSTACLE
            cost = max(cost, float(self.lineCost(x0, x1, y0, y1)))
            if cost == LETHAL_OBSTACLE:
                break
        return cost

    def lineCost(self, x0: float, x1: float, y0: float, y1: float, step_size: float = 0.5) -> float:
        """The greatest cost on a line between two cells; 254 as soon as it meets an obstacle."""
        if (x0, y0) == (x1, y1):
            return self.pointCost(int(x0), int(y0))
        cost, line = 0.0, LineIterator(x0, y0, x1, y1, step_size)
        while line.isValid() and cost != LETHAL_OBSTACLE:
            here = self.pointCost(int(line.getX()), int(line.getY()))
            cost = here if here == LETHAL_OBSTACLE else max(cost, here)
            line.advance()
        return cost

    def worldToMapValidated(self, wx: float, wy: float) -> tuple[int | None, int | None]:
        """Column and row of a position [m]; (None, None) outside the costmap."""
        return self._costs.worldToMapValidated(wx, wy)

    def pointCost(self, x: int, y: int) -> float:
        """The cost of a cell."""
        return self._costs.getCostXY(x, y)  # type: ignore[return-value]  # np.uint8, as in nav2
