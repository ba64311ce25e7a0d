"""The error of an estimated trajectory against known motions (Kümmerle et al. 2009): local, without aligning maps."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from coursekit.geometry.plane import Array, between, wrap
from coursekit.slam.files import read_lines


@dataclass(frozen=True)
class Errors:
    """Mean and standard deviation of the translation [m] and rotation [deg] errors."""

    translation: float
    translation_std: float
    rotation: float
    rotation_std: float
    used: int
    outside: int
    """Relations with stamps outside of the trajectory, which are not counted."""

    def __str__(self) -> str:
        return (
            f"translation {self.translation:.4f} ± {self.translation_std:.4f} m, "
            f"rotation {self.rotation:.3f} ± {self.rotation_std:.3f} deg ({self.used} relations)"
        )


def read_relations(path: str | Path) -> Array:
    r"""Read (n, 5) `t1 t2 x y theta` from lines `t1 t2 x y z roll pitch yaw`.

    Raises ValueError with the line number for a malformed line.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "known.relations")
    ...     _ = file.write_text("10.0 12.0 0.5 0 0 0 0 1.57\n", encoding="ascii")
    ...     read_relations(file).tolist()
    [[10.0, 12.0, 0.5, 0.0, 1.57]]
    """
    return _table(path, 8, "t1 t2 x y z roll pitch yaw", "relations")[:, [0, 1, 2, 3, 7]]


def read_trajectory(path: str | Path) -> Array:
    """Read (n, 4) `stamp x y theta`, sorted by stamp."""
    rows = _table(path, 4, "stamp x y theta", "poses")
    return rows[np.argsort(rows[:, 0], kind="stable")]


def write_trajectory(path: str | Path, trajectory: Array) -> None:
    """Write (n, 4) rows as `stamp x y theta` lines.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_trajectory(Path(folder, "slam.txt"), np.array([[2.0, 1.0, 0.5, 0.1]]))
    ...     read_trajectory(Path(folder, "slam.txt")).tolist()
    [[2.0, 1.0, 0.5, 0.1]]
    """
    lines = (f"{stamp:.6f} {x:.6f} {y:.6f} {theta:.6f}\n" for stamp, x, y, theta in trajectory)
    Path(path).write_text("".join(lines), encoding="ascii")


def _table(path: str | Path, width: int, form: str, noun: str) -> Array:
    """Read the numbers of a text file, `width` per line; empty lines and # comments are skipped."""
    rows: list[list[float]] = []
    for number, line in enumerate(read_lines(path), start=1):
        words = line.split("#", 1)[0].split()
        if not words:
            continue
        try:
            row = [float(word) for word in words]
        except ValueError:
            row = []
        if len(row) != width or not np.isfinite(row).all():
            raise ValueError(f"{path}, line {number}: expected '{form}', found '{line.strip()[:60]}'")
        rows.append(row)
    if not rows:
        raise ValueError(f"{path} holds no {noun}: each line should be '{form}'")
    return np.array(rows)


def poses_at(trajectory: Array, stamps: Array) -> Array:
    """Return (n, 3) poses at the stamps, interpolated between the rows `stamp x y theta` of the trajectory.

    >>> poses_at(np.array([[0.0, 0, 0, 3.0], [1.0, 2, 0, -3.0]]), np.array([0.5])).round(3)
    array([[ 1.   ,  0.   , -3.142]])
    """
    times = trajectory[:, 0]
    after = np.clip(np.searchsorted(times, stamps, side="right"), 1, max(len(times) - 1, 1))
    after = np.minimum(after, len(times) - 1)
    before = np.maximum(after - 1, 0)
    gap = times[after] - times[before]
    part = np.where(gap > 0, (stamps - times[before]) / np.where(gap > 0, gap, 1), 0.0)[:, None]
    first, second = trajectory[before, 1:], trajectory[after, 1:]
    step = second - first
    step[:, 2] = wrap(step[:, 2])
    poses = first + part * step
    poses[:, 2] = wrap(poses[:, 2])
    return poses


def errors(trajectory: Array, relations: Array, slack: float = 0.5) -> Errors:
    """Compare rows `stamp x y theta` with rows `t1 t2 x y theta`, except stamps outside by more than `slack` [s].

    Raises ValueError when all relations are outside of the trajectory.

    >>> trajectory = np.array([[0.0, 0.0, 0.0, 0.0], [1.0, 2.1, 0.0, 0.0]])
    >>> found = errors(trajectory, np.array([[0.0, 1.0, 2.0, 0.0, 0.0]]))  # 2 m in truth, 2.1 m by SLAM
    >>> round(found.translation, 3), found.rotation, found.used
    (0.1, 0.0, 1)
    """
    trajectory = trajectory[np.argsort(trajectory[:, 0], kind="stable")]  # logs are not always in order
    low, high = trajectory[0, 0] - slack, trajectory[-1, 0] + slack
    inside = (relations[:, :2] >= low).all(axis=1) & (relations[:, :2] <= high).all(axis=1)
    if not inside.any():
        raise ValueError(
            f"no relation lies within the trajectory ({trajectory[0, 0]:.2f} to {trajectory[-1, 0]:.2f} s): "
            "do the two files belong to the same log?"
        )
    chosen = relations[inside]
    estimated = between(poses_at(trajectory, chosen[:, 0]), poses_at(trajectory, chosen[:, 1]))
    wrong = between(chosen[:, 2:], estimated)
    metres, degrees = np.hypot(wrong[:, 0], wrong[:, 1]), np.degrees(np.abs(wrong[:, 2]))
    return Errors(
        float(metres.mean()), float(metres.std()), float(degrees.mean()), float(degrees.std()),
        int(inside.sum()), int((~inside).sum()),
    )  # fmt: skip
