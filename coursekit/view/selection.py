"""The selected thing of a stage: its display and its facts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from coursekit.nodes.rviz.kinds import KINDS

from .displays.facts import local, nearest_dot, world
from .scene_stage import Stage


@dataclass(frozen=True, eq=False)
class Picked:
    """A point on a thing, stored by names: shapes come and go with each message."""

    display: str
    """The display's key."""
    thing: str
    here: np.ndarray
    """The point in the thing's own frame [m]."""
    at: np.ndarray
    """The point in the fixed frame [m]: dots stay there, regardless of their sensor's motion."""


def pick(stage: Stage, number: int, point: Any) -> Picked | None:
    """Return the thing with this (recent) number, clicked at a point of the fixed frame [m]; None if it has gone."""
    with stage.lock:
        key = stage.scene.key_of(number)
        thing = stage.scene.things.get(key) if key is not None else None
        return Picked(*key, local(thing, point), np.asarray(point, float)) if key is not None and thing is not None else None


def told(stage: Stage, picked: Picked) -> dict[str, Any] | None:
    """Return the display, topic and current values for the page; None if the thing is no longer shown."""
    with stage.lock:
        thing = stage.scene.things.get((picked.display, picked.thing))
        display = next((display for display in stage.displays if display.key == picked.display), None)
        if thing is None or display is None:
            return None
        head = [("Topic", display.config.topic)] if KINDS[display.kind].type else []
        dot = nearest_dot(thing, local(thing, picked.at))
        here = picked.here if dot is None else dot[1]
        facts = [*head, *display.facts(picked.thing, thing, here, stage)]
        at = [round(float(value), 4) for value in world(thing, here)]
        return {"name": display.config.name, "facts": facts, "at": at}


__all__ = ["Picked", "pick", "told"]
