"""A network on loopback for each test."""

import pytest

from coursekit.processes.session import Session

from .sides import network


@pytest.fixture
def side():
    with network() as make:
        yield make


@pytest.fixture
def session():
    session = Session()
    yield session
    session.close()
