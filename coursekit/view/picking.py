"""The clicked thing of a stage: its display, and its facts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from coursekit.nodes.rviz.kinds import KINDS

from .displays.facts import local, nearest_dot, world
from .scene_stage import Stage


@dataclass(frozen=True, eq=False)
class Picked:
    """A place on a thing, kept by names: shapes come and go with each message."""

    display: str
    """The display's key"""
    thing: str
    here: np.ndarray
    """Where on the thing, in its own frame [m]"""
    at: np.ndarray
    """Where that was in the fixed frame [m]: dots stay there, whatever sensor they come from"""


def pick(stage: Stage, number: int, point: Any) -> Picked | None:
    """The thing that has or just had this number, clicked at a point of the fixed frame [m]; None if it has gone."""
    with stage.lock:
        key = stage.scene.key_of(number)
        thing = stage.scene.things.get(key) if key is not None else None
        return Picked(*key, local(thing, point), np.asarray(point, float)) if key is not None and thing is not None else None


def told(stage: Stage, picked: Picked) -> dict[str, Any] | None:
    """Display, topic and values as they are now, for the page; None when the thing is no longer shown."""
    with stage.lock:
        thing = stage.scene.things.get((picked.display, picked.thing))
        one = next((one for one in stage.displays if one.key == picked.display), None)
        if thing is None or one is None:
            return None
        head = [("Topic", one.config.topic)] if KINDS[one.kind].type else []
        dot = nearest_dot(thing, local(thing, picked.at))
        here = picked.here if dot is None else dot[1]
        facts = [*head, *one.facts(picked.thing, thing, here, stage)]
        at = [round(float(value), 4) for value in world(thing, here)]
        return {"name": one.config.name, "facts": facts, "at": at}


__all__ = ["Picked", "pick", "told"]
