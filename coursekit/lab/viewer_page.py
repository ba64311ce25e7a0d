"""The messages between a page and a viewer: the list of displays, the camera, the selection."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

from coursekit.nodes.rviz.config import VIEW_TYPES, make_config
from coursekit.nodes.rviz.kinds import KINDS
from coursekit.nodes.rviz.properties import ABOUT, properties
from coursekit.view.displays import Display
from coursekit.view.scene_stage import Stage
from coursekit.view.selection import Picked, pick, told
from coursekit.view.view_control import ORBIT
from coursekit.words.gettext import gettext

from .scene_panel import ScenePanel
from .viewer_tools import Tools


class ViewerPage(ScenePanel):
    """The base of `viewer`: everything that arrives from a page is validated here."""

    stage: Stage
    tools: Tools
    height_px: int
    picked: Picked | None = None
    """The object selected by the Select tool."""
    _placed = False

    def shown(self) -> dict[str, Any]:
        """Return the list beside the picture."""
        stage = self.stage
        level, text = stage.global_status()
        looking = {"frame": stage.looking.frame, "type": stage.looking.type, "views": [*stage.config.views]}
        return {
            "height": self.height_px, "fixed": stage.fixed_frame, "frames": sorted(stage.buffer.frames),
            "told": self.tools.told, "level": level, "remark": gettext(text),
            "rows": [_row(display) for display in stage.displays], "skipped": stage.config.skipped,
            "looking": looking, "picked": self._picked(),
        }  # fmt: skip

    def _picked(self) -> dict[str, Any] | None:
        return told(self.stage, self.picked) if self.picked is not None else None

    # -- the list of displays

    def on_kinds(self, _message: dict[str, Any]) -> None:
        """Send the page the kinds of displays, their descriptions, and their properties."""
        self.tell(type="kinds", kinds={name: _known(name) for name in KINDS})

    def on_topics(self, _message: dict[str, Any]) -> None:
        """Send the page the topics that can be displayed."""
        node = self.stage.node
        published = [topic for topic in sorted(node.get_topic_names_and_types()) if node.count_publishers(topic[0])]
        topics = [[topic, name] for topic, types in published for name, kind in KINDS.items() if kind.type in types]
        self.tell(type="topics", topics=topics)

    def on_add(self, message: dict[str, Any]) -> None:
        """Add a display."""
        kind, topic = str(message.get("kind")), str(message.get("topic") or "")
        if kind not in KINDS:
            return
        given = {"type": kind, "name": self._free_name(kind)} | ({"topic": topic} if topic else {})
        self.stage.add(make_config(displays=[given]).displays[0])
        self.hurry()

    def _free_name(self, kind: str) -> str:
        """Return 'LaserScan', 'LaserScan 2', ..."""
        taken, count, name = set(self.stage.names()), 1, kind
        while name in taken:
            count += 1
            name = f"{kind} {count}"
        return name

    def on_remove(self, message: dict[str, Any]) -> None:
        """Remove a display."""
        display = self._row_of(message)
        if display is not None:
            self.stage.remove(display)
            self.hurry()

    def on_switch(self, message: dict[str, Any]) -> None:
        """Switch a display on or off."""
        display = self._row_of(message)
        if display is not None:
            self.stage.switch(display, bool(message.get("on")))

    def on_topic(self, message: dict[str, Any]) -> None:
        """Change the topic of a display."""
        display, topic = self._row_of(message), str(message.get("topic", "")).strip()
        if display is not None and topic:
            self.stage.retopic(display, topic)

    def on_property(self, message: dict[str, Any]) -> None:
        """Change a property of a display."""
        display = self._row_of(message)
        if display is not None:
            self._try(lambda: self.stage.change(display, {str(message.get("key")): message.get("value")}))

    def on_fix(self, message: dict[str, Any]) -> None:
        """Select the fixed frame."""
        self.stage.fix(str(message.get("frame", "")))

    def on_save(self, message: dict[str, Any]) -> None:
        """Save the configuration in a file."""
        name = str(message.get("name", "")).strip()
        if name:
            self._try(lambda: self._save(name if name.endswith((".rviz", ".yaml")) else f"{name}.rviz"))

    def _save(self, name: str) -> None:
        self.save(name)
        self.tools.told = gettext(f'Saved. Open it with viewer("{name}") or rviz2 -d {name}')

    def save(self, path: Any) -> None:
        """Save the configuration to a file."""
        raise TypeError(f"{type(self).__name__} has to say how it is saved")

    # -- tools and the camera

    def on_tool(self, message: dict[str, Any]) -> None:
        """Handle the use of a tool."""
        self.tools.use(message)

    def on_pick(self, message: dict[str, Any]) -> None:
        """Select the clicked object, or none."""
        number, at = message.get("number"), message.get("at")
        good = isinstance(number, int) and isinstance(at, list) and len(at) == 3 and all(map(_finite, at))
        self.picked = pick(self.stage, int(number or 0), at) if good else None
        self.hurry()

    def marked(self) -> int | None:
        """Return the number of the selected object."""
        thing = self.stage.scene.things.get((self.picked.display, self.picked.thing)) if self.picked is not None else None
        return thing.number if thing is not None else None

    def on_look(self, message: dict[str, Any]) -> None:
        """Handle a camera moved by the user."""
        self._try(lambda: self.stage.looking.move(message))

    def on_home(self, message: dict[str, Any]) -> None:
        """Reset the camera to its first view."""
        self.stage.looking.go_home()
        super().on_home(message)

    def on_follow(self, message: dict[str, Any]) -> None:
        """Select the frame that the camera follows."""
        frame, kind = str(message.get("frame", "")), str(message.get("kind", ORBIT))
        self.stage.looking.follow(frame, kind if kind in VIEW_TYPES else ORBIT)
        self.look_anew()

    def on_view(self, message: dict[str, Any]) -> None:
        """Save, restore or delete a view."""
        name, looking = str(message.get("name", "")).strip()[:60], self.stage.looking
        if message.get("does") == "save" and name:
            looking.save(name)
        elif message.get("does") == "use":
            self._try(lambda: looking.use(name))
            self.look_anew()
        elif message.get("does") == "forget":
            self.stage.config.views.pop(name, None)
        self.hurry()

    def follows(self) -> list[float] | None:
        """Return the pose of the followed frame; as soon as it has one, the camera is sent to the page."""
        place = self.stage.looking.place()
        if (place is not None) > self._placed:
            self.look_anew()
        self._placed = place is not None
        return [round(number, 5) for number in place] if place is not None else None

    def _try(self, does: Any) -> None:
        try:
            does()
        except (ValueError, LookupError, TypeError, OSError) as error:
            self.tools.told = gettext(str(error))

    def _row_of(self, message: dict[str, Any]) -> Display | None:
        return next((display for display in self.stage.displays if display.key == f"{message.get('row')}"), None)


def _finite(number: Any) -> bool:
    return isinstance(number, int | float) and math.isfinite(number)


def _known(kind: str) -> dict[str, Any]:
    """Return the description of one kind of display, and its editable properties."""
    return {"about": gettext(ABOUT[kind]), "properties": [asdict(row) for row in properties(kind)]}


def _row(display: Display) -> dict[str, Any]:
    lines = [{"what": what, "level": level, "text": gettext(text)} for what, (level, text) in display.statuses.items()]
    config, kind = display.config, KINDS[display.kind]
    shown = {"row": display.key, "name": config.name, "kind": config.kind, "topic": config.topic if kind.type else None}
    state = {"on": config.enabled, "level": display.level, "lines": lines if config.enabled else []}
    return {**shown, **state, "options": dict(config.options)}


__all__ = ["ViewerPage"]
