"""The README's film: a student drives from the desk of chapter 0, and the robot maps the room.

No test, so it is named: `COURSEKIT_PICTURES=FOLDER python -m pytest tests/browser/film_desk.py` writes FOLDER/desk.gif.
"""

import io
import os
import time
from itertools import pairwise
from pathlib import Path

import pytest
from PIL import Image

from tests.browser.test_desk import LIVE

FRAME_MS = 100
"""Between two pictures, at least; a picture itself takes longer."""
SPEED = 3
"""How many times faster the film is than the drive."""
WIDTH = 900
ROUTE = (("ArrowUp", 9.0), ("ArrowLeft", 1.6), ("ArrowUp", 7.0), ("ArrowLeft", 1.6), ("ArrowUp", 4.0), ("", 1.5))
"""Which key is held for how long [s]."""


class Film:
    """Pictures of a page, one after the other."""

    def __init__(self, page):
        self._page = page
        self._frames = []
        self._times = []

    def take_for(self, seconds):
        """Add what the page shows, again and again."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self._take()
            self._page.wait_for_timeout(FRAME_MS)

    def _take(self):
        self._times.append(time.monotonic())
        whole = Image.open(io.BytesIO(self._page.screenshot())).convert("RGB")
        small = whole.resize((WIDTH, round(whole.height * WIDTH / whole.width)), Image.Resampling.LANCZOS)
        self._frames.append(small)

    def write(self, path):
        """Keep them as a GIF that begins anew at its end; one palette for all, so that nothing flickers."""
        palette = self._frames[-1].quantize(128, dither=Image.Dither.NONE)
        first, *others = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in self._frames]
        durations = [round(1000 * (after - before) / SPEED) for before, after in pairwise(self._times)] + [1000]
        first.save(path, save_all=True, append_images=others, duration=durations, loop=0, optimize=True)


def test_film(chapter):
    opened = chapter("00_start_here.ipynb")
    page = opened.page
    page.set_viewport_size({"width": 1366, "height": 768})
    opened.run_to("desk(")
    page.wait_for_selector(LIVE, timeout=60_000)
    page.wait_for_timeout(12_000)  # until all is laid out
    page.locator(".jupyterlab-sidecar .ck-pad .ck-field").click()
    film = Film(page)
    for key, seconds in ROUTE:
        if key:
            page.keyboard.down(key)
        film.take_for(seconds)
        if key:
            page.keyboard.up(key)
    folder = Path(os.environ["COURSEKIT_PICTURES"])
    folder.mkdir(parents=True, exist_ok=True)
    film.write(folder / "desk.gif")
    assert (folder / "desk.gif").stat().st_size < 3_000_000


pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]
