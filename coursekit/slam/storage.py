"""SLAM sessions as files: plain arrays in a .npz, nothing in it is ever executed."""

from __future__ import annotations

import dataclasses
import io
import json
import zipfile
import zlib
from pathlib import Path
from typing import Any

import numpy as np

from coursekit.files import write_whole
from coursekit.geometry.plane import Pose2D
from coursekit.slam.keyframe import Keyframe
from coursekit.slam.parameters import SlamParameters
from coursekit.slam.scan import Scan
from coursekit.slam.slam import Slam
from coursekit.slam.submaps import around, cover

FORMAT = 1
LARGEST = 2 << 30
"""Maximum size of a decompressed session [bytes]."""
_ENDINGS = (".npz", ".posegraph")
_FAULTS: tuple[type[Exception], ...] = (OSError, EOFError, LookupError, RuntimeError, TypeError, ArithmeticError, ValueError)
_FAULTS += (zipfile.BadZipFile, zlib.error)
"""The exceptions that readers raise for a damaged archive, or for arrays of other shapes."""


def save(slam: Slam, path: str | Path) -> Path:
    """Write a session to PATH (.npz is added unless it ends in that or .posegraph); return the full path.

    In ROS 2: slam_toolbox's service serialize_map.

    >>> import tempfile
    >>> slam = Slam()
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     save(slam, Path(folder, "office")).name
    'office.npz'
    """
    scans = [keyframe.scan for keyframe in slam.keyframes]
    edges = slam.graph.edges
    none = np.zeros((0, 2))
    arrays: dict[str, Any] = {
        "format": np.array(FORMAT),
        "parameters": np.array(json.dumps(dataclasses.asdict(slam.params))),
        "poses": slam.graph.poses,
        "pairs": np.stack([edges.i, edges.j], axis=1),
        "edge_motions": edges.z,
        "precisions": edges.precision,
        "robust": edges.robust,
        "scan_stamps": np.array([scan.stamp for scan in scans]),
        "origins": np.array([tuple(scan.origin) for scan in scans]).reshape(-1, 3),
        "hits": np.concatenate([none, *(scan.hits for scan in scans)]),
        "misses": np.concatenate([none, *(scan.misses for scan in scans)]),
        "hit_counts": np.array([len(scan.hits) for scan in scans], dtype=np.int64),
        "miss_counts": np.array([len(scan.misses) for scan in scans], dtype=np.int64),
        "stamps": np.array(slam.stamps),
        "bases": np.array(slam.bases, dtype=np.int64),
        "motions": np.array(slam.motions).reshape(-1, 3),
        "now": np.array(tuple(slam.pose)),
    }
    file = Path(path)
    file = file if file.suffix in _ENDINGS else file.with_name(file.name + ".npz")
    packed = io.BytesIO()
    np.savez_compressed(packed, **arrays)
    write_whole(file, packed.getvalue())
    return file.resolve()


def load(path: str | Path, at: Pose2D | None = None) -> Slam:
    """Read a session and prepare it to continue, from its last pose or from `at`. In ROS 2: deserialize_map.

    Raises FileNotFoundError, or ValueError when the file is not a saved session.

    >>> import tempfile
    >>> from coursekit.slam.scan import Laser
    >>> slam = Slam()
    >>> _ = slam.add_ranges(0.0, [1.0, 1.0, 1.0], Laser(angle_min=0.0, angle_increment=0.1), Pose2D())
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     len(load(save(slam, Path(folder, "office"))).keyframes)
    1
    """
    file = Path(path)
    if not file.exists() and file.suffix not in _ENDINGS:
        file = next((named for end in _ENDINGS if (named := file.with_name(file.name + end)).exists()), file)
    if not file.exists():
        raise FileNotFoundError(f"no file {file}: a session is saved with coursekit.slam.storage.save")
    try:
        with zipfile.ZipFile(file) as packed:
            if sum(item.file_size for item in packed.infolist()) > LARGEST:
                raise ValueError("it would fill the memory")
        with np.load(file, allow_pickle=False) as archive:
            data = {name: archive[name] for name in archive.files}
        return _restore(data, at)
    except _FAULTS as fault:
        raise ValueError(f"{file} is no saved SLAM session, or is damaged: {fault}") from fault


def _restore(data: dict[str, Any], at: Pose2D | None) -> Slam:
    """Restore a session from its arrays."""
    if int(data["format"]) != FORMAT:
        raise ValueError(f"its format is {int(data['format'])}, this coursekit reads {FORMAT}")
    slam = Slam(_parameters(str(data["parameters"])))
    _restore_graph(slam, data)
    for number, scan in enumerate(_scans(slam.params, data)):
        slam.keyframes.append(Keyframe(number, scan))
    if len(slam.keyframes) != slam.graph.size:
        raise ValueError(f"{slam.graph.size} poses, but {len(slam.keyframes)} keyframes")
    slam.stamps = [float(stamp) for stamp in data["stamps"]]
    slam.bases = [int(base) for base in data["bases"]]
    if any(not 0 <= base < slam.graph.size for base in slam.bases) or len(slam.bases) != len(slam.stamps):
        raise ValueError("its scans name keyframes that it does not have")
    slam.motions = [Pose2D.of(motion) for motion in data["motions"]]
    if slam.keyframes:
        resume(slam, at or Pose2D.of(data["now"]))
    return slam


def resume(slam: Slam, at: Pose2D) -> None:
    """Continue from a pose in the map: the next keyframe is connected to the nearest old one."""
    poses = slam.graph.poses
    for submap in cover(slam.keyframes, poses, slam.params):
        if submap.anchor not in {known.anchor for known in slam.search.submaps}:
            slam.search.add(submap)
    here = around(slam.keyframes, poses, at, slam.params)
    slam.tracker.start(here, here.anchor, slam.graph.pose(here.anchor).to(at))


def _parameters(text: str) -> SlamParameters:
    """Read parameters from JSON; unknown names are ignored."""
    known = {item.name for item in dataclasses.fields(SlamParameters)}
    values: dict[str, Any] = {}
    for name, value in json.loads(text).items():
        if name in known:
            values[name] = tuple(value) if isinstance(value, list) else value
    return SlamParameters(**values)


def _restore_graph(slam: Slam, data: dict[str, Any]) -> None:
    """Restore nodes and edges."""
    for pose in data["poses"]:
        slam.graph.add_node(Pose2D.of(pose))
    rows = zip(data["pairs"], data["edge_motions"], data["precisions"], data["robust"], strict=True)
    for (first, second), motion, precision, robust in rows:
        slam.graph.add_edge(int(first), int(second), Pose2D.of(motion), precision, bool(robust))


def _scans(params: SlamParameters, data: dict[str, Any]) -> list[Scan]:
    """Restore the keyframes' scans."""
    hits = np.split(data["hits"], np.cumsum(data["hit_counts"])[:-1])
    misses = np.split(data["misses"], np.cumsum(data["miss_counts"])[:-1])
    rows = zip(data["scan_stamps"], data["origins"], hits, misses, strict=False)
    return [
        Scan.from_points(hit, params, origin=Pose2D.of(origin), stamp=float(stamp), misses=miss)
        for stamp, origin, hit, miss in rows
    ]
