"""A picture in the notebook that can change thirty times a second without falling behind."""

from __future__ import annotations

import base64
import threading
from collections.abc import Callable
from typing import Any

import cv2

from coursekit.processes.session import current
from coursekit.words.gettext import gettext

from .bundle import forms_of
from .docking import View
from .script import script, style

PERIOD_SECONDS = 1 / 30
"""The minimum period between pictures sent to the browser [s]."""
PATIENCE_SECONDS = 1.0
"""The timeout after which a picture is sent although the browser has acknowledged none [s]."""
UNDER_WAY = 3
"""How many unacknowledged pictures may be in flight to the browser."""
QUALITY = 85


class Picture(View):
    """Shows the newest image. The browser acknowledges each drawn image, so none waits in a queue.

    `read()` returns the newest image (BGR, or None); it is called only when the image can be sent.
    """

    _esm = script("picture.js")
    _css = style("picture.css")

    def __init__(self, read: Callable[[], Any], live: bool = True) -> None:
        super().__init__()
        self._read = read
        self._live = live
        self._lock = threading.Lock()
        self._under_way = 0
        self._fresh = False
        self._sent_at = 0
        self._alarm: Any = None
        self._viewed = False
        self.on_key: Callable[[int], None] = lambda _code: None
        self.on_msg(self._hear)

    # -- for subclasses

    def heading(self) -> str:
        """Return the text above the picture."""
        return "image"

    def note(self) -> str:
        """Return the text to the right of the heading, for example the image size."""
        return ""

    def is_open(self) -> bool:
        """Whether more images may come."""
        return True

    def controls(self) -> dict[str, Any]:
        """Return what can be changed at the picture: `trackbars`, and `mouse` if somebody hears of it."""
        return {}

    def touched(self, message: dict[str, Any]) -> None:
        """Handle a trackbar that was moved, or the mouse."""

    # -- news

    def news(self) -> None:
        """Report a newer image or another change; thread-safe, and cheap when no page shows the picture."""
        if not self._viewed or current().clock.virtual:
            return
        with self._lock:
            self._fresh = True
            self._plan()

    def _plan(self) -> None:
        """Schedule a send as early as allowed; the caller holds the lock."""
        if not self._fresh or self._alarm is not None:
            return
        clock = current().clock
        least = PERIOD_SECONDS if self._under_way < UNDER_WAY else PATIENCE_SECONDS
        due = self._sent_at + round(least * 1e9)
        self._alarm = clock.call_at(max(due, clock.steady()), self._push)

    def _push(self) -> None:
        with self._lock:
            self._alarm = None
            self._fresh = False
            self._under_way = min(UNDER_WAY, self._under_way + 1)
            self._sent_at = current().clock.steady()
        self._tell()

    def _tell(self) -> None:
        image = self._read()
        message = {"title": self.heading(), "note": self.note(), "open": self.is_open(), "live": self._live}
        message |= self.controls()
        if image is None:
            self.send({**message, "empty": gettext("no image yet")})
            with self._lock:
                self._under_way = 0
            return
        data = cv2.imencode(".jpg", image, [cv2.IMWRITE_JPEG_QUALITY, QUALITY])[1].tobytes()
        self.send({**message, "width": image.shape[1]}, [data])

    def _hear(self, _widget: object, message: dict[str, Any], _buffers: object) -> None:
        kind = message.get("type")
        if kind == "ready":
            self._viewed = True
            self._tell()
        elif kind == "key":
            self.on_key(int(message.get("code", -1)))
        elif kind in ("slide", "mouse"):
            self.touched(message)
        elif kind == "shown":
            with self._lock:
                self._under_way = max(0, self._under_way - 1)
                if self._alarm is not None:
                    self._alarm.cancel()
                    self._alarm = None
                self._plan()

    # -- without a browser

    def __repr__(self) -> str:
        return f"[{self.heading()}: {self.note() or 'no image yet'}]"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        bundle = super()._repr_mimebundle_(**kwargs)
        data = forms_of(bundle)
        if data is not None:
            data["text/plain"] = repr(self)
            image = self._read()
            if image is not None:
                data["image/jpeg"] = base64.b64encode(cv2.imencode(".jpg", image)[1].tobytes()).decode()
        return bundle
