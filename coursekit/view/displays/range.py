"""Range: the cone of an ultrasonic or infrared sensor, up to the measured range."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Triangles, colour_of, tube

from .kept import KeptDisplay

if TYPE_CHECKING:
    from sensor_msgs.msg import Range as RangeMsg

    from coursekit.view.scene_stage import Stage


class Range(KeptDisplay):
    """The last `buffer_length` measurements."""

    kind = "Range"
    length = "buffer_length"

    def show(self, msg: RangeMsg, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Draw a cone along x from the sensor; none if the range is outside the limits."""
        far = msg.range
        if math.isinf(far) and msg.min_range == msg.max_range:
            far = msg.min_range if far < 0 else 0.0  # a switch: -inf means detected, inf not detected
        if not (math.isfinite(far) and msg.min_range <= far <= msg.max_range):
            self.say("Range", "Ok", f"Nothing between {msg.min_range:.3g} and {msg.max_range:.3g} m: {msg.range:.3g}")
            self.keep(scene, pose=pose)
            return
        self.say("Range", "Ok", f"{far:.3g} m")
        wide = far * math.tan(min(max(msg.field_of_view, 0.0), 3.0) / 2)
        body = tube(0.0, far, 0.0, wide, sides=24)
        self.keep(scene, Triangles(*body, colour_of(self.options["color"], self.options["alpha"])), pose=pose)
