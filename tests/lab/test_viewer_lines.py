"""Lines, outlines and dots as the page is told of them: never thinner than can be seen."""

import umsgpack
from geometry_msgs.msg import Point, Point32, PolygonStamped, PoseStamped
from nav_msgs.msg import Path
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker

from coursekit.view.scene import Changes, Thing
from coursekit.view.scene_shapes import Band
from coursekit.view.scene_wire import packed
from tests.lab.viewer_stage import scan_of, show


def sent(shape):
    """What the page is told of a shape."""
    thing = Thing(1, (shape,))
    _, (_, command) = packed(Changes(made=[thing]))
    return umsgpack.unpackb(command)["object"]


def test_a_path_goes_to_the_page_as_a_line_that_is_never_too_thin(session, talker):
    msg = Path(poses=[PoseStamped(), PoseStamped(), PoseStamped()])
    msg.poses[1].pose.position.x = msg.poses[2].pose.position.y = 2.0
    (band,), _, _ = show(session, talker, {"type": "Path", "line_width": 0.1}, msg)
    assert isinstance(band, Band) and band.ends[:, :2].tolist() == [[0, 0], [2, 0], [2, 0], [0, 2]]
    told = sent(band)
    assert told["object"]["type"] == "LineSegments" and told["object"]["userData"] == {"metres": 0.1, "least": 2.0}
    assert len(told["geometries"][0]["data"]["attributes"]["position"]["array"].data) == 4 * 3 * 4


def test_the_pieces_of_a_line_have_their_colours(session, talker):
    msg = Marker(type=Marker.LINE_LIST, points=[Point(), Point(x=1.0), Point(), Point(y=1.0)])
    msg.scale.x = msg.color.a = 1.0
    msg.colors = [ColorRGBA(r=1.0, a=1.0), ColorRGBA(r=1.0, a=1.0), ColorRGBA(b=1.0, a=1.0), ColorRGBA(b=1.0, a=1.0)]
    (band,), _, _ = show(session, talker, "Marker", msg)
    assert band.end_colours.tolist() == [[1, 0, 0], [1, 0, 0], [0, 0, 1], [0, 0, 1]]
    msg.type, msg.points, msg.colors = Marker.LINE_STRIP, msg.points[:3], msg.colors[:3]
    (band,), _, _ = show(session, talker, "Marker", msg)
    assert band.end_colours.tolist() == [[1, 0, 0], [1, 0, 0], [1, 0, 0], [0, 0, 1]]


def test_a_polygon_is_two_pixels_wide_and_dots_may_be_counted_in_pixels(session, talker):
    msg = PolygonStamped()
    msg.polygon.points = [Point32(), Point32(x=1.0)]
    (line,), _, _ = show(session, talker, "Polygon", msg)
    assert sent(line)["object"]["userData"] == {"least": 2.0}
    (dots,), _, _ = show(session, talker, {"type": "LaserScan", "style": "Points", "size_pixels": 5}, scan_of(1.0))
    (material,) = sent(dots)["materials"]
    assert (material["size"], material["sizeAttenuation"]) == (5.0, False)
