"""A path over costs, shown in the notebook and said in words."""

import numpy as np
import pytest

from coursekit.lab.path_view import path_view

COSTS = np.array([[0, 0, 253], [100, 0, 0]])


def test_it_is_a_picture_whose_words_are_the_text():
    shown = path_view(COSTS, [(0, 0), (0, 1), (1, 1)])
    assert repr(shown) == "The costs of 2 x 3 cells from above, and a path of 2 steps over them."
    assert f'role="img" aria-label="{shown!r}"' in shown._repr_html_() and "the path" in shown._repr_html_()


def test_where_no_path_leads_the_costs_are_shown():
    assert "a path of 0 steps" in repr(path_view(COSTS, None)) and "<svg" in path_view(COSTS)._repr_html_()


@pytest.mark.parametrize("path", [[(0, 3)], [(2, 0)], [(-1, 0)]])
def test_a_path_that_leaves_the_floor_is_told_where(path):
    with pytest.raises(ValueError, match="row first, then column"):
        path_view(COSTS, path)


@pytest.mark.parametrize("costs", [[1, 2], "costs", [["a"]], None])
def test_what_is_no_table_of_costs_is_told(costs):
    with pytest.raises(ValueError, match="rows and columns of numbers"):
        path_view(costs)
