"""The simulated world through a robot's camera, for code outside of ROS: `cv2.VideoCapture(0)`."""

from __future__ import annotations

from typing import Any
from weakref import WeakKeyDictionary

from coursekit.sim.view import View

from .devices import CameraDevice
from .simulators import Simulator

_views: WeakKeyDictionary[Any, dict[tuple[int, int, str], View]] = WeakKeyDictionary()


def picture_of(simulator: Simulator, width: int, height: int) -> Any:
    """Return the current image of the first robot's first camera in BGR order; None without a camera."""
    for name, model in list(simulator.assemblies.items()):
        robot = simulator.simulation.robots.get(name)
        camera = next((device for device in model.devices if isinstance(device, CameraDevice)), None)
        if robot is not None and camera is not None:
            return _view(simulator, camera, name, width, height).render(simulator.simulation, robot.place, without=robot)
    return None


def _view(simulator: Simulator, camera: CameraDevice, name: str, width: int, height: int) -> View:
    from .cameras import view_of

    views = _views.setdefault(simulator, {})
    key = (width, height, name)
    if key not in views:
        views[key] = view_of(camera, width, height)
    return views[key]


__all__ = ["picture_of"]
