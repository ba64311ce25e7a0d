"""The simulated world in a notebook: in 3D, with the simulator's clock, and with movable objects, as in Gazebo's
window.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.gazebo.model_conversion import ModelConversion
from coursekit.nodes.gazebo.simulators import Simulator, simulators
from coursekit.sim import Prism, Thing, WorldError
from coursekit.view.world_scene import WorldScene
from coursekit.words.counting import counted
from coursekit.words.gettext import gettext

from .errors import BadArgument, NotNow
from .panel import static
from .panel_node import appears
from .scene_panel import ScenePanel

NOTHING = "No simulator runs. Start one: %ros2 launch gazebo_ros gazebo.launch.py &"
STEP_S = 0.05
"""The simulated time of one press of the Step button [s]."""
SPEEDS = (0.25, 0.5, 1.0, 2.0, 4.0)
BOX_M, BOX_KG = 0.4, 2.0
"""The edge length and mass of an added box."""


class WorldView(ScenePanel):
    """See `world_view`."""

    _esm = static("world.js", "scene.js", "scene_looks.js", "scene_lines.js")
    _css = static("world.css", "scene.css")
    stage: WorldScene

    def __init__(self, height: int = 420) -> None:
        super().__init__()
        self.height_px = height
        self.stage = WorldScene(self._newest)
        self._said = ""
        self._held = "", Pose2D()
        """The name of the object clicked last, and its pose at that time."""
        self._boxes = 0
        self._measured: tuple[int, int] | None = None
        self._factor = 1.0
        self.stream()

    def _newest(self) -> Simulator | None:
        running = simulators.running(self.session)
        return running[-1] if running else None

    def _simulator(self) -> Simulator:
        simulator = self._newest()
        if simulator is None:
            raise BadArgument(NOTHING)
        return simulator

    # -- from code

    def pause(self) -> None:
        """Pause the world."""
        self._soon("pause", True)

    def play(self) -> None:
        """Let the world run."""
        self._soon("pause", False)

    def step(self, seconds: float = STEP_S) -> None:
        """Advance a paused world by `seconds`."""
        self._soon("step", seconds)

    def reset(self) -> None:
        """Move everything back to its start pose, and reset the simulated time to 0."""
        self._soon("restart", True)

    def speed(self, times: float) -> None:
        """Run the world `times` times as fast as the clock."""
        if not (isinstance(times, (int, float)) and 0.0 < times <= 100.0):
            raise BadArgument(f"speed() takes a number above 0, up to 100; not {times!r}")
        simulator = self._simulator()
        simulator.soon(simulator.time.go_at, float(times))

    def move(self, name: str, x: float, y: float, yaw: float | None = None) -> None:
        """Move a robot or object to a pose [m, m, rad]; LookupError suggests similar names."""
        simulation = self._simulator().simulation
        heading = simulation.pose_of(name).theta if yaw is None else yaw
        simulation.put(name, Pose2D(float(x), float(y), float(heading)))

    def add_box(self, x: float, y: float, size: float = BOX_M) -> str:
        """Add a movable box to the world [m], and wait until it is there. Returns its name."""
        name = self._begin_box(x, y, size)
        self._wait(lambda: name in self._simulator().simulation.names(), name)
        return name

    def _begin_box(self, x: float, y: float, size: float = BOX_M) -> str:
        simulator = self._simulator()
        name = self._free_name({*simulator.simulation.names(), *simulator.assemblies})
        half = size / 2
        corners = ((-half, -half), (half, -half), (half, half), (-half, half))
        place = Pose2D(float(x), float(y), 0.0)
        box = Thing(name, (Prism(corners, 0.0, size),), place, BOX_KG, texture="crates", model=name)
        simulator.soon(simulator.put, ModelConversion(name, things=[box], place=place))
        return name

    def _free_name(self, taken: set[str]) -> str:
        """Return an unused name for a box; never one given before, since that box may not have been added yet."""
        while True:
            self._boxes += 1
            if (name := f"box_{self._boxes}") not in taken:
                return name

    def remove(self, name: str) -> None:
        """Remove a robot or object from the world, and wait until it is gone; LookupError suggests similar names."""
        self._begin_removal(name)
        self._wait(lambda: name not in self._simulator().simulation.names(), name)

    def _begin_removal(self, name: str) -> None:
        simulator = self._simulator()
        simulator.simulation.pose_of(name)
        simulator.soon(simulator.delete, name)

    def _wait(self, condition: Callable[[], bool], name: str) -> None:
        if not appears(condition):
            raise NotNow(f"The simulator is busy, and {name} is not as asked yet. Wait a moment, then look again.")

    def _soon(self, what: str, value: Any) -> None:
        simulator = self._simulator()
        simulator.soon(getattr(simulator, what), value)

    # -- without the browser

    def text(self) -> str:
        """Return the world as text: its time, robots, movable objects, and the number of fixed ones."""
        simulator = self._newest()
        if simulator is None:
            return f"world view: {NOTHING}"
        simulation = simulator.simulation
        with simulation.busy:
            state = "paused" if simulator.time.paused else "running"
            lines = [f"world '{simulation.world.name}': {simulation.now_ns * 1e-9:.2f} s, {state}"]
            lines += [_robot_line(name, robot) for name, robot in simulation.robots.items()]
            lines += [f"  {name}: can be pushed, at {_at(simulation.pose_of(name))}" for name in simulation.things]
            fixed = len(simulation.fixed_things())
        return "\n".join([*lines, f"  {counted(fixed, 'fixed thing')}"])

    # -- with the browser

    def shown(self) -> dict[str, Any]:
        """Return the texts above and below the picture."""
        simulator = self._newest()
        if simulator is None:
            return {"height": self.height_px, "there": False, "told": NOTHING}
        return {
            "height": self.height_px, "there": True, "told": self._said,
            "time": round(simulator.simulation.now_ns * 1e-9, 1), "paused": simulator.time.paused,
            "speed": simulator.time.speed, "speeds": SPEEDS, "factor": self._real_time_factor(simulator),
            "lasers": self.stage.lasers, "names": self.stage.names(),
        }  # fmt: skip

    def _real_time_factor(self, simulator: Simulator) -> float:
        """Return the simulated seconds per second, over about the last second."""
        here = simulator.simulation.now_ns, self.session.clock.steady()
        before = self._measured
        if before is None or here[0] < before[0] or here[1] - before[1] > 3_000_000_000:
            self._measured = here
        elif here[1] - before[1] >= 1_000_000_000:
            self._factor = round((here[0] - before[0]) / (here[1] - before[1]), 2)
            self._measured = here
        return self._factor

    def on_press(self, message: dict[str, Any]) -> None:
        """Handle a button."""
        known = {"play": self.play, "pause": self.pause, "step": self.step, "reset": self.reset}
        does = known.get(str(message.get("button")))
        if does is not None and self._newest() is not None:
            does()

    def on_speed(self, message: dict[str, Any]) -> None:
        """Handle a chosen speed."""
        if self._newest() is not None and message.get("speed") in SPEEDS:
            self.speed(message["speed"])

    def on_lasers(self, message: dict[str, Any]) -> None:
        """Show or hide the laser beams."""
        self.stage.lasers = bool(message.get("on"))

    def on_pick(self, message: dict[str, Any]) -> None:
        """Handle a click on an object."""
        self._try(lambda: self._pick(str(message.get("name"))))

    def _pick(self, name: str) -> None:
        self._held = name, self._simulator().simulation.pose_of(name)
        self._say(f"{name} at {_at(self._held[1])} m")

    def on_drag(self, message: dict[str, Any]) -> None:
        """Drag the clicked object by this distance [m]."""
        self._try(lambda: self._drag(*_floor(message)))

    def _drag(self, x: float, y: float) -> None:
        name, place = self._held
        self.move(name, place.x + x, place.y + y)
        self._say(f"{name} at {_at(self._simulator().simulation.pose_of(name))} m")

    def on_box(self, message: dict[str, Any]) -> None:
        """Add a box at the clicked position."""
        self._try(lambda: self._begin_box(*_floor(message)))

    def on_remove(self, message: dict[str, Any]) -> None:
        """Remove the clicked object."""
        self._try(lambda: self._begin_removal(str(message.get("name"))))

    def _try(self, does: Any) -> None:
        try:
            does()
        except (LookupError, WorldError, BadArgument, ValueError) as error:
            self._say(gettext(str(error.args[0])))

    def _say(self, text: str) -> None:
        self._said = text


def _floor(message: dict[str, Any]) -> tuple[float, float]:
    x, y = message.get("x"), message.get("y")
    if not all(isinstance(number, (int, float)) and abs(number) < 1e4 for number in (x, y)):
        raise BadArgument("That is too far away.")
    return float(x), float(y)  # type: ignore[arg-type]


def _at(place: Pose2D) -> str:
    return f"({_short(place.x)}, {_short(place.y)})"


def _short(number: float) -> str:
    return f"{round(number, 2) + 0.0:.2f}"  # adding 0 removes the sign of -0.00


def _robot_line(name: str, robot: Any) -> str:
    ahead, _, turn = robot.velocity
    line = f"  {name}: robot, at {_at(robot.place)}, heading {round(math.degrees(robot.place.theta))} deg"
    line += f", {_short(ahead)} m/s, {_short(turn)} rad/s"
    return line + (f", touches {', '.join(sorted(robot.contacts))}" if robot.contacts else "")


__all__ = ["WorldView"]
