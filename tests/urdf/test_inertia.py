"""Which masses and inertias a body can have."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursekit.urdf import Box, Cylinder, Inertial, Link, Sphere, Visual, load
from coursekit.urdf.inertia import check, check_link, of_shape
from coursekit.urdf.shapes import mesh_of
from tests.urdf.oracle import ROBOTS

SIZES = st.floats(0.01, 10.0)


@pytest.mark.parametrize("path", sorted(ROBOTS.glob("*.urdf")), ids=lambda path: path.stem)
def test_the_robots_of_the_course_are_made_of_real_bodies(path):
    assert check(load(path)) == []


@pytest.mark.parametrize("shape", [Box((1.0, 2.0, 3.0)), Cylinder(0.5, 2.0), Sphere(0.7)])
def test_the_inertia_of_a_shape_is_that_of_its_triangles(shape):
    mesh = mesh_of(shape)
    expected = mesh.moment_inertia * 2.0 / mesh.volume
    np.testing.assert_allclose(of_shape(shape, 2.0), expected, atol=0.02 * expected.max())


def link(inertia, mass=1.0, shape=None):
    visuals = () if shape is None else (Visual(shape),)
    return Link("body", visuals, inertial=Inertial(mass, inertia))


@settings(deadline=None)
@given(SIZES, SIZES, SIZES, st.floats(0.01, 100.0))
def test_every_block_is_a_real_body(x, y, z, mass):
    shape = Box((x, y, z))
    full = of_shape(shape, mass)
    assert check_link(link((full[0, 0], 0.0, 0.0, full[1, 1], 0.0, full[2, 2]), mass, shape)) == []


@pytest.mark.parametrize(
    ("inertia", "words", "wrong"),
    [
        ((1.0, 0.0, 0.0, 1.0, 0.0, -1.0), "not positive definite", True),
        ((1.0, 2.0, 0.0, 1.0, 0.0, 1.0), "not positive definite", True),
        ((1.0, 0.0, 0.0, 1.0, 0.0, 3.0), "triangle inequality", True),
        ((1.0, 0.0, 0.0, 1.0, 0.0, 1.0), "times off", False),
    ],
)
def test_what_no_body_can_be_like_is_found(inertia, words, wrong):
    (finding,) = check_link(link(inertia, shape=Box((0.1, 0.1, 0.1))))
    assert words in str(finding)
    assert finding.wrong is wrong


def test_a_mass_of_nothing_is_odd():
    (finding,) = check_link(link((1.0, 0.0, 0.0, 1.0, 0.0, 1.0), mass=0.0))
    assert str(finding).startswith("odd: body: its mass is 0")
