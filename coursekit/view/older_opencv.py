"""Names of OpenCV 4.5, which a robot with Humble has, for programs that meet a newer OpenCV here.

The functions for ArUco markers are there, made of the newer ones. What only OpenCV's contrib modules have is told, with
what to type.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import cv2
import numpy as np

from coursekit.processes.older_names import Name, adding
from coursekit.processes.patching import IMPORTS, Change

_CONTRIB = (
    "TrackerKCF_create", "TrackerCSRT_create", "TrackerMOSSE_create", "legacy", "face", "xfeatures2d", "ximgproc", "bgsegm",
    "optflow", "text", "saliency", "xphoto", "plot",
)  # fmt: skip


def detectMarkers(
    image: Any, dictionary: Any, corners: Any = None, ids: Any = None, parameters: Any = None, *_ignored: Any
) -> tuple[Any, Any, Any]:
    """Return the markers' corners, their numbers (None without markers), and the candidates that are none."""
    used = cv2.aruco.DetectorParameters() if parameters is None else parameters
    return cv2.aruco.ArucoDetector(dictionary, used).detectMarkers(image)  # type: ignore[return-value]


def estimatePoseSingleMarkers(
    corners: Any, markerLength: float, cameraMatrix: Any, distCoeffs: Any, *_ignored: Any
) -> tuple[Any, Any, Any]:
    """Return the markers' turns and places, each as (N, 1, 3), and their corners: x right, y up, z out of the marker."""
    half = markerLength / 2
    points = np.array([[-half, half, 0], [half, half, 0], [half, -half, 0], [-half, -half, 0]], np.float32)
    poses = [cv2.solvePnP(points, np.asarray(corner).reshape(4, 2), cameraMatrix, distCoeffs)[1:] for corner in corners]
    if not poses:
        return None, None, points.reshape(4, 1, 3)
    turns, places = (np.array(part).reshape(-1, 1, 3) for part in zip(*poses, strict=True))
    return turns, places, points.reshape(4, 1, 3)


def drawAxis(image: Any, cameraMatrix: Any, distCoeffs: Any, rvec: Any, tvec: Any, length: float) -> Any:
    """Draw the axes of a marker."""
    return cv2.drawFrameAxes(image, cameraMatrix, distCoeffs, rvec, tvec, length)


def refineDetectedMarkers(
    image: Any, board: Any, detectedCorners: Any, detectedIds: Any, rejectedCorners: Any, *camera: Any, **named: Any
) -> Any:
    """Find markers of a board that were rejected; return corners, numbers, what is still rejected, and which were found."""
    detector = cv2.aruco.ArucoDetector(board.getDictionary())
    return detector.refineDetectedMarkers(image, board, detectedCorners, detectedIds, rejectedCorners, *camera, **named)


def estimatePoseBoard(
    corners: Any,
    ids: Any,
    board: Any,
    cameraMatrix: Any,
    distCoeffs: Any,
    rvec: Any,
    tvec: Any,
    useExtrinsicGuess: bool = False,
) -> tuple[int, Any, Any]:
    """Return how many markers of the board are seen, and its turn and place: x right, y up, z out of a grid board."""
    if ids is None or len(ids) == 0:
        return 0, rvec, tvec
    points, pixels = board.matchImagePoints(corners, ids)
    if points is None:
        return 0, rvec, tvec
    if isinstance(board, cv2.aruco.GridBoard):  # a newer OpenCV counts y downwards from the upper left corner
        points = points * (1, -1, 1) + (0, board.getRightBottomCorner()[1], 0)
    _, rvec, tvec = cv2.solvePnP(points, pixels, cameraMatrix, distCoeffs, rvec, tvec, useExtrinsicGuess)
    return len(points) // 4, rvec, tvec


def _draw_board(board: Any, outSize: Any, *more: Any, **named: Any) -> Any:
    return board.generateImage(outSize, *more, **named)


ARUCO: dict[str, Callable[..., Any]] = {
    "Dictionary_get": lambda dict: cv2.aruco.getPredefinedDictionary(dict),
    "Dictionary_create": lambda nMarkers, markerSize, *_: cv2.aruco.extendDictionary(nMarkers, markerSize),
    "DetectorParameters_create": lambda: cv2.aruco.DetectorParameters(),
    "detectMarkers": detectMarkers,
    "estimatePoseSingleMarkers": estimatePoseSingleMarkers,
    "drawAxis": drawAxis,
    "drawMarker": lambda dictionary, id, sidePixels, *more, **named: cv2.aruco.generateImageMarker(
        dictionary, id, sidePixels, *more, **named
    ),
    "refineDetectedMarkers": refineDetectedMarkers,
    "estimatePoseBoard": estimatePoseBoard,
    "drawPlanarBoard": _draw_board,
    "Board_create": lambda objPoints, dictionary, ids: cv2.aruco.Board(objPoints, dictionary, ids),
    "GridBoard_create": lambda markersX, markersY, markerLength, markerSeparation, dictionary, *_: cv2.aruco.GridBoard(
        (markersX, markersY), markerLength, markerSeparation, dictionary
    ),
    "CharucoBoard_create": lambda squaresX, squaresY, squareLength, markerLength, dictionary: cv2.aruco.CharucoBoard(
        (squaresX, squaresY), squareLength, markerLength, dictionary
    ),
}
"""The functions by their names in cv2.aruco."""


def _of_aruco() -> Iterator[Name]:
    yield from ((cv2.aruco, name, function) for name, function in ARUCO.items())
    yield from ((board, "draw", _draw_board) for board in (cv2.aruco.Board, cv2.aruco.GridBoard, cv2.aruco.CharucoBoard))


add_aruco = adding(_of_aruco)
"""Adds the functions that OpenCV lacks; returns what takes them away."""


def turn_rectangles(_found: Any) -> Callable[[], None]:
    """Have minAreaRect tell angles from above 0 to 90 degrees, as OpenCV 4.5.1 to 4.12; return what ends that."""
    theirs = cv2.minAreaRect

    def minAreaRect(points: Any) -> Any:
        center, (width, height), angle = theirs(points)
        if angle >= 0:
            return center, (width, height), angle
        if angle <= -90:
            return center, (width, height), angle + 180
        return center, (height, width), angle + 90

    cv2.minAreaRect = minAreaRect

    def remove() -> None:
        if cv2.minAreaRect is minAreaRect:
            cv2.minAreaRect = theirs

    return remove


def _absent(name: str) -> Any:
    text = f"module 'cv2' has no attribute '{name}'"
    if name in _CONTRIB:
        text += '. It is one of OpenCV\'s contrib modules: pip install "opencv-contrib-python-headless<5"'
    raise AttributeError(text, name=name, obj=cv2)


def tell_absent(_found: Any) -> Callable[[], None]:
    """Have cv2 tell what to type for names of contrib modules; return what ends that."""
    if "__getattr__" in vars(cv2):
        return lambda: None
    vars(cv2)["__getattr__"] = _absent
    return lambda: delattr(cv2, "__getattr__")


_TEST = "tests/view/test_older_opencv.py"
PATCHES = (
    Change("cv2.aruco (older names)", add_aruco, "programs for Humble's OpenCV 4.5 find their markers", _TEST, IMPORTS),
    Change("cv2.minAreaRect", turn_rectangles, "its angles are those of OpenCV 4.5, as on a robot", _TEST, IMPORTS),
    Change(
        "cv2.__getattr__", tell_absent, "what only OpenCV's contrib modules have is told, with what to type", _TEST, IMPORTS
    ),
)
