"""Logs of the CARMEN toolkit, the format of the classic SLAM data sets.

It reads FLASER, ROBOTLASER1 and, in a log without these, RAWLASER1; ODOM where scans have no pose; PARAM.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Pose2D
from coursekit.slam.carmen_line import Reading, parse_laser, parse_parameter
from coursekit.slam.carmen_odometry import OdometryTrack
from coursekit.slam.files import read_lines
from coursekit.slam.scan import Laser

TOLD = 20
"""Number of bad lines that are reported individually; further ones are only counted."""
MOST = 100_000_000
"""A limit for the number of readings, to protect the memory."""
_LASERS = ("FLASER", "ROBOTLASER1", "RAWLASER1")
_WANTED = "FLASER, ROBOTLASER1 or RAWLASER1"


@dataclass
class CarmenLog:
    """The scans of a log in the order of its lines, and the errors in it.

    >>> from coursekit.slam.carmen_line import parse_laser
    >>> lines = (f"FLASER 2 1.0 2.0 0 0 0 {x} 0 0 {stamp} host 0" for x, stamp in ((0.0, 10.0), (0.5, 12.5)))
    >>> log = CarmenLog([parse_laser(line) for line in lines])
    >>> log.seconds, log.has_odometry, log.lasers()[0].angles(2).round(3).tolist()
    (2.5, True, [-1.571, 0.0])
    """

    readings: list[Reading] = field(default_factory=list)
    parameters: dict[str, str] = field(default_factory=dict)
    bad: int = 0
    complaints: list[str] = field(default_factory=list)
    """Line number and fault of the first bad lines."""

    @property
    def has_odometry(self) -> bool:
        """Whether the odometry ever changes: a log without odometry repeats one pose."""
        return any(reading.odometry != self.readings[0].odometry for reading in self.readings)

    @property
    def seconds(self) -> float:
        """Duration from the first scan to the last."""
        return self.readings[-1].stamp - self.readings[0].stamp

    def lasers(self) -> list[Laser]:
        """Return the sensor of each scan: from its own header, else from PARAM lines, else the 180° of old logs."""
        limit = self._range_limit()
        offset = self._offset()
        laser_by_key: dict[tuple[str, int, object], Laser] = {}
        chosen = []
        for reading in self.readings:
            key = (reading.kind, len(reading.ranges), reading.laser)
            if key not in laser_by_key:
                laser_by_key[key] = self._laser(reading, limit.get(key[:2], np.inf), offset)
            chosen.append(laser_by_key[key])
        return chosen

    def _laser(self, reading: Reading, limit: float, offset: Pose2D) -> Laser:
        """The sensor of one scan."""
        count = len(reading.ranges)
        if reading.laser is not None:
            start, step, maximum = reading.laser
            return Laser(start, step, range_max=min(maximum, limit), offset=offset)
        view = np.radians(self._number("laser_front_laser_fov", 180.0))
        maximum = min(limit, self._number("robot_front_laser_max", np.inf))
        half = Laser.half_circle(count, maximum, offset)
        if abs(view - np.pi) < 1e-6:
            return half
        return Laser(-view / 2, view / max(count - 1, 1), range_max=maximum, offset=offset)

    def _number(self, name: str, default: float) -> float:
        """Return a PARAM as a positive number."""
        try:
            value = float(self.parameters[name])
        except (KeyError, ValueError):
            return default
        return value if np.isfinite(value) and value > 0 else default

    def _offset(self) -> Pose2D:
        """Return the laser's pose on the robot, from the poses of the lines if their offset is constant, else from PARAM."""
        seen = np.array([tuple(r.odometry.to(r.laser_pose)) for r in self.readings[:1000] if r.odometry is not None])
        if len(seen) and np.abs(seen - seen[0]).max() < 2e-3 and 1e-4 < np.hypot(*seen[0, :2]) < 3.0:
            return Pose2D.of(np.median(seen, axis=0))
        try:
            ahead = float(self.parameters["robot_frontlaser_offset"])
        except (KeyError, ValueError):
            return Pose2D()
        return Pose2D(ahead, 0.0, 0.0) if abs(ahead) < 3.0 else Pose2D()

    def _range_limit(self) -> dict[tuple[str, int], float]:
        """Return the range from which on each kind of scan means "no return": a maximum that the log repeats very often."""
        limits: dict[tuple[str, int], float] = {}
        groups: dict[tuple[str, int], list[np.ndarray]] = {}
        for reading in self.readings:
            groups.setdefault((reading.kind, len(reading.ranges)), []).append(reading.ranges)
        for key, rows in groups.items():
            limits[key] = saturation(np.concatenate(rows))
        return limits


