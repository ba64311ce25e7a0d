"""Detection of AprilTags with OpenCV, under the AprilTag library's conventions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

FAMILIES = {
    "16h5": cv2.aruco.DICT_APRILTAG_16h5,
    "25h9": cv2.aruco.DICT_APRILTAG_25h9,
    "36h10": cv2.aruco.DICT_APRILTAG_36h10,
    "36h11": cv2.aruco.DICT_APRILTAG_36h11,
}
_CELL = 8
"""Pixels of a bit when it is read again, to count what was corrected."""
_SQUARE = np.array([[-1, 1], [1, 1], [1, -1], [-1, -1]], np.float32)
"""The corners in the tag's own frame, y down: counter-clockwise, beginning at the lower left."""


@dataclass(frozen=True, eq=False)
class Tag:
    """A tag in an image."""

    id: int
    hamming: int
    """Bits that were corrected."""
    margin: float
    """How far the bits are from the threshold between black and white, on average [grey levels]."""
    corners: np.ndarray
    """(4, 2) [pixels]: counter-clockwise, beginning at the lower left of the tag."""

    @property
    def homography(self) -> np.ndarray:
        """(3, 3): from the tag, whose corners are at ±1 with y down, to the image."""
        matrix: np.ndarray = cv2.getPerspectiveTransform(_SQUARE, self.corners.astype(np.float32))
        return matrix

    @property
    def centre(self) -> np.ndarray:
        """(2,) [pixels]."""
        middle: np.ndarray = self.homography[:2, 2]
        return middle

    def pose(self, size: float, camera: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The rotation vector and the place [m] of a tag of that edge: x to its right, y up, z out of it.

        `camera` is the (3, 3) matrix of an image without distortion.
        """
        points = np.column_stack([_SQUARE[:, 0], -_SQUARE[:, 1], np.zeros(4)]) * (size / 2)
        _, turn, place = cv2.solvePnP(points, self.corners.astype(float), camera, None)
        return turn.ravel(), place.ravel()


class Detector:
    """Finds the tags of a family. ValueError for a family that is unknown here."""

    def __init__(self, family: str) -> None:
        if family not in FAMILIES:
            raise ValueError(f"Unsupported tag family: {family}; there are {', '.join(FAMILIES)}")
        self._codes = cv2.aruco.getPredefinedDictionary(FAMILIES[family])

    def find(self, grey: np.ndarray, *, most: int = 0, blur: float = 0.0, refine: bool = True) -> list[Tag]:
        """Return the tags of an image with at most so many corrected bits; `blur` is a sigma [pixels]."""
        if blur > 0:
            grey = cv2.GaussianBlur(grey, (0, 0), blur)
        given = cv2.aruco.DetectorParameters()
        given.errorCorrectionRate = min(most / self._codes.maxCorrectionBits, 1.0)
        given.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX if refine else cv2.aruco.CORNER_REFINE_NONE
        corners, ids, _ = cv2.aruco.ArucoDetector(self._codes, given).detectMarkers(grey)
        tags = [
            self._tag(grey, int(tag_id), at[0])
            for tag_id, at in zip([] if ids is None else ids.ravel(), corners, strict=True)
        ]
        return sorted((tag for tag in tags if tag.hamming <= most), key=lambda tag: tag.id)

    def _tag(self, grey: np.ndarray, number: int, corners: Any) -> Tag:
        """OpenCV draws these tags upside down, and begins at the upper left, clockwise."""
        size = self._codes.markerSize
        bits = self._codes.getBitsFromByteList(self._codes.bytesList[number : number + 1], size)
        wanted = np.pad(np.asarray(bits, bool), 1)
        seen = _cells(grey, corners, size + 2)
        threshold = (seen[wanted].mean() + seen[~wanted].mean()) / 2
        off = np.where(wanted, seen - threshold, threshold - seen)[1:-1, 1:-1]
        white, black = off[wanted[1:-1, 1:-1]], off[~wanted[1:-1, 1:-1]]
        return Tag(number, int((off < 0).sum()), float(min(white.mean(), black.mean())), np.asarray(corners)[[1, 0, 3, 2]])


def _cells(grey: np.ndarray, corners: Any, count: int) -> np.ndarray:
    """The mean grey of the middle of each cell, (count, count)."""
    edge = count * _CELL
    square = np.array([[0, 0], [edge, 0], [edge, edge], [0, edge]], np.float32) - 0.5
    turn = cv2.getPerspectiveTransform(np.asarray(corners, np.float32), square)
    flat = cv2.warpPerspective(grey, turn, (edge, edge)).astype(float)
    middle = flat.reshape(count, _CELL, count, _CELL)[:, 2:-2, :, 2:-2]
    means: np.ndarray = middle.mean(axis=(1, 3))
    return means
