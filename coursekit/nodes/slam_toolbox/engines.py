"""The engines that process scans: one maps, the other localises in a finished map."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Protocol

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import GridMap, load_map
from coursekit.nodes.slam_toolbox.map_topic import grid_map
from coursekit.nodes.slam_toolbox.markers import graph_markers, status_markers
from coursekit.slam import storage
from coursekit.slam.localizer import Localizer
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Scan
from coursekit.slam.slam import Result, Slam

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg
    from visualization_msgs.msg import MarkerArray

NEAR, TURN = 1.5, 0.7
"""The tolerance of a given pose [m], [rad]."""


class Engine(Protocol):
    """Processes scans, and provides the pose and the map."""

    @property
    def pose(self) -> Pose2D: ...
    def add(self, scan: Scan, odometry: Pose2D) -> Result: ...
    def grid(self) -> GridMap | None: ...
    def markers(self, last: Result | None, frame: str, stamp: TimeMsg) -> MarkerArray: ...


class Mapping:
    """Extends a map."""

    def __init__(self, slam: Slam) -> None:
        self.slam = slam

    @property
    def pose(self) -> Pose2D:
        """The robot's pose in the map."""
        return self.slam.pose

    def add(self, scan: Scan, odometry: Pose2D) -> Result:
        """Process a scan; with the first one, the map's frame is that of the odometry, as in slam_toolbox."""
        if not self.slam.keyframes:
            self.slam.begin_at(odometry)
        return self.slam.add(scan, odometry)

    def grid(self) -> GridMap | None:
        """The map so far, None before the first scan."""
        grid = self.slam.map()
        return grid_map(grid) if grid.log_odds.size else None

    def markers(self, last: Result | None, frame: str, stamp: TimeMsg) -> MarkerArray:
        """The pose graph."""
        return graph_markers(self.slam, last, frame, stamp)


class Localizing:
    """Localises in a map that does not change; with `near` None, it searches the whole map first."""

    def __init__(self, localizer: Localizer, cells: GridMap, near: Pose2D | None) -> None:
        self.localizer, self._cells = localizer, cells
        self._wanted, self._near = True, near

    @property
    def pose(self) -> Pose2D:
        """The robot's pose in the map."""
        return self.localizer.pose

    def look_near(self, pose: Pose2D) -> None:
        """Start again near a given pose."""
        self._wanted, self._near = True, pose

    def add(self, scan: Scan, odometry: Pose2D) -> Result:
        """Process a scan; after a restart, search for the pose first."""
        if self._wanted and len(scan.points):
            self._find(scan)
        return self.localizer.add(scan, odometry)

    def _find(self, scan: Scan) -> None:
        self._wanted, near = False, self._near
        if near is not None:
            self.localizer.set_pose(near)
            self.localizer.find(scan, near, NEAR, TURN)
        else:
            self._wanted = self.localizer.find(scan, None, None, math.pi)[1] == 0.0

    def grid(self) -> GridMap | None:
        """The map."""
        return self._cells

    def markers(self, last: Result | None, frame: str, stamp: TimeMsg) -> MarkerArray:
        """A text about the last match."""
        return status_markers(last, self.pose, frame, stamp)


def localizing(slam: Slam, near: Pose2D | None) -> Localizing:
    """An engine that localises in the map of a session."""
    localizer = Localizer.from_keyframes(slam.keyframes, slam.graph.poses, slam.params)
    return Localizing(localizer, grid_map(slam.map()), near)


def load_slam(name: str, at: Pose2D | None, params: SlamParameters) -> Slam:
    """Load a saved session, to continue from its first pose or from `at`; raises OSError or ValueError if there is none."""
    slam = storage.load(name)
    slam.params = slam.tracker.params = slam.search.params = params
    if slam.keyframes:
        storage.resume(slam, at if at is not None else slam.graph.pose(0))
    return slam


def load_localizing(name: str, near: Pose2D | None, params: SlamParameters) -> Localizing:
    """An engine that localises in a saved session or in a map's .yaml; raises OSError or ValueError if there is none."""
    if Path(name).suffix != ".yaml":
        return localizing(load_slam(name, near, params), near)
    cells = load_map(name)
    return Localizing(Localizer.from_cells(cells.cells, cells.resolution, cells.origin[:2], params), cells, near)
