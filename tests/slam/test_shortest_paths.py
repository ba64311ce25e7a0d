"""Shortest ways along a graph, against scipy's."""

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from coursekit.slam.shortest_paths import shortest_ways

PAIRS = st.sets(st.tuples(st.integers(0, 11), st.integers(0, 11)).filter(lambda pair: pair[0] < pair[1]), max_size=30)


@settings(max_examples=60, deadline=None, derandomize=True)
@given(PAIRS, st.integers(0, 11), st.integers(0, 1000))
def test_ways_are_as_short_as_scipy_finds_them(pairs, start, seed):
    edges = np.array(sorted(pairs), dtype=np.int64).reshape(-1, 2)
    lengths = np.random.default_rng(seed).uniform(0.1, 3.0, len(edges))
    expected = dijkstra(csr_matrix((lengths, (edges[:, 0], edges[:, 1])), shape=(12, 12)), directed=False, indices=start)
    assert np.allclose(shortest_ways(edges[:, 0], edges[:, 1], lengths, 12, start), expected)


def test_of_two_edges_between_the_same_places_the_shorter_counts():
    first, second, lengths = np.array([0, 0]), np.array([1, 1]), np.array([2.0, 1.0])
    assert shortest_ways(first, second, lengths, 2, 0).tolist() == [0.0, 1.0]
