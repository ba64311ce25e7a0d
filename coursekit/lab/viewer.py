"""The viewer in a notebook: robots, frames and messages in 3D, as RViz shows them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from coursekit.nodes.rviz.config import Config, DisplayConfig, make_config
from coursekit.nodes.rviz.config_file import read, save
from coursekit.nodes.rviz.kinds import KINDS
from coursekit.nodes.rviz.windows import windows
from coursekit.processes.session import current
from coursekit.view.scene_stage import Stage
from coursekit.view.scene_text import described
from coursekit.view.view_control import FOLLOWER, ORBIT

from .errors import BadArgument
from .panel import static
from .panel_node import HiddenNode
from .viewer_page import ViewerPage
from .viewer_tools import Tools

SETTLE_SECONDS = 1.0
"""How long a new viewer waits at most for the data of all its displays [s]."""
_ROBOT = "robot_description"
_SCENE = ("scene.js", "scene_looks.js", "scene_lines.js")
_SCRIPTS = (*_SCENE, "viewer_list.js", "viewer_adding.js", "viewer_tools.js", "viewer_views.js")


class Viewer(ViewerPage):
    """See `viewer`."""

    _esm = static("viewer.js", *_SCRIPTS)
    _css = static("viewer.css", "scene.css")

    def __init__(self, config: Config | None = None, height: int = 420) -> None:
        super().__init__("viewer")
        self.height_px = height
        if config is None:
            self._settle(lambda: bool(robot_topics(self.hidden)))
            config = bare_config(self.hidden)
        self.stage = Stage(self.hidden.node, config)
        self.tools = Tools(self.hidden.node, self.stage)
        self.stream()
        self._settle(self._complete)

    def _settle(self, done: Any) -> None:
        clock = self.session.clock
        give_up = clock.steady() + round(SETTLE_SECONDS * 1e9)
        while not done() and clock.steady() < give_up:
            clock.sleep(0.05)

    def _complete(self) -> bool:
        waits = [
            display
            for display in self.stage.displays
            if display.config.enabled and KINDS[display.kind].type and not display.count
        ]
        self.stage.buffer.catch_up()
        return not waits and bool(self.stage.buffer.frames) and not self.session.clock.virtual

    # -- from code

    @property
    def fixed_frame(self) -> str:
        """The fixed frame; can be set. '' chooses it automatically."""
        self.stage.update()
        return self.stage.fixed_frame

    @fixed_frame.setter
    def fixed_frame(self, frame: str) -> None:
        self.stage.fix(frame)

    @property
    def displays(self) -> list[str]:
        """The names of the displays."""
        return self.stage.names()

    def add(self, display: str | Mapping[str, Any], **options: Any) -> None:
        """Add a display: `add("LaserScan", topic="/scan", size=0.05)`; ValueError for an unknown type or option."""
        given = {"type": display, **options} if isinstance(display, str) and options else display
        self.stage.add(make_config(displays=[given]).displays[0])

    def remove(self, name: str) -> None:
        """Remove a display; LookupError if there is none of that name."""
        self.stage.remove(self.stage.find(name))

    def change(self, name: str, **options: Any) -> None:
        """Change a display's options: `change("LaserScan", size=0.05, alpha=0.5)`; ValueError lists the valid options."""
        self.stage.change(self.stage.find(name), options)

    def switch(self, name: str, on: bool) -> None:
        """Switch a display on or off; LookupError if there is none of that name."""
        self.stage.switch(self.stage.find(name), on)

    def status(self, name: str) -> str:
        """Return the status of a display: 'Ok: ...', 'Warn: ...', 'Error: ...'."""
        self.stage.update()
        display = self.stage.find(name)
        return f"{display.level}: {display.remark}"

    def save(self, path: str | Path) -> None:
        """Save the configuration to a file, for `viewer(path)` and `rviz2 -d path`.

        A file that ends in .rviz has RViz's format, any other is short YAML.
        """
        shown = [display.config for display in self.stage.displays]
        save(Config(self.fixed_frame, shown, self.stage.looking.view(), views=self.stage.config.views), path)

    def follow(self, frame: str, turn: bool = False) -> None:
        """Make the camera follow a frame, or none for ''; with `turn` it also rotates with the frame."""
        self.stage.looking.follow(frame, FOLLOWER if turn else ORBIT)
        self.look_anew()

    @property
    def views(self) -> list[str]:
        """The names of the saved views."""
        return [*self.stage.config.views]

    def save_view(self, name: str) -> None:
        """Save the current view under a name."""
        self.stage.looking.save(name)

    def look(self, name: str) -> None:
        """Restore a saved view; LookupError if there is none of that name."""
        self.stage.looking.use(name)
        self.look_anew()

    def goal_pose(self, x: float, y: float, yaw: float = 0.0) -> None:
        """Publish a goal on /goal_pose, as the tool 2D Goal Pose does [m, m, rad]."""
        self.tools.goal_pose(x, y, yaw)

    def pose_estimate(self, x: float, y: float, yaw: float = 0.0) -> None:
        """Publish a pose on /initialpose, as the tool 2D Pose Estimate does [m, m, rad]."""
        self.tools.pose_estimate(x, y, yaw)

    def publish_point(self, x: float, y: float, z: float = 0.0) -> None:
        """Publish a point on /clicked_point, as the tool Publish Point does [m]."""
        self.tools.publish_point(x, y, z)

    # -- without the browser

    def text(self) -> str:
        """Return the viewer's content as text."""
        self.stage.update()
        return described(self.stage)


