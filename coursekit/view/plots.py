"""matplotlib's windows in a session: `plt.show`, `plt.pause`, animations and `flush_events` of a process.

A node that plots runs in a thread, where no GUI toolkit works, so none is used. Its figures become windows as
OpenCV's do (a notebook shows them: `coursekit.lab.windows()`). `show` lasts until Ctrl-C or until the last figure is
closed. Timers, such as an animation's, use the session's time. Plots made by a notebook's own cells are not affected.
"""

from __future__ import annotations

from typing import Any

import cv2  # noqa: F401 - brings highgui with it, which cannot come first
import matplotlib.backend_bases as bases
import matplotlib.pyplot as plt
import numpy as np
from matplotlib._pylab_helpers import Gcf
from matplotlib.backends.backend_agg import FigureCanvasAgg

from coursekit.processes.patching import IMPORTS, Patch, always, patch_manager
from coursekit.processes.process import Process, current_process

from . import older_matplotlib
from .desk import desk
from .highgui import imshow

FRAME = 0.1
"""The maximum time between two updates of the figures [s]."""
_real: dict[str, Any] = {
    "new_figure_manager": plt.new_figure_manager,
    "show": plt.show,
    "pause": plt.pause,
    "new_timer": bases.FigureCanvasBase.new_timer,
    "flush_events": bases.FigureCanvasBase.flush_events,
    "set_new": Gcf._set_new_active_manager,
}


class Plots:
    """The figures of one process and its running timers."""

    def __init__(self, process: Process) -> None:
        self.clock = process.session.clock
        self.managers: list[Any] = []
        self.timers: list[SessionTimer] = []
        self._drawn: set[int] = set()
        process.cleanups.append(self.close)

    def add(self, manager: Any) -> None:
        """Manage a new figure."""
        self.managers.append(manager)
        manager.canvas.mpl_connect("draw_event", lambda _: self._drawn.add(manager.num))

    def open_managers(self) -> list[Any]:
        """Return the figures that pyplot still has."""
        self.managers = [manager for manager in self.managers if Gcf.figs.get(manager.num) is manager]
        return self.managers

    def draw(self) -> None:
        """Draw the changed figures, and show them."""
        for manager in self.open_managers():
            canvas = manager.canvas
            name = canvas.figure.get_label() or f"Figure {manager.num}"
            if canvas.figure.stale or name not in desk().windows:
                canvas.draw()
            if manager.num in self._drawn:
                self._drawn.discard(manager.num)
                imshow(name, np.asarray(canvas.buffer_rgba())[..., 2::-1])

    def run(self, seconds: float | None) -> None:
        """Draw and fire timers for `seconds`; None: until no figure is open."""
        end = None if seconds is None else self.clock.steady() + round(seconds * 1e9)
        while self.open_managers() if end is None else True:
            self.draw()
            now = self.clock.steady()
            if end is not None and now >= end:
                return
            due = [timer.due for timer in self.timers] + ([end] if end is not None else [])
            self.clock.sleep(max(0.0, min([FRAME, *((at - now) * 1e-9 for at in due)])))
            for timer in [timer for timer in self.timers if timer.due <= self.clock.steady()]:
                timer.fire()

    def close(self) -> None:
        """Close the process's figures and their windows."""
        for manager in self.open_managers():
            desk().close(manager.canvas.figure.get_label() or f"Figure {manager.num}")
            Gcf.figs.pop(manager.num, None)


class SessionTimer(bases.TimerBase):
    """A timer that uses the session's time while its process shows figures."""

    plots: Plots
    due = 0

    def _timer_start(self) -> None:
        self.due = self.plots.clock.steady() + self.interval * 1_000_000
        if self not in self.plots.timers:
            self.plots.timers.append(self)

    def _timer_stop(self) -> None:
        if self in self.plots.timers:
            self.plots.timers.remove(self)

    def fire(self) -> None:
        """Call the callbacks, and schedule the next call one interval later."""
        self.due += self.interval * 1_000_000
        self._on_timer()  # type: ignore[attr-defined]
        if self.single_shot:
            self._timer_stop()


def plots() -> Plots | None:
    """Return the figures of the current process; None outside of processes."""
    process = current_process()
    if process is None:
        return None
    if "plots" not in process.locals:
        process.locals["plots"] = Plots(process)
    return process.locals["plots"]  # type: ignore[no-any-return]


def new_figure_manager(num: int | str, *args: Any, FigureClass: Any = plt.Figure, **kwargs: Any) -> Any:
    """Make a figure and its manager; in a process without a window of the system."""
    if current_process() is None:
        return _real["new_figure_manager"](num, *args, FigureClass=FigureClass, **kwargs)
    return FigureCanvasAgg.new_manager(FigureClass(*args, **kwargs), num)


def show(*args: Any, block: bool | None = None, **kwargs: Any) -> Any:
    """Show the figures; returns when the last is closed, or at once with `block=False` or after `plt.ion()`."""
    own = plots()
    if own is None:
        return _real["show"](*args, **kwargs) if block is None else _real["show"](*args, block=block, **kwargs)
    own.run(None if (not plt.isinteractive() if block is None else block) else 0.0)
    return None


def pause(interval: float) -> None:
    """Show the figures for `interval` seconds of the session's time."""
    own = plots()
    if own is None:
        _real["pause"](interval)
    else:
        own.run(interval)


def _new_timer(self: Any, interval: int | None = None, callbacks: Any = None) -> Any:
    own = plots()
    if own is None:
        return _real["new_timer"](self, interval, callbacks)
    timer = SessionTimer(interval, callbacks)
    timer.plots = own
    return timer


def _flush_events(self: Any) -> None:
    own = plots()
    if own is None:
        _real["flush_events"](self)
    else:
        own.run(0.0)


def _set_new_active_manager(cls: Any, manager: Any) -> None:
    _real["set_new"](manager)
    own = plots()
    if own is not None:
        own.add(manager)


def patches() -> list[Patch]:
    """Return the patches of pyplot."""
    return [*_PATCHES, *older_matplotlib.PATCHES]


def install() -> None:
    """Patch pyplot while sessions are open."""
    patch_manager.lend(*_PATCHES)
    patch_manager.lend(*older_matplotlib.PATCHES, at_once=True)


_REASON, _TEST = "a program's figures become windows of the session", "tests/view/test_plots.py"
_CANVAS, _MANAGERS = "matplotlib.backend_bases.FigureCanvasBase", "matplotlib._pylab_helpers.Gcf"
_PATCHES = [
    Patch("matplotlib.pyplot.new_figure_manager", always(new_figure_manager), _REASON, _TEST, IMPORTS),
    Patch("matplotlib.pyplot.show", always(show), _REASON, _TEST, IMPORTS),
    Patch("matplotlib.pyplot.pause", always(pause), _REASON, _TEST, IMPORTS),
    Patch(f"{_CANVAS}.new_timer", always(_new_timer), "animations keep the session's time", _TEST, IMPORTS),
    Patch(f"{_CANVAS}.flush_events", always(_flush_events), _REASON, _TEST, IMPORTS),
    Patch(f"{_MANAGERS}._set_new_active_manager", always(classmethod(_set_new_active_manager)), _REASON, _TEST, IMPORTS),
]
