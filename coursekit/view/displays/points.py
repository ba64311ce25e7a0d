"""LaserScan and PointCloud2: dots in one colour, or coloured by intensity, by height or by the cloud's own colours."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.view.scene import Pose, Scene, Thing
from coursekit.view.scene_shapes import Points, Triangles, box, colour_of, scattered

from .display import StampedDisplay
from .facts import Fact, header_facts, nearest_dot, point_text, world

if TYPE_CHECKING:
    from sensor_msgs.msg import LaserScan as LaserScanMsg
    from sensor_msgs.msg import PointCloud as PointCloudMsg
    from sensor_msgs.msg import PointCloud2 as PointCloud2Msg

    from coursekit.view.scene_stage import Stage

MOST = 200_000
"""The maximum number of points shown; of larger clouds only every second, third, ... point is drawn."""
KEPT = 1000
"""The maximum number of messages kept for decay_time."""
MOST_BOXES = 5000
"""The maximum number of boxes; larger clouds are drawn as dots, regardless of the style."""
_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}


def rainbow(values: np.ndarray) -> np.ndarray:
    """Return (n, 3) colours: the lowest value is blue, the highest red.

    >>> rainbow(np.array([0.0, 1.0, 2.0])).tolist()
    [[0.0, 0.0, 0.5], [0.5, 1.0, 0.5], [0.5, 0.0, 0.0]]
    """
    if not len(values):
        return np.zeros((0, 3))
    low, high = float(np.min(values)), float(np.max(values))
    place = (values - low) / (high - low if high > low else 1.0)
    wheel = np.stack([np.abs(place * 4 - 3), np.abs(place * 4 - 2), np.abs(place * 4 - 1)], axis=1)
    return np.clip(1.5 - wheel, 0.0, 1.0)


class _Dots(StampedDisplay):
    """The points of the last `decay_time` seconds; 0: only the newest."""

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self._made = 0
        self._ends: dict[str, int] = {}

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Draw the newest points; remove those that have decayed."""
        super().draw(stage, scene)
        for name in [name for name, end in self._ends.items() if end <= stage.now() and name != f"{self._made}"]:
            del self._ends[name]
            scene.remove(self.key, name)

    def redraw(self, scene: Scene) -> None:
        """Show the newest message again; remove earlier ones."""
        super().redraw(scene)
        self._ends = {}

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the facts of the dot nearest to the click."""
        dot = nearest_dot(thing, here)
        if dot is None:
            return super().facts(name, thing, here, stage)
        return [*self.dot_facts(*dot), ("Position", point_text(world(thing, dot[1]))), *header_facts(self.shown)]

    def dot_facts(self, number: int, dot: np.ndarray) -> list[Fact]:
        """Return the facts of a dot, given in the message's frame."""
        return [("Point", f"{number}")]

    def move(self, pose: Pose, scene: Scene) -> None:
        """Move the newest message to its pose; earlier ones stay."""
        if scene.has(self.key, f"{self._made}"):
            scene.place(self.key, f"{self._made}", pose)

    def dots(self, points: np.ndarray, colours: np.ndarray | None, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Show the points with finite coordinates."""
        good = np.isfinite(points).all(axis=1)
        points, colours = points[good], None if colours is None else colours[good]
        step = -(-len(points) // MOST) or 1
        self.say("Points", "Ok", f"Showing {len(points[::step])} points")
        shape = self._shape(points[::step], None if colours is None else colours[::step])
        if self.options["decay_time"] > 0:
            self._made += 1
            self._ends[f"{self._made}"] = stage.now() + round(self.options["decay_time"] * 1e9)
            if len(self._ends) > KEPT:
                self._ends.pop(gone := next(iter(self._ends)))
                scene.remove(self.key, gone)
        scene.put(self.key, f"{self._made}", *([shape] if len(points) else []), pose=pose)

    def _shape(self, points: np.ndarray, colours: np.ndarray | None) -> Points | Triangles:
        size, colour = float(self.options["size"]), colour_of(self.options["color"], self.options["alpha"])
        if self.options["style"] != "Boxes" or len(points) > MOST_BOXES:
            if self.options["style"] == "Points":
                return Points(points, float(self.options["size_pixels"]), colour, colours, pixels=True)
            return Points(points, size, colour, colours)
        body = box(size, size, size)
        vertices, faces = scattered(body, points)
        if colours is not None:
            colours = np.concatenate([colours, np.full((len(points), 1), colour[3])], axis=1).repeat(len(body[1]), axis=0)
        return Triangles(vertices, faces, colour, colours)


class LaserScan(_Dots):
    """The newest scan, without beams that are out of range."""

    kind = "LaserScan"

    def dot_facts(self, number: int, dot: np.ndarray) -> list[Fact]:
        """Return number, range and angle of the beam."""
        msg, angle, far = self.shown, float(np.arctan2(dot[1], dot[0])), float(np.hypot(dot[0], dot[1]))
        step = msg.angle_increment or 1.0
        beam = round((((angle - msg.angle_min) * np.sign(step)) % (2 * np.pi)) / abs(step))
        facts = [("Beam", f"{beam}"), ("Range", f"{far:.3f} m"), ("Angle", f"{np.degrees(angle):.1f} deg")]
        bright = msg.intensities
        return facts + ([("Intensity", f"{bright[beam]:g}")] if beam < len(bright) else [])

    def show(self, msg: LaserScanMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw dots at the ends of the beams."""
        ranges = np.asarray(msg.ranges, float)
        angles = msg.angle_min + np.arange(len(ranges)) * msg.angle_increment
        with np.errstate(invalid="ignore"):
            hit = (ranges >= msg.range_min) & (ranges <= msg.range_max)
        far, turn = ranges[hit], angles[hit]
        points = np.stack([far * np.cos(turn), far * np.sin(turn), np.zeros_like(far)], axis=1)
        bright = np.asarray(msg.intensities, float)
        by_brightness = self.options["color_transformer"] == "Intensity" and len(bright) == len(ranges)
        self.dots(points, rainbow(bright[hit]) if by_brightness else None, pose, stage, scene)


class PointCloud(_Dots):
    """The newest cloud of the older type, with a list of points and named channels."""

    kind = "PointCloud"

    def show(self, msg: PointCloudMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw dots."""
        points = np.array([(point.x, point.y, point.z) for point in msg.points], float).reshape(-1, 3)
        bright = next((np.array(channel.values, float) for channel in msg.channels if channel.name == "intensity"), None)
        shown = bright is not None and len(bright) == len(points) and self.options["color_transformer"] != "FlatColor"
        self.dots(points, rainbow(bright) if shown and bright is not None else None, pose, stage, scene)


class PointCloud2(_Dots):
    """The newest cloud."""

    kind = "PointCloud2"

    def show(self, msg: PointCloud2Msg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw dots."""
        try:
            table = read_cloud(msg)
            points = np.stack([table[axis].astype(float) for axis in "xyz"], axis=1)
        except (ValueError, KeyError, TypeError) as error:
            self.say("Message", "Error", f"The cloud cannot be read: {error}")
            return
        self.unsay("Message")
        self.dots(points, self._colours(table, points), pose, stage, scene)

    def _colours(self, table: np.ndarray, points: np.ndarray) -> np.ndarray | None:
        names, how = table.dtype.names or (), self.options["color_transformer"]
        packed = next((field for field in ("rgb", "rgba") if field in names), None)
        if packed is not None and how in ("", "RGB8", "RGB"):
            word = np.ascontiguousarray(table[packed]).view("u4")
            return np.stack([(word >> shift) & 255 for shift in (16, 8, 0)], axis=1) / 255.0
        if "intensity" in names and how in ("", "Intensity"):
            return rainbow(table["intensity"].astype(float))
        height = np.nan_to_num(points[:, 2], posinf=0.0, neginf=0.0)
        return None if how == "FlatColor" else rainbow(height)


def read_cloud(msg: PointCloud2Msg) -> np.ndarray:
    """Convert a sensor_msgs/PointCloud2 to a table with its field names; ValueError if sizes do not match."""
    order = ">" if msg.is_bigendian else "<"
    for field in msg.fields:
        if field.datatype not in _TYPES:
            raise ValueError(f"field '{field.name}' has the unknown datatype {field.datatype}")
    kinds = [order + _TYPES[field.datatype] for field in msg.fields]
    kind = np.dtype(
        {
            "names": [field.name for field in msg.fields],
            "formats": [base if f.count <= 1 else (base, (f.count,)) for base, f in zip(kinds, msg.fields, strict=True)],
            "offsets": [field.offset for field in msg.fields],
            "itemsize": msg.point_step,
        }
    )
    missing = [axis for axis in "xyz" if axis not in (kind.names or ())]
    if missing:
        raise ValueError(f"there is no field '{missing[0]}'; there are {', '.join(kind.names or ()) or 'none'}")
    data = bytes(msg.data)
    wanted = msg.height * msg.row_step
    if len(data) < wanted or msg.row_step < msg.width * msg.point_step:
        raise ValueError(f"data has {len(data)} bytes, {msg.height} rows of {msg.row_step} need {wanted}")
    rows = [np.frombuffer(data, kind, msg.width, row * msg.row_step) for row in range(msg.height)]
    return np.concatenate(rows) if rows else np.zeros(0, kind)
