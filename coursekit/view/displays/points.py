"""LaserScan and PointCloud2: dots, coloured by one colour, by intensity, by height or by the cloud's own colours."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Points, colour_of

from .display import StampedDisplay

if TYPE_CHECKING:
    from coursekit.view.scene_stage import Stage

MOST = 200_000
"""Of larger clouds every second, third, ... point is shown."""
_TYPES = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 8: "f8"}


def rainbow(values: np.ndarray) -> np.ndarray:
    """(n, 3) colours: the least value blue, the greatest red."""
    if not len(values):
        return np.zeros((0, 3))
    low, high = float(np.min(values)), float(np.max(values))
    place = (values - low) / (high - low if high > low else 1.0)
    wheel = np.stack([np.abs(place * 4 - 3), np.abs(place * 4 - 2), np.abs(place * 4 - 1)], axis=1)
    return np.clip(1.5 - wheel, 0.0, 1.0)


class _Dots(StampedDisplay):
    def dots(self, points: np.ndarray, colours: np.ndarray | None, pose: Pose, scene: Scene) -> None:
        """Show points, where they are numbers."""
        good = np.isfinite(points).all(axis=1)
        points, colours = points[good], None if colours is None else colours[good]
        step = -(-len(points) // MOST) or 1
        self.say("Points", "Ok", f"Showing {len(points[::step])} points")
        shape = Points(
            points[::step],
            float(self.options["size"]),
            colour_of(self.options["color"], self.options["alpha"]),
            None if colours is None else colours[::step],
        )
        scene.put(self.key, "points", *([shape] if len(points) else []), pose=pose)


class LaserScan(_Dots):
    """The newest scan; beams out of range are left out."""

    kind = "LaserScan"

    def show(self, msg: Any, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Dots where the beams ended."""
        ranges = np.asarray(msg.ranges, float)
        angles = msg.angle_min + np.arange(len(ranges)) * msg.angle_increment
        with np.errstate(invalid="ignore"):
            hit = (ranges >= msg.range_min) & (ranges <= msg.range_max)
        far, turn = ranges[hit], angles[hit]
        points = np.stack([far * np.cos(turn), far * np.sin(turn), np.zeros_like(far)], axis=1)
        bright = np.asarray(msg.intensities, float)
        by_brightness = self.options["color_transformer"] == "Intensity" and len(bright) == len(ranges)
        self.dots(points, rainbow(bright[hit]) if by_brightness else None, pose, scene)


class PointCloud2(_Dots):
    """The newest cloud."""

    kind = "PointCloud2"

    def show(self, msg: Any, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Dots."""
        try:
            table = read_cloud(msg)
            points = np.stack([table[axis].astype(float) for axis in "xyz"], axis=1)
        except (ValueError, KeyError, TypeError) as error:
            self.say("Message", "Error", f"The cloud cannot be read: {error}")
            return
        self.unsay("Message")
        self.dots(points, self._colours(table, points), pose, scene)

    def _colours(self, table: np.ndarray, points: np.ndarray) -> np.ndarray | None:
        names, how = table.dtype.names or (), self.options["color_transformer"]
        packed = next((one for one in ("rgb", "rgba") if one in names), None)
        if packed is not None and how in ("", "RGB8", "RGB"):
            word = np.ascontiguousarray(table[packed]).view("u4")
            return np.stack([(word >> shift) & 255 for shift in (16, 8, 0)], axis=1) / 255.0
        if "intensity" in names and how in ("", "Intensity"):
            return rainbow(table["intensity"].astype(float))
        height = np.nan_to_num(points[:, 2], posinf=0.0, neginf=0.0)
        return None if how == "FlatColor" else rainbow(height)


def read_cloud(msg: Any) -> np.ndarray:
    """A sensor_msgs/PointCloud2 as a table with its fields' names; raises ValueError if sizes do not fit."""
    order = ">" if msg.is_bigendian else "<"
    for field in msg.fields:
        if field.datatype not in _TYPES:
            raise ValueError(f"field '{field.name}' has the unknown datatype {field.datatype}")
    kinds = [order + _TYPES[field.datatype] for field in msg.fields]
    kind = np.dtype(
        {
            "names": [field.name for field in msg.fields],
            "formats": [one if f.count <= 1 else (one, (f.count,)) for one, f in zip(kinds, msg.fields, strict=True)],
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
