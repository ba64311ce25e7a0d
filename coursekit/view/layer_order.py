"""The order of boxes within the layers of a layered layout: few crossings, groups together."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

SWEEPS = 12


class Order:
    """`rows[i]` is layer i from top to bottom; `groups` the group of each box; `bands` the groups from the top."""

    def __init__(self, groups: dict[str, str]) -> None:
        self.groups = groups
        self.rows: list[list[str]] = []
        self.bands: list[str] = []

    def places(self) -> dict[str, int]:
        """The place of each box in its layer."""
        return {key: place for row in self.rows for place, key in enumerate(row)}


def order_layers(order: Order, layers: dict[str, int], chains: Sequence[Sequence[str]]) -> None:
    """Fill `order.rows` and `order.bands`."""
    named = sorted({group for group in order.groups.values() if group})
    middle = (len(named) + 1) // 2
    order.bands = [*named[:middle], "", *named[middle:]]
    rank = {group: place for place, group in enumerate(order.bands)}
    order.rows = [[] for _ in range(max(layers.values()) + 1)]
    for key in _walk(list(layers), chains):
        order.rows[layers[key]].append(key)
    for row in order.rows:
        row.sort(key=lambda key: rank[order.groups[key]])
    links = _links(chains)
    best, least = _copy(order.rows), crossings(order.rows, links)
    for sweep in range(SWEEPS):
        _sweep(order, links, rank, down=sweep % 2 == 0)
        _swap(order, links)
        count = crossings(order.rows, links)
        if count < least:
            best, least = _copy(order.rows), count
    order.rows = best


def _walk(keys: list[str], chains: Sequence[Sequence[str]]) -> list[str]:
    """The boxes so that connected ones follow each other."""
    beside: dict[str, list[str]] = {key: [] for key in keys}
    for a, b in _links(chains):
        beside[a].append(b)
        beside[b].append(a)
    seen: dict[str, None] = {}
    for start in keys:
        stack = [start]
        while stack:
            key = stack.pop()
            if key not in seen:
                seen[key] = None
                stack += reversed(beside[key])
    return list(seen)


def _links(chains: Sequence[Sequence[str]]) -> list[tuple[str, str]]:
    return [link for chain in chains for link in pairwise(chain)]


def _copy(rows: list[list[str]]) -> list[list[str]]:
    return [list(row) for row in rows]


def crossings(rows: Sequence[Sequence[str]], links: Sequence[tuple[str, str]]) -> int:
    """How many pairs of links (between neighbouring layers) cross.

    >>> crossings([["a", "b"], ["c", "d"]], [("a", "d"), ("b", "c")])
    1
    """
    at = {key: (layer, place) for layer, row in enumerate(rows) for place, key in enumerate(row)}
    by_layer: dict[int, list[tuple[int, int]]] = {}
    for a, b in links:
        by_layer.setdefault(at[a][0], []).append((at[a][1], at[b][1]))
    return sum(
        (a - c) * (b - d) < 0
        for pairs in by_layer.values()
        for place, (a, b) in enumerate(pairs)
        for c, d in pairs[place + 1 :]
    )


def _sweep(order: Order, links: Sequence[tuple[str, str]], rank: dict[str, int], *, down: bool) -> None:
    """Sort each layer by the mean place of its neighbours in the layer before."""
    beside: dict[str, list[str]] = {}
    for a, b in links:
        beside.setdefault(b if down else a, []).append(a if down else b)
    places = order.places()
    for row in order.rows if down else reversed(order.rows):
        means = {
            key: sum(places[one] for one in beside[key]) / len(beside[key]) if key in beside else places[key]
            for key in row
        }
        row.sort(key=lambda key: (rank[order.groups[key]], means[key]))
        places.update({key: place for place, key in enumerate(row)})


def _swap(order: Order, links: Sequence[tuple[str, str]]) -> None:
    """Exchange neighbours of one group where that saves crossings."""
    for layer, row in enumerate(order.rows):
        near = [link for link in links if link[0] in row or link[1] in row]
        rows = [[], *order.rows[max(0, layer - 1) : layer + 2]]
        for place in range(len(row) - 1):
            if order.groups[row[place]] != order.groups[row[place + 1]]:
                continue
            before = crossings(rows, near)
            row[place], row[place + 1] = row[place + 1], row[place]
            if crossings(rows, near) >= before:
                row[place], row[place + 1] = row[place + 1], row[place]
