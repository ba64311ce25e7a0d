"""A robot keeps its way around an obstacle unless another is much shorter."""

import numpy as np

from coursekit.nav.path_change import WORTH, remaining, worth_it

STEPS = np.linspace(0.0, 1.0, 60)


def around(side, far=4.0):
    """An arch of this height from (0, 0) to (far, 0)."""
    return np.column_stack([far * STEPS, side * np.sin(np.pi * STEPS)])


def test_the_other_side_is_not_taken_for_a_few_centimetres():
    assert not worth_it(around(-1.0), around(1.05))
    assert not worth_it(around(1.05), around(-1.0))


def test_the_same_way_is_taken_as_it_is_now_even_if_longer():
    assert worth_it(around(1.3), around(1.0))


def test_a_much_shorter_way_is_taken():
    assert worth_it(around(0.1), around(3.0))
    assert not worth_it(around(0.1), around(0.7)), f"it has more than {WORTH:.0%} of the length"


def test_what_has_been_driven_no_longer_counts():
    way = around(1.0)
    assert remaining(way, *way[20]).tolist() == way[20:].tolist()
    assert len(remaining(way, 9.0, 0.0)) == 1
