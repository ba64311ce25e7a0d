"""The base of the displays: a topic, a status as RViz words it, and a part of the scene."""

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
    from coursekit.view.scene_stage import Stage

LEVELS = ("Ok", "Warn", "Error")
WAITING = 5
"""So many messages at most wait for their transform."""


class NoTransform(Exception):
    """A frame cannot be placed; the text names it and what there is."""


class NotYet(NoTransform):
    """A frame cannot be placed yet: its time is after the newest transform, which may still come."""


class Display:
    """One row of the list. A subclass gives `draw`, and `kind`, its name in `KINDS`.

    Messages arrive in the node's thread and wait, a few at most; `update` draws in the thread that renders.
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

    def connect(self, node: Any) -> None:
        """Subscribe, if it is on and has a topic."""
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
        """The QoS it asks for: as told, else what fits every publisher."""
        from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

        lasting = KINDS[self.kind].lasting
        durability = self.options["durability"] or ("Transient Local" if lasting else "Volatile")
        reliability = self.options["reliability"] or ("Reliable" if lasting else "Best Effort")
        return QoSProfile(
            depth=max(1, int(self.options["depth"])),
            durability=DurabilityPolicy[durability.upper().replace(" ", "_")],
            reliability=ReliabilityPolicy[reliability.upper().replace(" ", "_")],
        )

    def disconnect(self, node: Any) -> None:
        """Forget the topic and what came."""
        if self._subscription is not None:
            node.destroy_subscription(self._subscription)
        self._subscription = None
        with self._lock:
            self._waiting.clear()
        self.count = 0
        self.statuses = {}
        self.forget()

    def _take(self, msg: Any) -> None:
        with self._lock:
            self.count += 1
            self._waiting.append(msg)
        self.heard(msg)

    def taken(self) -> list[Any]:
        """The messages that wait, oldest first; they wait no longer."""
        with self._lock:
            found = list(self._waiting)
            self._waiting.clear()
        return found

    def put_back(self, messages: list[Any]) -> None:
        """Let messages wait again, before those that came meanwhile."""
        with self._lock:
            room = WAITING - len(self._waiting)
            self._waiting.extendleft(reversed(messages[max(0, len(messages) - room) :] if room > 0 else []))

    # -- for a subclass

    def heard(self, msg: Any) -> None:
        """A message came, in the node's thread."""

    def forget(self) -> None:
        """Forget what was shown."""

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Bring the display's things in the scene up to date."""

    def redraw(self, scene: Scene) -> None:
        """Its options have changed: the next `draw` has to make everything anew, from what is there."""
        scene.clear(self.key)

    def facts(self, name: str, thing: Thing, here: Any, stage: Stage) -> list[Fact]:
        """The facts of one of its things, clicked `here` [m] in the thing's own frame."""
        return [("Frame", stage.fixed_frame), ("Clicked", point_text(world(thing, here)))]

    # -- what it says

    def update(self, stage: Stage) -> None:
        """Draw, or take away what is off."""
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
        """One line of the status."""
        self.statuses[what] = (level, text)

    def unsay(self, what: str) -> None:
        """Take a line back."""
        self.statuses.pop(what, None)

    @property
    def level(self) -> str:
        """The worst of its lines; 'Off' when it is off."""
        if not self.config.enabled:
            return "Off"
        return max((level for level, _ in self.statuses.values()), key=LEVELS.index, default="Ok")

    @property
    def remark(self) -> str:
        """The lines that matter: those of the worst level; of good ones only what is news."""
        worst = self.level
        if worst == "Ok":
            return "; ".join(text for _, text in self.statuses.values() if not text.endswith(" OK"))
        return "; ".join(f"{what}: {text}" for what, (level, text) in self.statuses.items() if level == worst)


class StampedDisplay(Display):
    """Shows the newest message whose header's frame can be placed at its time."""

    def __init__(self, config: DisplayConfig, number: int) -> None:
        super().__init__(config, number)
        self.shown: Any = None

    def forget(self) -> None:
        """Nothing is shown any more."""
        self.shown = None

    def draw(self, stage: Stage, scene: Scene) -> None:
        """Show the newest message that can be placed; the newer ones wait for their transforms."""
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
        """Show the newest message once more."""
        super().redraw(scene)
        if self.shown is not None:
            self.put_back([self.shown])

    def facts(self, name: str, thing: Thing, here: Any, stage: Stage) -> list[Fact]:
        """Frame and time of the message, and where it was clicked, in the fixed frame."""
        return [*header_facts(self.shown), ("Clicked", point_text(world(thing, here)))]

    def _tell(self, faults: list[NoTransform]) -> None:
        """Why no message can be shown, newest first. One that came before its transform is no fault, unless all wait."""
        if not faults:
            return
        if not isinstance(faults[0], NotYet) or len(faults) == WAITING:
            self.say("Transform", "Error", str(faults[0]))
        elif self.shown is None:
            self.say("Transform", "Warn", str(faults[0]))

    def _stay(self, stage: Stage, scene: Scene) -> None:
        """Things stay where their frame was at their time, also when the fixed frame is another now."""
        if self.shown is None:
            return
        try:
            self.move(self.pose_of(self.shown, stage), scene)
        except NoTransform:
            return

    def pose_of(self, msg: Any, stage: Stage) -> Pose:
        """Where the frame of a message is: at the message's time. Raises NoTransform."""
        return stage.pose_at(msg.header)

    def move(self, pose: Pose, scene: Scene) -> None:
        """Put what is shown to the pose of its frame."""
        for display, name in list(scene.things):
            if display == self.key:
                scene.place(display, name, pose)

    def show(self, msg: Any, pose: Pose, stage: Stage, scene: Scene) -> None:
        """Show a message; `pose` is that of its frame in the fixed frame."""
        raise TypeError(f"{type(self).__name__} has to say how a message is shown")


__all__ = ["LEVELS", "Display", "NoTransform", "NotYet", "StampedDisplay"]
