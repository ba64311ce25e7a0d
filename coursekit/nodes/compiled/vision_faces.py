"""What a compiled program calls in OpenCV 4.5 and Python's newer cv2 does in other words: ArUco markers, cascades.

Key points and their matches: vision_features. Files of settings: vision_files.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from coursekit.nodes.compiled import vision_features, vision_files

if TYPE_CHECKING:
    import cv2
    from cv2.aruco import Dictionary


def _dictionary(patterns: np.ndarray, size: int, correction: int) -> Dictionary:
    import cv2

    return cv2.aruco.Dictionary(patterns, size, correction)


def _parts(dictionary: Dictionary) -> tuple[np.ndarray, int, int]:
    return dictionary.bytesList, dictionary.markerSize, dictionary.maxCorrectionBits


def predefined(number: int) -> tuple[np.ndarray, int, int]:
    """Return the patterns of a dictionary that comes with OpenCV, their side [cells], and how many cells may be wrong."""
    import cv2

    return _parts(cv2.aruco.getPredefinedDictionary(number))


def generated(markers: int, size: int, seed: int) -> tuple[np.ndarray, int, int]:
    """Return the same of a new dictionary."""
    import cv2

    return _parts(cv2.aruco.extendDictionary(markers, size, randomSeed=seed))


def drawn(patterns: np.ndarray, size: int, correction: int, number: int, pixels: int, border: int) -> np.ndarray:
    """Return the image of a marker, (pixels, pixels) of uint8."""
    import cv2

    return cv2.aruco.generateImageMarker(_dictionary(patterns, size, correction), number, pixels, borderBits=border)


def detected(image: np.ndarray, patterns: np.ndarray, size: int, correction: int, **fields: float) -> Any:
    """Return the markers' corners, their numbers (None without markers), and the candidates that are none."""
    import cv2

    parameters = cv2.aruco.DetectorParameters()
    for name, value in fields.items():
        setattr(parameters, name, type(getattr(parameters, name))(value))
    return cv2.aruco.ArucoDetector(_dictionary(patterns, size, correction), parameters).detectMarkers(image)


def grid(
    patterns: np.ndarray,
    size: int,
    correction: int,
    shape: tuple[int, int],
    side: float,
    gap: float,
    ids: np.ndarray,
    pixels: tuple[int, int],
    margin: int,
    border: int,
) -> np.ndarray:
    """Return the image of a board of markers in rows, uint8; `shape` and `pixels` are (width, height), side and gap in m."""
    import cv2

    board = cv2.aruco.GridBoard(shape, side, gap, _dictionary(patterns, size, correction), ids)
    return board.generateImage(pixels, marginSize=margin, borderBits=border)


def poses(corners: list[np.ndarray], side: float, camera: np.ndarray, distortion: np.ndarray | None) -> Any:
    """Return each marker's turn and place, (N, 1, 3), and where its corners are in its own frame [m]."""
    import cv2

    return cv2.aruco.estimatePoseSingleMarkers(corners, side, camera, distortion)  # type: ignore[attr-defined]  # in sessions


def outlined(image: np.ndarray, corners: list[np.ndarray], ids: np.ndarray | None, color: tuple[float, ...]) -> Any:
    """Return the image with outlines and numbers of markers."""
    import cv2

    rows = [np.asarray(corner, np.float32).reshape(1, 4, 2) for corner in corners]
    return cv2.aruco.drawDetectedMarkers(image, rows, ids, color[:3])


def cascade(file: str) -> cv2.CascadeClassifier:
    """Return a classifier; the files that Debian's OpenCV has in /usr/share are those of Python's."""
    import cv2

    own = Path(cv2.__file__).parent / "data" / Path(file).name
    return cv2.CascadeClassifier(file if Path(file).is_file() or not own.is_file() else str(own))


FACES: dict[str, Callable[..., Any]] = {
    "aruco_dictionary": predefined,
    "aruco_new_dictionary": generated,
    "aruco_marker": drawn,
    "aruco_detect": detected,
    "aruco_grid": grid,
    "aruco_poses": poses,
    "aruco_draw": outlined,
    "cascade": cascade,
    **vision_features.FACES,
    **vision_files.FACES,
}
"""The functions by the names that C++ asks for."""
