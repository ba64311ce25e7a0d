"""A teleop pad for any node that subscribes to geometry_msgs/Twist."""

from __future__ import annotations

from typing import Any

import traitlets

from coursekit.cli.session_client import domain_id
from coursekit.processes.session import current

from .bundle import with_text
from .docking import View
from .drive import Driver
from .script import script, style


class Pad(View):
    """A pad for keyboard, touch, mouse and gamepad; made by `pad`. Releasing it stops the robot at once."""

    _esm = script("steer.js", "pad.js")
    _css = style("steer.css", "pad.css")
    topic = traitlets.Unicode("/cmd_vel").tag(sync=True)
    linear = traitlets.Float(0.5).tag(sync=True)
    angular = traitlets.Float(1.0).tag(sync=True)
    holonomic = traitlets.Bool(False).tag(sync=True)
    lost = traitlets.Unicode("").tag(sync=True)
    """The network address of the robot whose subscription was lost; '' otherwise."""

    def __init__(self, topic: str, linear: float, angular: float, holonomic: bool) -> None:
        self._driver = Driver(topic, linear, angular)
        super().__init__(topic=self._driver.topic, linear=linear, angular=angular, holonomic=holonomic)
        self.on_msg(lambda _widget, message, _buffers: self._driver.hear(message))
        self._driver.join()
        self._graph = current().graph(domain_id())
        self._graph.watch(self._look)
        self._look()

    def close(self) -> None:
        """Stop watching the graph and close the widget."""
        self._graph.unwatch(self._look)
        super().close()

    def _look(self) -> None:
        """Update `lost` after a change of the graph: the link to the robot is gone, or back."""
        lost = self._driver.lost()
        if lost != self.lost:
            self.lost = lost

    def press(self, keys: str = "up", seconds: float = 1.0) -> None:
        """Hold keys ('up', 'down', 'left', 'right', 'up+left', ...) for some seconds, as a user would."""
        self._driver.press(keys, seconds)

    def drive(self, forward: float, left: float = 0.0, turn: float = 0.0) -> None:
        """Publish one velocity, components from -1 to 1 of full speed. Unless repeated, it ends after 0.5 s."""
        self._driver.drive(forward, left, turn)

    def stop(self) -> None:
        """Release the controls: publish zero."""
        self._driver.stop()

    def __repr__(self) -> str:
        sideways = ", sideways too" if self.holonomic else ""
        gone = f"; THE LINK TO {self.lost} IS GONE" if self.lost else ""
        return f"[pad {self.topic}: {self.linear:.2f} m/s, {self.angular:.2f} rad/s{sideways}{gone}]"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_text(super()._repr_mimebundle_(**kwargs), repr(self))


def pad(topic: str = "/cmd_vel", linear: float = 0.5, angular: float = 1.0, holonomic: bool = False) -> Pad:
    """Show a teleop pad: geometry_msgs/Twist on `topic`, full speed `linear` m/s and `angular` rad/s.

    It takes arrow keys or WASD, an on-screen stick for touch or mouse, and a gamepad; with `holonomic` Q and E move
    sideways. From code, for example in a test: `pad().press("up", seconds=1)`.

    >>> %ros2 run turtlesim turtlesim_node &
    [turtlesim_node: running]
    >>> keys = pad("/turtle1/cmd_vel", linear=2.0)
    >>> keys.press("left", seconds=1)
    >>> keys
    [pad /turtle1/cmd_vel: 2.00 m/s, 1.00 rad/s]
    """
    return Pad(topic, linear, angular, holonomic)
