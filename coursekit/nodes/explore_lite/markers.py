"""Frontiers as markers: blue lines, red if abandoned, with a green ball at each one's nearest point."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import Point
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

from coursekit.nav.frontiers import Frontier

_BLUE, _RED, _GREEN = (0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)


def markers(found: list[Frontier], given_up: list[bool], frame: str, stamp: Any, before: int) -> MarkerArray:
    """Make two markers for each frontier; surplus ones of `before` are deleted."""
    drawn: list[Marker] = []

    def add(kind: int, colour: tuple[float, float, float], size: float) -> Marker:
        marker = Marker(ns="frontiers", id=len(drawn), type=kind, action=Marker.ADD, frame_locked=True)
        marker.header.frame_id, marker.header.stamp = frame, stamp
        marker.scale.x = marker.scale.y = marker.scale.z = size
        marker.color = ColorRGBA(r=colour[0], g=colour[1], b=colour[2], a=1.0)
        drawn.append(marker)
        return marker

    least = found[0].cost if found else 0.0
    for frontier, lost in zip(found, given_up, strict=True):
        line = add(Marker.POINTS, _RED if lost else _BLUE, 0.1)
        line.points = [Point(x=x, y=y) for x, y in frontier.points.tolist()]
        size = min(abs(least * 0.4 / frontier.cost), 0.5) if frontier.cost else 0.5
        ball = add(Marker.SPHERE, _GREEN, size)
        ball.pose.position.x, ball.pose.position.y = frontier.nearest
    while len(drawn) < before:
        add(Marker.POINTS, _BLUE, 0.1).action = Marker.DELETE
    return MarkerArray(markers=drawn)
