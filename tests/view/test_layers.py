from itertools import combinations

from hypothesis import given
from hypothesis import strategies as st

from coursekit.view import layer_order
from coursekit.view.layers import Box, arrange

NAMES = "abcdefghij"
edges = st.lists(st.tuples(st.sampled_from(NAMES), st.sampled_from(NAMES)), max_size=20, unique=True)


def boxes(groups=""):
    return [Box(name, 30 + 7 * i, 20 + i, groups[i] if groups else "") for i, name in enumerate(NAMES)]


def corners(box, layout):
    x, y = layout.centres[box.key]
    return x - box.width / 2, y - box.height / 2, x + box.width / 2, y + box.height / 2


@given(edges)
def test_no_two_boxes_overlap_and_all_are_in_the_picture(pairs):
    all_boxes = boxes()
    layout = arrange(all_boxes, pairs)
    for one, other in combinations(all_boxes, 2):
        a, b = corners(one, layout), corners(other, layout)
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] + 1e-6 or b[3] <= a[1] + 1e-6
    for box in all_boxes:
        left, top, right, bottom = corners(box, layout)
        assert left >= 0 and top >= 0 and right <= layout.width and bottom <= layout.height


@given(edges, st.lists(st.sampled_from(["", "one", "two"]), min_size=10, max_size=10))
def test_a_frame_holds_its_group_and_nothing_else(pairs, groups):
    all_boxes = boxes(groups)
    layout = arrange(all_boxes, pairs)
    for group, (x, y, width, height) in layout.frames.items():
        for box in all_boxes:
            left, top, right, bottom = corners(box, layout)
            inside = left >= x and right <= x + width and top >= y and bottom <= y + height
            apart = right <= x or left >= x + width or bottom <= y + 1e-6 or top >= y + height - 1e-6
            assert inside if box.group == group else apart


@given(edges)
def test_each_edge_has_a_route_from_rim_to_rim(pairs):
    box_by_key = {box.key: box for box in boxes()}
    layout = arrange(list(box_by_key.values()), pairs)
    for (a, b), route in zip(pairs, layout.routes, strict=True):
        if a != b:
            assert abs(abs(route[0][0] - layout.centres[a][0]) - box_by_key[a].width / 2) < 1e-6
            assert abs(abs(route[-1][0] - layout.centres[b][0]) - box_by_key[b].width / 2) < 1e-6


def test_edges_of_a_graph_without_cycle_point_right():
    pairs = [("a", "b"), ("a", "c"), ("b", "d"), ("c", "d"), ("a", "d")]
    centres = arrange(boxes(), pairs).centres
    assert all(centres[a][0] < centres[b][0] for a, b in pairs)


def test_two_pairs_that_could_cross_do_not():
    centres = arrange(boxes(), [("a", "d"), ("b", "c")]).centres
    assert (centres["a"][1] - centres["b"][1]) * (centres["d"][1] - centres["c"][1]) > 0


@given(st.lists(st.tuples(st.integers(0, 9), st.integers(0, 9)), max_size=40))
def test_crossings_are_counted_as_by_comparing_each_link_with_each(pairs):
    rows = [[f"a{i}" for i in range(10)], [f"b{i}" for i in range(10)]]
    links = [(f"a{a}", f"b{b}") for a, b in pairs]
    wanted = sum((a - c) * (b - d) < 0 for (a, b), (c, d) in combinations(pairs, 2))
    assert layer_order.crossings(rows, links) == wanted


def test_all_crossings_of_a_large_picture_are_counted_once_a_sweep(monkeypatch):
    counted = []
    real = layer_order.crossings
    monkeypatch.setattr(layer_order, "crossings", lambda rows, links: counted.append(1) or real(rows, links))
    names = [f"n{i}" for i in range(300)]
    arrange([Box(name, 30, 20) for name in names], [(a, b) for a, b in zip(names, names[150:], strict=False)] * 3)
    assert len(counted) <= layer_order.SWEEPS + 1
