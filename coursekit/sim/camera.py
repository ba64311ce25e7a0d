"""A virtual camera over a small arena: its image depends only on the time, so it is the same in every run.

Metres, x to the right, y ahead, z up. On a chequered floor a robot with an ArUco marker drives in a circle, a red ball
rolls in a figure of eight, a green one to and fro, a blue one hops; an ArUco marker hangs on the wall.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

Point = tuple[float, float, float]

HEIGHT = 1.35
"""Height of the camera above (0, 0) [m]."""
TILT = math.radians(27.0)
"""Angle of the camera below the horizontal."""
FOCAL = 0.82
"""Focal length in widths of the image."""
WALL = 5.2
"""Distance of the wall [m]."""
ROBOT_MARKER, WALL_MARKER = 7, 23
"""Ids of the markers in the dictionary DICT_4X4_50."""
ROBOT_MARKER_SIDE, WALL_MARKER_SIDE = 0.30, 0.70
BALL_RADIUS = {"red": 0.16, "green": 0.13, "blue": 0.11}
_BALL_BGR = {"red": (38, 38, 225), "green": (60, 185, 45), "blue": (225, 110, 25)}
_TILE = 0.4
_PER_METRE = 60
_HALF_FLOOR = 4.2


@dataclass(frozen=True)
class Ball:
    """A ball: its centre [m] and radius [m]."""

    colour: str
    centre: Point
    radius: float


class Scene:
    """The image of a camera.

    >>> scene = Scene()
    >>> image = scene.render(1.5, width=320, height=240)
    >>> image.shape, bool((image == scene.render(1.5, width=320, height=240)).all())
    ((240, 320, 3), True)
    """

    def __init__(self) -> None:
        self._floor = _floor()
        self._markers = {number: _marker(number) for number in (ROBOT_MARKER, WALL_MARKER)}
        self._still: dict[tuple[int, int], Any] = {}

    # -- ground truth

    @staticmethod
    def balls(t: float) -> list[Ball]:
        """Return the balls at time `t` [s]."""
        red = (1.25 * math.sin(0.9 * t), 2.7 + 0.55 * math.sin(1.8 * t), BALL_RADIUS["red"])
        green = (1.6 * math.sin(0.55 * t + 2.0), 3.9, BALL_RADIUS["green"])
        hop = abs(math.sin(2.2 * t))
        blue = (-0.95 + 0.25 * math.sin(0.4 * t), 1.95, BALL_RADIUS["blue"] + 0.35 * hop)
        places = {"red": red, "green": green, "blue": blue}
        return [Ball(name, place, BALL_RADIUS[name]) for name, place in places.items()]

    @staticmethod
    def robot(t: float) -> tuple[float, float, float]:
        """Return the robot's x, y [m] and heading [rad] at time `t`: a circle of 0.75 m, counter-clockwise."""
        angle = 0.5 * t
        return 0.35 + 0.75 * math.cos(angle), 2.55 + 0.75 * math.sin(angle), angle + math.pi / 2

    @staticmethod
    def camera_matrix(width: int = 640, height: int = 480) -> Any:
        """Return the 3 x 3 pinhole camera matrix; there is no distortion.

        >>> Scene.camera_matrix(640, 480)[:2, 2].tolist()  # the middle of the image
        [319.5, 239.5]
        """
        f = FOCAL * width
        return np.array([[f, 0.0, (width - 1) / 2], [0.0, f, (height - 1) / 2], [0.0, 0.0, 1.0]])

    @staticmethod
    def in_camera(point: Point) -> Point:
        """Transform a point [m] to the camera's own frame: x right, y down, z ahead (REP 103's optical frame).

        >>> Scene.in_camera((0.5, 0.0, HEIGHT))  # beside the camera, at its height
        (0.5, -0.0, 0.0)
        """
        x, y, z = point[0], point[1], point[2] - HEIGHT
        cos, sin = math.cos(TILT), math.sin(TILT)
        return x, -sin * y - cos * z, cos * y - sin * z

    def pixel(self, point: Point, width: int = 640, height: int = 480) -> tuple[float, float]:
        """Return column and row of a point [m] in the image.

        >>> straight_ahead = (0.0, math.cos(TILT), HEIGHT - math.sin(TILT))
        >>> [round(one, 6) for one in Scene().pixel(straight_ahead)]
        [319.5, 239.5]
        """
        x, y, depth = self.in_camera(point)
        f = FOCAL * width
        return (width - 1) / 2 + f * x / depth, (height - 1) / 2 + f * y / depth

    # -- rendering

    def render(self, t: float, width: int = 640, height: int = 480) -> Any:
        """Return the image at time `t` [s]: height x width x 3, uint8, blue first."""
        image = self._background(width, height).copy()
        things: list[tuple[float, Ball | None]] = [(self.in_camera(ball.centre)[2], ball) for ball in self.balls(t)]
        things.append((self.in_camera((*self.robot(t)[:2], 0.1))[2], None))
        for ball in self.balls(t):
            self._shadow(image, ball)
        for _, thing in sorted(things, key=lambda pair: -pair[0]):
            if thing is None:
                self._draw_robot(image, t)
            else:
                self._draw_ball(image, thing)
        return image

    def _background(self, width: int, height: int) -> Any:
        still = self._still.get((width, height))
        if still is None:
            still = _sky(width, height)
            self._paste(still, self._floor, _square(0.0, WALL - _HALF_FLOOR, _HALF_FLOOR))
            self._draw_wall_marker(still)
            if len(self._still) > 4:
                self._still.clear()
            self._still[width, height] = still
        return still

    def _paste(self, image: Any, texture: Any, corners: list[Point]) -> None:
        """Map a texture onto a quadrilateral of the world (from its upper left corner, clockwise)."""
        height, width = image.shape[:2]
        rows, columns = texture.shape[:2]
        here = np.array([(0, 0), (columns, 0), (columns, rows), (0, rows)], np.float32)
        there = np.array([self.pixel(_in_front(corner), width, height) for corner in corners], np.float32)
        cv2.warpPerspective(
            texture,
            cv2.getPerspectiveTransform(here, there),
            (width, height),
            dst=image,
            flags=cv2.INTER_AREA if columns > 400 else cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_TRANSPARENT,
        )

    def _draw_wall_marker(self, image: Any) -> None:
        half, low = 0.5 * WALL_MARKER_SIDE * 1.3, 0.25
        corners = [(-half, WALL, low + 2 * half), (half, WALL, low + 2 * half), (half, WALL, low), (-half, WALL, low)]
        self._paste(image, self._markers[WALL_MARKER], corners)

    def _polygon(self, image: Any, points: list[Point], colour: tuple[int, int, int]) -> None:
        height, width = image.shape[:2]
        pixels = [self.pixel(point, width, height) for point in points]
        cv2.fillPoly(image, [np.array([(round(u * 16), round(v * 16)) for u, v in pixels])], colour, cv2.LINE_AA, 4)

    def _shadow(self, image: Any, ball: Ball) -> None:
        x, y, z = ball.centre
        radius = ball.radius / (1.0 + max(0.0, z - ball.radius))
        self._polygon(image, _ring(x, y, 0.0, radius), (96, 104, 110))

    def _draw_ball(self, image: Any, ball: Ball) -> None:
        height, width = image.shape[:2]
        u, v = self.pixel(ball.centre, width, height)
        radius = FOCAL * width * ball.radius / self.in_camera(ball.centre)[2]
        colour = np.array(_BALL_BGR[ball.colour], float)
        for part, light in ((1.0, 0.72), (0.86, 0.86), (0.66, 1.0)):
            off = (1 - part) * radius * 0.6
            shade = [float(value) for value in np.minimum(255, colour * light)]
            place = (round((u - off) * 16), round((v - off) * 16))
            cv2.circle(image, place, round(radius * part * 16), shade, -1, cv2.LINE_AA, 4)
        shine = (round((u - 0.38 * radius) * 16), round((v - 0.42 * radius) * 16))
        cv2.circle(image, shine, round(radius * 0.13 * 16), (255, 255, 255), -1, cv2.LINE_AA, 4)

    def _draw_robot(self, image: Any, t: float) -> None:
        x, y, heading = self.robot(t)
        self._polygon(image, _ring(x, y, 0.0, 0.33), (96, 104, 110))
        for z, colour in ((0.06, (60, 50, 45)), (0.10, (105, 92, 84)), (0.14, (125, 110, 100))):
            self._polygon(image, _ring(x, y, z, 0.30), colour)
        self._polygon(image, _ring(x, y, 0.18, 0.30), (214, 205, 198))
        nose = [(0.29, 0.0), (0.21, 0.07), (0.21, -0.07)]
        self._polygon(image, [_moved(x, y, heading, u, v, 0.18) for u, v in nose], (30, 140, 240))
        half = 0.5 * ROBOT_MARKER_SIDE * 1.3
        corners = [(half, half), (half, -half), (-half, -half), (-half, half)]
        self._paste(image, self._markers[ROBOT_MARKER], [_moved(x, y, heading, u, v, 0.18) for u, v in corners])