def saturation(ranges: np.ndarray) -> float:
    """Return the value from which on ranges mean "no return", inf if there is none.

    It is a maximum that is far more frequent than the ranges just below it, or 50 m and more, which the lasers of old
    logs write for "no return".

    >>> saturation(np.array([1.0, 2.0, 8.0, 3.0, 8.0, 2.5, 8.0, 8.0]))
    8.0
    """
    values = ranges[np.isfinite(ranges)]
    if not len(values):
        return float("inf")
    top = float(values.max())
    often, near = int((values == top).sum()), int(((values > 0.97 * top) & (values < top)).sum())
    if often > max(3, 2 * near) and often > 1e-4 * len(values):
        return min(top, 50.0) if top >= 50.0 else top
    return 50.0 if top >= 50.0 else float("inf")


def read_log(path: str | Path) -> CarmenLog:
    r"""Read a log (.clf, .log, also compressed as .gz, .bz2 or .xz). Bad lines are skipped and recorded with their numbers.

    Raises FileNotFoundError, or ValueError when the file contains no scan.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "short.clf")
    ...     _ = file.write_text("# two scans\nFLASER 2 1.0 2.0 0 0 0 0.5 0 0 12.5 host 0\nFLASER 3 1.0\n", encoding="ascii")
    ...     log = read_log(file)
    >>> len(log.readings), log.complaints
    (1, ['line 3: 3 beams announced, but the line ends after 3 words'])
    """
    log, kinds, total, track = CarmenLog(), Counter[str](), 0, OdometryTrack()
    for number, line in enumerate(read_lines(path), start=1):
        word = line.split(None, 1)[0] if line.strip() else ""
        if word in _LASERS or word == "ODOM":
            try:
                if word == "ODOM":
                    track.add(line)
                    continue
                reading = parse_laser(line)
            except ValueError as fault:
                _complain(log, number, str(fault))
                continue
            total += len(reading.ranges)
            if total > MOST:
                raise ValueError(f"{path} holds more than {MOST} readings: cut it into pieces")
            log.readings.append(reading)
        elif word == "PARAM":
            name, value = parse_parameter(line)
            if len(log.parameters) < 10_000:
                log.parameters[name] = value
        elif word and not word.startswith("#") and len(kinds) < 10:
            kinds[word[:20]] += 1
    if not log.readings:
        raise ValueError(_nothing(path, log, kinds))
    if any(reading.kind != "RAWLASER1" for reading in log.readings):  # these repeat the same scans
        log.readings = [reading for reading in log.readings if reading.kind != "RAWLASER1"]
    log.readings = [scan if scan.odometry is not None else _placed(scan, track) for scan in log.readings]
    return log


def _placed(reading: Reading, track: OdometryTrack) -> Reading:
    """Return a scan without a pose, with the pose from the ODOM lines."""
    here = track.at(reading.stamp)
    return replace(reading, odometry=here, laser_pose=here)


def _complain(log: CarmenLog, number: int, fault: str) -> None:
    """Record a bad line."""
    log.bad += 1
    if len(log.complaints) < TOLD:
        log.complaints.append(f"line {number}: {fault}")


def _nothing(path: str | Path, log: CarmenLog, kinds: Counter[str]) -> str:
    """Return why a file contained no scans."""
    if log.bad:
        return f"{path}: none of its {log.bad} scans can be read; {log.complaints[0]}"
    if not kinds:
        return f"{path} is empty: expected a CARMEN log with {_WANTED} lines"
    listed = ", ".join(repr(kind) for kind in kinds)
    return f"{path} is no CARMEN log: no line begins with {_WANTED} (found {listed})"
