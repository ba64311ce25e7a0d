"""The functions of transformations.py, against transforms3d, and the laws they obey."""

import math

import numpy as np
import pytest
import tf_transformations as tf
from hypothesis import given
from hypothesis import strategies as st

t3 = pytest.importorskip("transforms3d", reason="the oracle of rotations: pip install transforms3d")

angle = st.floats(-3.1, 3.1)
angles = st.tuples(angle, angle, angle)
number = st.floats(-10, 10)
vector = st.tuples(number, number, number).filter(lambda v: math.hypot(*v) > 0.1)
factor = st.floats(0.1, 5).map(lambda value: value if value > 1.05 or value < 0.95 else 2.0)


def wxyz(q):
    return q[3], q[0], q[1], q[2]


@pytest.mark.parametrize("axes", sorted(tf._AXES2TUPLE))
@given(abc=angles)
def test_euler_angles_of_all_orders_are_those_of_transforms3d(axes, abc):
    expected = t3.euler.euler2mat(*abc, axes=axes)
    assert np.allclose(tf.euler_matrix(*abc, axes=axes)[:3, :3], expected)
    assert np.allclose(wxyz(tf.quaternion_from_euler(*abc, axes=axes)), t3.euler.euler2quat(*abc, axes=axes))
    back = tf.euler_from_matrix(expected, axes)
    assert np.allclose(tf.euler_matrix(*back, axes=axes)[:3, :3], expected, atol=1e-6)
    code = tf._AXES2TUPLE[axes]
    assert tf.euler_from_matrix(expected, code) == back and tf._TUPLE2AXES[code] == axes


def test_unknown_orders_are_refused():
    for axes in ("xyz", (5, 5, 5, 5)):
        with pytest.raises(KeyError):
            tf.euler_matrix(0, 0, 0, axes)


@given(angles)
def test_roll_pitch_and_yaw_come_back(abc):
    roll, pitch, yaw = abc[0], abc[1] / 2.1, abc[2]
    back = tf.euler_from_quaternion(tf.quaternion_from_euler(roll, pitch, yaw))
    assert back == pytest.approx((roll, pitch, yaw), abs=1e-7)
    assert all(type(value) is float for value in (*back, *tf.quaternion_from_euler(roll, pitch, yaw)))


@given(angles, angles)
def test_quaternions_multiply_as_matrices_do(one, other):
    p, q = tf.quaternion_from_euler(*one), tf.quaternion_from_euler(*other)
    product = tf.quaternion_matrix(tf.quaternion_multiply(p, q))
    assert np.allclose(product, tf.quaternion_matrix(p) @ tf.quaternion_matrix(q))
    assert np.allclose(tf.quaternion_multiply(p, tf.quaternion_inverse(p)), (0, 0, 0, 1))
    assert np.allclose(tf.quaternion_conjugate(p), tf.quaternion_inverse(p))
    assert np.allclose(tf.quaternion_matrix(tf.quaternion_from_matrix(product)), product)
    assert np.allclose(tf.quaternion_matrix(p)[:3, :3], t3.quaternions.quat2mat(wxyz(p)))


@given(angle, vector)
def test_a_turn_about_an_axis(turn, axis):
    matrix = tf.rotation_matrix(turn, axis)
    assert np.allclose(matrix[:3, :3], t3.axangles.axangle2mat(axis, turn))
    assert np.allclose(tf.quaternion_matrix(tf.quaternion_about_axis(turn, axis)), matrix)


@given(st.floats(0.01, 3), vector, vector)
def test_turns_come_back_from_their_matrix(turn, axis, point):
    matrix = tf.rotation_matrix(turn, axis, point)
    assert np.allclose(matrix @ (*point, 1.0), (*point, 1.0))
    assert tf.is_same_transform(tf.rotation_matrix(*tf.rotation_from_matrix(matrix)), matrix)


def test_slerp_goes_evenly():
    a, b = tf.quaternion_from_euler(0, 0, 0), tf.quaternion_from_euler(0, 0, 1)
    assert np.allclose(tf.quaternion_slerp(a, b, 0.25), tf.quaternion_from_euler(0, 0, 0.25))
    assert np.allclose(tf.quaternion_slerp(a, b, 0.0), a) and np.allclose(tf.quaternion_slerp(a, b, 1.0, 1), b)
    assert np.allclose(tf.quaternion_slerp(a, [-part for part in b], 0.5), tf.quaternion_from_euler(0, 0, 0.5))


