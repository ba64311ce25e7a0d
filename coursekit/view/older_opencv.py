"""Names of OpenCV 4.5, which a robot with Humble has, for programs that meet a newer OpenCV here.

The functions for ArUco markers are there, made of the newer ones. What only OpenCV's contrib modules have is told, with
what to type.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import cv2
import numpy as np

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


ARUCO: dict[str, Callable[..., Any]] = {
    "Dictionary_get": lambda dict: cv2.aruco.getPredefinedDictionary(dict),
    "Dictionary_create": lambda nMarkers, markerSize, *_: cv2.aruco.extendDictionary(nMarkers, markerSize),
    "DetectorParameters_create": lambda: cv2.aruco.DetectorParameters(),
    "detectMarkers": detectMarkers,
    "estimatePoseSingleMarkers": estimatePoseSingleMarkers,
    "drawAxis": drawAxis,
    "drawMarker": lambda dictionary, id, sidePixels, *more: cv2.aruco.generateImageMarker(dictionary, id, sidePixels, *more),
    "GridBoard_create": lambda markersX, markersY, markerLength, markerSeparation, dictionary, *_: cv2.aruco.GridBoard(
        (markersX, markersY), markerLength, markerSeparation, dictionary
    ),
    "CharucoBoard_create": lambda squaresX, squaresY, squareLength, markerLength, dictionary: cv2.aruco.CharucoBoard(
        (squaresX, squaresY), squareLength, markerLength, dictionary
    ),
}
"""The functions by their names in cv2.aruco."""


def add_aruco(_found: Any) -> Callable[[], None]:
    """Add the functions that OpenCV lacks; return what takes them away."""
    mine = {name: function for name, function in ARUCO.items() if name not in vars(cv2.aruco)}
    for name, function in mine.items():
        setattr(cv2.aruco, name, function)

    def remove() -> None:
        for name, function in mine.items():
            if vars(cv2.aruco).get(name) is function:
                delattr(cv2.aruco, name)

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
    Change(
        "cv2.__getattr__", tell_absent, "what only OpenCV's contrib modules have is told, with what to type", _TEST, IMPORTS
    ),
)
