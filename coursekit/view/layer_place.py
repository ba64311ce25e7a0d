"""The vertical positions of a layered layout's boxes: near their neighbours, without overlaps."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from .layer_order import Order

ROUNDS = 24


def place(
    order: Order,
    chains: Sequence[Sequence[str]],
    heights: dict[str, float],
    between: float,
    pads: tuple[float, float],
) -> tuple[dict[str, float], dict[str, tuple[float, float]]]:
    """Return (centre y of each box, (top, bottom) of each band).

    `pads` is the padding above and below the boxes of a named band.
    """
    ys: dict[str, float] = {}
    bands: dict[str, tuple[float, float]] = {}
    top = 0.0
    for group in order.bands:
        rows = [[key for key in row if order.groups[key] == group] for row in order.rows]
        if not any(rows):
            continue
        inside = _one_band(rows, chains, heights, between)
        above, below = pads if group else (0.0, 0.0)
        shift = top + above - min(inside[key] - heights[key] / 2 for key in inside)
        for key, y in inside.items():
            ys[key] = y + shift
        bottom = max(ys[key] + heights[key] / 2 for key in inside) + below
        bands[group] = (top, bottom)
        top = bottom + between
    return ys, bands


def _one_band(
    rows: Sequence[Sequence[str]], chains: Sequence[Sequence[str]], heights: dict[str, float], between: float
) -> dict[str, float]:
    here = {key for row in rows for key in row}
    beside: dict[str, list[str]] = {key: [] for key in here}
    for chain in chains:
        for a, b in pairwise(chain):
            if a in here and b in here:
                beside[a].append(b)
                beside[b].append(a)
    ys: dict[str, float] = {}
    for row in rows:
        ys.update(zip(row, _apart([0.0] * len(row), row, heights, between), strict=True))
    for step in range(ROUNDS):
        for row in rows if step % 2 == 0 else reversed(rows):
            wished = [
                sum(ys[neighbour] for neighbour in beside[key]) / len(beside[key]) if beside[key] else ys[key]
                for key in row
            ]
            ys.update(zip(row, _apart(wished, row, heights, between), strict=True))
    return ys


def _apart(
    wished: Sequence[float], row: Sequence[str], heights: dict[str, float], between: float
) -> list[float]:
    """Return the positions nearest to `wished` (least squares) that keep the order and the distances."""
    offsets = [0.0]
    for a, b in pairwise(row):
        offsets.append(offsets[-1] + (heights[a] + heights[b]) / 2 + between)
    runs: list[tuple[float, int]] = []  # (mean, length), increasing: pool adjacent violators
    for wish, offset in zip(wished, offsets, strict=False):
        mean, size = wish - offset, 1
        while runs and runs[-1][0] > mean:
            other, count = runs.pop()
            mean = (mean * size + other * count) / (size + count)
            size += count
        runs.append((mean, size))
    means = [mean for mean, size in runs for _ in range(size)]
    return [mean + offset for mean, offset in zip(means, offsets, strict=False)]
