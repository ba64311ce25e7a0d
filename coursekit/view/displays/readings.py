"""Temperature, RelativeHumidity, FluidPressure and Illuminance: a dot at the sensor, coloured by its value."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from coursekit.view.scene import Pose, Scene
from coursekit.view.scene_shapes import Label, Points, colour_of

from .display import StampedDisplay
from .points import rainbow

if TYPE_CHECKING:
    from sensor_msgs.msg import FluidPressure as FluidPressureMsg
    from sensor_msgs.msg import Illuminance as IlluminanceMsg
    from sensor_msgs.msg import RelativeHumidity as RelativeHumidityMsg
    from sensor_msgs.msg import Temperature as TemperatureMsg

    from coursekit.view.scene_stage import Stage


class _Reading(StampedDisplay):
    field: ClassVar[str] = ""
    unit: ClassVar[str] = ""

    def show(
        self,
        msg: TemperatureMsg | RelativeHumidityMsg | FluidPressureMsg | IlluminanceMsg,
        pose: Pose,
        stage: Stage,
        scene: Scene,
    ) -> None:
        """Draw the dot, blue at `min_intensity` and red at `max_intensity`, with the number beside it."""
        value, low, high = getattr(msg, self.field), self.options["min_intensity"], self.options["max_intensity"]
        if not math.isfinite(value):
            self.say("Reading", "Warn", f"The sensor reads {value}")
            return
        text = f"{value:.4g} {self.unit}".strip()
        self.say("Reading", "Ok", text)
        shade = rainbow(np.clip(np.array([value, low, high]), min(low, high), max(low, high)))[:1]
        dot = Points(np.zeros((1, 3)), self.options["size"], colour_of([255, 255, 255], self.options["alpha"]), shade)
        scene.put(self.key, "reading", dot, Label(text), pose=pose)


class Temperature(_Reading):
    """In degrees Celsius."""

    kind, field, unit = "Temperature", "temperature", "°C"


class RelativeHumidity(_Reading):
    """From 0 to 1."""

    kind, field = "RelativeHumidity", "relative_humidity"


class FluidPressure(_Reading):
    """In pascals."""

    kind, field, unit = "FluidPressure", "fluid_pressure", "Pa"


class Illuminance(_Reading):
    """In lux."""

    kind, field, unit = "Illuminance", "illuminance", "lx"
