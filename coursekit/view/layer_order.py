"""The order of boxes within the layers of a layered layout: few crossings, groups kept together."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from itertools import pairwise

SWEEPS = 12
MANY_LINKS = 400
PATIENCE = 3
"""The number of sweeps without improvement after which a large layout is finished."""


class Order:
    """`rows[i]` is layer i from top to bottom; `groups` maps boxes to groups; `bands` are the groups from top to bottom."""

    def __init__(self, groups: dict[str, str]) -> None:
        self.groups = groups
        self.rows: list[list[str]] = []
        self.bands: list[str] = []

    def places(self) -> dict[str, int]:
        """Return the index of each box in its layer."""
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
    beside = _Neighbours(links)
    best, least = _copy(order.rows), crossings(order.rows, links)
    since = 0
    for sweep in range(SWEEPS):
        _sweep(order, beside, rank, down=sweep % 2 == 0)
        _swap(order, beside)
        count = crossings(order.rows, links)
        since += 1
        if count < least:
            best, least, since = _copy(order.rows), count, 0
        if since == PATIENCE and len(links) > MANY_LINKS:
            break
    order.rows = best


class _Neighbours:
    """The links of each box to the layers before and after it."""

    def __init__(self, links: Sequence[tuple[str, str]]) -> None:
        self.before: dict[str, list[str]] = {}
        self.after: dict[str, list[str]] = {}
        for a, b in links:
            self.before.setdefault(b, []).append(a)
            self.after.setdefault(a, []).append(b)


def _walk(keys: list[str], chains: Sequence[Sequence[str]]) -> list[str]:
    """Return the boxes in an order in which connected ones follow each other."""
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
    """Count the crossing pairs of links (between neighbouring layers).

    >>> crossings([["a", "b"], ["c", "d"]], [("a", "d"), ("b", "c")])
    1
    """
    at = {key: (layer, place) for layer, row in enumerate(rows) for place, key in enumerate(row)}
    by_layer: dict[int, list[tuple[int, int]]] = {}
    for a, b in links:
        by_layer.setdefault(at[a][0], []).append((at[a][1], at[b][1]))
    count = 0
    for pairs in by_layer.values():
        ends: list[int] = []  # of links that start above; a link crosses those that end below its own end
        for _, end in sorted(pairs):
            place = bisect_right(ends, end)
            count += len(ends) - place
            ends.insert(place, end)
    return count


def _sweep(order: Order, linked: _Neighbours, rank: dict[str, int], *, down: bool) -> None:
    """Sort each layer by the mean position of its neighbours in the previous layer."""
    beside = linked.before if down else linked.after
    places = order.places()
    for row in order.rows if down else reversed(order.rows):
        means = {
            key: sum(places[neighbour] for neighbour in beside[key]) / len(beside[key]) if key in beside else places[key]
            for key in row
        }
        row.sort(key=lambda key: (rank[order.groups[key]], means[key]))
        places.update({key: place for place, key in enumerate(row)})


def _swap(order: Order, linked: _Neighbours) -> None:
    """Swap neighbours of one group where that removes crossings."""
    places = order.places()
    for row in order.rows:
        sides = (linked.before, linked.after)
        ends = [{key: sorted(places[neighbour] for neighbour in side.get(key, ())) for key in row} for side in sides]
        for place in range(len(row) - 1):
            upper, lower = row[place], row[place + 1]
            if order.groups[upper] != order.groups[lower]:
                continue
            if sum(_saved(side[upper], side[lower]) for side in ends) > 0:
                row[place], row[place + 1] = lower, upper
        places.update({key: place for place, key in enumerate(row)})


def _saved(upper: list[int], lower: list[int]) -> int:
    """Count the crossings removed by swapping two boxes, whose links end at these (sorted) positions."""
    if len(upper) > len(lower):
        return sum(len(upper) - bisect_right(upper, end) - bisect_left(upper, end) for end in lower)
    return sum(bisect_left(lower, end) - (len(lower) - bisect_right(lower, end)) for end in upper)
