"""Driving a robot along points as an onlooker would, and recording where it believed to be meanwhile."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from coursekit.geometry.plane import Pose2D, wrap
from coursekit.processes.session import current
from coursekit.view.progress_bar import ProgressBar

from .drive import Driver
from .errors import NotNow
from .panel_node import HiddenNode
from .simulated import robot_name, simulator

if TYPE_CHECKING:
    from tf2_ros import Buffer

BEAT_SECONDS = 0.1
"""The control period of the driver [s]."""
NEAR = 0.3
"""The distance at which a point counts as reached [m]."""
PATIENCE_SECONDS = 6.0
"""The timeout without progress, after which an obstacle is assumed [s]."""
TURNING_SECONDS = 60.0
"""The same timeout while the robot rotates [s]."""
SLAM_SECONDS = 30.0
"""The timeout for SLAM's first scan [s]."""
TURN = 1.5
"""The maximum angular velocity [rad/s]."""
_BELIEFS = {"odometry": "odom", "SLAM": "map"}


class Tour:
    """A robot's path: its true poses, and the poses estimated by odometry and SLAM; all relative to its start pose.

    `tracks` has arrays (n, 3) of x [m], y [m], yaw [rad] under 'truth', 'odometry' and 'SLAM'; NaN where there was no
    estimate.
    """

    def __init__(self, name: str, base: str) -> None:
        self.name = name
        self._base = base
        self._simulator = simulator()
        self._start: Pose2D = self._simulator.simulation.start_of(name).inverse()
        self._noted: dict[str, list[tuple[float, float, float]]] = {"truth": [], "odometry": [], "SLAM": []}
        self.seconds = 0.0

    @property
    def tracks(self) -> dict[str, np.ndarray]:
        """The recorded poses, ten per second."""
        return {name: np.array(track, float).reshape(-1, 3) for name, track in self._noted.items()}

    @property
    def length(self) -> float:
        """The length of the path [m]."""
        return float(np.hypot(*np.diff(self.tracks["truth"][:, :2], axis=0).T).sum())

    def errors(self, who: str) -> np.ndarray:
        """Return the position error of 'odometry' or 'SLAM' [m], ten times a second; NaN where there was no estimate."""
        tracks = self.tracks
        off: np.ndarray = np.hypot(*(tracks[who] - tracks["truth"])[:, :2].T)
        return off

    def error(self, who: str) -> float:
        """Return the position error at the end [m]."""
        return float(self.errors(who)[-1])

    def look(self, buffer: Buffer) -> Pose2D:
        """Record the true pose and the estimates. Returns the true pose in the world."""
        self._simulator.advance()
        here: Pose2D = self._simulator.simulation.pose_of(self.name)
        x, y, yaw = self._start @ here
        self._noted["truth"].append((x, y, yaw))
        for name, frame in _BELIEFS.items():
            self._noted[name].append(_belief(buffer, frame, self._base))
        return here

    def __repr__(self) -> str:
        said = [f"{name} {self.error(name):.2f} m" for name in _BELIEFS if not math.isnan(self.error(name))]
        off = f"; at the end off by: {', '.join(said)}" if said else ""
        return f"drove {self.length:.1f} m in {self.seconds:.0f} s{off}"


def _belief(buffer: Buffer, frame: str, base: str) -> tuple[float, float, float]:
    from rclpy.time import Time
    from tf2_ros import TransformException

    try:
        transform = buffer.lookup_transform(frame, base, Time()).transform
    except TransformException:
        return math.nan, math.nan, math.nan
    return transform.translation.x, transform.translation.y, 2 * math.atan2(transform.rotation.z, transform.rotation.w)


def drive_along(
    points: Iterable[tuple[float, float]],
    speed: float = 0.5,
    *,
    robot: str = "",
    topic: str = "/cmd_vel",
    base: str = "base_footprint",
) -> Tour:
    """Drive a simulated robot from point to point, steering by its true pose.

    Points are x and y in the world [m]; `speed` is in m/s. It publishes geometry_msgs/Twist on `topic`.
    LookupError: no simulator or robot; RuntimeError: it is stuck; the message gives the position.

    >>> %ros2 launch coursekit_robots simulation.launch.py &
    [simulation.launch.py: running]
    >>> wait(2)
    >>> tour = drive_along([(0.5, 0.0), (0.5, 0.5)])
    >>> round(tour.length, 1)
    0.6
    """
    from tf2_ros import Buffer, TransformListener

    tour = Tour(robot_name(robot), base)
    hidden, driver = HiddenNode("tour"), Driver(topic, speed, TURN, "tour")
    begin = current().clock.steady()
    try:
        buffer = Buffer()
        listener = TransformListener(buffer, hidden.node)
        current().clock.sleep(BEAT_SECONDS)
        _wait_for_slam(hidden, buffer, base)
        places = list(points)
        with ProgressBar("Driving") as bar:
            for number, (x, y) in enumerate(places):
                bar.share = number / len(places)
                _go(tour, driver, buffer, x, y)
        driver.stop()
        current().clock.sleep(5 * BEAT_SECONDS)
        tour.look(buffer)
        listener.unregister()
    finally:
        tour.seconds = (current().clock.steady() - begin) * 1e-9
        driver.leave()
        hidden.close()
    return tour


def _wait_for_slam(hidden: HiddenNode, buffer: Buffer, base: str) -> None:
    """If a node publishes a map, wait for its first scan: on a busy computer that takes a while."""
    clock = current().clock
    give_up = clock.steady() + round(SLAM_SECONDS * 1e9)
    while hidden.node.count_publishers("/map") and math.isnan(_belief(buffer, _BELIEFS["SLAM"], base)[0]):
        if clock.steady() > give_up:
            return
        clock.sleep(BEAT_SECONDS)


def _go(tour: Tour, driver: Driver, buffer: Buffer, x: float, y: float) -> None:
    clock = current().clock
    looked = began = since = clock.steady()
    best = math.inf
    while (gap := math.hypot(x - (here := tour.look(buffer)).x, y - here.y)) > NEAR:
        now = clock.steady()
        off = wrap(math.atan2(y - here.y, x - here.x) - here.theta)
        _steer(driver, gap, off, max(BEAT_SECONDS, (now - looked) * 1e-9))
        looked = now
        if gap < best - 0.05:
            best, since, began = gap, now, now
        elif abs(off) > 0.5:
            since = now
        if now - since > PATIENCE_SECONDS * 1e9:
            raise NotNow(f"stuck at ({here.x:.1f}, {here.y:.1f}) on the way to ({x:g}, {y:g}): what is in the way?")
        if now - began > TURNING_SECONDS * 1e9:
            where = f"at ({here.x:.1f}, {here.y:.1f}) it turns and comes no nearer to ({x:g}, {y:g})"
            raise NotNow(f"{where}: is the computer busy with something else?")
        clock.sleep(BEAT_SECONDS)


def _steer(driver: Driver, gap: float, off: float, lag: float) -> None:
    """Rotate and drive towards a point, but not past it before the next step, `lag` seconds ahead."""
    most = min(TURN, abs(off) / lag)
    turn = max(-most, min(most, 2 * off))
    forward = max(0.0, math.cos(off)) ** 3
    driver.drive(min(forward, gap / (lag * driver.linear)), 0.0, turn / TURN)
