"""Maps, SLAM's files and behaviour trees."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

from .format import MAPS, SHARE, TEXT, XML, YAML, Faults, Format, values_only


def _map(path: Path) -> Any:
    from coursekit.nav.map_file import load_map

    picture = path.with_name("room.pgm")
    if not picture.exists():
        picture.write_bytes((MAPS / "robot_world.pgm").read_bytes())
    return load_map(path)


def _picture(path: Path) -> Any:
    from coursekit.nav.map_picture import read_picture

    return read_picture(path)


def _map_faults() -> Faults:
    from coursekit.nav.map_error import MapError

    return MapError, OSError


@cache
def _png() -> bytes:
    import cv2

    return bytes(cv2.imencode(".png", np.arange(400, dtype=np.uint8).reshape(20, 20))[1])


@cache
def _session() -> bytes:
    from coursekit.geometry.plane import Pose2D
    from coursekit.slam import storage
    from coursekit.slam.scan import Laser
    from coursekit.slam.slam import Slam

    slam = Slam()
    for number in range(6):
        slam.add_ranges(float(number), [3.0] * 90, Laser(-3.0, 0.06), Pose2D(0.4 * number, 0, 0))
    with tempfile.TemporaryDirectory() as folder:
        return storage.save(slam, Path(folder, "s")).read_bytes()


def _slam(path: Path) -> Any:
    from coursekit.slam import storage

    return storage.load(path)


def _carmen(path: Path) -> Any:
    from coursekit.slam.carmen import read_log

    return read_log(path)


CARMEN = b"""PARAM robot_frontlaser_offset 0.08
ODOM 0.1 0.2 0.3 0 0 0 1.0 host 1.0
FLASER 5 1.0 2.0 3.0 2.0 1.0 0.1 0.2 0.3 0.1 0.2 0.3 1.0 host 1.0
ROBOTLASER1 0 -1.57 3.14 0.8 80 0.01 0 4 1 2 3 4 0 0 0 0 0 0 0 0 0 0 0 0 0 2.0 host 2.0
"""


TREE = SHARE / "nav2_bt_navigator/behavior_trees/navigate_w_replanning_time.xml"


def _tree(path: Path) -> Any:
    from coursekit.nodes.nav2.tree_run import load_tree, text_of

    return load_tree(str(path), text_of(str(path)), {"node": mock.MagicMock()})


def _tree_faults() -> Faults:
    from coursekit.nav.behavior_tree import TreeError

    return (TreeError,)


FORMATS = (
    Format("map", ".yaml", lambda: b"image: room.pgm\nmode: trinary\nresolution: 0.05\norigin: [-1.0, 2.0, 0]\n"
           b"negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n", _map, _map_faults, YAML),
    Format("PGM", ".pgm", lambda: b"P5\n# made\n20 20\n255\n" + bytes(range(200)) * 2, _picture, _map_faults),
    Format("PNG", ".png", _png, _picture, _map_faults),
    Format("SLAM session", ".npz", _session, _slam, values_only),
    Format("CARMEN log", ".log", lambda: CARMEN, _carmen, values_only, TEXT),
    Format("behaviour tree", ".xml", TREE.read_bytes, _tree, _tree_faults, XML),
)  # fmt: skip
