"""Places of the Earth in metres."""

import math

import pytest

from coursekit.nav.utm import Utm

KNOWN = [  # Toronto, Iraq, the same in the south, and the origin of a zone
    (43.642566, -79.387139, Utm(17), 630084, 4833438),
    (33.3, 44.4, Utm(38), 444140.54, 3684706.36),
    (-33.3, 44.4, Utm(38, north=False), 444140.54, 6315293.64),
    (0.0, 3.0, Utm(31), 500000, 0),
]
PLACES = [(48.1, 11.5), (-54.8, -68.3), (0.0, -180.0), (83.9, 20.0), (10.0, 179.999)]


@pytest.mark.parametrize(("latitude", "longitude", "zone", "east", "north"), KNOWN)
def test_a_place_lies_in_its_zone(latitude, longitude, zone, east, north):
    assert Utm.at(latitude, longitude) == zone
    assert zone.plane(latitude, longitude) == pytest.approx((east, north), abs=0.6)


def test_norway_and_svalbard_have_wide_zones():
    assert [Utm.at(*place).zone for place in ((60.4, 5.3), (78.2, 15.6), (78.0, 8.9), (55.0, 5.3))] == [32, 33, 31, 31]


@pytest.mark.parametrize(("latitude", "longitude"), PLACES)
def test_there_and_back_ends_where_it_began(latitude, longitude):
    zone = Utm.at(latitude, longitude)
    assert zone.place(*zone.plane(latitude, longitude)) == pytest.approx((latitude, longitude), abs=1e-8)


def test_the_plane_is_turned_by_its_convergence():
    zone = Utm.at(48.1, 11.5)
    (x, y), (on_x, on_y) = zone.plane(48.1, 11.5), zone.plane(48.1001, 11.5)
    assert math.atan2(on_x - x, on_y - y) == pytest.approx(-zone.convergence(48.1, 11.5), abs=1e-4)


@pytest.mark.parametrize("name", ["", "T", "17", "0T", "61T", "17I", "17Ö"])
def test_what_is_no_zone_is_refused(name):
    with pytest.raises(ValueError, match="no UTM zone"):
        Utm.named(name)
    assert Utm.named("56h") == Utm(56, north=False)
