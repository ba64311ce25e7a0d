"""What crosses between sandbox and judge arrives as it was; what cannot cross is described, and harms nobody."""

import json

import numpy as np
import pytest
from geometry_msgs.msg import Point
from hypothesis import given
from hypothesis import strategies as st

from coursekit.grade.wire import Described, pack, unpack
from coursekit.slam.wall_field import WallField

PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text() | st.binary(),
    lambda inner: st.lists(inner, max_size=4) | st.tuples(inner, inner) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)


def over(value):
    return unpack(json.loads(json.dumps(pack(value))))


@given(PLAIN)
def test_plain_values_arrive_exactly(value):
    assert over(value) == value and type(over(value)) is type(value)


@given(st.sets(st.integers()), st.frozensets(st.text()))
def test_sets_arrive(one, other):
    assert over(one) == one and over(other) == other


@given(st.lists(st.lists(st.floats(width=32, allow_nan=False), min_size=3, max_size=3)))
def test_arrays_keep_kind_and_shape(rows):
    made = np.array(rows, np.float32).reshape(-1, 3)
    got = over(made)
    assert got.dtype == made.dtype and got.shape == made.shape and (got == made).all()


def test_messages_arrive():
    assert over(Point(x=1.5, z=-2.0)) == Point(x=1.5, z=-2.0)


def test_a_field_of_gaps_can_be_asked_on_the_other_side():
    field = WallField([[0.0, 0.0], [1.0, 0.5]], cell=0.05, reach=2.0)
    asked = np.random.default_rng(1).uniform(-3, 3, (50, 2))
    assert (over(field)(asked) == field(asked)).all()


def test_a_field_too_large_to_make_is_refused():
    packed = pack(WallField([[0.0, 0.0], [1.0, 0.5]]))
    packed["gaps"][0] = pack(np.array([[0.0, 0.0], [1e5, 1e5]]))
    with pytest.raises(ValueError, match="too many"):
        unpack(packed)


@pytest.mark.parametrize("value", [object(), len, lambda: 1, pytest], ids=["object", "builtin", "function", "module"])
def test_other_things_are_described_and_equal_nothing(value):
    got = over(value)
    assert isinstance(got, Described) and got != got and got != value


@pytest.mark.parametrize("tree", [{"call": ["os.system", "true"]}, {}, {"int": "1", "float": "2"}])
def test_what_pack_never_makes_is_refused(tree):
    with pytest.raises(ValueError):
        unpack(tree)
