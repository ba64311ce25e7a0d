"""What crosses between sandbox and judge arrives as it was; what cannot cross is described, and harms nobody."""

import base64
import json

import numpy as np
import pytest
from geometry_msgs.msg import Point
from hypothesis import given
from hypothesis import strategies as st

from coursekit.grade.sandbox_json import Described, pack, unpack, unpack_of_judge
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
    array = np.array(rows, np.float32).reshape(-1, 3)
    got = over(array)
    assert got.dtype == array.dtype and got.shape == array.shape and (got == array).all()


def test_messages_arrive():
    assert over(Point(x=1.5, z=-2.0)) == Point(x=1.5, z=-2.0)


def test_a_field_of_gaps_can_be_asked_on_the_other_side():
    field = WallField([[0.0, 0.0], [1.0, 0.5]], cell=0.05, reach=2.0)
    asked = np.random.default_rng(1).uniform(-3, 3, (50, 2))
    assert (unpack_of_judge(json.loads(json.dumps(pack(field))))(asked) == field(asked)).all()


def test_a_field_too_large_to_make_is_refused():
    packed = pack(WallField([[0.0, 0.0], [1.0, 0.5]]))
    packed["gaps"][0] = pack(np.array([[0.0, 0.0], [1e5, 1e5]]))
    with pytest.raises(ValueError, match="too many"):
        unpack_of_judge(packed)


def test_a_student_sends_no_field_of_gaps():
    with pytest.raises(ValueError, match="no tag 'gaps'"):
        unpack(pack(WallField([[0.0, 0.0], [1.0, 0.5]])))


@pytest.mark.parametrize("value", [object(), len, lambda: 1, pytest], ids=["object", "builtin", "function", "module"])
def test_other_things_are_described_and_equal_nothing(value):
    got = over(value)
    assert isinstance(got, Described) and got != got and got != value


LARGE = [
    {"array": ["<U250000000", [1], ["x"]]},
    {"array": ["O", [1], ["x"]]},
    {"array": ["V1000000000", [1], [0]]},
    {"array": ["int64", [1 << 40], [0]]},
    {"array": ["int64", [-1], [0]]},
    {"int": "9" * 5000},
    {"int": 7},
    {"set": [{"int": str(number * (2**61 - 1))} for number in range(6000)]},
    {"message": ["../../etc/msg/Passwd", ""]},
    {"message": ["std_msgs/msg/String", base64.b64encode(b"\0\1\0\0\xff\xff\xff\x7f").decode()]},
]
"""Little JSON that would become large, or reach for what is not a value."""


@pytest.mark.parametrize("tree", [{"call": ["os.system", "true"]}, {}, {"int": "1", "float": "2"}, *LARGE])
def test_what_pack_never_makes_is_refused(tree):
    with pytest.raises(ValueError):
        unpack(tree)
