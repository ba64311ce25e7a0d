"""The base of the displays: a topic, a status in RViz's words, and a part of the scene."""

from __future__ import annotations

import threading
from collections import deque
from typing import TYPE_CHECKING, Any, ClassVar

from coursekit.nodes.rviz.config import DisplayConfig
from coursekit.nodes.rviz.kinds import KINDS
from coursekit.view.scene import Pose, Scene, Thing
from coursekit.words.counting import counted

from .facts import Fact, header_facts, point_text, world
from .silence import why_nothing

if TYPE_CHECKING:
    import numpy as np
    from rclpy.node import Node

    from coursekit.view.scene_stage import Stage

LEVELS = ("Ok", "Warn", "Error")
WAITING = 5
"""How many messages at most wait for their transform."""


class NoTransform(Exception):
    """A frame cannot be placed; the message names it and lists the known frames."""


class NotYet(NoTransform):
    """A frame cannot be placed yet: its time is after the newest transform, and a later one may still come."""


class Display:
    """One row of the list. A subclass implements `draw`, and sets `kind`, its name in `KINDS`.

    Messages arrive in the node's thread and are queued, a few at most; `update` draws in the rendering thread.
    """

    kind: ClassVar[str] = ""

    def __init__(self, config: DisplayConfig, number: int) -> None:
        self.config = config
        self.key = f"{number}"
        self.statuses: dict[str, tuple[str, str]] = {}
        self.count = 0
        self._waiting: deque[Any] = deque(maxlen=WAITING)
        self._subscription: Any = None
        self._fault = ""
        self._lock = threading.Lock()

    # -- the topic

    @property
    def options(self) -> dict[str, Any]:
        """The options, by their names in the configuration."""
        return self.config.options

    def connect(self, node: Node) -> None:
        """Subscribe, if the display is on and has a topic."""
        kind = KINDS[self.kind]
        if not kind.type or not self.config.enabled or self._subscription is not None:
            return
        from rclpy.exceptions import NameValidationException

        from coursekit.interfaces import load

        self._fault = ""
        try:
            self._subscription = node.create_subscription(load(kind.type), self.config.topic, self._take, self.quality)
        except NameValidationException as error:
            self._fault = f"Error subscribing: {error}"

    @property
    def quality(self) -> Any:
        """The requested QoS: as configured, otherwise one that is compatible with every publisher."""
        from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

        lasting = KINDS[self.kind].lasting
        durability = self.options["durability"] or ("Transient Local" if lasting else "Volatile")
        reliability = self.options["reliability"] or ("Reliable" if lasting else "Best Effort")
        return QoSProfile(
            depth=max(1, int(self.options["depth"])),
            durability=DurabilityPolicy[durability.upper().replace(" ", "_")],
            reliability=ReliabilityPolicy[reliability.upper().replace(" ", "_")],
        )

    def disconnect(self, node: Node) -> None:
        """Drop the subscription and its messages."""
        if self._subscription is not None:
            node.destroy_subscription(self._subscription)
        self._subscription = None
        with self._lock:
            self._waiting.clear()
        self.count = 0
        self.statuses = {}
        self.forget()

    def _take(self, msg: object) -> None:
        with self._lock:
            self.count += 1
            self._waiting.append(msg)
        self.heard(msg)

    def taken(self) -> list[Any]:
        """Take the queued messages, oldest first."""
        with self._lock:
            taken = list(self._waiting)
            self._waiting.clear()
        return taken

    def put_back(self, messages: list[Any]) -> None:
        """Put messages back into the queue, before those that have arrived since."""
        with self._lock:
            room = WAITING - len(self._waiting)
            self._waiting.extendleft(reversed(messages[max(0, len(messages) - room) :] if room > 0 else []))

    # -- for subclasses

    def heard(self, msg: object) -> None:
        """Handle a message, in the node's thread."""

    def forget(self) -> None:
        """Forget the shown content."""

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Bring the display's things in the scene up to date."""

    def redraw(self, scene: Scene) -> None:
        """Apply changed options: the next `draw` must rebuild everything from the data at hand."""
        scene.clear(self.key)

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the facts of one of the display's things, clicked at `here` [m] in the thing's own frame."""
        return [("Frame", stage.fixed_frame), ("Clicked", point_text(world(thing, here)))]

    # -- the status

    def update(self, stage: Stage) -> None:
        """Draw the display, or clear it when it is off."""
        if not self.config.enabled:
            stage.scene.clear(self.key)
            return
        if KINDS[self.kind].type:
            self._tell_topic(stage)
        self.draw(stage, stage.scene)

    def _tell_topic(self, stage: Stage) -> None:
        if self._fault:
            self.say("Topic", "Error", self._fault)
        elif self.count:
            self.say("Topic", "Ok", f"{counted(self.count, 'message')} received")
        else:
            self.say("Topic", "Warn", f"No messages received. {why_nothing(stage.node, self)}".strip())

    def say(self, what: str, level: str, text: str) -> None:
        """Set one line of the status."""
        self.statuses[what] = (level, text)

    def unsay(self, what: str) -> None:
        """Remove a line of the status."""
        self.statuses.pop(what, None)

    @property
    def level(self) -> str:
        """The worst level of the status lines; 'Off' when the display is off."""
        if not self.config.enabled:
            return "Off"
        return max((level for level, _ in self.statuses.values()), key=LEVELS.index, default="Ok")

    @property
    def remark(self) -> str:
        """The lines of the worst level; if that is Ok, only those that add information."""
        worst = self.level
        if worst == "Ok":
            return "; ".join(text for _, text in self.statuses.values() if not text.endswith(" OK"))
        return "; ".join(f"{what}: {text}" for what, (level, text) in self.statuses.items() if level == worst)


class StampedDisplay(Display):
    """Shows the newest message whose header's frame can be placed at its stamp."""

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self.shown: Any = None

    def forget(self) -> None:
        """Forget the shown message."""
        self.shown = None

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Show the newest message that can be placed; newer ones wait for their transforms."""
        messages = self.taken()
        faults: list[NoTransform] = []
        for index in range(len(messages) - 1, -1, -1):
            msg = messages[index]
            try:
                pose = self.pose_of(msg, stage)
            except NoTransform as error:
                faults.append(error)
                continue
            self.say("Transform", "Ok", "Transform OK")
            self.put_back(messages[index + 1 :])
            self.shown = msg
            self.show(msg, pose, stage, scene)
            return
        self.put_back(messages)
        self._tell(faults)
        self._stay(stage, scene)

    def redraw(self, scene: Scene) -> None:
        """Show the newest message again."""
        super().redraw(scene)
        if self.shown is not None:
            self.put_back([self.shown])

    def facts(self, name: str, thing: Thing, here: np.ndarray, stage: Stage) -> list[Fact]:
        """Return the frame and stamp of the message, and the clicked point in the fixed frame."""
        return [*header_facts(self.shown), ("Clicked", point_text(world(thing, here)))]

    def _tell(self, faults: list[NoTransform]) -> None:
        """Report why no message can be shown. Waiting for a transform is not an error, unless the whole queue waits."""
        if not faults:
            return
        if not isinstance(faults[0], NotYet) or len(faults) == WAITING:
            self.say("Transform", "Error", str(faults[0]))
        elif self.shown is None:
            self.say("Transform", "Warn", str(faults[0]))

    def _stay(self, stage: Stage, scene: Scene) -> None:
        """Keep things where their frame was at their stamp, also after a change of the fixed frame."""
        if self.shown is None:
            return
        try:
            self.move(self.pose_of(self.shown, stage), scene)
        except NoTransform:
            return

    def pose_of(self, msg: Any, stage: Stage) -> Pose:
        """Return the pose of a message's frame at the message's stamp. Raises NoTransform."""
        return stage.pose_at(msg.header)

    def move(self, pose: Pose, scene: Scene) -> None:
        """Move the shown things to the pose of their frame."""
        for display, name in list(scene.things):
            if display == self.key:
                scene.place(display, name, pose)

    def show(self, msg: Any, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Show a message; `pose` is the pose of its frame in the fixed frame."""
        raise TypeError(f"{type(self).__name__} has to say how a message is shown")


__all__ = ["LEVELS", "Display", "NoTransform", "NotYet", "StampedDisplay"]