@given(vector, vector)
def test_mirrors_come_back(point, normal):
    matrix = tf.reflection_matrix(point, normal)
    assert np.allclose(matrix @ matrix, np.identity(4), atol=1e-7) and np.isclose(np.trace(matrix), 2.0)
    assert np.allclose(matrix, t3.reflections.rfnorm2aff(normal, point))
    assert tf.is_same_transform(tf.reflection_matrix(*tf.reflection_from_matrix(matrix)), matrix)


@given(factor, vector, vector)
def test_zooms_come_back(scale, origin, direction):
    for matrix in (tf.scale_matrix(scale, origin), tf.scale_matrix(scale, origin, direction)):
        assert np.allclose(matrix @ (*origin, 1.0), (*origin, 1.0))
        assert tf.is_same_transform(tf.scale_matrix(*tf.scale_from_matrix(matrix)), matrix)


@given(st.floats(0.05, 1.4), vector, vector, vector)
def test_shears_come_back(turn, direction, point, other):
    normal = np.cross(direction, other)
    if np.linalg.norm(normal) < 0.1:
        return
    matrix = tf.shear_matrix(turn, direction, point, normal)
    assert np.isclose(np.linalg.det(matrix), 1.0)
    assert np.allclose(matrix, t3.shears.sadn2aff(turn, direction, normal, point))
    assert tf.is_same_transform(tf.shear_matrix(*tf.shear_from_matrix(matrix)), matrix)
    with pytest.raises(ValueError, match="not orthogonal"):
        tf.shear_matrix(turn, normal, point, normal)


def test_projections_come_back():
    point, normal, direct, eye = np.random.default_rng(3).random((4, 3)) + 0.2
    for options in ({}, {"direction": direct}, {"perspective": eye}, {"perspective": eye, "pseudo": True}):
        matrix = tf.projection_matrix(point, normal, **options)
        projection = tf.projection_from_matrix(matrix, pseudo=options.get("pseudo", False))
        assert tf.is_same_transform(tf.projection_matrix(*projection), matrix)
    flat = tf.projection_matrix(point, normal) @ tf.projection_matrix(point, normal, perspective=eye, pseudo=True)
    assert tf.is_same_transform(flat, tf.projection_matrix(point, normal, perspective=eye))


def test_the_clipped_box_becomes_the_unit_cube():
    box = (1.0, 3.0, 2.0, 5.0, 0.5, 4.0)
    plain = tf.clip_matrix(*box)
    assert np.allclose(plain @ (1, 2, 0.5, 1), (-1, -1, -1, 1)) and np.allclose(plain @ (3, 5, 4, 1), (1, 1, 1, 1))
    corner = tf.clip_matrix(*box, perspective=True) @ (3, 5, 0.5, 1)
    assert np.allclose(corner / corner[3], (1, 1, -1, 1))
    with pytest.raises(ValueError, match="invalid frustrum"):
        tf.clip_matrix(3, 1, 2, 5, 0.5, 4)
    with pytest.raises(ValueError, match="near <= 0"):
        tf.clip_matrix(1, 3, 2, 5, -1, 4, perspective=True)


def test_a_matrix_is_taken_apart_and_put_together():
    rotation = tf.random_rotation_matrix((0.3, 0.6, 0.9))
    shear = tf.shear_matrix(-1.234, (1, 0, 0), (0, 0, 0), (0, 0, 1))
    matrix = tf.concatenate_matrices(tf.translation_matrix((1, 2, 3)), rotation, shear, tf.scale_matrix(1.23))
    scale, shears, turn, place, perspective = tf.decompose_matrix(matrix)
    assert np.allclose(scale, 1.23) and np.allclose(place, (1, 2, 3)) and perspective is None
    assert np.allclose(shears, (0, math.tan(-1.234), 0)) and np.allclose(tf.euler_matrix(*turn), rotation)
    assert tf.is_same_transform(tf.compose_matrix(scale, shears, turn, place, perspective), matrix)
    assert tf.decompose_matrix(tf.scale_matrix(0.123))[0][0] == 0.123
    with pytest.raises(ValueError, match="degenerate"):
        tf.decompose_matrix(np.zeros((4, 4)))


