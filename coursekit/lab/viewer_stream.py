"""The stream to the browser: at most thirty times a second, and only after the browser has drawn the last part."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

import cv2

from coursekit.view.scene import Changes, Scene
from coursekit.view.scene_past import Moment, between, moment_of, size_of
from coursekit.view.scene_wire import packed

from .panel_history import EVERY_SECONDS

if TYPE_CHECKING:
    from .scene_panel import ScenePanel

FRAME_SECONDS = 1 / 30
LIST_SECONDS = 0.25
"""The period at which the list of displays is compared [s]."""
JPEG_QUALITY = 80
Kept = tuple[Moment, dict[str, bytes]]
"""The scene at one time: its objects, and the pictures beside it by display name."""


class Stream:
    """Sends a panel's scene in its own thread. Nothing queues: while a page draws, changes only accumulate."""

    def __init__(self, panel: ScenePanel) -> None:
        self.panel = panel
        self._lock = threading.Lock()
        self._running = False
        self._closed = False
        self._sent = self._acknowledged = 0
        self._whole = True
        self._fitted = False
        self._anew = False
        self._led: dict[str, Any] = {}
        self._list: Any = None
        self._list_due = 0
        self._pictures: dict[str, int] = {}
        self._jpegs: dict[str, bytes] = {}
        """The newest pictures, by display name."""
        self._jpegs_there: dict[str, bytes] = {}
        """The pictures that the page has."""
        self._kept: Kept = {}, {}
        """The newest moment recorded in the panel's history."""
        self._keep_due = 0
        self._page: Moment | None = None
        """The page's content while it shows the past."""

    def open(self) -> None:
        """Handle a page that shows nothing yet: send everything."""
        with self._lock:
            self._whole, self._fitted, self._list, self._jpegs_there = True, False, None, {}
            self._acknowledged = self._sent
            start, self._running = not self._running, True
        if start:
            self.panel.session.spawn(self._run)

    def drawn(self, number: int) -> None:
        """Handle the acknowledgement of a drawn message."""
        self._acknowledged = max(self._acknowledged, min(number, self._sent))

    def look_anew(self) -> None:
        """Send the camera, also to a page whose camera the user has moved."""
        self._anew, self._fitted = True, False
        self.hurry()

    def hurry(self) -> None:
        """Compare the list with the next picture."""
        self._list_due = 0

    def close(self) -> None:
        """Stop the stream."""
        self._closed = True

    def _run(self) -> None:
        clock = self.panel.session.clock
        due = clock.steady()
        while not self._closed:
            if self._acknowledged == self._sent:
                self.step()
            due = max(due + round(FRAME_SECONDS * 1e9), clock.steady())
            clock.sleep(max(0.001, (due - clock.steady()) * 1e-9))

    def step(self) -> None:
        """Send the changes, if there are any."""
        stage = self.panel.stage
        with self._lock:
            whole, self._whole = self._whole, False
        with stage.lock:
            scene = stage.update()
            self._keep(scene)
            time = self.panel.cursor.time
            then: Kept | None = None if time is None else self.panel.past.at(time) or (moment_of(scene), {})
            anew = whole or (self._page is None and then is not None)
            changes = self._changes(scene, whole, then)
            view = self._view(whole)
            led = {"follow": self.panel.follows(), "marked": self.panel.marked(), "past": self._page is not None}
        self._tell_list()
        pictures, images = self._images(then)
        if not (changes or anew or view or pictures or led != self._led):
            return
        self._led = led
        message, buffers = packed(changes)
        self._sent += 1
        message |= {"type": "scene", "n": self._sent, "whole": anew, "view": view, "images": pictures, **led}
        if not self._closed:
            self.panel.send(message, buffers=[*buffers, *images])

    def _changes(self, scene: Scene, whole: bool, then: Kept | None) -> Changes:
        """Return the changes that make the page show the scene, or the past moment at the cursor."""
        live = scene.whole() if whole else scene.changes()
        if then is None and self._page is None:
            return live
        before = {} if whole or self._page is None else self._page
        self._page = then[0] if then is not None else None
        return between(before, then[0] if then is not None else moment_of(scene))

    def _keep(self, scene: Scene) -> None:
        """Record the current scene a few times a second, if it differs from the last recorded one."""
        now, (things, jpegs) = self.panel.session.clock.steady(), self._kept
        if now < self._keep_due:
            return
        self._keep_due = now + round(EVERY_SECONDS * 1e9)
        moment = moment_of(scene)
        if between(things, moment) or jpegs != self._jpegs:
            new = [jpeg for name, jpeg in self._jpegs.items() if jpegs.get(name) is not jpeg]
            self._kept = moment, dict(self._jpegs)
            self.panel.past.keep(now, self._kept, size_of(moment, things) + sum(map(len, new)))

    def _view(self, whole: bool) -> dict[str, Any] | None:
        """Return the camera: at the start, and once more when there is an object to look at."""
        stage = self.panel.stage
        if self._fitted and not whole:
            return None
        self._fitted = stage.seen() and stage.scene.bounds() is not None
        if not (self._fitted or whole):
            return None
        anew, self._anew = self._anew, False
        camera = stage.camera()
        return {**camera.as_dict(), "flat": camera.flat, "anew": anew}

    def _tell_list(self) -> None:
        now = self.panel.session.clock.steady()
        if self._list is not None and now < self._list_due:
            return
        self._list_due = now + round(LIST_SECONDS * 1e9)
        shown = self.panel.shown()
        if shown != self._list:
            self._list = shown
            self.panel.tell(type="shown", **shown)

    def _images(self, then: Kept | None) -> tuple[list[str], list[bytes]]:
        """Return the names of the pictures that the page lacks, and their JPEG data."""
        for image in self.panel.stage.images():
            if self._pictures.get(image.key) != image.drawn:
                self._pictures[image.key] = image.drawn
                good, jpeg = cv2.imencode(".jpg", image.picture, (cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY))
                self._jpegs |= {image.config.name: jpeg.tobytes()} if good else {}
        wanted = self._jpegs if then is None else then[1]
        news = {name: jpeg for name, jpeg in wanted.items() if self._jpegs_there.get(name) is not jpeg}
        self._jpegs_there |= news
        return list(news), list(news.values())


__all__ = ["Stream"]
