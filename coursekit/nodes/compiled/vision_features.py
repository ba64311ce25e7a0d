"""Key points of images for compiled programs: they cross the link as rows of numbers.

A key point is (x, y, size, angle, response, octave, class), a match (index, index in the other image, distance).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import cv2

KINDS = {"ORB", "SIFT", "BRISK", "AKAZE", "FastFeatureDetector", "GFTTDetector", "SimpleBlobDetector"}


def rows_of(points: Sequence[cv2.KeyPoint]) -> np.ndarray:
    """Return key points as (N, 7)."""
    rows = [(*point.pt, point.size, point.angle, point.response, point.octave, point.class_id) for point in points]
    return np.array(rows, np.float64).reshape(-1, 7)


def points_of(rows: np.ndarray | None) -> list[cv2.KeyPoint]:
    """Return (N, 7) as key points."""
    import cv2

    found = [] if rows is None else rows.tolist()
    return [cv2.KeyPoint(*floats, int(octave), int(kind)) for *floats, octave, kind in found]  # type: ignore[call-overload]


def _settings(kind: str, fields: dict[str, float]) -> Any:
    import cv2

    settings = getattr(cv2, f"{kind}_Params")()
    for name, value in fields.items():
        setattr(settings, name, type(getattr(settings, name))(value))
    return settings


class Detector:
    """Finds key points and describes them.

    Raises:
        ValueError: for a kind that OpenCV does not have here.
    """

    def __init__(self, kind: str, *arguments: float, **fields: float) -> None:
        import cv2

        if kind not in KINDS:
            raise ValueError(f"There is no detector {kind}. There are {', '.join(sorted(KINDS))}.")
        settings = [_settings(kind, fields)] if fields else arguments
        self._detector = getattr(cv2, f"{kind}_create")(*settings)

    def detect(self, image: np.ndarray, mask: np.ndarray | None) -> np.ndarray:
        """Return the key points where the mask is not zero."""
        return rows_of(self._detector.detect(image, mask))

    def compute(self, image: np.ndarray, points: np.ndarray | None) -> tuple[np.ndarray, np.ndarray | None]:
        """Return those of the key points that can be described, and their descriptions, one a row."""
        kept, descriptions = self._detector.compute(image, points_of(points))
        return rows_of(kept), descriptions

    def detectAndCompute(self, image: np.ndarray, mask: np.ndarray | None) -> tuple[np.ndarray, np.ndarray | None]:
        """Return key points and descriptions."""
        points, descriptions = self._detector.detectAndCompute(image, mask)
        return rows_of(points), descriptions


def match_rows(matches: Sequence[cv2.DMatch]) -> np.ndarray:
    """Return matches as (N, 3)."""
    rows = [(match.queryIdx, match.trainIdx, match.distance) for match in matches]
    return np.array(rows, np.float64).reshape(-1, 3)


def matched(query: np.ndarray | None, train: np.ndarray | None, norm: int, crossed: int) -> np.ndarray:
    """Return the best match of each description, (N, 3)."""
    import cv2

    return match_rows(() if query is None or train is None else cv2.BFMatcher(norm, bool(crossed)).match(query, train))


def matched_several(
    query: np.ndarray | None, train: np.ndarray | None, norm: int, crossed: int, count: int
) -> list[np.ndarray]:
    """Return the `count` best matches of each description, (count, 3) or fewer."""
    import cv2

    if query is None or train is None:
        return []
    return [match_rows(each) for each in cv2.BFMatcher(norm, bool(crossed)).knnMatch(query, train, k=count)]


def drawn(image: np.ndarray, points: np.ndarray | None, color: tuple[float, ...], flags: int) -> Any:
    """Return the image with its key points, each in a colour of its own if `color` is negative."""
    import cv2

    return cv2.drawKeypoints(image, points_of(points), None, color, flags)  # type: ignore[call-overload]


def matches_drawn(
    image: np.ndarray, points: np.ndarray | None, other: np.ndarray, others: np.ndarray | None, matches: np.ndarray | None
) -> Any:
    """Return both images beside each other, with a line for each match."""
    import cv2

    found = [] if matches is None else matches.tolist()
    pairs = [cv2.DMatch(int(query), int(train), distance) for query, train, distance in found]
    return cv2.drawMatches(image, points_of(points), other, points_of(others), pairs, None)  # type: ignore[call-overload]


FACES: dict[str, Callable[..., Any]] = {
    "feature_detector": Detector,
    "match_features": matched,
    "match_features_knn": matched_several,
    "draw_keypoints": drawn,
    "draw_matches": matches_drawn,
}
"""The functions by the names that C++ asks for."""
