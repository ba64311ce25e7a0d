"""A scene as a PNG without a browser: painter's algorithm, far things first."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import repeat
from typing import Any

import cv2
import numpy as np

from .scene import Scene, Thing
from .scene_camera import FIELD, NEAR, Camera
from .scene_shapes import Band, Label, Lines, Picture, Points, Triangles, rotation

FINE = 2
"""The oversampling factor for smooth edges."""
_SHIFT = 4
_TOP, _BOTTOM = (250, 247, 245), (232, 226, 221)
_LIGHT = np.array([0.35, -0.5, 0.79])
MOST_DOTS = 20_000
FARTHEST = 20_000
"""How far beside the picture a corner may be [pixels]; parts with farther ones are left out."""


class Still:
    """One picture; `width` and `height` in pixels."""

    def __init__(self, camera: Camera, width: int = 640, height: int = 400) -> None:
        self.camera = camera
        self.width, self.height = width * FINE, height * FINE
        self.zoom = camera.stretch * self.height / 2 / math.tan(FIELD / 2)
        steps = np.linspace(0.0, 1.0, self.height)[:, None, None]
        flat = np.array(_TOP) * (1 - steps) + np.array(_BOTTOM) * steps
        self.image = np.ascontiguousarray(np.broadcast_to(flat, (self.height, self.width, 3)).round().astype(np.uint8))
        self._parts: list[tuple[float, np.ndarray, Sequence[float], float, float]] = []
        self._labels: list[tuple[np.ndarray, Label]] = []

    def png(self, scene: Scene, below: list[str]) -> bytes:
        """Draw a scene, the displays `below` (floors) first. The same scene gives the same bytes."""
        things = list(scene.things.items())
        for floor in (True, False):
            for key, thing in things:
                if (key[0] in below) == floor:
                    self._add(thing)
            self._paint()
        small = cv2.resize(self.image, None, fx=1 / FINE, fy=1 / FINE, interpolation=cv2.INTER_AREA)
        self._write(small)
        return bytes(cv2.imencode(".png", small, (cv2.IMWRITE_PNG_COMPRESSION, 6))[1].tobytes())

    # -- collecting

    def _add(self, thing: Thing) -> None:
        turn = rotation(np.array(thing.pose[3:]))

        def world(points: np.ndarray) -> np.ndarray:
            return (points * thing.scale) @ turn.T + thing.pose[:3]

        add: dict[type, Any] = {
            Triangles: self._triangles, Band: self._triangles, Lines: self._lines, Points: self._points,
            Picture: self._picture, Label: self._label,
        }  # fmt: skip
        for shape in thing.shapes:
            add[type(shape)](shape, world)

    def _pixels(self, seen: np.ndarray) -> np.ndarray:
        flat = seen[..., :2] / np.maximum(seen[..., 2:], NEAR) * self.zoom
        return np.stack([self.width / 2 + flat[..., 0], self.height / 2 - flat[..., 1]], axis=-1)

    def _triangles(self, shape: Triangles, world: Any) -> None:
        points = world(shape.vertices)
        corners = points[shape.faces]
        area = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals = area / np.maximum(np.linalg.norm(area, axis=1, keepdims=True), 1e-30)
        towards = np.einsum("ij,ij->i", normals, self.camera.eye() - corners.mean(axis=1))
        bright = 0.62 + 0.38 * np.clip(np.where(towards < 0, -1, 1) * (normals @ _LIGHT), -0.5, 1)
        seen = self.camera.seen(points)[shape.faces]
        depth = seen[:, :, 2]
        every = np.array(shape.colour) if shape.colours is None else shape.colours
        paints = np.broadcast_to(every, (len(shape.faces), 4))
        pixels = self._pixels(seen)
        drawn = (depth.min(axis=1) > NEAR) & (np.abs(pixels).max(axis=(1, 2)) <= FARTHEST)
        colours = paints[drawn, 2::-1] * 255 * bright[drawn, None]
        depths, alphas = depth[drawn].mean(axis=1).tolist(), paints[drawn, 3].tolist()
        self._parts += zip(depths, _fixed(pixels[drawn]), colours.tolist(), alphas, repeat(0.0))

    def _lines(self, shape: Lines, world: Any) -> None:
        seen = self.camera.seen(world(shape.points)).reshape(-1, 2, 3)
        every = shape.colours[::2] if shape.colours is not None else np.array(shape.colour[:3])
        paints = np.broadcast_to(every, (len(seen), 3)) * 255
        for (a, b), (red, green, blue) in zip(seen, paints, strict=True):
            clipped = _before(a, b)
            if clipped is not None:
                depth = float(clipped[:, 2].mean())
                colour = float(blue), float(green), float(red)
                self._part(depth, self._pixels(clipped), colour, shape.colour[3], 0.0)

    def _points(self, shape: Points, world: Any) -> None:
        step = -(-len(shape.points) // MOST_DOTS) or 1
        seen = self.camera.seen(world(shape.points[::step]))
        every = np.array(shape.colour[:3]) if shape.colours is None else shape.colours[::step]
        paints = np.broadcast_to(every, (len(seen), 3)) * 255
        pixels = self._pixels(seen)
        for index in np.nonzero(seen[:, 2] > NEAR)[0]:
            depth = float(seen[index, 2])
            wide = shape.size * FINE if shape.pixels else shape.size / depth * self.zoom
            radius = max(1.0 * FINE, wide / 2)
            red, green, blue = map(float, paints[index])
            self._part(depth, pixels[index : index + 1], (blue, green, red), 1.0, radius)

    def _part(self, depth: float, corners: np.ndarray, colour: Sequence[float], alpha: float, radius: float) -> None:
        if np.abs(corners).max() <= FARTHEST:
            self._parts.append((depth, _fixed(corners), colour, alpha, radius))

    def _picture(self, shape: Picture, world: Any) -> None:
        """Draw a map at once: it lies below everything."""
        w, h = shape.width, shape.height
        seen = self.camera.seen(world(np.array([[0, h, 0], [w, h, 0], [w, 0, 0], [0, 0, 0]], float)))
        if seen[:, 2].min() <= NEAR:
            return
        rows, columns = shape.image.shape[:2]
        source = np.array([[0, 0], [columns, 0], [columns, rows], [0, rows]], np.float32) - 0.5
        warp = cv2.getPerspectiveTransform(source, self._pixels(seen).astype(np.float32))
        flat = cv2.warpPerspective(shape.image, warp, (self.width, self.height), flags=cv2.INTER_NEAREST)
        cover = flat[:, :, 3:].astype(float) / 255 * shape.alpha
        self.image[:] = (self.image * (1 - cover) + flat[:, :, 2::-1] * cover).round()

    def _label(self, shape: Label, world: Any) -> None:
        seen = self.camera.seen(world(np.zeros((1, 3))))[0]
        if seen[2] > NEAR:
            self._labels.append((np.array([*(self._pixels(seen) / FINE), seen[2]]), shape))

    # -- painting

    def _paint(self) -> None:
        for _, points, colour, alpha, radius in sorted(self._parts, key=lambda part: -part[0]):
            if alpha >= 0.999:
                _draw(self.image, points, colour, radius)
            else:
                self._blend(points, colour, alpha, radius)
        self._parts = []

    def _blend(self, points: np.ndarray, colour: Sequence[float], alpha: float, radius: float) -> None:
        """Draw a part that can be seen through, in the box around it."""
        low = np.maximum((points.min(axis=0) >> _SHIFT) - 3, 0)
        high = np.maximum((points.max(axis=0) >> _SHIFT) + 5, 0)
        box = self.image[low[1] : high[1], low[0] : high[0]]
        if box.size:
            canvas = box.copy()
            _draw(canvas, points - (low << _SHIFT).astype(np.int32), colour, radius)
            box[:] = (canvas * alpha + box * (1 - alpha)).round()

    def _write(self, image: np.ndarray) -> None:
        """Draw the labels, in a font included in matplotlib."""
        if not self._labels:
            return
        from matplotlib import get_data_path
        from PIL import Image, ImageDraw, ImageFont

        paper = Image.fromarray(image)
        pen = ImageDraw.Draw(paper)
        for (x, y, depth), label in self._labels:
            size = 10.0 if not label.height else label.height / depth * self.zoom / FINE
            if not 3.0 <= size <= 200.0 or not (-200 < x < image.shape[1] + 200 and -50 < y < image.shape[0] + 50):
                continue
            font = ImageFont.truetype(f"{get_data_path()}/fonts/ttf/DejaVuSans.ttf", round(size))
            red, green, blue = (round(value * 255) for value in label.colour[:3])
            place, anchor = ((x, y), "mm") if label.height else ((x + 5, y - 5), "lm")
            rim = (59, 50, 38) if label.light else (248, 245, 243)
            pen.text(place, label.text, (blue, green, red), font, anchor, stroke_width=1, stroke_fill=rim)
        image[:] = np.asarray(paper)


def _fixed(corners: np.ndarray) -> np.ndarray:
    """Return pixels as the whole numbers that are drawn."""
    return np.round(corners * (1 << _SHIFT)).astype(np.int32)


def _draw(image: np.ndarray, points: np.ndarray, colour: Sequence[float], radius: float) -> None:
    """Draw a dot, a line or a triangle."""
    if len(points) == 1:
        cv2.circle(image, points[0].tolist(), round(radius * (1 << _SHIFT)), colour, -1, cv2.LINE_AA, _SHIFT)
    elif len(points) == 2:
        cv2.line(image, points[0].tolist(), points[1].tolist(), colour, FINE, cv2.LINE_AA, _SHIFT)
    else:
        cv2.fillConvexPoly(image, points, colour, cv2.LINE_8, _SHIFT)


def _before(a: np.ndarray, b: np.ndarray) -> np.ndarray | None:
    """Return the part of a line in front of the camera; None if there is none."""
    if a[2] <= NEAR and b[2] <= NEAR:
        return None
    if a[2] <= NEAR or b[2] <= NEAR:
        cut = a + (b - a) * ((NEAR * 2 - a[2]) / (b[2] - a[2]))
        a, b = (cut, b) if a[2] <= NEAR else (a, cut)
    return np.stack([a, b])


__all__ = ["Still"]
