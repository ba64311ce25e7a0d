"""turtlesim's window in the notebook: it shows the turtles, and drives one by keys or touch."""

from __future__ import annotations

import base64
import threading
from typing import Any

import traitlets

from coursekit.nodes.turtlesim.simulators import simulators
from coursekit.processes.session import current
from coursekit.sim.turtle import SIDE
from coursekit.view.turtle import KINDS, describe, png, shape

from .bundle import forms_of
from .docking import View
from .drive import Driver
from .errors import NotThere
from .script import script, style

FRAME_SECONDS = 0.05
"""The minimum period between frames sent to the browser [s]."""
SPEED = 2.0
"""Full speed in m/s and rad/s, as in turtle_teleop_key."""
NONE_RUNS = "No turtlesim runs. Start one: %ros2 run turtlesim turtlesim_node &"

_shown: dict[str, TurtleWindow] = {}


class Snapshot:
    """The window at one moment: a picture, and a text for outputs without pictures."""

    def __init__(self, image: bytes, text: str) -> None:
        self.image = image
        self.text = text

    def __repr__(self) -> str:
        return self.text

    def _repr_png_(self) -> bytes:
        return self.image


class TurtleWindow(View):
    """The window of a running turtlesim; made by `turtlesim_window`."""

    _esm = script("steer.js", "turtle.js")
    _css = style("steer.css", "turtle.css")
    side = traitlets.Float(SIDE).tag(sync=True)
    shape = traitlets.Any(shape()).tag(sync=True)
    kinds = traitlets.Any(KINDS).tag(sync=True)
    turtle = traitlets.Unicode("turtle1").tag(sync=True)

    def __init__(self, node: str | None = None, turtle: str = "turtle1") -> None:
        super().__init__(turtle=turtle)
        self.node = node
        self._drivers: dict[str, Driver] = {}
        self._sent: tuple[Any, ...] = ()
        self._copied: list[tuple[int, tuple[float, float]]] = []
        self._last = 0
        self._lock = threading.Lock()
        self.on_msg(self._hear)
        older = _shown.pop(node or "", None)
        if older is not None:
            older.forget()
        _shown[node or ""] = self
        simulators.watch(self._frame)

    # -- for programs

    @property
    def simulator(self) -> Any:
        """The turtlesim shown: the one of the given name, or the newest; None if none runs."""
        running = simulators.running(current())
        named = [node for node in running if self.node in (None, node.full_name)]
        return named[-1] if named else None

    def snapshot(self, size: int = 500) -> Snapshot:
        """Return a picture of the current window; LookupError if no turtlesim runs."""
        simulator = self.simulator
        if simulator is None:
            raise NotThere(NONE_RUNS)
        return Snapshot(png(simulator.world, simulator.background(), size), repr(self))

    def press(self, keys: str = "up", seconds: float = 1.0) -> None:
        """Hold arrow keys ('up', 'left', 'up+left', ...) for some seconds, as a user would."""
        self._driver().press(keys, seconds)

    def stop(self) -> None:
        """Release all keys and the stick."""
        for driver in self._drivers.values():
            driver.stop()

    def forget(self) -> None:
        """Stop updating: another window has taken over."""
        simulators.unwatch(self._frame)
        for driver in self._drivers.values():
            driver.leave()

    def __repr__(self) -> str:
        simulator = self.simulator
        return NONE_RUNS if simulator is None else describe(simulator.world, simulator.full_name)

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        bundle = super()._repr_mimebundle_(**kwargs)
        data = forms_of(bundle)
        if data is not None:
            data["text/plain"] = repr(self)
            if self.simulator is not None:
                data["image/png"] = base64.b64encode(self.snapshot().image).decode()
        return bundle

    # -- driving

    def _driver(self) -> Driver:
        simulator = self.simulator
        namespace = simulator.namespace.rstrip("/") if simulator is not None else ""
        topic = f"{namespace}/{self.turtle}/cmd_vel"
        if topic not in self._drivers:
            self._drivers[topic] = Driver(topic, SPEED, SPEED, "turtlesim_window")
        return self._drivers[topic]

    def _hear(self, _widget: object, message: dict[str, Any], _buffers: object) -> None:
        if message.get("type") == "ready":
            self._tell(whole=True)
        elif message.get("type") == "pick":
            self.stop()
            self.turtle = str(message.get("name"))
            self._tell()
        else:
            self._driver().hear(message)

    # -- to the browser

    def _frame(self, simulator: Any) -> None:
        clock = current().clock
        if clock.virtual or self.node not in (None, simulator.full_name):
            return
        now = clock.steady()
        if now - self._last < FRAME_SECONDS * 1e9 and simulator.running:
            return
        self._last = now
        self._tell()

    def _tell(self, whole: bool = False) -> None:
        """Send the changes, or everything."""
        simulator = self.simulator
        if simulator is None:
            self._sent = ()
            self.send(_message(None, self.turtle, [], True))
            return
        with self._lock:
            world = simulator.world
            key = (id(simulator), world.paper.edition)
            whole = whole or self._sent[:1] != (key,)
            strokes = self._new_strokes(world.paper.strokes, whole)
            message = _message(simulator, self.turtle, strokes, whole)
            state = (key, message["turtles"], message["background"], self.turtle)
            if strokes or whole or state != self._sent:
                self._sent = state
                self.send(message)

    def _new_strokes(self, strokes: list[Any], whole: bool) -> list[dict[str, Any]]:
        """Return the parts of strokes that the browser lacks."""
        if whole:
            self._copied = []
        news = []
        for number, stroke in enumerate(list(strokes)):
            points = [(round(x, 3), round(y, 3)) for x, y in stroke.points[-1:]]
            mark = (len(stroke.points), points[0])
            known = self._copied[number] if number < len(self._copied) else (0, (0.0, 0.0))
            if known == mark:
                continue
            first = max(0, known[0] - 1)
            fresh = [(round(x, 3), round(y, 3)) for x, y in stroke.points[first : mark[0]]]
            news.append({"i": number, "from": first, "colour": stroke.colour, "width": stroke.width, "points": fresh})
            self._copied[number : number + 1] = [mark]
        return news


def _message(simulator: Any, driven: str, strokes: list[dict[str, Any]], whole: bool) -> dict[str, Any]:
    turtles = sorted(simulator.world.turtles.values(), key=lambda turtle: turtle.name) if simulator else []
    poses = [[turtle.name, turtle.kind, turtle.x, turtle.y, turtle.theta] for turtle in turtles]  # the page rounds, once
    return {
        "type": "state",
        "running": simulator is not None,
        "node": simulator.full_name if simulator else "",
        "note": NONE_RUNS,
        "background": list(simulator.background()) if simulator else [69, 86, 255],
        "driven": driven,
        "turtles": poses,
        "strokes": strokes,
        "whole": whole,
    }


def turtlesim_window(node: str | None = None, turtle: str = "turtle1") -> TurtleWindow:
    """Show the window of the running or next turtlesim, or of node `node` ('/turtlesim1/turtlesim').

    Click it and drive `turtle` with the arrow keys or the stick; clicking another turtle drives that one.
    From code: `window.press("up", seconds=1)`, `window.snapshot()`.

    >>> %ros2 run turtlesim turtlesim_node &
    [turtlesim_node: running]
    >>> window = turtlesim_window()
    >>> window.press("up", seconds=1)
    >>> window
    TurtleSim [/turtlesim]
      turtle1  x 7.34 m  y 5.54 m  heading   0.0°  drove 1.79 m
    """
    return TurtleWindow(node, turtle)
