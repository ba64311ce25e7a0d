"""The button of a view that moves it to the desk."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar

import anywidget


class View(anywidget.AnyWidget):
    """The base of all views that a cell shows and that can be docked on the desk."""

    put_on_desk: ClassVar[Callable[[View], object]]
    """The button's callback; `coursekit.lab.desk` sets it when imported."""

    def __init__(self, **traits: Any) -> None:
        super().__init__(**traits)
        self.on_msg(self._hear_button)

    def _hear_button(self, _view: View, message: dict[str, Any], _buffers: object) -> None:
        if message.get("type") == "desk":
            View.put_on_desk(self)
