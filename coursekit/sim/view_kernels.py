"""The loops of the camera, compiled. A column is `slope` metres to the left per metre ahead; rows count downwards."""

from __future__ import annotations

import math

import numba
import numpy as np

PER_METRE = 32
"""Texture pixels per metre; textures are 64 pixels wide and repeat every 2 m."""
SIZE = 64


@numba.njit(cache=True)
def sky_and_floor(picture, slopes, horizon, focal, above, x, y, theta, floor):  # type: ignore[no-untyped-def]
    """Fill an image with sky above the horizon and a textured floor below it."""
    height, width = picture.shape[0], picture.shape[1]
    c, s = math.cos(theta), math.sin(theta)
    for row in range(height):
        down = row - horizon
        if down <= 0.5:
            light = min(235.0, 205.0 - 0.1 * down)
            for column in range(width):
                picture[row, column, 0] = light
                picture[row, column, 1] = light - 8
                picture[row, column, 2] = light - 18
            continue
        ahead = above * focal / down
        shade = 1.0 / (1.0 + 0.05 * ahead)
        for column in range(width):
            left = ahead * slopes[column]
            u = math.floor((x + c * ahead - s * left) * PER_METRE) & (SIZE - 1)
            v = math.floor((y + s * ahead + c * left) * PER_METRE) & (SIZE - 1)
            for k in range(3):
                picture[row, column, k] = floor[v, u, k] * shade


@numba.njit(cache=True)
def paint(picture, slopes, horizon, focal, above, far, x, y, theta, edges, looks, textures):  # type: ignore[no-untyped-def]
    """Paint upright edges (n, 6: x1, y1, x2, y2, low, high), far ones first; `looks` (n, 4): texture, blue, green, red."""
    width = picture.shape[1]
    c, s = math.cos(theta), math.sin(theta)
    count = len(edges)
    distances, along = np.empty(count), np.empty(count)
    order = np.empty(count, np.int64)
    for column in range(width):
        slope = slopes[column]
        met = 0
        for row in range(count):
            ax, ay = edges[row, 0] - x, edges[row, 1] - y
            bx, by = edges[row, 2] - x, edges[row, 3] - y
            a1, a2 = c * ax + s * ay, c * ay - s * ax
            b1, b2 = c * bx + s * by, c * by - s * bx
            sa, sb = a2 - slope * a1, b2 - slope * b1
            if sa * sb > 0.0 or sa == sb:
                continue
            share = sa / (sa - sb)
            ahead = a1 + share * (b1 - a1)
            if 0.02 < ahead < far:
                at = met
                while at > 0 and distances[at - 1] < ahead:
                    distances[at], along[at], order[at] = distances[at - 1], along[at - 1], order[at - 1]
                    at -= 1
                distances[at], along[at], order[at] = ahead, share, row
                met += 1
        first = 0
        for k in range(met - 1, -1, -1):  # edges behind a full-height wall need not be painted
            e = order[k]
            if edges[e, 4] <= 0.001 and horizon - focal * (edges[e, 5] - above) / distances[k] <= 0:
                first = k
                break
        for k in range(first, met):
            e = order[k]
            _column(picture, column, horizon, focal, above, distances[k], along[k], edges[e], looks[e], textures)


@numba.njit(cache=True)
def _column(picture, column, horizon, focal, above, ahead, share, edge, look, textures):  # type: ignore[no-untyped-def]
    """Paint one column of one wall."""
    height, scale = picture.shape[0], focal / ahead
    top, bottom = horizon - scale * (edge[5] - above), horizon - scale * (edge[4] - above)
    length = math.sqrt((edge[2] - edge[0]) ** 2 + (edge[3] - edge[1]) ** 2)
    turn = abs(edge[3] - edge[1]) / max(length, 1e-9)
    shade = (0.78 + 0.22 * turn) / (1.0 + 0.04 * ahead)
    u = int(share * length * PER_METRE) & (SIZE - 1)
    texture = int(look[0])
    for row in range(max(0, math.ceil(top)), min(height - 1, math.floor(bottom)) + 1):
        z = above + (horizon - row) / scale
        v = math.floor(z * PER_METRE) & (SIZE - 1)
        for k in range(3):
            picture[row, column, k] = min(255.0, textures[texture, v, u, k] * look[k + 1] * shade)


@numba.njit(cache=True)
def measure(depths, slopes, horizon, focal, above, far, x, y, theta, edges):  # type: ignore[no-untyped-def]
    """Fill an image with the depth of the floor and of upright edges [m]; inf from `far` on."""
    height, width = depths.shape
    c, s = math.cos(theta), math.sin(theta)
    for row in range(height):
        down = row - horizon
        ahead = above * focal / down if down > 0.0 else math.inf
        depths[row, :] = ahead if ahead < far else math.inf
    for e in range(len(edges)):
        ax, ay = edges[e, 0] - x, edges[e, 1] - y
        bx, by = edges[e, 2] - x, edges[e, 3] - y
        a1, a2 = c * ax + s * ay, c * ay - s * ax
        b1, b2 = c * bx + s * by, c * by - s * bx
        for column in range(width):
            sa, sb = a2 - slopes[column] * a1, b2 - slopes[column] * b1
            if sa * sb > 0.0 or sa == sb:
                continue
            ahead = a1 + sa / (sa - sb) * (b1 - a1)
            if not 0.02 < ahead < far:
                continue
            scale = focal / ahead
            top, bottom = horizon - scale * (edges[e, 5] - above), horizon - scale * (edges[e, 4] - above)
            for row in range(max(0, math.ceil(top)), min(height - 1, math.floor(bottom)) + 1):
                if ahead < depths[row, column]:
                    depths[row, column] = ahead


__all__ = ["measure", "paint", "sky_and_floor"]
