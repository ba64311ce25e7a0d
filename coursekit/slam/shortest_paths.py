"""Shortest paths in a graph (Dijkstra), compiled, for each keyframe."""

from __future__ import annotations

import heapq

import numpy as np
from numba import njit


@njit(cache=True)
def shortest_ways(first, second, lengths, size, start):  # type: ignore[no-untyped-def]
    """Return the shortest path lengths from a node to all (size); edges (m) are undirected, inf means unreachable.

    >>> shortest_ways(np.array([0, 1]), np.array([1, 2]), np.array([1.0, 2.0]), 4, 0).tolist()
    [0.0, 1.0, 3.0, inf]
    """
    count = len(lengths)
    newest, before = np.full(size, -1, np.int64), np.empty(2 * count, np.int64)
    for k in range(2 * count):  # a linked list of the edges at each node
        node = first[k] if k < count else second[k - count]
        before[k], newest[node] = newest[node], k
    ways = np.full(size, np.inf)
    ways[start] = 0.0
    heap = [(0.0, start)]
    while heap:
        way, node = heapq.heappop(heap)
        if way > ways[node]:
            continue
        k = newest[node]
        while k >= 0:
            other, edge = (second[k], k) if k < count else (first[k - count], k - count)
            if way + lengths[edge] < ways[other]:
                ways[other] = way + lengths[edge]
                heapq.heappush(heap, (ways[other], other))
            k = before[k]
    return ways


__all__ = ["shortest_ways"]
