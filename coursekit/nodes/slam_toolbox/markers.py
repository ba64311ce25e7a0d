"""Markers of mapping: keyframes, edges, accepted and rejected loops, and the quality of the last match."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np
from geometry_msgs.msg import Point
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

from coursekit.geometry.plane import Array, Pose2D
from coursekit.nodes.scanning.planar import to_pose
from coursekit.slam.slam import Result, Slam

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time as TimeMsg

DOUBTED = 0.1
"""Loops with a trust below this are shown as rejected."""
RED, GREEN, BLUE, WHITE = (1.0, 0.1, 0.1), (0.1, 0.8, 0.2), (0.2, 0.4, 1.0), (1.0, 1.0, 1.0)


def graph_markers(slam: Slam, last: Result | None, frame: str, stamp: TimeMsg) -> MarkerArray:
    """The pose graph in the map's frame."""
    edges, poses = slam.graph.edges, slam.graph.poses
    doubted = edges.robust & (slam.graph.trust() < DOUBTED) if len(edges.i) else edges.robust
    ends = np.stack([poses[edges.i, :2], poses[edges.j, :2]], axis=1).reshape(-1, 2, 2)
    markers = [
        _list("slam_toolbox", Marker.SPHERE_LIST, 0.1, RED, poses[:, :2]),
        _list("slam_toolbox_edges", Marker.LINE_LIST, 0.03, BLUE, ends[~edges.robust].reshape(-1, 2)),
        _list("loops_accepted", Marker.LINE_LIST, 0.05, GREEN, ends[edges.robust & ~doubted].reshape(-1, 2)),
        _list("loops_rejected", Marker.LINE_LIST, 0.05, RED, ends[doubted].reshape(-1, 2)),
    ]
    counts = f"loops: {len(slam.loops)} accepted, {slam.rejected} rejected"
    return _array([*markers, status_marker(last, slam.pose, counts)], frame, stamp)


def status_markers(last: Result | None, pose: Pose2D, frame: str, stamp: TimeMsg) -> MarkerArray:
    """The status text alone, for a map that does not change."""
    return _array([status_marker(last, pose, "localising")], frame, stamp)


def status_marker(last: Result | None, pose: Pose2D, more: str) -> Marker:
    """A status text above the robot."""
    marker = _marker("status", Marker.TEXT_VIEW_FACING, 0.25, WHITE)
    marker.pose = to_pose(pose)
    marker.pose.position.z = 1.0
    marker.text = f"{_words(last)}\n{more}"
    return marker


def _words(last: Result | None) -> str:
    """The last match as text."""
    if last is None:
        return "waiting for scans"
    fits = f"match {100 * last.score:.0f} %" if last.accepted else "no match: odometry alone"
    return f"{fits}, degeneracy {last.degeneracy:.2f}" + (": corridor?" if last.degeneracy > 0.8 else "")


def _marker(space: str, kind: int, size: float, color: tuple[float, float, float]) -> Marker:
    """An empty marker."""
    marker = Marker(ns=space, type=kind, action=Marker.ADD)
    marker.scale.x = marker.scale.y = marker.scale.z = size
    marker.color = ColorRGBA(r=color[0], g=color[1], b=color[2], a=1.0)
    marker.pose.orientation.w = 1.0
    return marker


def _list(space: str, kind: int, size: float, color: tuple[float, float, float], points: Array) -> Marker:
    """A marker of points; without points it deletes the marker."""
    marker = _marker(space, kind, size, color)
    marker.points = [Point(x=x, y=y, z=0.0) for x, y in points.tolist()]
    if not marker.points:
        marker.action = Marker.DELETE
    return marker


def _array(markers: Iterable[Marker], frame: str, stamp: TimeMsg) -> MarkerArray:
    """The markers with their frame and time."""
    all_markers = list(markers)
    for marker in all_markers:
        marker.header.frame_id, marker.header.stamp = frame, stamp
    return MarkerArray(markers=all_markers)