def test_a_mirrored_matrix_is_taken_apart_too():
    matrix = tf.compose_matrix((-1.0, 2.0, 3.0), (0.1, 0.2, 0.3), (1, 2, 3), (4, 5, 6))
    t, r, z, s = t3.affines.decompose44(matrix)
    ours = tf.decompose_matrix(matrix)
    assert np.allclose(ours[0], z) and np.allclose(ours[1], s) and np.allclose(ours[3], t)
    assert np.allclose(tf.euler_matrix(*ours[2])[:3, :3], r)


@pytest.mark.parametrize("usesvd", [True, False])
def test_superimposing_finds_the_motion(usesvd):
    points = np.random.default_rng(1).normal(size=(3, 20))
    motion = tf.compose_matrix(angles=(0.1, 2.0, -1.0), translate=(1, 2, 3), scale=(2, 2, 2))
    moved = motion[:3, :3] @ points + motion[:3, 3:]
    assert np.allclose(tf.superimposition_matrix(points, moved, scaling=True, usesvd=usesvd), motion)
    assert np.allclose(tf.superimposition_matrix(points, points, usesvd=usesvd), np.identity(4))
    with pytest.raises(ValueError, match="wrong shape"):
        tf.superimposition_matrix(points, moved[:, :5])


def test_a_crystals_cell():
    cube = tf.orthogonalization_matrix((10, 10, 10), (90, 90, 90))
    assert np.allclose(cube[:3, :3], np.identity(3) * 10)
    assert np.isclose(tf.orthogonalization_matrix([9.8, 12.0, 15.5], [87.2, 80.7, 69.7]).sum(), 43.063229)


def test_lengths_and_directions():
    block = np.random.default_rng(2).random((5, 4, 3))
    assert np.allclose(tf.vector_norm(block, axis=1), np.linalg.norm(block, axis=1))
    assert tf.vector_norm([]) == 0.0 and tf.vector_norm([1.0]) == 1.0
    out = np.empty((5, 3))
    tf.vector_norm(block, axis=1, out=out)
    assert np.allclose(out, np.linalg.norm(block, axis=1))
    assert np.allclose(np.linalg.norm(tf.unit_vector(block, axis=-1), axis=-1), 1.0)
    whole = np.empty_like(block)
    tf.unit_vector(block, axis=1, out=whole)
    assert np.allclose(whole, tf.unit_vector(block, axis=1)) and list(tf.unit_vector([])) == []
    assert np.isclose(np.linalg.norm(tf.unit_vector(block)), 1.0)


def test_random_things_are_what_they_say():
    assert np.isclose(tf.vector_norm(tf.random_quaternion()), 1.0) and tf.random_vector(10).shape == (10,)
    rotation = tf.random_rotation_matrix()
    assert np.allclose(rotation.T @ rotation, np.identity(4))
    assert np.allclose(tf.inverse_matrix(rotation), rotation.T)
    assert np.allclose(tf.translation_from_matrix(tf.translation_matrix((1, 2, 3))), (1, 2, 3))
    assert np.allclose(tf.identity_matrix(), np.identity(4))
    assert np.allclose(tf.quaternion_matrix((0, 0, 0, 0)), np.identity(4))


def test_the_arcball_turns_about_its_axes():
    ball = tf.Arcball(initial=[0, 0, 0, 1])
    ball.place([320, 320], 320)
    ball.setaxes([1, 1, 0], [-1, 1, 0])
    ball.setconstrain(True)
    assert ball.getconstrain()
    ball.down([400, 200])
    ball.drag([200, 400])
    assert np.isclose(ball.matrix().sum(), 0.2055924)
    ball.next()
    assert np.allclose(tf.Arcball(np.identity(4)).matrix(), np.identity(4))
    with pytest.raises(ValueError, match="not a quaternion or matrix"):
        tf.Arcball([1, 2, 3])
