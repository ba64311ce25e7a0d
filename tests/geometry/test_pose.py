"""Rigid motions obey the laws of a group, and agree with 4 x 4 matrices."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from coursekit.geometry.pose import between, canonical, matrix, multiply, normalized
from coursekit.tf import IDENTITY, compose, interpolate, inverse, rotate, slerp

number = st.floats(-100, 100)
quaternion = (
    st.tuples(*[st.floats(-1, 1)] * 4)
    .filter(lambda q: sum(part * part for part in q) > 1e-2)
    .map(lambda q: normalized((0.0, 0.0, 0.0, *q))[3:])
)
pose = st.tuples(st.tuples(number, number, number), quaternion).map(lambda pair: (*pair[0], *pair[1]))
ratio = st.floats(0, 1)


def same(a, b):
    return np.allclose(matrix(a), matrix(b), atol=1e-9)


@given(pose)
def test_the_identity_changes_nothing(a):
    assert same(compose(a, IDENTITY), a) and same(compose(IDENTITY, a), a)


@given(pose)
def test_a_motion_and_its_inverse_cancel(a):
    assert same(compose(a, inverse(a)), IDENTITY) and same(compose(inverse(a), a), IDENTITY)


@given(pose, pose, pose)
def test_composition_is_associative(a, b, c):
    assert np.allclose(matrix(compose(compose(a, b), c)), matrix(compose(a, compose(b, c))), atol=1e-8)


@given(pose, pose)
def test_composition_is_the_product_of_matrices(a, b):
    assert np.allclose(matrix(compose(a, b)), np.array(matrix(a)) @ matrix(b), atol=1e-9)


@given(pose, pose)
def test_between_is_the_inverse_of_one_after_the_other(a, b):
    assert same(between(a, b), compose(inverse(a), b))


@given(quaternion, st.tuples(number, number, number))
def test_turning_keeps_lengths(q, v):
    assert math.isclose(math.hypot(*rotate(q, v)), math.hypot(*v), abs_tol=1e-9)


@given(quaternion, quaternion, st.tuples(number, number, number))
def test_turning_by_a_product_is_turning_twice(a, b, v):
    assert np.allclose(rotate(multiply(a, b), v), rotate(a, rotate(b, v)), atol=1e-9)


@given(quaternion, quaternion, ratio)
def test_slerp_gives_unit_quaternions_at_a_steady_angle(a, b, part):
    middle = slerp(a, b, part)
    assert math.isclose(math.hypot(*middle), 1.0, rel_tol=1e-9)
    whole = math.acos(min(1.0, abs(float(np.dot(a, b)))))
    assert math.isclose(math.acos(min(1.0, abs(float(np.dot(a, middle))))), part * whole, abs_tol=1e-6)


@given(pose, pose)
def test_interpolation_ends_at_both_ends(a, b):
    assert same(interpolate(a, b, 0.0), a) and same(interpolate(a, b, 1.0), b)


@given(pose)
def test_the_canonical_sign_is_the_same_motion(a):
    assert same(canonical(a), a) and same(canonical((*a[:3], *(-part for part in a[3:]))), a)
    assert canonical(a)[3:] == canonical((*a[:3], *(-part for part in a[3:])))[3:] or abs(a[6]) == 0.5
