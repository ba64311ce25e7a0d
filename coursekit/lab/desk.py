"""The desk: the viewer, pad and other panels docked beside the notebook, visible while the notebook scrolls."""

from __future__ import annotations

import re
from typing import Any

import anywidget
import ipywidgets

from coursekit.processes.session import current
from coursekit.words.gettext import gettext

from .bundle import forms_of
from .docking import View
from .errors import BadArgument
from .kernel import notebook_name, running_variables
from .panel import open_panels
from .script import script, style

NOTHING = "Nothing is on the desk. Put panels there: desk(viewer(), pad())"


class _Floor(anywidget.AnyWidget):
    """Loads the desk's style into the page, and reports when the student closes the desk."""

    _esm = script("desk.js")
    _css = style("desk.css")


class Desk:
    """The panels docked beside the notebook; made by `desk`."""

    def __init__(self) -> None:
        self.panels: list[Any] = []
        self._sidecar: Any = None
        self._column = ipywidgets.VBox()
        self._column.add_class("ck-desk")

    def put(self, panels: list[Any]) -> None:
        """Show exactly these panels, from top to bottom."""
        self.panels = panels
        self._column.children = tuple(panels)

    def close(self) -> None:
        """Remove the desk. Its panels stay alive and can still be shown in a cell."""
        if self._sidecar is not None:
            self._sidecar.close()
            self._sidecar = None

    def _dock(self) -> None:
        """Open the desk on the page unless it is open; a reloaded page opens it by itself."""
        if self._sidecar is not None:
            return
        from sidecar import Sidecar

        floor = _Floor()
        floor.on_msg(lambda *_: self.close())
        self._sidecar = Sidecar(title=gettext(f"Desk: {notebook_name().removesuffix('.ipynb')}"), anchor="split-right")
        self._sidecar.append_display_data(ipywidgets.VBox([self._column, floor]).add_class("ck-room"))

    def _still(self) -> dict[str, str]:
        """Return the still picture for use without a browser: that of the first panel that has one."""
        forms = (forms_of(panel._repr_mimebundle_()) or {} for panel in self.panels)
        return next(({"image/png": form["image/png"]} for form in forms if "image/png" in form), {})

    def __repr__(self) -> str:
        return "\n".join([gettext("On the desk:"), *map(repr, self.panels)]) if self.panels else gettext(NOTHING)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        if not self.panels or current().clock.virtual:
            return {"text/plain": repr(self), **self._still()}
        if "__vsc_ipynb_file__" in running_variables():  # VS Code cannot dock beside a notebook: the cell shows the panels
            return self._column._repr_mimebundle_(**options)
        self._dock()
        return {"text/plain": gettext(f"On the desk, beside this notebook: {', '.join(map(_named, self.panels))}")}


_desks: list[Desk] = []
"""The desk of this kernel; empty until it is made."""


def desk(*panels: Any) -> Desk:
    """Dock panels beside the notebook, from top to bottom: `desk(viewer(), pad())`; without arguments, all open panels.

    A notebook has one desk: the new panels replace those already on it.

    Raises:
        BadArgument: when an argument is not a panel.

    >>> %ros2 run turtlesim turtlesim_node &
    [turtlesim_node: running]
    >>> wait(1)
    >>> desk(turtlesim_window(), pad("/turtle1/cmd_vel"))
    On the desk:
    TurtleSim [/turtlesim]
      turtle1  x 5.54 m  y 5.54 m  heading   0.0°  drove 0.00 m
    [pad /turtle1/cmd_vel: 0.50 m/s, 1.00 rad/s]
    """
    for panel in panels:
        if not isinstance(panel, ipywidgets.DOMWidget):
            raise BadArgument(
                f"{type(panel).__name__} cannot be docked. Panels can: viewer(), pad(), graph(), terminal(...)"
            )
    if not _desks:
        _desks.append(Desk())
    _desks[0].put(list(panels) or list[Any](open_panels()))
    return _desks[0]


def _put_on_desk(view: View) -> None:
    """Add a view below those already on the desk; those that have ended make room."""
    others = [panel for panel in (_desks[0].panels if _desks else []) if panel is not view and _lives(panel)]
    desk(*others, view)._dock()


def _lives(panel: Any) -> bool:
    return panel.comm is not None and not getattr(panel, "closed", False)


View.put_on_desk = staticmethod(_put_on_desk)


def _named(panel: Any) -> str:
    return re.sub("(?<!^)(?=[A-Z])", " ", type(panel).__name__.removesuffix("Panel")).lower()


__all__ = ["Desk", "desk"]
