"""A drive on the floor, and what wheels and a gyroscope say of it."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from coursekit.nav.fusion.measurement import Measurement, keep_in_plane
from coursekit.nav.fusion.state import SIZE

PERIOD_NS = 20_000_000


def say(time_ns: int, source: str = "one", threshold: float = math.inf, **numbers: tuple[float, float]) -> Measurement:
    """A measurement: say(0, X=(1.0, 0.01)) gives the value and the variance of some numbers of the state."""
    from coursekit.nav.fusion import state

    values, covariance, used = np.zeros(SIZE), np.zeros((SIZE, SIZE)), np.zeros(SIZE, bool)
    for name, (value, variance) in numbers.items():
        place = getattr(state, name)
        values[place], covariance[place, place], used[place] = value, variance, True
    return Measurement(source, time_ns, values, covariance, used, threshold)


def flat(measurement: Measurement) -> Measurement:
    """The same of a body on the floor."""
    keep_in_plane(measurement.values, measurement.covariance, measurement.used)
    return measurement


def drive(seed: int, steps: int = 1500) -> Iterator[tuple[tuple[float, float, float], Measurement, Measurement]]:
    """The truth (x, y, yaw), what the wheels say of the speeds (they slip in turns), what the gyroscope says."""
    rng = np.random.default_rng(seed)
    x = y = yaw = 0.0
    for k in range(1, steps + 1):
        t, dt = k * PERIOD_NS * 1e-9, PERIOD_NS * 1e-9
        forward, turn = 0.5 + 0.2 * math.sin(t / 3), 0.6 * math.sin(t / 2)
        x, y = x + forward * math.cos(yaw + turn * dt / 2) * dt, y + forward * math.sin(yaw + turn * dt / 2) * dt
        yaw += turn * dt
        slip = 1.15 * turn + rng.normal(0, 0.1) + 0.03
        wheels = say(k * PERIOD_NS, "wheels", VX=(forward + rng.normal(0, 0.02), 4e-4), VY=(0.0, 1e-4), VYAW=(slip, 0.02))
        gyroscope = say(k * PERIOD_NS, "gyroscope", VYAW=(turn + rng.normal(0, 0.005), 2.5e-5))
        yield (x, y, yaw), flat(wheels), flat(gyroscope)


