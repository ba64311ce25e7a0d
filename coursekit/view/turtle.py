"""The turtles' window as a picture and as text. The turtle is drawn by coursekit."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import cv2
import numpy as np

from coursekit.sim.turtle import SIDE, Turtle, World

Polygon = list[tuple[float, float]]

BACKGROUND = (69, 86, 255)
KINDS = [
    {"shell": "#3f9b57", "plate": "#58b96f", "rim": "#2b6f3d", "skin": "#9bd770"},
    {"shell": "#d9822b", "plate": "#f0a04b", "rim": "#a05a16", "skin": "#f5d491"},
    {"shell": "#b6467f", "plate": "#d8689f", "rim": "#82305a", "skin": "#f4b9d2"},
    {"shell": "#2f8fa8", "plate": "#4fb3cb", "rim": "#1f6577", "skin": "#a9e2e4"},
    {"shell": "#7a5bc0", "plate": "#9a7ee0", "rim": "#523a8c", "skin": "#cfc0f2"},
    {"shell": "#b09a3a", "plate": "#d0bb5a", "rim": "#7d6c23", "skin": "#ebe2a4"},
]
"""The turtles' colours, in order of appearance."""
_ACROSS = 4
"""Fractional bits of coordinates for OpenCV."""


def _ellipse(x: float, y: float, a: float, b: float, turned: float = 0.0, corners: int = 28) -> Polygon:
    """Return an ellipse about (x, y) with half axes a and b [m], rotated by `turned` [rad]."""
    cos, sin = math.cos(turned), math.sin(turned)
    points = []
    for number in range(corners):
        angle = 2 * math.pi * number / corners
        u, v = a * math.cos(angle), b * math.sin(angle)
        points.append((round(x + cos * u - sin * v, 4), round(y + sin * u + cos * v, 4)))
    return points


@lru_cache(maxsize=1)
def shape() -> list[tuple[str, Polygon]]:
    """Return the turtle as polygons [m], facing along x: (colour name, corners), from bottom to top."""
    legs = [
        ("skin", _ellipse(0.23 * ahead, 0.27 * side, 0.17, 0.085, side * ahead * math.radians(52)))
        for ahead in (1, -1)
        for side in (1, -1)
    ]
    tail = ("skin", [(-0.30, 0.06), (-0.47, 0.0), (-0.30, -0.06)])
    head = ("skin", _ellipse(0.40, 0.0, 0.125, 0.105))
    eyes = [("eye", _ellipse(0.445, 0.055 * side, 0.024, 0.024, corners=12)) for side in (1, -1)]
    shell = [("rim", _ellipse(0.0, 0.0, 0.335, 0.285)), ("shell", _ellipse(0.0, 0.0, 0.295, 0.245))]
    return [*legs, tail, head, *eyes, *shell, *_plates()]


def _plates() -> list[tuple[str, Polygon]]:
    """Return a six-sided plate in the middle of the shell and six around it."""

    def plate(x: float, y: float, radius: float) -> tuple[str, Polygon]:
        corners = [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in _SIXTHS]
        return ("plate", [(round(u, 4), round(v, 4)) for u, v in corners])

    around = [plate(0.195 * math.cos(a), 0.160 * math.sin(a), 0.066) for a in _SIXTHS]
    return [plate(0.0, 0.0, 0.092), *around]


_SIXTHS = [math.pi * number / 3 for number in range(6)]


def describe(world: World, name: str = "/turtlesim") -> str:
    """Describe the window: every turtle's position, heading and path length.

    >>> world = World(); _ = world.spawn()
    >>> print(describe(world))
    TurtleSim [/turtlesim]
      turtle1  x 5.54 m  y 5.54 m  heading   0.0°  drove 0.00 m
    """
    lines = [f"TurtleSim [{name}]"]
    width = max((len(turtle) for turtle in world.turtles), default=0)
    for turtle in sorted(world.turtles.values(), key=lambda turtle: turtle.name):
        heading = math.degrees(turtle.theta) + 0.0
        lines.append(
            f"  {turtle.name:{width}}  x {turtle.x:.2f} m  y {turtle.y:.2f} m  heading {heading:5.1f}°"
            f"  drove {turtle.travelled:.2f} m"
        )
    return "\n".join(lines if world.turtles else [*lines, "  no turtles"])


def picture(world: World, background: tuple[int, int, int] = BACKGROUND, size: int = 500) -> Any:
    """Return the window as an image: a `size` x `size` x 3 array of uint8 in OpenCV's BGR order."""
    scale = size / (SIDE + 1 / 45)
    image = np.full((size, size, 3), background[::-1], np.uint8)
    for stroke in world.paper.strokes:
        points = _pixels(stroke.points, scale)
        thickness = max(1, round(stroke.width * size / 500))
        cv2.polylines(image, [points], False, stroke.colour[::-1], thickness, cv2.LINE_AA, _ACROSS)
    for turtle in sorted(world.turtles.values(), key=lambda turtle: turtle.name):
        _draw_turtle(image, turtle, scale)
    return image


def png(world: World, background: tuple[int, int, int] = BACKGROUND, size: int = 500) -> bytes:
    """Return the window as a PNG file."""
    return bytes(cv2.imencode(".png", picture(world, background, size))[1])


def _draw_turtle(image: Any, turtle: Turtle, scale: float) -> None:
    cos, sin = math.cos(turtle.theta), math.sin(turtle.theta)
    colours = KINDS[turtle.kind % len(KINDS)]
    for role, corners in shape():
        moved = [(turtle.x + cos * u - sin * v, turtle.y + sin * u + cos * v) for u, v in corners]
        colour = _bgr(colours.get(role, "#26313a"))
        cv2.fillPoly(image, [_pixels(moved, scale)], colour, cv2.LINE_AA, _ACROSS)


def _pixels(points: Polygon, scale: float) -> Any:
    fine = scale * (1 << _ACROSS)
    return np.array([(round(x * fine), round((SIDE - y) * fine)) for x, y in points], np.int32)


def _bgr(colour: str) -> tuple[int, int, int]:
    return int(colour[5:7], 16), int(colour[3:5], 16), int(colour[1:3], 16)
