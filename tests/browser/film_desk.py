"""The README's film: a student drives from the desk of chapter 0, and the robot maps the room.

No test, so it is named: `COURSEKIT_PICTURES=FOLDER python -m pytest tests/browser/film_desk.py` writes FOLDER/desk.gif.
"""

import io
import os
from pathlib import Path

import pytest
from PIL import Image

from tests.browser.test_desk import LIVE

FRAME_MS = 250
"""Of the page's time and of the film's."""
WIDTH = 900
ROUTE = (("ArrowUp", 10), ("ArrowLeft", 6), ("ArrowUp", 14), ("ArrowLeft", 6), ("ArrowUp", 10), ("", 6))
"""Which key is held for how many frames."""


class Film:
    """Pictures of a page, one after the other."""

    def __init__(self, page):
        self._page = page
        self._frames = []

    def take(self):
        """Add what the page shows now."""
        whole = Image.open(io.BytesIO(self._page.screenshot())).convert("RGB")
        small = whole.resize((WIDTH, round(whole.height * WIDTH / whole.width)), Image.Resampling.LANCZOS)
        self._frames.append(small)

    def write(self, path):
        """Keep them as a GIF that begins anew at its end; one palette for all, so that nothing flickers."""
        palette = self._frames[-1].quantize(128, dither=Image.Dither.NONE)
        first, *others = [one.quantize(palette=palette, dither=Image.Dither.NONE) for one in self._frames]
        first.save(path, save_all=True, append_images=others, duration=FRAME_MS, loop=0, optimize=True)


def test_film(chapter):
    opened = chapter("00_start_here.ipynb")
    page = opened.page
    page.set_viewport_size({"width": 1366, "height": 768})
    opened.run_to("desk(")
    page.wait_for_selector(LIVE, timeout=60_000)
    page.wait_for_timeout(4000)
    page.locator(".jupyterlab-sidecar .ck-pad .ck-field").click()
    film = Film(page)
    for key, frames in ROUTE:
        if key:
            page.keyboard.down(key)
        for _ in range(frames):
            film.take()
            page.wait_for_timeout(FRAME_MS)
        if key:
            page.keyboard.up(key)
    folder = Path(os.environ["COURSEKIT_PICTURES"])
    folder.mkdir(parents=True, exist_ok=True)
    film.write(folder / "desk.gif")
    assert (folder / "desk.gif").stat().st_size < 3_000_000


pytestmark = [pytest.mark.browser, pytest.mark.timeout(300)]