def _moved(x: float, y: float, heading: float, u: float, v: float, z: float) -> Point:
    cos, sin = math.cos(heading), math.sin(heading)
    return x + cos * u - sin * v, y + sin * u + cos * v, z


def _ring(x: float, y: float, z: float, radius: float) -> list[Point]:
    return [_moved(x, y, 2 * math.pi * number / 32, radius, 0.0, z) for number in range(32)]


def _square(x: float, y: float, half: float) -> list[Point]:
    return [(x - half, y + half, 0.0), (x + half, y + half, 0.0), (x + half, y - half, 0.0), (x - half, y - half, 0.0)]


def _in_front(point: Point) -> Point:
    """Move a corner behind the camera forward, where it can be projected."""
    return point if point[1] > 0.2 else (point[0], 0.2, point[2])


def _floor() -> Any:
    """Return the floor from above, its far edge at the wall."""
    size = round(2 * _HALF_FLOOR * _PER_METRE)
    cells = np.arange(size) // round(_TILE * _PER_METRE)
    chequers = (cells[:, None] + cells[None, :]) % 2
    colours = np.array([(196, 205, 210), (150, 161, 168)], np.uint8)
    return colours[chequers]


def _marker(number: int) -> Any:
    """Return a marker with its white margin: 1.3 times the marker itself."""
    dictionary = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
    inner = cv2.aruco.generateImageMarker(dictionary, number, 180)
    framed = cv2.copyMakeBorder(inner, 27, 27, 27, 27, cv2.BORDER_CONSTANT, value=255)
    return cv2.cvtColor(framed, cv2.COLOR_GRAY2BGR)


def _sky(width: int, height: int) -> Any:
    """Return the wall: a gradient."""
    upper, lower = np.array([120.0, 96.0, 78.0]), np.array([176.0, 156.0, 140.0])
    part = np.linspace(0.0, 1.0, height)[:, None]
    column = (upper * (1 - part) + lower * part).astype(np.uint8)
    return np.ascontiguousarray(np.broadcast_to(column[:, None, :], (height, width, 3)))
