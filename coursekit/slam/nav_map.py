"""A map as nav2 keeps it: a picture (.pgm) and a description (.yaml) beside it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from coursekit.slam.grid import OccupancyGrid

FREE, WALL, UNKNOWN = 254, 0, 205
OCCUPIED_ABOVE, FREE_BELOW = 0.65, 0.196


def picture(grid: OccupancyGrid) -> np.ndarray:
    """uint8 (rows, columns), the largest y on top: 254 free, 0 wall, 205 unknown."""
    cells = grid.trinary()
    shades = np.full(cells.shape, UNKNOWN, dtype=np.uint8)
    shades[cells == 0] = FREE
    shades[cells == 100] = WALL
    return shades[::-1]


def write_map(path: str | Path, grid: OccupancyGrid) -> tuple[Path, Path]:
    """Write PATH.yaml and PATH.pgm; returns both names in full.

    Raises ValueError when the map is empty, OSError when the folder cannot be written.
    """
    if not grid.log_odds.size:
        raise ValueError("the map is empty: no scan has been added")
    yaml = Path(path).with_suffix(".yaml").resolve()
    pgm = yaml.with_suffix(".pgm")
    shades = picture(grid)
    header = f"P5\n{shades.shape[1]} {shades.shape[0]}\n255\n".encode("ascii")
    pgm.write_bytes(header + shades.tobytes())
    yaml.write_text(
        f"image: {pgm.name}\nmode: trinary\nresolution: {grid.resolution:.6g}\n"
        f"origin: [{grid.origin[0]:.6g}, {grid.origin[1]:.6g}, 0]\n"
        f"negate: 0\noccupied_thresh: {OCCUPIED_ABOVE}\nfree_thresh: {FREE_BELOW}\n",
        encoding="utf-8",
    )
    return yaml, pgm
