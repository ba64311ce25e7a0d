"""The input of a costmap's RangeSensorLayer: a topic of ranges, for example from sonars and infrared sensors."""

from __future__ import annotations

import math

import numpy as np
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import Range
from tf2_sensor_msgs.tf2_sensor_msgs import transform_points

from coursekit.nodes.nav2.scan_source import Source
from coursekit.nodes.scanning.planar import ends_of

STEP = math.radians(2.0)
"""The angle between the beams of a cone [rad]."""


class RangeSource(Source):
    """Marks obstacles on the arc at the end of a sensor's cone, and clears the space before it."""

    kind, what = Range, "range"

    def fault(self, msg: Range) -> str:
        """The reason why a range cannot be used; empty if it can."""
        numbers = (msg.field_of_view, msg.min_range, msg.max_range)
        if all(map(math.isfinite, numbers)) and 0 <= msg.field_of_view <= 2 * math.pi and msg.min_range <= msg.max_range:
            return ""
        return f"its field_of_view, min_range and max_range are {', '.join(f'{number:g}' for number in numbers)}"

    def see(self, msg: Range, seat: TransformStamped) -> None:
        """Mark and clear with a range of a sensor at the pose `seat`."""
        far = msg.range >= msg.max_range
        if (far and not self.given["clear_on_max_reading"]) or not msg.range >= msg.min_range:
            return
        half = msg.field_of_view / 2
        angles = np.linspace(-half, half, max(math.ceil(2 * half / STEP), 1) + 1)
        flat = ends_of(np.full(len(angles), min(msg.range, msg.max_range)), angles)
        ends, here = transform_points(flat, seat)[:, :2], seat.transform.translation
        self.layer.see((here.x, here.y), ends, np.full(len(ends), not far), clearing=True)


__all__ = ["RangeSource"]
