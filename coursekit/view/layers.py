"""Layered layout of a small directed graph, from left to right: it takes boxes with sizes and returns positions and routes.

The steps are Sugiyama's: reverse edges to remove cycles, assign boxes to layers, order the layers for few
crossings, then align the boxes. Boxes of one group (a namespace) share a horizontal band.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from .layer_order import Order, crossings, order_layers
from .layer_place import place

Point = tuple[float, float]
MARGIN = 14.0
GROUP_PAD = 14.0
GROUP_TITLE = 18.0


@dataclass(frozen=True)
class Box:
    """A box to place; a `group` of '' means none."""

    key: str
    width: float
    height: float
    group: str = ""


@dataclass
class Layout:
    """Centres of the boxes, points along the edges (in the given order) and frames of the groups."""

    centres: dict[str, Point] = field(default_factory=dict)
    routes: list[list[Point]] = field(default_factory=list)
    frames: dict[str, tuple[float, float, float, float]] = field(default_factory=dict)
    width: float = 0.0
    height: float = 0.0


def arrange(
    boxes: Sequence[Box], edges: Sequence[tuple[str, str]], *, gap: float = 64.0, between: float = 16.0
) -> Layout:
    """Place `boxes` such that `edges` (pairs of keys) mostly point right.

    `gap` is the space between layers, `between` the vertical space between boxes, in pixels.

    >>> layout = arrange([Box("a", 40, 20), Box("b", 40, 20)], [("a", "b")])
    >>> layout.centres["a"][0] < layout.centres["b"][0], layout.centres["a"][1] == layout.centres["b"][1]
    (True, True)
    """
    if not boxes:
        return Layout(width=2 * MARGIN, height=2 * MARGIN)
    keys = [box.key for box in boxes]
    forward = _acyclic(keys, edges)
    layers = _layers(keys, forward)
    order = Order({box.key: box.group for box in boxes})
    chains = [_chain(index, pair, layers, order) for index, pair in enumerate(forward)]
    order_layers(order, layers, chains)
    return _placed(boxes, edges, order, chains, gap, between)


def _acyclic(keys: Sequence[str], edges: Sequence[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return the edges, with those that close a cycle reversed (Eades, Lin, Smyth: there are few)."""
    rank = {key: place for place, key in enumerate(_sequence(list(keys), edges))}
    return [(a, b) if rank[a] <= rank[b] else (b, a) for a, b in edges]


def _sequence(left: list[str], edges: Sequence[tuple[str, str]]) -> list[str]:
    first: list[str] = []
    last: list[str] = []
    after: dict[str, set[str]] = {key: set() for key in left}
    before: dict[str, set[str]] = {key: set() for key in left}
    for a, b in edges:
        if a != b:
            after[a].add(b)
            before[b].add(a)
    while left:
        source = next((key for key in left if not before[key]), None)
        sink = next((key for key in left if not after[key]), None) if source is None else None
        chosen = source or sink or max(left, key=lambda key: len(after[key]) - len(before[key]))
        if sink is not None:
            last.append(sink)
        else:
            first.append(chosen)
        left.remove(chosen)
        for other in after[chosen]:
            before[other].discard(chosen)
        for other in before[chosen]:
            after[other].discard(chosen)
    return first + last[::-1]


def _layers(keys: Sequence[str], edges: Sequence[tuple[str, str]]) -> dict[str, int]:
    """Return the layer of each box: right of its sources, and a box without sources as near to its targets as possible."""
    layers = dict.fromkeys(keys, 0)
    after: dict[str, list[str]] = {}
    for a, b in edges:
        if a != b:
            after.setdefault(a, []).append(b)
    pointed_at = {b for others in after.values() for b in others}
    changed = True
    while changed:
        changed = False
        for a, others in after.items():
            for b in others:
                if layers[b] <= layers[a]:
                    layers[b], changed = layers[a] + 1, True
    for key, others in after.items():
        if key not in pointed_at:
            layers[key] = min(layers[b] for b in others) - 1
    return layers


def _chain(index: int, pair: tuple[str, str], layers: dict[str, int], order: Order) -> list[str]:
    """Return the edge's boxes, with a placeholder in every layer that it crosses."""
    a, b = pair
    group = order.groups[a] if order.groups[a] == order.groups[b] else ""
    chain = [a]
    for layer in range(layers[a] + 1, layers[b]):
        stand_in = f"{index}\n{layer}"
        order.groups[stand_in] = group
        layers[stand_in] = layer
        chain.append(stand_in)
    return chain if a == b else [*chain, b]


def _placed(
    boxes: Sequence[Box],
    edges: Sequence[tuple[str, str]],
    order: Order,
    chains: list[list[str]],
    gap: float,
    between: float,
) -> Layout:
    sizes = {box.key: (box.width, box.height) for box in boxes}
    heights = {key: sizes.get(key, (0.0, 6.0))[1] for layer in order.rows for key in layer}
    ys, bands = place(order, chains, heights, between, (GROUP_PAD + GROUP_TITLE, GROUP_PAD))
    layout = Layout()
    left = MARGIN + (GROUP_PAD if len(bands) > 1 or "" not in bands else 0.0)
    inset = left
    spans: dict[str, tuple[float, float]] = {}
    for layer in order.rows:
        width = max((sizes[key][0] for key in layer if key in sizes), default=0.0)
        for key in layer:
            spans[key] = (left, left + width)
            layout.centres[key] = (left + width / 2, ys[key] + MARGIN)
        left += width + gap
    layout.width = left - gap + inset
    layout.height = max(bottom for _, bottom in bands.values()) + 2 * MARGIN
    _frame(layout, boxes, bands)
    for (a, _), chain in zip(edges, chains, strict=True):
        layout.routes.append(_route(chain if chain[0] == a else chain[::-1], layout, sizes, spans))
    layout.centres = {box.key: layout.centres[box.key] for box in boxes}
    return layout


def _frame(layout: Layout, boxes: Sequence[Box], bands: dict[str, tuple[float, float]]) -> None:
    for group, (top, bottom) in bands.items():
        if group:
            lefts = [layout.centres[box.key][0] - box.width / 2 for box in boxes if box.group == group]
            rights = [layout.centres[box.key][0] + box.width / 2 for box in boxes if box.group == group]
            x = min(lefts) - GROUP_PAD
            layout.frames[group] = (x, top + MARGIN, max(rights) + GROUP_PAD - x, bottom - top)


def _route(
    chain: list[str],
    layout: Layout,
    sizes: dict[str, tuple[float, float]],
    spans: dict[str, tuple[float, float]],
) -> list[Point]:
    """Return the route from the edge of the first box to that of the last, straight through the layers in between."""
    if len(chain) == 1:
        return []
    points: list[Point] = []
    rightward = layout.centres[chain[0]][0] < layout.centres[chain[-1]][0]
    sign = 1.0 if rightward else -1.0
    for place_in_chain, key in enumerate(chain):
        x, y = layout.centres[key]
        if place_in_chain == 0:
            points.append((x + sign * sizes[key][0] / 2, y))
        elif place_in_chain == len(chain) - 1:
            points.append((x - sign * sizes[key][0] / 2, y))
        else:
            near, far = spans[key] if rightward else spans[key][::-1]
            points += [(near, y), (far, y)]
    return points


__all__ = ["Box", "Layout", "Point", "arrange", "crossings"]
