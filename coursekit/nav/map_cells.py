"""Conversion between the shades of an image and the cells of a map, in nav2's three modes."""

from __future__ import annotations

import numpy as np

MODES = ("trinary", "scale", "raw")
FREE, WALL, UNKNOWN = 254, 0, 205
OCCUPIED_ABOVE, FREE_BELOW = 0.65, 0.196  # 205 is 0.19608 and stays unknown

BAND = 1 << 18
"""Values of an image that are converted at a time."""


def cells_of(shades: np.ndarray, *, mode: str, negate: bool, occupied_thresh: float, free_thresh: float) -> np.ndarray:
    """Return int8 cells of an image: (rows, columns) gray, or (rows, columns, 3 or 4) with alpha last; uint8 or uint16.

    >>> picture = np.array([[0, 205, 254]], dtype=np.uint8)
    >>> cells_of(picture, mode="trinary", negate=False, occupied_thresh=0.65, free_thresh=0.196).tolist()
    [[100, -1, 0]]
    """
    bands = np.array_split(shades, max(1, shades.size // BAND))  # the floats of a large map at once would fill a laptop
    return np.concatenate([_cells(band, mode, negate, occupied_thresh, free_thresh) for band in bands])


def _cells(shades: np.ndarray, mode: str, negate: bool, occupied_thresh: float, free_thresh: float) -> np.ndarray:
    shade, alpha = _shade(shades, with_alpha=mode == "trinary")
    if mode == "raw":
        value = np.floor(shade * 255 + 0.5)
        return np.where(value <= 100, value, -1).astype(np.int8)
    occupied = shade if negate else 1.0 - shade
    if mode == "scale":
        middle = np.rint((occupied - free_thresh) / (occupied_thresh - free_thresh) * 100.0)
    else:
        middle = np.full(occupied.shape, -1.0)
    cells = np.where(occupied_thresh < occupied, 100.0, np.where(occupied < free_thresh, 0.0, middle))
    if mode == "scale" and alpha is not None:
        cells[alpha < 1.0] = -1.0
    return cells.astype(np.int8)


def _shade(shades: np.ndarray, *, with_alpha: bool) -> tuple[np.ndarray, np.ndarray | None]:
    """Return brightness and alpha, 0 ... 1 (None without alpha); `with_alpha` averages alpha in as a fourth channel."""
    top = float(np.iinfo(shades.dtype).max)
    if shades.ndim == 2:
        return shades / top, None
    total = shades[..., :3].sum(axis=-1, dtype=np.float64)
    if shades.shape[2] < 4:
        return total / (3 * top), None
    alpha = shades[..., 3] / top
    if with_alpha:
        return (total + shades[..., 3]) / (4 * top), alpha
    return total / (3 * top), alpha


def picture_of(cells: np.ndarray, *, mode: str, occupied_thresh: float, free_thresh: float) -> np.ndarray:
    """Return a uint8 image of cells: gray, or in mode 'scale' RGBA (unknown is transparent).

    >>> picture_of(np.array([[0, 100, -1]]), mode="trinary", occupied_thresh=0.65, free_thresh=0.25).tolist()
    [[254, 0, 205]]
    """
    cells = np.asarray(cells).astype(np.int16)
    known = (cells >= 0) & (cells <= 100)
    if mode == "raw":
        return np.where(known, cells, 255).astype(np.uint8)
    if mode == "scale":
        gray = np.where(known, np.rint((100 - cells) * 2.55), 128).astype(np.uint8)
        return np.dstack([gray, gray, gray, np.where(known, 255, 0).astype(np.uint8)])
    shades = np.full(cells.shape, UNKNOWN, dtype=np.uint8)
    shades[known & (cells >= np.rint(occupied_thresh * 100))] = WALL
    shades[known & (cells <= np.rint(free_thresh * 100))] = FREE
    return shades