def robot_topics(hidden: HiddenNode) -> list[str]:
    """Return the topics on which robot descriptions are published."""
    topics = hidden.node.get_topic_names_and_types()
    ends = [name for name, kinds in topics if name.endswith(f"/{_ROBOT}") and "std_msgs/msg/String" in kinds]
    return sorted(name for name in ends if hidden.node.count_publishers(name))


def bare_config(hidden: HiddenNode) -> Config:
    """Return the default displays: the grid, all robots, the frames."""
    topics = robot_topics(hidden) or [f"/{_ROBOT}"]
    robots: list[dict[str, Any]] = [{"type": "RobotModel", "topic": topic} for topic in topics]
    if len(robots) > 1:
        for robot in robots:
            robot["name"] = robot["topic"].rpartition("/")[0].strip("/") or "RobotModel"
    return make_config("", ["Grid", *robots, {"type": "TF", "show_names": len(robots) < 2}])


def _newest() -> Config | None:
    """Return the configuration of the newest running rviz2; None when none runs."""
    running = windows.running(current())
    return running[-1].config if running else None


def _chosen(file: Any, fixed_frame: str, displays: Any, view: Any) -> Config | None:
    """Return the configuration requested by `viewer`'s arguments; ValueError for an invalid one."""
    if file is not None:
        return read(file)
    if displays is not None:
        return make_config(fixed_frame, displays, view)
    return _newest() if not fixed_frame and not view else None


def viewer(
    file: str | Path | None = None,
    *,
    fixed_frame: str = "",
    displays: Iterable[str | Mapping[str, Any] | DisplayConfig] | None = None,
    view: Mapping[str, Any] | None = None,
    height: int = 420,
) -> Viewer:
    """Show robots, frames and messages in 3D, as configured by a file (our YAML or .rviz) or by `displays`.

    A display is 'LaserScan', 'LaserScan /scan' or {'type': 'LaserScan', 'topic': '/scan', 'size': 0.05}. Without
    arguments it shows the displays of the running rviz2, else grid, robots and frames. `view` may set distance [m],
    yaw, pitch [rad] and target, and a target_frame to follow. ValueError for an unknown display or option lists the
    valid ones; OSError: there is no such file.

    >>> %ros2 run tf2_ros static_transform_publisher --x 1 --frame-id odom --child-frame-id base_link &
    [static_transform_publisher: running]
    >>> wait(1)
    >>> viewer(fixed_frame="odom", displays=["Grid", "TF"])
    viewer: fixed frame odom
    [x] Grid  Ok
    [x] TF    Ok     2 frames

    In ROS 2: `rviz2 -d FILE`.
    """
    try:
        config = _chosen(file, fixed_frame, displays, view)
    except ValueError as error:
        raise BadArgument(str(error)) from None
    viewer = Viewer(config, height)
    if file is not None or displays is None:
        if fixed_frame:
            viewer.fixed_frame = fixed_frame
        if view:
            viewer.stage.config.view = make_config(view=view).view
            viewer.stage.looking.go_home()
    return viewer


__all__ = ["Viewer", "viewer"]
