"""A network on loopback for each test."""

import pytest

from .sides import network


@pytest.fixture
def side():
    with network() as make:
        yield make
