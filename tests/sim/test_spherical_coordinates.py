"""Places of a world as latitude, longitude and altitude."""

import math

import pytest

from coursekit.sim.spherical_coordinates import SphericalCoordinates, pressure

DEGREE = 111_319.4908
"""Of longitude at the equator [m]: the ellipsoid's long axis tells."""


def test_the_equator_is_a_circle_and_a_tangent_leaves_it():
    latitude, longitude, altitude = SphericalCoordinates().fix(1000.0, 0.0)
    assert latitude == pytest.approx(0.0, abs=1e-12) and longitude == pytest.approx(1000.0 / DEGREE, rel=1e-7)
    assert altitude == pytest.approx(1000.0**2 / 2 / 6_378_137.0, rel=1e-4)


def test_degrees_are_as_long_as_on_wgs_84():
    """At 45 degrees one of latitude has 111132 m, one of longitude 78847 m."""
    latitude, _, _ = SphericalCoordinates(45.0).fix(0.0, 100.0)
    assert 100.0 / (latitude - 45.0) == pytest.approx(111_132.0, rel=1e-5)
    _, longitude, _ = SphericalCoordinates(45.0, 7.0).fix(100.0, 0.0)
    assert 100.0 / (longitude - 7.0) == pytest.approx(78_847.0, rel=1e-5)


def test_the_world_s_x_axis_may_point_elsewhere_than_east():
    ahead = SphericalCoordinates(45.0, 7.0, heading=90.0).fix(100.0, 0.0)
    assert ahead == pytest.approx(SphericalCoordinates(45.0, 7.0).fix(0.0, 100.0))


@pytest.mark.parametrize("latitude", [-89.0, -30.0, 0.0, 60.0, 89.9])
def test_up_is_up_everywhere(latitude):
    there = SphericalCoordinates(latitude, 179.0, 100.0).fix(0.0, 0.0, 50.0)
    assert there == pytest.approx((latitude, 179.0, 150.0), abs=1e-8)


def test_the_air_gets_thinner():
    """The standard atmosphere's table: 101325 Pa at the sea, 54020 Pa at 5000 m."""
    assert pressure(0.0) == 101_325.0 and pressure(5000.0) == pytest.approx(54_020.0, rel=1e-3)
    assert not math.isnan(pressure(1e9))


def test_a_place_of_the_earth_is_found_in_the_world():
    globe = SphericalCoordinates(-33.3, 179.999, 50.0, heading=30.0)
    assert globe.place(*globe.fix(400.0, -300.0, 20.0)) == pytest.approx((400.0, -300.0, 20.0), abs=1e-5)
