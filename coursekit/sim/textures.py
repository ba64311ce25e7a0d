"""Textures: 64 x 64 grey pixels that repeat every 2 m, tinted with an object's colour."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from coursekit.geometry.plane import Array

from .world import TEXTURES

SIZE = 64
USUAL = {
    "plain": (0.88, 0.86, 0.80), "brick": (0.72, 0.35, 0.28), "concrete": (0.68, 0.68, 0.67), "wood": (0.66, 0.47, 0.28),
    "crates": (0.80, 0.62, 0.36), "metal": (0.55, 0.60, 0.66), "stripes": (0.95, 0.80, 0.15), "tiles": (0.75, 0.74, 0.70),
    "door": (0.45, 0.32, 0.22), "hedge": (0.25, 0.50, 0.22),
}  # fmt: skip
"""Red, green and blue of textures for objects without a colour of their own."""
ROBOT_COLOUR = (0.15, 0.45, 0.95)
"""Blue, green, red of other robots."""


def _grey(name: str) -> Array:
    v, u = np.mgrid[0:SIZE, 0:SIZE]
    grain = np.random.default_rng(TEXTURES.index(name)).uniform(0.93, 1.0, (SIZE, SIZE))
    if name == "brick":
        shifted = (u + 8 * ((v // 8) % 2)) % 16
        return np.where((v % 8 == 0) | (shifted == 0), 1.25, grain)
    if name == "wood":
        return grain * (0.9 + 0.1 * np.cos(u * np.pi / 4)) * np.where(u % 16 == 0, 0.7, 1.0)
    if name == "crates":
        return grain * np.where((u % 32 < 2) | (v % 32 < 2), 0.5, 1.0) * np.where(v % 8 == 4, 0.85, 1.0)
    if name == "metal":
        return grain * np.where(v % 16 == 0, 0.75, 1.0)
    if name == "stripes":
        return np.where((u + v) % 32 < 16, 1.0, 0.15)
    if name == "tiles":
        return grain * np.where((u % 16 == 0) | (v % 16 == 0), 0.6, 1.0)
    if name == "hedge":
        return np.asarray(np.random.default_rng(1).uniform(0.5, 1.1, (SIZE, SIZE)))
    return grain


@lru_cache(maxsize=1)
def all_textures() -> Array:
    """Return all textures (number, 64, 64, 3), with values from 0 to 255, row 0 at the floor."""
    textures = np.stack([np.repeat(_grey(name)[:, :, None] * 255.0, 3, axis=2) for name in TEXTURES])
    return textures


def floor_of(name: str) -> Array:
    """Return a floor texture in its own colours, blue first."""
    red, green, blue = USUAL[name]
    return np.minimum(all_textures()[TEXTURES.index(name)] * (blue, green, red), 255.0)


__all__ = ["ROBOT_COLOUR", "USUAL", "all_textures", "floor_of"]
