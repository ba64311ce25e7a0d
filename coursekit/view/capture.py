"""`cv2.VideoCapture(0)` without a webcam: the virtual camera, with 30 images per second of session time.

While a simulator runs, the camera shows the simulated world through the first camera of a robot; otherwise it shows a
scene of its own.
"""

from __future__ import annotations

import sys
from typing import Any

import cv2

from coursekit.processes.session import current
from coursekit.sim.camera import Scene

WIDTH, HEIGHT, RATE = 640, 480, 30.0
LARGEST = 1920
_scene = Scene()


class VirtualCapture:
    """A camera with OpenCV's interface; index 0 only.

    `read` waits for the next image, as a webcam does. Any size from 16 to 1920 pixels and any rate from 1 to 120
    can be set.
    """

    def __init__(self, index: Any = 0, *_backend: Any) -> None:
        self._open = False
        self.open(index)

    def open(self, index: Any = 0, *_backend: Any) -> bool:
        """Open the camera; False for any index but 0."""
        self._size = {cv2.CAP_PROP_FRAME_WIDTH: WIDTH, cv2.CAP_PROP_FRAME_HEIGHT: HEIGHT}
        self._rate = RATE
        self._due = current().clock.steady()
        self._seen = self._due
        self._open = index == 0
        return self._open

    def isOpened(self) -> bool:
        """Whether the camera can be read."""
        return self._open

    def read(self, image: Any = None) -> tuple[bool, Any]:
        """Return (True, the next image), or (False, None) if the camera is not open."""
        return self.retrieve(image) if self.grab() else (False, None)

    def grab(self) -> bool:
        """Wait for the next image and grab it."""
        if not self._open:
            return False
        clock = current().clock
        now = clock.steady()
        if now < self._due:
            clock.sleep((self._due - now) * 1e-9)
        self._seen = max(self._due, now)
        period = round(1e9 / self._rate)
        self._due += period if now - self._due < 2 * period else now - self._due + period
        return True

    def retrieve(self, image: Any = None, _flag: int = 0) -> tuple[bool, Any]:
        """Return the grabbed image in BGR order."""
        if not self._open:
            return False, None
        width, height = (
            int(self._size[property_id]) for property_id in (cv2.CAP_PROP_FRAME_WIDTH, cv2.CAP_PROP_FRAME_HEIGHT)
        )
        picture = _picture(self._seen * 1e-9, width, height)
        if image is not None and image.shape == picture.shape:
            image[:] = picture
            picture = image
        return True, picture

    def get(self, prop: int) -> float:
        """Return a property: width, height, rate, position in ms; 0.0 for others."""
        if prop in self._size:
            return float(self._size[prop])
        return {cv2.CAP_PROP_FPS: self._rate, cv2.CAP_PROP_POS_MSEC: self._seen * 1e-6}.get(prop, 0.0)

    def set(self, prop: int, value: float) -> bool:
        """Change width, height or rate; False for any other property or an invalid value."""
        if not self._open:
            return False
        if prop in self._size and 16 <= value <= LARGEST:
            self._size[prop] = int(value)
            return True
        if prop == cv2.CAP_PROP_FPS and 1.0 <= value <= 120.0:
            self._rate = float(value)
            return True
        return False

    def getBackendName(self) -> str:
        """Return the name of the backend."""
        return "COURSEKIT"

    def release(self) -> None:
        """Close the camera."""
        self._open = False


def _picture(seconds: float, width: int, height: int) -> Any:
    """Render the simulated world, or the scene at a time."""
    if "coursekit.nodes.gazebo.simulators" not in sys.modules:  # no simulator ever ran: spare its import
        return _scene.render(seconds, width, height)
    from coursekit.nodes.gazebo.simulators import simulators
    from coursekit.nodes.gazebo.virtual_camera import picture_of

    for simulator in simulators.running(current()):
        picture = picture_of(simulator, width, height)
        if picture is not None:
            return picture
    return _scene.render(seconds, width, height)
