"""nav2_simple_commander's costmap, line and outline, as programs use them."""

import math

import pytest
from geometry_msgs.msg import Point32, Polygon
from nav2_msgs.msg import Costmap
from nav2_simple_commander.costmap_2d import PyCostmap2D
from nav2_simple_commander.footprint_collision_checker import LETHAL_OBSTACLE, FootprintCollisionChecker
from nav2_simple_commander.line_iterator import LineIterator
from nav_msgs.msg import OccupancyGrid


def grid():
    """Ten by ten cells of 0.1 m from (-0.5, -0.5), with an obstacle in column 8, row 5."""
    msg = OccupancyGrid()
    msg.info.width = msg.info.height = 10
    msg.info.resolution = 0.1
    msg.info.origin.position.x = msg.info.origin.position.y = -0.5
    msg.data = [0] * 100
    msg.data[58] = 127
    return msg


def square(half):
    return Polygon(points=[Point32(x=x * half, y=y * half) for x, y in ((1, 1), (1, -1), (-1, -1), (-1, 1))])


def test_cells_are_found_by_place_and_by_number_and_can_be_set():
    costs = PyCostmap2D(grid())
    assert (costs.getSizeInCellsX(), costs.getIndex(8, 5), costs.getCostXY(8, 5), costs.getCostIdx(58)) == (10, 58, 127, 127)
    assert costs.worldToMapValidated(0.31, 0.01) == (8, 5) and costs.worldToMapValidated(0.7, 0.0) == (None, None)
    assert costs.getSizeInMetersX() == pytest.approx(0.95)
    costs.setCost(0, 0, 254)
    assert costs.getCostXY(0, 0) == 254


def test_a_costmap_message_is_understood_like_a_map():
    msg = Costmap(data=[0, 254])
    msg.metadata.size_x, msg.metadata.size_y, msg.metadata.resolution = 2, 1, 0.5
    assert PyCostmap2D(msg).getCostXY(1, 0) == 254


@pytest.mark.parametrize("line", [(0, 0, 0, 3), (3, 1, 0, 1), (0, 0, 3, -2), (0.0, 0.0, 1.0, 3.0)])
def test_a_line_goes_from_its_first_point_to_its_last(line):
    points, iterator = [], LineIterator(*line, 0.5)
    while iterator.isValid():
        points.append((iterator.getX(), iterator.getY()))
        iterator.advance()
    assert points[0] == line[:2] and points[-1] == pytest.approx(line[2:])
    assert iterator.get_line_length() == pytest.approx(math.dist(line[:2], line[2:]))


def test_lines_that_are_none_are_refused():
    with pytest.raises(ValueError, match="zero length"):
        LineIterator(1, 1, 1, 1)
    with pytest.raises(TypeError, match="x0 must be a number"):
        LineIterator("1", 1, 1, 2)
    with pytest.raises(ValueError, match="positive"):
        LineIterator(1, 1, 1, 2, 0)


def test_an_outline_costs_what_its_edges_meet():
    costs, checker = PyCostmap2D(grid()), FootprintCollisionChecker()
    with pytest.raises(ValueError, match="Costmap not specified"):
        checker.footprintCost(square(0.1))
    checker.setCostmap(costs)
    assert checker.footprintCostAtPose(0.0, 0.0, 0.0, square(0.15)) == 0
    assert checker.footprintCostAtPose(0.2, 0.0, 0.0, square(0.12)) == 127
    assert checker.footprintCostAtPose(0.0, 0.0, math.pi / 4, square(0.25)) == 127  # only the turned corner reaches it
    assert checker.footprintCostAtPose(0.4, 0.0, 0.0, square(0.15)) == LETHAL_OBSTACLE  # over the edge of the map
