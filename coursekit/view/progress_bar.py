"""A progress bar in the notebook for slow work: it appears after a moment, shows the progress, and disappears."""

from __future__ import annotations

import html
import threading
import time
from contextlib import AbstractContextManager
from typing import Any

from .shell import running_shell

PATIENCE_SECONDS = 1.5
"""The minimum duration of work with a bar [s]."""
LOOK_SECONDS = 0.3
LATE_SECONDS = 45.0


class ProgressBar(AbstractContextManager["ProgressBar"]):
    """Shows `what` and a bar while the block runs; nothing on the virtual clock or without a notebook.

    >>> with ProgressBar("Driving") as bar:
    ...     bar.share = 0.5
    """

    def __init__(self, what: str, seconds: float = 0.0, late: str = "") -> None:
        self.what, self.seconds, self.late = what, seconds, late
        """`late` is shown below the bar once the block has run for LATE_SECONDS."""
        self.share: float | None = None
        """The completed fraction, 0 to 1; None if unknown, or if the work lasts `seconds`."""
        self.note = ""
        """A sentence below the bar, for as long as it is set."""
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._show, daemon=True)
        self._since = time.monotonic()

    def __enter__(self) -> ProgressBar:
        if _has_a_page():
            self._thread.start()
        return self

    def __exit__(self, *_: Any) -> None:
        self._over.set()
        if self._thread.ident is not None:
            self._thread.join()

    def _show(self) -> None:
        from IPython.display import HTML, display

        if self._over.wait(PATIENCE_SECONDS):
            return
        shown = display(HTML(self.html()), display_id=True)
        while not self._over.wait(LOOK_SECONDS):
            shown.update(HTML(self.html()))
        shown.update(HTML(""))

    def html(self) -> str:
        """Return the current bar."""
        passed = time.monotonic() - self._since
        share = passed / self.seconds if self.seconds else self.share
        value = "" if share is None else f' value="{min(max(share, 0.0), 1.0):.3f}"'
        style = "font:13px system-ui,sans-serif;color:#68757d"
        bar = f'<progress max="1"{value} style="width:14rem;vertical-align:middle"></progress>'
        notes = (self.note, self.late if passed >= LATE_SECONDS else "")
        below = "".join(f"<br>{html.escape(note)}" for note in notes if note)
        return f'<div style="{style}">{html.escape(self.what)} {bar} {passed:.0f} s{below}</div>'


def _has_a_page() -> bool:
    """Whether a notebook page may show the bar: the process is a kernel on the wall clock."""
    from coursekit.processes.session import current

    return hasattr(getattr(running_shell(), "kernel", None), "session") and not current().clock.virtual


__all__ = ["ProgressBar"]
